#include <heddle/beam/director_element.h>
#include <heddle/beam/director_point.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Heddle
{
  namespace Beam
  {
    namespace
    {
      using namespace DirectorPoint;



      template <int degree>
      inline Fields
      interpolate(const LagrangePoint<degree> &point,
                  const Tensor<1, 3>          *blocks,
                  const double                 length)
      {
        Fields p{};
        for (int a = 0; a <= degree; ++a)
          for (unsigned int k = 0; k < 3; ++k)
            {
              const Tensor<1, 3> &block = blocks[3 * a + k];
              const Lanes<4>      lanes = {block[0], block[1], block[2], 0.};
              p[k] += point.slope[a] / length * lanes;
              if (k > 0)
                p[k + 2] += point.value[a] * lanes;
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
          for (unsigned int k = 0; k < 3; ++k, residual += 3)
            {
              Lanes<4> sum = point.slope[a] / length * forces[k];
              if (k > 0)
                sum += point.value[a] * forces[k + 2];
              for (unsigned int c = 0; c < 3; ++c)
                residual[c] += sum[c];
            }
      }



      /** Derivatives of the forces of an element: of block a, in b, by column.
       */
      template <int degree>
      struct TangentSums
      {
        static constexpr unsigned int n_blocks = 3 * (degree + 1);

        Lanes<4> columns[n_blocks][3][n_blocks] = {};

        /** Copy it to 3 n_blocks rows of as many numbers. */
        void
        write(double *numbers) const
        {
          for (const auto &of_block : columns)
            for (const auto &column : of_block)
              for (const Lanes<4> &block : column)
                for (unsigned int d = 0; d < 3; ++d)
                  *numbers++ = block[d];
        }
      };



      /** Add interpolate() and its transpose on both sides of @p hessian. */
      template <int degree>
      inline void
      add_hessian(const LagrangePoint<degree> &point,
                  const Hessian               &hessian,
                  const double                 length,
                  const double                 weight,
                  TangentSums<degree>         &tangent)
      {
        for (int b = 0; b <= degree; ++b)
          for (unsigned int l = 0; l < 3; ++l)
            for (unsigned int c = 0; c < 3; ++c)
              {
                // How the forces of all parts change with the block's
                // component.
                const double slope = weight * point.slope[b] / length,
                             value = weight * point.value[b];
                Fields change;
                for (unsigned int part = 0; part < n_parts; ++part)
                  {
                    change[part] = slope * hessian.columns[part][l][c];
                    if (l > 0)
                      change[part] += value * hessian.columns[part][l + 2][c];
                  }
                Lanes<4> *sums = tangent.columns[3 * b + l][c];
                for (int a = 0; a <= degree; ++a)
                  for (unsigned int k = 0; k < 3; ++k, ++sums)
                    {
                      *sums += point.slope[a] / length * change[k];
                      if (k > 0)
                        *sums += point.value[a] * change[k + 2];
                    }
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
    ElementKind
    DirectorElement<degree>::kind() const
    {
      return ElementKind::director;
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
          const Fields  p      = interpolate(point, blocks, length);
          const Fields  dp     = interpolate(point, increment, length);
          const Strains change = change_of_strains(p, dp);
          Strains       e      = elastic_strains(p, reference_strains);
          for (unsigned int i = 0; i < n_strains_at_point; ++i)
            e[i] += change[i];
          const Strains s = law.stresses(e);
          stresses        = std::copy(s.begin(), s.end(), stresses);
          reference_strains += n_strains_at_point;
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
      const Law                   law(section);
      std::array<Fields, degree>  fields;
      std::array<Strains, degree> stresses;
      double                      energy = 0.;
      for (int q = 0; q < degree; ++q)
        {
          const double weight = points[q].weight * length;
          fields[q]           = interpolate(points[q], blocks, length);
          const Strains e     = elastic_strains(
            fields[q], reference_strains + q * n_strains_at_point);
          stresses[q] = law.stresses(e);
          for (unsigned int i = 0; i < n_strains_at_point; ++i)
            energy += .5 * weight * e[i] * stresses[q][i];

          if (residual != nullptr)
            {
              Fields forces = forces_of(fields[q], stresses[q]);
              for (Lanes<4> &force : forces.parts)
                force *= weight;
              add_forces(points[q], forces, length, residual);
            }
        }
      if (tangent == nullptr)
        return energy;

      TangentSums<degree> sums;
      for (int q = 0; q < degree; ++q)
        {
          if (predicted_stresses != nullptr)
            std::copy_n(predicted_stresses + q * n_strains_at_point,
                        n_strains_at_point,
                        stresses[q].begin());
          const Hessian hessian(law, fields[q], stresses[q]);
          add_hessian(
            points[q], hessian, length, points[q].weight * length, sums);
        }
      sums.write(tangent);
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

      SectionState state;
      for (unsigned int q = first; q <= last; ++q)
        {
          const double part   = 1. / (last - first + 1);
          const Fields fields = interpolate(points[q], blocks, length);
          const auto   e =
            elastic_strains(fields, reference_strains + q * n_strains_at_point);
          const Strains s  = Law(section).stresses(e);
          const auto along = [&](const Lanes<4> &force, const Part direction) {
            const Lanes<4> &d        = fields[direction];
            const Lanes<4>  products = force * d, squares = d * d;
            return (products[0] + products[1] + products[2]) /
                   std::sqrt(squares[0] + squares[1] + squares[2]);
          };
          // The force in the section is the derivative by r': beside that of
          // axial and shear strain it has those of bending and twist, which
          // are as large where a fiber is bent.
          const Lanes<4> force = forces_of(fields, s)[t];
          state.axial_strain += part * e[0];
          state.axial_force += part * along(force, t);
          state.twist += part * e[8];
          state.torque += part * s[8];
          for (unsigned int a = 0; a < 2; ++a)
            {
              state.shear_strain[a] += part * e[1 + a];
              state.shear_force[a] += part * along(force, a == 0 ? g1 : g2);
              state.curvature[a] += part * e[6 + a];
              state.bending_moment[a] += part * s[6 + a];
            }
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
          const Strains s = Law(section).stresses(e);
          Strains       w;
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



    template <int degree>
    double
    DirectorElement<degree>::alignment(const Tensor<1, 3> *blocks,
                                       const double        length) const
    {
      double least = std::numeric_limits<double>::max();
      for (const auto &point : points)
        {
          const Fields p      = interpolate(point, blocks, length);
          const auto   vector = [&p](const unsigned int part) {
            return Tensor<1, 3>({p[part][0], p[part][1], p[part][2]});
          };
          least =
            std::min(least, vector(0) * cross_product_3d(vector(3), vector(4)));
        }
      return least;
    }



    template class DirectorElement<1>;
    template class DirectorElement<2>;
    template class DirectorElement<3>;
  } // namespace Beam
} // namespace Heddle
