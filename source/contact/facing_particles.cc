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



      /**
       * One number for each of n searches. Loops over them are short and of
       * known length: the compiler puts them into the lanes of one register.
       */
      template <unsigned int n>
      struct alignas(8 * n) Lanes
      {
        double lane[n];

        double &
        operator[](const unsigned int i)
        {
          return lane[i];
        }

        double
        operator[](const unsigned int i) const
        {
          return lane[i];
        }
      };



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
          curves[i] = &curve;
          load(i, curve.interval(s));
        }

        /** Set the points at the arc lengths @p s. */
        void
        evaluate(const Lanes<n> &s, LanePoints<n> &points)
        {
          Lanes<n> t;
          for (unsigned int i = 0; i < n; ++i)
            {
              const unsigned int there = curves[i]->interval(s[i], interval[i]);
              if (there != interval[i])
                load(i, there);
            }
          for (unsigned int i = 0; i < n; ++i)
            t[i] = s[i] - first[i];
          for (unsigned int d = 0; d < 3; ++d)
            for (unsigned int i = 0; i < n; ++i)
              {
                const double bent = c2[d][i] + t[i] * c3[d][i];
                const double more = bent + t[i] * c3[d][i];
                points.position[d][i] =
                  c0[d][i] + t[i] * (c1[d][i] + t[i] * bent);
                points.tangent[d][i]   = c1[d][i] + t[i] * (bent + more);
                points.curvature[d][i] = 2. * (more + t[i] * c3[d][i]);
              }
        }

      private:
        void
        load(const unsigned int i, const unsigned int new_interval)
        {
          interval[i]             = new_interval;
          first[i]                = curves[i]->arc_lengths[new_interval];
          const CurveCubic &cubic = curves[i]->cubic(new_interval);
          for (unsigned int d = 0; d < 3; ++d)
            {
              c0[d][i] = cubic.c0[d];
              c1[d][i] = cubic.c1[d];
              c2[d][i] = cubic.c2[d];
              c3[d][i] = cubic.c3[d];
            }
        }

        const Curve *curves[n];
        unsigned int interval[n];
        Lanes<n>     first, c0[3], c1[3], c2[3], c3[3];
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
      }



      template <unsigned int n>
      void
      FacingSearch<n>::set_places()
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            s_a[i] = 0.5 * (p[i] + q[i]);
            s_b[i] = 0.5 * sigma[i] * (p[i] - q[i]);
          }
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
          for (unsigned int i = 0; i < n; ++i)
            {
              connection[d][i] = a.position[d][i] - b.position[d][i];
              sum[d][i]        = a.tangent[d][i] + sigma[i] * b.tangent[d][i];
              bent[d][i]       = a.curvature[d][i] - b.curvature[d][i];
              force[i] += connection[d][i] * sum[d][i];
              convex[i] += 0.5 * sum[d][i] * sum[d][i];
              curved[i] += 0.5 * connection[d][i] * bent[d][i];
            }

        // Newton's method for the stationary distance; where the distance is
        // not convex, downhill with the stiffness of straight fibers.
        for (unsigned int i = 0; i < n; ++i)
          {
            const double least  = 0.2 * convex[i] + 1e-3;
            const double newton = convex[i] + curved[i];
            const double free   = -force[i] / std::max(newton, least);
            const double bounded =
              std::min(std::max(free, -scale[i]), scale[i]);
            const double next =
              std::min(std::max(q[i] + bounded, low[i]), high[i]);
            step[i] = next - q[i];
            short_by[i] =
              (newton > least ? last_step : last_step_downhill) * scale[i] -
              std::abs(step[i]);
          }

        // Who has arrived waits there, so that nobody's particles depend on
        // who is searched beside.
        bool all = true;
        for (unsigned int i = 0; i < n; ++i)
          {
            q[i] += has_arrived(i) ? 0. : step[i];
            all = all && has_arrived(i);
          }
        return all;
      }



      template <unsigned int n>
      void
      FacingSearch<n>::finish()
      {
        // What this leaves of third order is below round-off.
        Lanes<n> half;
        for (unsigned int i = 0; i < n; ++i)
          {
            half[i] = has_arrived(i) ? 0.5 * step[i] : 0.;
            q[i] += 2. * half[i];
          }
        set_places();
        for (unsigned int d = 0; d < 3; ++d)
          for (unsigned int i = 0; i < n; ++i)
            {
              connection[d][i] +=
                half[i] * sum[d][i] + 0.5 * half[i] * half[i] * bent[d][i];
              a.tangent[d][i] += half[i] * a.curvature[d][i];
              b.tangent[d][i] -= half[i] * sigma[i] * b.curvature[d][i];
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
