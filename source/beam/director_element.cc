#include <heddle/beam/director_element.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Beam
  {
    namespace
    {
      /** Strains per integration point. */
      constexpr unsigned int n_strains_at_point = 12;

      /** Numbers in Fields that mean something, and with the padding. */
      constexpr unsigned int n_fields = 15;
      constexpr unsigned int width    = 16;

      /**
       * The fields at a point that the strains are made of: five vectors, in
       * the order of Part, padded to a whole number of machine words.
       */
      using Fields = std::array<double, width>;

      /**
       * Where the vectors r', g_1', g_2', g_1, g_2 start in Fields: derivatives
       * of the three blocks of a node, then values of the last two.
       */
      enum Part : unsigned int
      {
        t  = 0,
        d1 = 3,
        d2 = 6,
        g1 = 9,
        g2 = 12
      };

      using Strains = std::array<double, n_strains_at_point>;

      /** A column for each strain, and for each field. */
      using Gradients = Eigen::Matrix<double, width, n_strains_at_point>;
      using Hessian   = Eigen::Matrix<double, width, n_fields>;



      /**
       * The section law: diagonal but for the coupling of axial strain and
       * section stretch.
       */
      struct Law
      {
        explicit Law(const Section &section)
          : lambda(2. * section.thickness * section.poisson_ratio /
                   (1. - 2. * section.poisson_ratio))
          , coupling(2. * section.poisson_ratio * (lambda + section.thickness))
        {
          const double stretch = lambda + 2. * section.thickness;
          diagonal = {{section.axial + 2. * section.poisson_ratio * coupling,
                       section.shear,
                       section.shear,
                       stretch,
                       stretch,
                       section.thickness,
                       section.bending,
                       section.bending,
                       section.torsion,
                       section.gradient,
                       section.gradient,
                       2. * section.gradient}};
        }



        /** Apply the law to strains, or to their gradients of @p n numbers. */
        template <unsigned int n>
        void
        apply(const double *strains, double *stresses) const
        {
          using Numbers     = Eigen::Array<double, n, 1>;
          const auto strain = [strains](const unsigned int i) {
            return Eigen::Map<const Numbers>(strains + i * n);
          };
          const auto stress = [stresses](const unsigned int i) {
            return Eigen::Map<Numbers>(stresses + i * n);
          };
          for (unsigned int i = 0; i < n_strains_at_point; ++i)
            stress(i) = diagonal[i] * strain(i);
          stress(0) += coupling * (strain(3) + strain(4));
          stress(3) += coupling * strain(0) + lambda * strain(4);
          stress(4) += coupling * strain(0) + lambda * strain(3);
        }

        double  lambda;
        double  coupling;
        Strains diagonal;
      };



      inline double
      dot(const Fields &p, const Part a, const Part b)
      {
        return p[a] * p[b] + p[a + 1] * p[b + 1] + p[a + 2] * p[b + 2];
      }



      inline Strains
      strains_of(const Fields &p)
      {
        const double g1_d2 = dot(p, g1, d2);
        const double g2_d1 = dot(p, g2, d1);
        return {{.5 * (dot(p, t, t) - 1.),
                 dot(p, t, g1),
                 dot(p, t, g2),
                 .5 * (dot(p, g1, g1) - 1.),
                 .5 * (dot(p, g2, g2) - 1.),
                 dot(p, g1, g2),
                 dot(p, t, d1),
                 dot(p, t, d2),
                 .5 * (g2_d1 - g1_d2),
                 dot(p, g1, d1),
                 dot(p, g2, d2),
                 .5 * (g1_d2 + g2_d1)}};
      }



      /** Derivatives of the strains in the fields, strain by strain. */
      inline Gradients
      gradients_of(const Fields &p)
      {
        Gradients  gradients = Gradients::Zero();
        const auto set       = [&](const unsigned int strain,
                             const Part         at,
                             const Part         by,
                             const double       factor) {
          for (unsigned int c = 0; c < 3; ++c)
            gradients(at + c, strain) = factor * p[by + c];
        };
        const auto set_product =
          [&](const unsigned int strain, const Part a, const Part b) {
            set(strain, a, b, 1.);
            set(strain, b, a, 1.);
          };
        set(0, t, t, 1.);
        set_product(1, t, g1);
        set_product(2, t, g2);
        set(3, g1, g1, 1.);
        set(4, g2, g2, 1.);
        set_product(5, g1, g2);
        set_product(6, t, d1);
        set_product(7, t, d2);
        for (const auto &[strain, sign] : {std::pair(8u, -1.), {11u, 1.}})
          {
            set(strain, g1, d2, .5 * sign);
            set(strain, d2, g1, .5 * sign);
            set(strain, g2, d1, .5);
            set(strain, d1, g2, .5);
          }
        set_product(9, g1, d1);
        set_product(10, g2, d2);
        return gradients;
      }



      /** One number for each pair of the five vectors. */
      using PairsOfParts = std::array<std::array<double, 5>, 5>;



      /**
       * The second derivatives of the strains times @p stresses: the number of
       * two vectors stands for that multiple of the identity.
       */
      inline PairsOfParts
      second_derivatives(const Strains &stresses)
      {
        const Strains &s = stresses;
        const double   u = .5 * (s[11] - s[8]), v = .5 * (s[11] + s[8]);
        return {{{{s[0], s[6], s[7], s[1], s[2]}},
                 {{s[6], 0., 0., s[9], v}},
                 {{s[7], 0., 0., u, s[10]}},
                 {{s[1], s[9], u, s[3], s[5]}},
                 {{s[2], v, s[10], s[5], s[4]}}}};
      }



      /**
       * Derivatives of the strains times @p stresses: strains are quadratic in
       * the fields, so these are second derivatives times the fields.
       */
      inline Fields
      forces_of(const Fields &p, const Strains &stresses)
      {
        const PairsOfParts factors = second_derivatives(stresses);
        Fields             forces{};
        for (unsigned int a = 0; a < 5; ++a)
          for (unsigned int b = 0; b < 5; ++b)
            for (unsigned int c = 0; c < 3; ++c)
              forces[3 * a + c] += factors[a][b] * p[3 * b + c];
        return forces;
      }



      /** Set the columns of @p part from those strains that depend on it. */
      template <unsigned int... strains>
      inline void
      set_columns(const Part       part,
                  const Gradients &gradients,
                  const Gradients &scaled,
                  Hessian         &hessian)
      {
        for (unsigned int c = part; c < part + 3; ++c)
          hessian.col(c) =
            (... + (gradients(c, strains) * scaled.col(strains)));
      }



      /** Return B^T C B + G(stresses) in the fields of one point. */
      inline Hessian
      hessian_of(const Law &law, const Fields &p, const Strains &stresses)
      {
        const Gradients gradients = gradients_of(p);
        Gradients       scaled;
        law.apply<width>(gradients.data(), scaled.data());

        Hessian hessian;
        set_columns<0, 1, 2, 6, 7>(t, gradients, scaled, hessian);
        set_columns<1, 3, 5, 8, 9, 11>(g1, gradients, scaled, hessian);
        set_columns<2, 4, 5, 8, 10, 11>(g2, gradients, scaled, hessian);
        set_columns<6, 8, 9, 11>(d1, gradients, scaled, hessian);
        set_columns<7, 8, 10, 11>(d2, gradients, scaled, hessian);
        const PairsOfParts geometric = second_derivatives(stresses);
        for (unsigned int a = 0; a < 5; ++a)
          for (unsigned int b = 0; b < 5; ++b)
            for (unsigned int c = 0; c < 3; ++c)
              hessian(3 * a + c, 3 * b + c) += geometric[a][b];
        return hessian;
      }



      template <int degree>
      inline Fields
      interpolate(const LagrangePoint<degree> &point,
                  const Tensor<1, 3>          *blocks,
                  const double                 length)
      {
        Fields p{};
        for (int a = 0; a <= degree; ++a)
          {
            const double slope = point.slope[a] / length;
            for (unsigned int k = 0; k < 3; ++k)
              for (unsigned int c = 0; c < 3; ++c)
                p[t + 3 * k + c] += slope * blocks[3 * a + k][c];
            for (unsigned int k = 1; k < 3; ++k)
              for (unsigned int c = 0; c < 3; ++c)
                p[g1 + 3 * (k - 1) + c] +=
                  point.value[a] * blocks[3 * a + k][c];
          }
        return p;
      }



      /** Add the transpose of interpolate() applied to @p forces. */
      template <int degree>
      inline void
      add_forces(const LagrangePoint<degree> &point,
                 const Fields                &forces,
                 const double                 length,
                 double                      *residual)
      {
        for (int a = 0; a <= degree; ++a)
          {
            const double slope = point.slope[a] / length;
            for (unsigned int c = 0; c < 9; ++c)
              residual[9 * a + c] += slope * forces[t + c];
            for (unsigned int c = 3; c < 9; ++c)
              residual[9 * a + c] += point.value[a] * forces[c + 6];
          }
      }



      /**
       * Add interpolate() and its transpose on both sides of @p hessian; of the
       * first point it is what is set.
       */
      template <int degree, bool is_first>
      inline void
      add_hessian(const LagrangePoint<degree> &point,
                  const Hessian               &hessian,
                  const double                 length,
                  const double                 weight,
                  double                      *tangent)
      {
        // Derivatives are the first nine fields, values the last six.
        constexpr unsigned int                  n = 9 * (degree + 1);
        Eigen::Matrix<double, n, n_fields>      rows;
        Eigen::Map<Eigen::Matrix<double, n, n>> sum(tangent);
        for (int a = 0; a <= degree; ++a)
          {
            auto of_node = rows.template middleRows<9>(9 * a);
            of_node = (weight * point.slope[a] / length) * hessian.topRows<9>();
            of_node.template bottomRows<6>() +=
              (weight * point.value[a]) * hessian.middleRows<6>(9);
          }
        for (int a = 0; a <= degree; ++a)
          {
            const double slope   = point.slope[a] / length;
            auto         of_node = sum.template middleCols<9>(9 * a);
            if constexpr (is_first)
              of_node = slope * rows.template leftCols<9>();
            else
              of_node += slope * rows.template leftCols<9>();
            of_node.template rightCols<6>() +=
              point.value[a] * rows.template rightCols<6>();
          }
      }



      /** Elastic strains at a point: those of the reference are subtracted. */
      inline Strains
      elastic_strains(const Fields &p, const double *reference_strains)
      {
        Strains strains = strains_of(p);
        for (unsigned int i = 0; i < n_strains_at_point; ++i)
          strains[i] -= reference_strains[i];
        return strains;
      }



      /** Gauss points on the interval from 0 to 1: position and weight. */
      template <int degree>
      std::array<std::pair<double, double>, degree>
      gauss_rule()
      {
        if constexpr (degree == 1)
          return {{{.5, 1.}}};
        else if constexpr (degree == 2)
          {
            const double x = .5 / std::sqrt(3.);
            return {{{.5 - x, .5}, {.5 + x, .5}}};
          }
        else
          {
            const double x = .5 * std::sqrt(.6);
            return {{{.5 - x, 5. / 18.}, {.5, 8. / 18.}, {.5 + x, 5. / 18.}}};
          }
      }
    } // namespace



    template <int degree>
    DirectorElement<degree>::DirectorElement()
    {
      const auto rule = gauss_rule<degree>();
      for (int q = 0; q < degree; ++q)
        {
          const double x   = degree * rule[q].first;
          points[q].weight = rule[q].second;
          for (int a = 0; a <= degree; ++a)
            {
              double value = 1., slope = 0.;
              for (int b = 0; b <= degree; ++b)
                if (b != a)
                  {
                    slope = (slope * (x - b) + value) / (a - b);
                    value *= (x - b) / (a - b);
                  }
              points[q].value[a] = value;
              points[q].slope[a] = degree * slope;
            }
        }
    }



    template <int degree>
    std::string
    DirectorElement<degree>::name() const
    {
      return "director";
    }



    template <int degree>
    unsigned int
    DirectorElement<degree>::n_nodes() const
    {
      return degree + 1;
    }



    template <int degree>
    unsigned int
    DirectorElement<degree>::n_blocks_per_node() const
    {
      return 3;
    }



    template <int degree>
    unsigned int
    DirectorElement<degree>::n_strains() const
    {
      return degree * n_strains_at_point;
    }



    template <int degree>
    void
    DirectorElement<degree>::strains(const Tensor<1, 3> *blocks,
                                     const double        length,
                                     double             *strains) const
    {
      for (const auto &point : points)
        {
          const Strains e = strains_of(interpolate(point, blocks, length));
          strains         = std::copy(e.begin(), e.end(), strains);
        }
    }



    template <int degree>
    void
    DirectorElement<degree>::predict_stresses(const Section      &section,
                                              const Tensor<1, 3> *blocks,
                                              const Tensor<1, 3> *increment,
                                              const double        length,
                                              const double *reference_strains,
                                              double       *stresses) const
    {
      const Law law(section);
      for (const auto &point : points)
        {
          const Fields    p         = interpolate(point, blocks, length);
          const Fields    dp        = interpolate(point, increment, length);
          const Gradients gradients = gradients_of(p);
          Strains         e         = elastic_strains(p, reference_strains);
          for (unsigned int i = 0; i < n_strains_at_point; ++i)
            for (unsigned int c = 0; c < n_fields; ++c)
              e[i] += gradients(c, i) * dp[c];
          law.apply<1>(e.data(), stresses);
          reference_strains += n_strains_at_point;
          stresses += n_strains_at_point;
        }
    }



    template <int degree>
    double
    DirectorElement<degree>::assemble(const Section      &section,
                                      const Tensor<1, 3> *blocks,
                                      const double        length,
                                      const double       *reference_strains,
                                      const double       *predicted_stresses,
                                      double             *residual,
                                      double             *tangent) const
    {
      constexpr unsigned int n = 9 * (degree + 1);
      if (residual != nullptr)
        std::fill_n(residual, n, 0.);
      const Law law(section);
      double    energy = 0.;
      for (int q = 0; q < degree; ++q)
        {
          const auto   &point  = points[q];
          const double  weight = point.weight * length;
          const Fields  p      = interpolate(point, blocks, length);
          const Strains e =
            elastic_strains(p, reference_strains + q * n_strains_at_point);
          Strains stresses;
          law.apply<1>(e.data(), stresses.data());
          for (unsigned int i = 0; i < n_strains_at_point; ++i)
            energy += .5 * weight * e[i] * stresses[i];

          if (residual != nullptr)
            {
              Fields forces = forces_of(p, stresses);
              for (double &force : forces)
                force *= weight;
              add_forces(point, forces, length, residual);
            }
          if (tangent != nullptr)
            {
              if (predicted_stresses != nullptr)
                std::copy_n(predicted_stresses + q * n_strains_at_point,
                            n_strains_at_point,
                            stresses.begin());
              const Hessian hessian = hessian_of(law, p, stresses);
              if (q == 0)
                add_hessian<degree, true>(
                  point, hessian, length, weight, tangent);
              else
                add_hessian<degree, false>(
                  point, hessian, length, weight, tangent);
            }
        }
      return energy;
    }



    template <int degree>
    Element::SectionState
    DirectorElement<degree>::section_state(
      const Section      &section,
      const Tensor<1, 3> *blocks,
      const double        length,
      const double       *reference_strains) const
    {
      // The middle is a Gauss point of the odd degrees, and half way between
      // the two of the quadratic element.
      const unsigned int first = (degree - 1) / 2, last = degree / 2;

      Strains e{}, s;
      for (unsigned int q = first; q <= last; ++q)
        {
          const Strains at_point =
            elastic_strains(interpolate(points[q], blocks, length),
                            reference_strains + q * n_strains_at_point);
          for (unsigned int i = 0; i < n_strains_at_point; ++i)
            e[i] += at_point[i] / (last - first + 1);
        }
      Law(section).apply<1>(e.data(), s.data());

      SectionState state;
      state.axial_strain = e[0];
      state.axial_force  = s[0];
      state.twist        = e[8];
      state.torque       = s[8];
      for (unsigned int a = 0; a < 2; ++a)
        {
          state.shear_strain[a]   = e[1 + a];
          state.shear_force[a]    = s[1 + a];
          state.curvature[a]      = e[6 + a];
          state.bending_moment[a] = s[6 + a];
        }
      return state;
    }



    template <int degree>
    Element::EnergySplit
    DirectorElement<degree>::energy_split(const Section      &section,
                                          const Tensor<1, 3> *blocks,
                                          const double        length,
                                          const double *reference_strains) const
    {
      EnergySplit split;
      for (const auto &point : points)
        {
          const Strains e = elastic_strains(interpolate(point, blocks, length),
                                            reference_strains);
          Strains       s;
          Law(section).apply<1>(e.data(), s.data());
          Strains w;
          for (unsigned int i = 0; i < n_strains_at_point; ++i)
            w[i] = .5 * point.weight * length * e[i] * s[i];

          // A fiber under tension, its section free, has axial energy only:
          // the square of the coupled law is completed, see the class.
          const double axial =
            .5 * point.weight * length * section.axial * e[0] * e[0];
          split.axial += axial;
          split.shear += w[1] + w[2];
          split.bending += w[6] + w[7];
          split.torsion += w[8];
          split.section +=
            w[0] + w[3] + w[4] - axial + w[5] + w[9] + w[10] + w[11];
          reference_strains += n_strains_at_point;
        }
      return split;
    }



    template class DirectorElement<1>;
    template class DirectorElement<2>;
    template class DirectorElement<3>;
  } // namespace Beam
} // namespace Heddle
