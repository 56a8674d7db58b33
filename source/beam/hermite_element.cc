#include <heddle/beam/hermite_element.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace Heddle
{
  namespace Beam
  {
    namespace
    {
      constexpr unsigned int n_unknowns = 12;
      constexpr unsigned int n_axial    = 3;
      constexpr unsigned int n_bending  = 2;

      constexpr std::array<double, n_axial> axial_weight{
        {1. / 6., 4. / 6., 1. / 6.}};
      constexpr std::array<double, n_bending> bending_weight{{.5, .5}};

      /** 1/sqrt(3): the Gauss points on the interval from -1 to 1. */
      constexpr double gauss_point = 0.57735026918962576;

      /** Width of the rounding of the kink, relative to the curvature. */
      constexpr double rounding = 1e-2;

      /** Turn over an element below which the reference is straight. */
      constexpr double smallest_turn = 1e-8;

      /** Factors of the blocks r_1, t_1, r_2, t_2 in a linear combination. */
      using Factors = std::array<double, 4>;



      /** r' at the first node, in the middle, at the second node. */
      inline std::array<Factors, n_axial>
      tangent_factors(const double length)
      {
        const double middle = 1.5 / length;
        return {{{{0., 1., 0., 0.}},
                 {{-middle, -.25, middle, -.25}},
                 {{0., 0., 0., 1.}}}};
      }



      /** r'' at the two Gauss points. */
      inline std::array<Factors, n_bending>
      curvature_factors(const double length)
      {
        const double                   inverse = 1. / length;
        std::array<Factors, n_bending> factors;
        for (unsigned int q = 0; q < n_bending; ++q)
          {
            const double x   = q == 0 ? -gauss_point : gauss_point;
            const double way = 6. * x * inverse * inverse;
            factors[q]       = {
                    {way, (3. * x - 1.) * inverse, -way, (3. * x + 1.) * inverse}};
          }
        return factors;
      }



      inline Tensor<1, 3>
      combine(const Factors &factors, const Tensor<1, 3> *blocks)
      {
        Tensor<1, 3> sum;
        for (unsigned int i = 0; i < 3; ++i)
          sum[i] = factors[0] * blocks[0][i] + factors[1] * blocks[1][i] +
                   factors[2] * blocks[2][i] + factors[3] * blocks[3][i];
        return sum;
      }



      inline double
      axial_strain(const Tensor<1, 3> &tangent)
      {
        return .5 * (tangent * tangent - 1.);
      }



      /** Rounded magnitude of a curvature over a reference magnitude. */
      class RoundedCurvature
      {
      public:
        RoundedCurvature(const double reference, const double length)
          : magnitude(reference * length < smallest_turn ? 0. : reference)
          , rest(magnitude * std::sqrt(1. + rounding * rounding))
        {
        }

        /** Return m(x). */
        double
        value(const Tensor<1, 3> &x) const
        {
          return std::sqrt(x * x + rounding * rounding * magnitude * magnitude);
        }

        /** Return m - m_0, the elastic strain where m(x) is @p m. */
        double
        strain(const double m) const
        {
          return m - rest;
        }

        /** Return m_0 / m, and zero for a straight reference. */
        double
        ratio(const double m) const
        {
          return rest > 0. ? rest / m : 0.;
        }

      private:
        double magnitude;
        double rest;
      };



      inline void
      add_residual(const Factors      &factors,
                   const Tensor<1, 3> &force,
                   double             *residual)
      {
        for (unsigned int a = 0; a < 4; ++a)
          for (unsigned int i = 0; i < 3; ++i)
            residual[3 * a + i] += factors[a] * force[i];
      }



      /** The tangent of an element, as a sum over its points. */
      class Tangent
      {
      public:
        /** Begin with zeros in @p tangent, of 12 x 12 numbers. */
        explicit Tangent(double *tangent)
          : values(tangent)
        {
          values.setZero();
        }

        /**
         * Add that of an energy density with the second derivative
         * @p isotropic I + @p along x x^T in the vector x that @p factors make.
         */
        void
        add(const Factors      &factors,
            const Tensor<1, 3> &x,
            const double        isotropic,
            const double        along)
        {
          for (unsigned int a = 0; a < 4; ++a)
            for (unsigned int b = 0; b < 4; ++b)
              identities[a][b] += isotropic * factors[a] * factors[b];
          if (along == 0.)
            return;

          Eigen::Matrix<double, n_unknowns, 1> direction;
          for (unsigned int a = 0; a < 4; ++a)
            for (unsigned int i = 0; i < 3; ++i)
              direction[3 * a + i] = factors[a] * x[i];
          values.noalias() += (along * direction) * direction.transpose();
        }

        /** The same where the vector is the block @p a itself. */
        void
        add_to_block(const unsigned int  a,
                     const Tensor<1, 3> &x,
                     const double        isotropic,
                     const double        along)
        {
          identities[a][a] += isotropic;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              values(3 * a + i, 3 * a + j) += along * x[i] * x[j];
        }

        /** Add what is isotropic, at last and once for all points. */
        void
        end()
        {
          for (unsigned int a = 0; a < 4; ++a)
            for (unsigned int b = 0; b < 4; ++b)
              for (unsigned int i = 0; i < 3; ++i)
                values(3 * a + i, 3 * b + i) += identities[a][b];
        }

      private:
        Eigen::Map<Eigen::Matrix<double, n_unknowns, n_unknowns>> values;
        std::array<Factors, 4>                                    identities{};
      };



      inline double
      assemble_axial(const Section      &section,
                     const Tensor<1, 3> *blocks,
                     const double        length,
                     const double       *reference_strains,
                     const double       *predicted_stresses,
                     double             *residual,
                     Tangent            *tangent)
      {
        const Factors in_the_middle = tangent_factors(length)[1];
        double        energy        = 0.;
        for (unsigned int q = 0; q < n_axial; ++q)
          {
            // At a node r' is an unknown: that block.
            const bool         at_node = q != 1;
            const unsigned int block   = q == 0 ? 1 : 3;
            const Tensor<1, 3> x =
              at_node ? blocks[block] : combine(in_the_middle, blocks);
            const double weight = axial_weight[q] * length;
            const double strain = axial_strain(x) - reference_strains[q];
            const double stress = section.axial * strain;
            energy += .5 * weight * stress * strain;
            if (residual != nullptr && at_node)
              for (unsigned int i = 0; i < 3; ++i)
                residual[3 * block + i] += weight * stress * x[i];
            else if (residual != nullptr)
              add_residual(in_the_middle, weight * stress * x, residual);
            if (tangent == nullptr)
              continue;
            const double isotropic =
              weight *
              (predicted_stresses != nullptr ? predicted_stresses[q] : stress);
            const double along = weight * section.axial;
            if (at_node)
              tangent->add_to_block(block, x, isotropic, along);
            else
              tangent->add(in_the_middle, x, isotropic, along);
          }
        return energy;
      }



      /** The force is EI (1 - m_0/m) x, of derivative along x EI m_0/m^3. */
      inline double
      assemble_bending(const Section      &section,
                       const Tensor<1, 3> *blocks,
                       const double        length,
                       const double       *reference_curvatures,
                       double             *residual,
                       Tangent            *tangent)
      {
        const auto factors = curvature_factors(length);
        double     energy  = 0.;
        for (unsigned int q = 0; q < n_bending; ++q)
          {
            const RoundedCurvature curvature(reference_curvatures[q], length);
            const Tensor<1, 3>     x = combine(factors[q], blocks);
            const double           stiffness =
              bending_weight[q] * length * section.bending;
            const double m      = curvature.value(x);
            const double strain = curvature.strain(m);
            const double ratio  = curvature.ratio(m);
            energy += .5 * stiffness * strain * strain;
            if (residual != nullptr)
              add_residual(factors[q], stiffness * (1. - ratio) * x, residual);
            if (tangent != nullptr)
              tangent->add(factors[q],
                           x,
                           stiffness * (1. - ratio),
                           ratio > 0. ? stiffness * ratio / (m * m) : 0.);
          }
        return energy;
      }
    } // namespace



    ElementKind
    HermiteElement::kind() const
    {
      return ElementKind::hermite;
    }



    unsigned int
    HermiteElement::n_nodes() const
    {
      return 2;
    }



    unsigned int
    HermiteElement::n_blocks_per_node() const
    {
      return 2;
    }



    unsigned int
    HermiteElement::n_strains() const
    {
      return n_axial + n_bending;
    }



    void
    HermiteElement::strains(const Tensor<1, 3> *blocks,
                            const double        length,
                            double             *strains) const
    {
      for (const Factors &factors : tangent_factors(length))
        *strains++ = axial_strain(combine(factors, blocks));
      for (const Factors &factors : curvature_factors(length))
        *strains++ = combine(factors, blocks).norm();
    }



    void
    HermiteElement::predict_stresses(const Section      &section,
                                     const Tensor<1, 3> *blocks,
                                     const Tensor<1, 3> *increment,
                                     const double        length,
                                     const double       *reference_strains,
                                     double             *stresses) const
    {
      for (const Factors &factors : tangent_factors(length))
        {
          const Tensor<1, 3> x = combine(factors, blocks);
          *stresses++ =
            section.axial * (axial_strain(x) - *reference_strains++ +
                             x * combine(factors, increment));
        }
      for (const Factors &factors : curvature_factors(length))
        {
          const RoundedCurvature curvature(*reference_strains++, length);
          *stresses++ =
            section.bending *
            curvature.strain(curvature.value(combine(factors, blocks) +
                                             combine(factors, increment)));
        }
    }



    double
    HermiteElement::assemble(const Section      &section,
                             const Tensor<1, 3> *blocks,
                             const double        length,
                             const double       *reference_strains,
                             const double       *predicted_stresses,
                             double             *residual,
                             double             *tangent) const
    {
      if (residual != nullptr)
        std::fill_n(residual, n_unknowns, 0.);
      std::optional<Tangent> sum;
      if (tangent != nullptr)
        sum.emplace(tangent);
      Tangent *const into = sum ? &*sum : nullptr;

      const double energy =
        assemble_axial(section,
                       blocks,
                       length,
                       reference_strains,
                       predicted_stresses,
                       residual,
                       into) +
        assemble_bending(
          section, blocks, length, reference_strains + n_axial, residual, into);
      if (sum)
        sum->end();
      return energy;
    }



    Element::SectionState
    HermiteElement::section_state(const Section      &section,
                                  const Tensor<1, 3> *blocks,
                                  const double        length,
                                  const double       *reference_strains) const
    {
      const Tensor<1, 3> tangent = combine(tangent_factors(length)[1], blocks);
      SectionState       state;
      state.axial_strain = axial_strain(tangent) - reference_strains[1];

      // Values of bending are the mean of two points, so that the reference
      // itself gives zero. With the derivative of its energy by r'', M = m r''
      // / |r''|, the force in the section is n = N r' - M'.
      Tensor<1, 3> force   = (section.axial * state.axial_strain) * tangent;
      const auto   factors = curvature_factors(length);
      for (unsigned int q = 0; q < n_bending; ++q)
        {
          const RoundedCurvature curvature(reference_strains[n_axial + q],
                                           length);
          const Tensor<1, 3>     bend   = combine(factors[q], blocks);
          const double           m      = curvature.value(bend);
          const double           strain = curvature.strain(m);
          state.curvature[0] += bending_weight[q] * strain;
          if (m > 0.)
            force += (q == 0 ? 1. : -1.) / (gauss_point * length) *
                     section.bending * strain / m * bend;
        }
      const Tensor<1, 3> axis = tangent / tangent.norm();
      state.axial_force       = force * axis;
      state.shear_force[0]    = (force - state.axial_force * axis).norm();
      state.bending_moment[0] = section.bending * state.curvature[0];
      return state;
    }



    Element::EnergySplit
    HermiteElement::energy_split(const Section      &section,
                                 const Tensor<1, 3> *blocks,
                                 const double        length,
                                 const double       *reference_strains) const
    {
      EnergySplit split;
      split.axial   = assemble_axial(section,
                                   blocks,
                                   length,
                                   reference_strains,
                                   /*predicted_stresses=*/nullptr,
                                   /*residual=*/nullptr,
                                   /*tangent=*/nullptr);
      split.bending = assemble_bending(section,
                                       blocks,
                                       length,
                                       reference_strains + n_axial,
                                       /*residual=*/nullptr,
                                       /*tangent=*/nullptr);
      return split;
    }



    double
    HermiteElement::alignment(const Tensor<1, 3> *blocks,
                              const double        length) const
    {
      const Tensor<1, 3> chord  = (blocks[2] - blocks[0]) / length,
                         mean   = 0.5 * (blocks[1] + blocks[3]),
                         middle = 1.5 * chord - 0.5 * mean;
      return std::min(chord * mean, middle * mean);
    }
  } // namespace Beam
} // namespace Heddle
