#ifndef heddle_beam_director_point_h
#define heddle_beam_director_point_h

#include <heddle/base/lanes.h>
#include <heddle/beam/element.h>

#include <array>
#include <utility>

namespace Heddle
{
  namespace Beam
  {
    /**
     * What the director element computes at one integration point, whatever
     * its degree: strains, section law, forces and their derivatives, by the
     * vectors r', g_1', g_2', g_1 and g_2 there. See DirectorElement for the
     * strains and their source.
     */
    namespace DirectorPoint
    {
      /** Strains per integration point. */
      inline constexpr unsigned int n_strains_at_point = 12;

      /**
       * The vectors that the strains are made of: r', g_1', g_2', g_1, g_2. The
       * derivative of block k of a node is part k, its value part k + 2.
       */
      enum Part : unsigned int
      {
        t,
        d1,
        d2,
        g1,
        g2
      };

      inline constexpr unsigned int n_parts = 5;

      struct Fields
      {
        Lanes<4> parts[n_parts];

        Lanes<4> &
        operator[](const unsigned int part)
        {
          return parts[part];
        }

        const Lanes<4> &
        operator[](const unsigned int part) const
        {
          return parts[part];
        }
      };

      using Strains = std::array<double, n_strains_at_point>;

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



        Strains
        stresses(const Strains &strains) const
        {
          Strains result;
          for (unsigned int i = 0; i < n_strains_at_point; ++i)
            result[i] = diagonal[i] * strains[i];
          result[0] += coupling * (strains[3] + strains[4]);
          result[3] += coupling * strains[0] + lambda * strains[4];
          result[4] += coupling * strains[0] + lambda * strains[3];
          return result;
        }

        double  lambda;
        double  coupling;
        Strains diagonal;
      };



      /**
       * Derivative of the strains at @p p in the direction @p q: a bilinear
       * form, and a symmetric one, for strains are quadratic.
       */
      inline Strains
      change_of_strains(const Fields &p, const Fields &q)
      {
        const auto dot = [&](const Part a, const Part b) {
          const Lanes<4> products = p[a] * q[b];
          return products[0] + products[1] + products[2];
        };
        const auto both = [&](const Part a, const Part b) {
          return dot(a, b) + dot(b, a);
        };
        const double g1_d2 = both(g1, d2);
        const double g2_d1 = both(g2, d1);
        return {{dot(t, t),
                 both(t, g1),
                 both(t, g2),
                 dot(g1, g1),
                 dot(g2, g2),
                 both(g1, g2),
                 both(t, d1),
                 both(t, d2),
                 .5 * (g2_d1 - g1_d2),
                 both(g1, d1),
                 both(g2, d2),
                 .5 * (g1_d2 + g2_d1)}};
      }



      inline Strains
      strains_of(const Fields &p)
      {
        Strains strains = change_of_strains(p, p);
        for (const unsigned int square : {0, 3, 4})
          strains[square] -= 1.;
        for (double &strain : strains)
          strain *= .5;
        return strains;
      }



      /** One number for each pair of the five vectors. */
      using PairsOfParts = std::array<std::array<double, n_parts>, n_parts>;



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
        for (unsigned int a = 0; a < n_parts; ++a)
          for (unsigned int b = 0; b < n_parts; ++b)
            forces[a] += factors[a][b] * p[b];
        return forces;
      }



      /**
       * The derivatives of the forces of one point: a 3x3 block, column by
       * column, for each pair of parts.
       */
      class Hessian
      {
      public:
        /** Set B^T C B + G(stresses). */
        Hessian(const Law &law, const Fields &p, const Strains &stresses)
          : p(p)
        {
          const PairsOfParts geometric = second_derivatives(stresses);
          for (unsigned int a = 0; a < n_parts; ++a)
            for (unsigned int b = 0; b < n_parts; ++b)
              {
                const double factor = geometric[a][b];
                columns[a][b][0]    = Lanes<4>{factor, 0., 0., 0.};
                columns[a][b][1]    = Lanes<4>{0., factor, 0., 0.};
                columns[a][b][2]    = Lanes<4>{0., 0., factor, 0.};
              }

          const Strains &c = law.diagonal;
          add_square(t, c[0]);
          add_square({t, g1}, c[1]);
          add_square({t, g2}, c[2]);
          add_square(g1, c[3]);
          add_square(g2, c[4]);
          add_square({g1, g2}, c[5]);
          add_square({t, d1}, c[6]);
          add_square({t, d2}, c[7]);
          add_square({g1, d1}, c[9]);
          add_square({g2, d2}, c[10]);
          add_mixed(t, g1, law.coupling);
          add_mixed(t, g2, law.coupling);
          add_mixed(g1, g2, law.lambda);

          // Twist and gradient of the shear are half the difference and half
          // the sum of two products.
          add_square({g1, d2}, .25 * (c[8] + c[11]));
          add_square({g2, d1}, .25 * (c[8] + c[11]));
          add_mixed({g1, d2}, {g2, d1}, .25 * (c[11] - c[8]));
        }

        Lanes<4> columns[n_parts][n_parts][3];

      private:
        /** Two parts whose product is a strain. */
        struct Product
        {
          Part a, b;
        };

        /** Add factor x y^T, x and y being parts, to the block (a, b). */
        void
        add_dyad(const Part   a,
                 const Part   b,
                 const double factor,
                 const Part   x,
                 const Part   y)
        {
          const Lanes<4> scaled = factor * p[x];
          for (unsigned int c = 0; c < 3; ++c)
            columns[a][b][c] += scaled * p[y][c];
        }

        /** Add the square of the gradient of half the square of a part. */
        void
        add_square(const Part a, const double factor)
        {
          add_dyad(a, a, factor, a, a);
        }

        /** ... and of the product of two. */
        void
        add_square(const Product &one, const double factor)
        {
          add_dyad(one.a, one.a, factor, one.b, one.b);
          add_dyad(one.a, one.b, factor, one.b, one.a);
          add_dyad(one.b, one.a, factor, one.a, one.b);
          add_dyad(one.b, one.b, factor, one.a, one.a);
        }

        /** The gradients of two half squares, each times the other. */
        void
        add_mixed(const Part a, const Part b, const double factor)
        {
          add_dyad(a, b, factor, a, b);
          add_dyad(b, a, factor, b, a);
        }

        /** ... and of two products. */
        void
        add_mixed(const Product &one, const Product &other, const double factor)
        {
          for (const auto &[at, by] : {std::pair(one.a, one.b), {one.b, one.a}})
            for (const auto &[there, by_there] :
                 {std::pair(other.a, other.b), {other.b, other.a}})
              {
                add_dyad(at, there, factor, by, by_there);
                add_dyad(there, at, factor, by_there, by);
              }
        }

        const Fields &p;
      };
    } // namespace DirectorPoint
  }   // namespace Beam
} // namespace Heddle

#endif
