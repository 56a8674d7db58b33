#include <heddle/base/lanes.h>
#include <heddle/contact/facing_particles.h>
#include <heddle/contact/intermediate_geometry.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Contact
  {
    namespace
    {
      /**
       * So short a step of Newton's method, in radii, is the last one: what it
       * leaves is of second order ...
       */
      constexpr double last_step = 1e-6;

      /** ... but not where the stiffness is none of the distance. */
      constexpr double last_step_downhill = 1e-9;

      constexpr unsigned int max_iterations = 30;



      /** A point of each of n curves, with two derivatives in arc length. */
      template <unsigned int n>
      struct LanePoints
      {
        Lanes<n> position[3], tangent[3], curvature[3];
      };



      /** The cubics of n curves, each in the interval where it was last. */
      template <unsigned int n>
      class LaneCubics
      {
      public:
        void
        begin(const unsigned int i, const Curve &curve, const double s)
        {
          curves[i]   = &curve;
          interval[i] = curve.interval(s);
        }

        /** After all have begun: load their cubics. */
        void
        load()
        {
          for (unsigned int i = 0; i < n; ++i)
            {
              const double *knots = curves[i]->arc_lengths + interval[i];
              first[i]            = knots[0];
              length[i]           = knots[1] - knots[0];
            }
          for (unsigned int d = 0; d < 3; ++d)
            for (unsigned int i = 0; i < n; ++i)
              {
                const CurveCubic &cubic = curves[i]->cubic(interval[i]);
                c0[d][i]                = cubic.c0[d];
                c1[d][i]                = cubic.c1[d];
                c2[d][i]                = cubic.c2[d];
                c3[d][i]                = cubic.c3[d];
              }
        }

        /** Set the points at the arc lengths @p s. */
        void
        evaluate(const Lanes<n> &s, LanePoints<n> &points)
        {
          Lanes<n> t    = s - first;
          bool     left = false;
          for (unsigned int i = 0; i < n; ++i)
            left = left || t[i] < 0. || t[i] >= length[i];
          if (left)
            {
              for (unsigned int i = 0; i < n; ++i)
                interval[i] = curves[i]->interval(s[i], interval[i]);
              load();
              t = s - first;
            }
          for (unsigned int d = 0; d < 3; ++d)
            {
              const Lanes<n> bent = c2[d] + t * c3[d];
              const Lanes<n> more = bent + t * c3[d];
              points.position[d]  = c0[d] + t * (c1[d] + t * bent);
              points.tangent[d]   = c1[d] + t * (bent + more);
              points.curvature[d] = 2. * (more + t * c3[d]);
            }
        }

      private:
        const Curve *curves[n];
        unsigned int interval[n];
        Lanes<n>     first, length, c0[3], c1[3], c2[3], c3[3];
      };



      /** Which end of a fiber particles at s_a and s_b are, if any. */
      FacingEnd
      end_at(const IntermediateGeometry &between,
             const double                s_a,
             const double                s_b,
             const double                tolerance)
      {
        return s_a < tolerance                        ? FacingEnd::first_of_a
               : s_a > between.a.length() - tolerance ? FacingEnd::last_of_a
               : s_b < tolerance                      ? FacingEnd::first_of_b
               : s_b > between.b.length() - tolerance ? FacingEnd::last_of_b
                                                      : FacingEnd::none;
      }



      /** The search for the particles of n intermediate geometries at once. */
      template <unsigned int n>
      class FacingSearch
      {
      public:
        FacingSearch(const IntermediateGeometry *const *between,
                     const double                      *p,
                     const double                      *q);

        /** Make a step of Newton's method; return whether all have arrived. */
        bool
        advance();

        /** Make the last, short steps. */
        void
        finish();

        /** The particles of geometry @p i, and their q. */
        FacingParticles
        particles(const unsigned int i, double &q) const;

      private:
        void
        set_places();

        /** How far [mm] one may go where @p free is wanted. */
        void
        find_reach(const Lanes<n> &free, Lanes<n> &reach) const;

        /** Whether the next step is short, and the last one. */
        bool
        has_arrived(const unsigned int i) const
        {
          return short_by[i] > 0.;
        }

        const IntermediateGeometry *const *between;

        Lanes<n>      p, q, sigma, scale, low, high, s_a, s_b;
        LaneCubics<n> cubics_a, cubics_b;
        LanePoints<n> a, b;
        Lanes<n>      connection[3], sum[3], bent[3], step, short_by;
      };



      template <unsigned int n>
      FacingSearch<n>::FacingSearch(const IntermediateGeometry *const *between,
                                    const double                      *p,
                                    const double                      *q)
        : between(between)
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            const auto bounds = between[i]->range_of_q(p[i]);
            this->p[i]        = p[i];
            low[i]            = bounds.first;
            high[i]           = bounds.second;
            this->q[i]        = std::min(std::max(q[i], low[i]), high[i]);
            sigma[i]          = between[i]->orientation;
            scale[i]          = between[i]->a.radius + between[i]->b.radius;
          }
        set_places();
        for (unsigned int i = 0; i < n; ++i)
          {
            cubics_a.begin(i, between[i]->a, s_a[i]);
            cubics_b.begin(i, between[i]->b, s_b[i]);
          }
        cubics_a.load();
        cubics_b.load();
      }



      template <unsigned int n>
      void
      FacingSearch<n>::set_places()
      {
        s_a = 0.5 * (p + q);
        s_b = 0.5 * sigma * (p - q);
      }



      template <unsigned int n>
      void
      FacingSearch<n>::find_reach(const Lanes<n> &free, Lanes<n> &reach) const
      {
        reach = scale;
        for (unsigned int i = 0; i < n; ++i)
          if (std::abs(free[i]) > scale[i])
            reach[i] = std::max(scale[i],
                                0.5 * std::hypot(connection[0][i],
                                                 connection[1][i],
                                                 connection[2][i]));
      }



      template <unsigned int n>
      bool
      FacingSearch<n>::advance()
      {
        set_places();
        cubics_a.evaluate(s_a, a);
        cubics_b.evaluate(s_b, b);

        Lanes<n> force = {}, convex = {}, curved = {};
        for (unsigned int d = 0; d < 3; ++d)
          {
            connection[d] = a.position[d] - b.position[d];
            sum[d]        = a.tangent[d] + sigma * b.tangent[d];
            bent[d]       = a.curvature[d] - b.curvature[d];
            force += connection[d] * sum[d];
            convex += 0.5 * sum[d] * sum[d];
            curved += 0.5 * connection[d] * bent[d];
          }

        // Newton's method for the stationary distance; where the distance is
        // not convex, downhill with the stiffness of straight fibers. No step
        // is longer than fibers are thick or, from afar, half as far apart.
        const Lanes<n> least     = 0.2 * convex + 1e-3;
        const Lanes<n> newton    = convex + curved;
        const auto     is_convex = newton > least;
        const Lanes<n> free      = -force / (is_convex ? newton : least);
        Lanes<n>       reach;
        find_reach(free, reach);
        const Lanes<n> no_more  = free < reach ? free : reach;
        const Lanes<n> next     = q + (no_more > -reach ? no_more : -reach);
        const Lanes<n> below    = next < high ? next : high;
        step                    = (below > low ? below : low) - q;
        const Lanes<n> size     = step < 0. ? -step : step;
        const Lanes<n> last     = scale * last_step;
        const Lanes<n> downhill = scale * last_step_downhill;
        short_by                = (is_convex ? last : downhill) - size;

        // Who has arrived waits there, so that nobody's particles depend on
        // who is searched beside.
        q += short_by > 0. ? Lanes<n>{} : step;
        bool all = true;
        for (unsigned int i = 0; i < n; ++i)
          all = all && has_arrived(i);
        return all;
      }



      template <unsigned int n>
      void
      FacingSearch<n>::finish()
      {
        // What this leaves of third order is below round-off.
        const Lanes<n> half = short_by > 0. ? 0.5 * step : Lanes<n>{};
        q += 2. * half;
        set_places();
        for (unsigned int d = 0; d < 3; ++d)
          {
            connection[d] += half * sum[d] + 0.5 * half * half * bent[d];
            a.tangent[d] += half * a.curvature[d];
            b.tangent[d] -= half * sigma * b.curvature[d];
          }
      }



      template <unsigned int n>
      FacingParticles
      FacingSearch<n>::particles(const unsigned int i, double &found_q) const
      {
        const double    tolerance = 1e-9 * scale[i];
        FacingParticles found     = {};
        found.s_a                 = s_a[i];
        found.s_b                 = s_b[i];
        found.end = end_at(*between[i], s_a[i], s_b[i], tolerance);
        found_q   = q[i];

        // Along p both particles advance by half, but at the end of a fiber
        // only the other one does.
        double advance_a = 0.5, advance_b = 0.5 * sigma[i];
        if (found.end == FacingEnd::first_of_a ||
            found.end == FacingEnd::last_of_a)
          advance_a = 0., advance_b = sigma[i];
        else if (found.end != FacingEnd::none)
          advance_a = 1., advance_b = 0.;
        for (unsigned int d = 0; d < 3; ++d)
          {
            found.connection[d] = connection[d][i];
            found.squared_distance += connection[d][i] * connection[d][i];
            found.slope +=
              2. * connection[d][i] *
              (advance_a * a.tangent[d][i] - advance_b * b.tangent[d][i]);
          }

        // A fiber does not touch its own neighbourhood.
        if (between[i]->min_separation > 0. && sigma[i] > 0. &&
            q[i] > high[i] - tolerance)
          found.squared_distance = 1e6 * scale[i] * scale[i];
        return found;
      }
    } // namespace



    template <unsigned int n>
    void
    find_facing(const IntermediateGeometry *const *between,
                const double                      *p,
                double                            *q,
                FacingParticles                   *particles)
    {
      FacingSearch<n> search(between, p, q);
      for (unsigned int iteration = 0; iteration < max_iterations; ++iteration)
        if (search.advance())
          break;
      search.finish();
      for (unsigned int i = 0; i < n; ++i)
        particles[i] = search.particles(i, q[i]);
    }



    template void
    find_facing<1>(const IntermediateGeometry *const *,
                   const double *,
                   double *,
                   FacingParticles *);
    template void
    find_facing<4>(const IntermediateGeometry *const *,
                   const double *,
                   double *,
                   FacingParticles *);
  } // namespace Contact
} // namespace Heddle
