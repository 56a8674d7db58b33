#include <heddle/beam/director_element.h>

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

      /** Where the vectors r', g_1, g_2, g_1', g_2' start in Fields. */
      enum Part : unsigned int
      {
        t  = 0,
        g1 = 3,
        g2 = 6,
        d1 = 9,
        d2 = 12
      };

      using Strains   = std::array<double, n_strains_at_point>;
      using Gradients = std::array<double, n_strains_at_point * width>;
      using Hessian   = std::array<double, n_fields * width>;



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



        /** Apply the law to @p n columns: strains, or their gradients. */
        template <unsigned int n>
        void
        apply(const double *strains, double *stresses) const
        {
          for (unsigned int i = 0; i < n_strains_at_point; ++i)
            for (unsigned int c = 0; c < n; ++c)
              stresses[i * n + c] = diagonal[i] * strains[i * n + c];
          for (unsigned int c = 0; c < n; ++c)
            {
              const double e  = coupling * strains[c];
              const double e1 = strains[3 * n + c];
              const double e2 = strains[4 * n + c];
              stresses[c] += coupling * (e1 + e2);
              stresses[3 * n + c] += e + lambda * e2;
              stresses[4 * n + c] += e + lambda * e1;
            }
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
        Gradients  gradients{};
        const auto set = [&](const unsigned int strain,
                             const Part         at,
                             const Part         by,
                             const double       factor) {
          for (unsigned int c = 0; c < 3; ++c)
            gradients[strain * width + at + c] = factor * p[by + c];
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



      /** Add the second derivatives of the strains times @p stresses. */
      inline void
      add_geometric(const Strains &stresses, Hessian &hessian)
      {
        const auto add = [&](const Part a, const Part b, const double s) {
          for (unsigned int c = 0; c < 3; ++c)
            {
              hessian[(a + c) * width + b + c] += s;
              if (a != b)
                hessian[(b + c) * width + a + c] += s;
            }
        };
        add(t, t, stresses[0]);
        add(t, g1, stresses[1]);
        add(t, g2, stresses[2]);
        add(g1, g1, stresses[3]);
        add(g2, g2, stresses[4]);
        add(g1, g2, stresses[5]);
        add(t, d1, stresses[6]);
        add(t, d2, stresses[7]);
        add(g1, d2, .5 * (stresses[11] - stresses[8]));
        add(g2, d1, .5 * (stresses[11] + stresses[8]));
        add(g1, d1, stresses[9]);
        add(g2, d2, stresses[10]);
      }



      /** Return B^T C B + G(stresses) in the fields of one point. */
      inline Hessian
      hessian_of(const Law &law, const Fields &p, const Strains &stresses)
      {
        const Gradients gradients = gradients_of(p);
        Gradients       scaled;
        law.apply<width>(gradients.data(), scaled.data());

        Hessian hessian;
        for (unsigned int r = 0; r < n_fields; ++r)
          {
            Fields row{};
            for (unsigned int i = 0; i < n_strains_at_point; ++i)
              for (unsigned int c = 0; c < width; ++c)
                row[c] += gradients[i * width + r] * scaled[i * width + c];
            std::copy(row.begin(), row.end(), &hessian[r * width]);
          }
        add_geometric(stresses, hessian);
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
            for (unsigned int c = 0; c < 3; ++c)
              {
                p[t + c] += slope * blocks[3 * a][c];
                p[g1 + c] += point.value[a] * blocks[3 * a + 1][c];
                p[g2 + c] += point.value[a] * blocks[3 * a + 2][c];
                p[d1 + c] += slope * blocks[3 * a + 1][c];
                p[d2 + c] += slope * blocks[3 * a + 2][c];
              }
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
            for (unsigned int c = 0; c < 3; ++c)
              residual[9 * a + c] += slope * forces[t + c];
            for (unsigned int c = 3; c < 9; ++c)
              residual[9 * a + c] +=
                point.value[a] * forces[c] + slope * forces[c + 6];
          }
      }



      /** Add interpolate() and its transpose on both sides of @p hessian. */
      template <int degree>
      inline void
      add_hessian(const LagrangePoint<degree> &point,
                  const Hessian               &hessian,
                  const double                 length,
                  const double                 weight,
                  double                      *tangent)
      {
        constexpr unsigned int n = 9 * (degree + 1);

        double columns[n_fields][n];
        for (unsigned int r = 0; r < n_fields; ++r)
          for (int b = 0; b <= degree; ++b)
            {
              const double *h     = &hessian[r * width];
              const double  value = weight * point.value[b];
              const double  slope = weight * point.slope[b] / length;
              for (unsigned int c = 0; c < 3; ++c)
                columns[r][9 * b + c] = slope * h[c];
              for (unsigned int c = 3; c < 9; ++c)
                columns[r][9 * b + c] = value * h[c] + slope * h[c + 6];
            }

        for (int a = 0; a <= degree; ++a)
          {
            const double slope = point.slope[a] / length;
            double      *rows  = tangent + 9 * a * n;
            for (unsigned int r = 0; r < 3; ++r)
              for (unsigned int c = 0; c < n; ++c)
                rows[r * n + c] += slope * columns[r][c];
            for (unsigned int r = 3; r < 9; ++r)
              for (unsigned int c = 0; c < n; ++c)
                rows[r * n + c] +=
                  point.value[a] * columns[r][c] + slope * columns[r + 6][c];
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
              e[i] += gradients[i * width + c] * dp[c];
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
      if (tangent != nullptr)
        std::fill_n(tangent, n * n, 0.);

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
              const Gradients gradients = gradients_of(p);
              Fields          forces{};
              for (unsigned int i = 0; i < n_strains_at_point; ++i)
                for (unsigned int c = 0; c < width; ++c)
                  forces[c] += weight * stresses[i] * gradients[i * width + c];
              add_forces(point, forces, length, residual);
            }
          if (tangent != nullptr)
            {
              if (predicted_stresses != nullptr)
                std::copy_n(predicted_stresses + q * n_strains_at_point,
                            n_strains_at_point,
                            stresses.begin());
              add_hessian(
                point, hessian_of(law, p, stresses), length, weight, tangent);
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
