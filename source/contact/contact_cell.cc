#include <heddle/contact/contact_cell.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Heddle
{
  namespace Contact
  {
    namespace internal
    {
      namespace ContactCell
      {
        using GaussPoint = std::pair<double, double>;

        /** Places and weights of the elements of a stretch, from -1 to 1. */
        constexpr std::array<GaussPoint, 4> gauss_points = {
          {{-0.8611363115940526, 0.3478548451374538},
           {-0.3399810435848563, 0.6521451548625461},
           {0.3399810435848563, 0.6521451548625461},
           {0.8611363115940526, 0.3478548451374538}}};



        /** f(t) = c0 + c1 t + c2 t^2 + c3 t^3 for t in [0, 1]. */
        struct Cubic
        {
          double c0, c1, c2, c3;

          double
          operator()(const double t) const
          {
            return c0 + t * (c1 + t * (c2 + t * c3));
          }

          double
          slope(const double t) const
          {
            return c1 + t * (2. * c2 + t * 3. * c3);
          }
        };



        /**
         * Square of the distance between two ends, from 0 to 1: the cubic that
         * interpolates values and slopes.
         */
        Cubic
        squared_distance(const CellEnd &left, const CellEnd &right)
        {
          const double size = right.p - left.p;
          const double f0 = left.squared_distance, f1 = right.squared_distance,
                       m0 = size * left.slope, m1 = size * right.slope;
          return {
            f0, m0, 3. * (f1 - f0) - 2. * m0 - m1, 2. * (f0 - f1) + m0 + m1};
        }



        /** The least of the control polygon, which bounds the cubic. */
        double
        lower_bound(const Cubic &f)
        {
          const double f1 = f(1.);
          return std::min({f.c0, f.c0 + f.c1 / 3., f1 - f.slope(1.) / 3., f1});
        }



        /** Places in (0, 1) where the slope of the cubic vanishes, sorted. */
        unsigned int
        stationary_points(const Cubic &f, std::array<double, 2> &points)
        {
          const double a = 3. * f.c3, b = f.c2, c = f.c1;
          const double discriminant = b * b - a * c;
          unsigned int n            = 0;
          if (discriminant > 0.)
            {
              // The roots of a t^2 + 2 b t + c without cancellation.
              const double r = -(b + std::copysign(std::sqrt(discriminant), b));
              for (const double t : {c / r, r / a})
                if (t > 0. && t < 1.)
                  points[n++] = t;
              if (n == 2 && points[0] > points[1])
                std::swap(points[0], points[1]);
            }
          return n;
        }



        /** The root between @p low and @p high, where the signs differ. */
        double
        root_between(const Cubic &f, double low, double high)
        {
          const bool falls = f(low) > 0.;
          double     t     = 0.5 * (low + high);
          for (unsigned int iteration = 0; iteration < 60; ++iteration)
            {
              const double value                   = f(t);
              ((value > 0.) == falls ? low : high) = t;
              const double newton                  = t - value / f.slope(t);
              const double next =
                (newton > low && newton < high) ? newton : 0.5 * (low + high);
              if (std::abs(next - t) < 1e-14)
                return next;
              t = next;
            }
          return t;
        }
      } // namespace ContactCell
    }   // namespace internal



    CellEnd
    cell_end(const IntermediateGeometry &geometry,
             const double                p,
             const double                q)
    {
      double                found     = q;
      const FacingParticles particles = geometry.facing(p, found);
      return {
        p, found, particles.squared_distance, particles.slope, particles.end};
    }



    std::array<CellEnd, n_ends_at_once>
    cell_ends(const std::array<const IntermediateGeometry *, n_ends_at_once>
                                                       &geometries,
              const std::array<double, n_ends_at_once> &p,
              std::array<double, n_ends_at_once>        q)
    {
      std::array<FacingParticles, n_ends_at_once> particles;
      std::array<CellEnd, n_ends_at_once>         ends;
      find_facing<n_ends_at_once>(
        geometries.data(), p.data(), q.data(), particles.data());
      for (unsigned int i = 0; i < n_ends_at_once; ++i)
        ends[i] = {p[i],
                   q[i],
                   particles[i].squared_distance,
                   particles[i].slope,
                   particles[i].end};
      return ends;
    }



    double
    least_distance(const IntermediateGeometry &geometry,
                   const CellEnd              &begin,
                   const CellEnd              &end)
    {
      // Where the end of a fiber comes to face the distance has a kink, but it
      // changes by no more than p.
      if (begin.end != end.end)
        return 0.5 * (std::sqrt(begin.squared_distance) +
                      std::sqrt(end.squared_distance) - (end.p - begin.p));
      const double bound = internal::ContactCell::lower_bound(
        internal::ContactCell::squared_distance(begin, end));
      // Curved fibers come a little closer than the cubic says.
      return std::sqrt(std::max(0., bound)) -
             0.2 * (geometry.a.radius + geometry.b.radius);
    }



    namespace
    {
      /** Places the elements of one cell. */
      class CellFiller
      {
      public:
        CellFiller(const IntermediateGeometry  &geometry,
                   const double                 distance_at_contact,
                   const double                 skin,
                   const bool                   aligned,
                   std::vector<ContactElement> &elements)
          : geometry(geometry)
          , aligned(aligned)
          , distance_at_contact(distance_at_contact)
          , reach(distance_at_contact + skin)
          , elements(elements)
        {
        }

        /** Fill a cell, cut where the end of a fiber comes to face. */
        void
        fill(const CellEnd &begin, const CellEnd &end);

        double deepest = 0.;

      private:
        /**
         * Draw two ends of a part, at which different ends of fibers face,
         * together to where that changes.
         */
        void
        find_kink(CellEnd &low, CellEnd &high) const;

        /** The end of the other fiber that is next to this one, if any. */
        FacingEnd
        beside(const FacingEnd end) const;

        /** Fill a part in which no end begins to face. */
        void
        fill_smooth(const CellEnd &begin, const CellEnd &end);

        /** Place the elements of the overlap between p = low and p = high. */
        void
        fill_stretch(const CellEnd &begin,
                     const CellEnd &end,
                     const double   low,
                     const double   high);

        /** Set the elements at n places @p p, between two ends. */
        template <unsigned int n>
        void
        find_elements(const CellEnd  &begin,
                      const CellEnd  &end,
                      const double   *p,
                      ContactElement *found) const;

        const IntermediateGeometry  &geometry;
        const bool                   aligned;
        const double                 distance_at_contact;
        const double                 reach;
        std::vector<ContactElement> &elements;
      };



      template <unsigned int n>
      void
      CellFiller::find_elements(const CellEnd  &begin,
                                const CellEnd  &end,
                                const double   *p,
                                ContactElement *found) const
      {
        const IntermediateGeometry *between[n];
        double                      q[n];
        FacingParticles             particles[n];
        for (unsigned int i = 0; i < n; ++i)
          {
            const double t = (p[i] - begin.p) / (end.p - begin.p);
            between[i]     = &geometry;
            q[i]           = begin.q + t * (end.q - begin.q);
          }
        find_facing<n>(between, p, q, particles);
        for (unsigned int i = 0; i < n; ++i)
          {
            const double distance = std::sqrt(particles[i].squared_distance);
            found[i]              = {};
            found[i].s_a          = particles[i].s_a;
            found[i].s_b          = particles[i].s_b;
            found[i].gap          = distance - distance_at_contact;
            found[i].normal       = particles[i].connection / distance;
          }
      }



      void
      CellFiller::fill(const CellEnd &begin, const CellEnd &end)
      {
        const double size = end.p - begin.p;
        CellEnd      from = begin;
        if (begin.end != end.end)
          {
            // The distance changes by no more than p: is there an overlap?
            if (std::sqrt(begin.squared_distance) +
                  std::sqrt(end.squared_distance) - size >
                2. * reach)
              return;
            for (unsigned int cut = 0; cut < 3 && from.end != end.end; ++cut)
              {
                CellEnd low = from, high = end;
                find_kink(low, high);
                if (low.p - from.p > 1e-9 * size)
                  fill_smooth(from, low);
                from = high;
              }
          }
        if (end.p - from.p > 1e-9 * size)
          fill_smooth(from, end);
      }



      FacingEnd
      CellFiller::beside(const FacingEnd end) const
      {
        const bool same = geometry.orientation > 0;
        switch (end)
          {
            case FacingEnd::first_of_a:
              return same ? FacingEnd::first_of_b : FacingEnd::last_of_b;
            case FacingEnd::last_of_a:
              return same ? FacingEnd::last_of_b : FacingEnd::first_of_b;
            case FacingEnd::first_of_b:
              return same ? FacingEnd::first_of_a : FacingEnd::last_of_a;
            case FacingEnd::last_of_b:
              return same ? FacingEnd::last_of_a : FacingEnd::first_of_a;
            default:
              return FacingEnd::none;
          }
      }



      void
      CellFiller::find_kink(CellEnd &low, CellEnd &high) const
      {
        const FacingEnd before = low.end;
        const double    close  = 1e-8 * (geometry.a.radius + geometry.b.radius);

        // Where fibers end side by side it is at the end of the cell, and
        // either of them may come first.
        const std::array<FacingEnd, 7> ends = {{high.end,
                                                before,
                                                beside(high.end),
                                                FacingEnd::first_of_a,
                                                FacingEnd::last_of_a,
                                                FacingEnd::first_of_b,
                                                FacingEnd::last_of_b}};
        for (auto end = ends.begin(); end != ends.end(); ++end)
          if (*end != FacingEnd::none &&
              std::find(ends.begin(), end, *end) == end &&
              high.p - low.p > 4. * close)
            {
              const double guess = geometry.kink(*end, 0.5 * (low.p + high.p));
              const double kink =
                std::min(std::max(guess, low.p + close), high.p - close);
              const double t      = (kink - low.p) / (high.p - low.p);
              const double q      = low.q + t * (high.q - low.q);
              const double left_p = kink - close, right_p = kink + close;
              const auto   sides =
                cell_ends({{&geometry, &geometry, &geometry, &geometry}},
                          {{left_p, right_p, left_p, right_p}},
                          {{q, q, q, q}});
              const CellEnd &left = sides[0], &right = sides[1];
              if (left.end == before && right.end != before)
                {
                  low   = left;
                  high  = right;
                  low.p = high.p = kink;
                  return;
                }
            }

        // Several changes in one part.
        for (unsigned int step = 0; step < 45; ++step)
          {
            const CellEnd middle = cell_end(
              geometry, 0.5 * (low.p + high.p), 0.5 * (low.q + high.q));
            (middle.end == before ? low : high) = middle;
          }
      }



      void
      CellFiller::fill_smooth(const CellEnd &begin, const CellEnd &end)
      {
        using namespace internal::ContactCell;
        Cubic f = squared_distance(begin, end);
        f.c0 -= reach * reach;

        // Curved fibers come a little closer than the cubic says.
        const double allowance = 0.2 * reach * distance_at_contact;
        if (lower_bound(f) >= allowance)
          return;

        for (const CellEnd *side : {&begin, &end})
          deepest = std::max(
            deepest, distance_at_contact - std::sqrt(side->squared_distance));
        if (aligned && begin.end == FacingEnd::none)
          {
            fill_stretch(begin, end, begin.p, end.p);
            return;
          }

        // Walk over the monotone pieces and collect stretches with f < 0.
        std::array<double, 2> stationary;
        const unsigned int    n_pieces = stationary_points(f, stationary) + 1;
        const double          size     = end.p - begin.p;
        bool                  inside   = f.c0 < 0.;
        double                from = begin.p, low = 0.;
        for (unsigned int piece = 0; piece < n_pieces; ++piece)
          {
            const double high = piece + 1 < n_pieces ? stationary[piece] : 1.;
            if ((f(high) < 0.) != inside)
              {
                const double at = begin.p + root_between(f, low, high) * size;
                if (inside)
                  fill_stretch(begin, end, from, at);
                from   = at;
                inside = !inside;
              }
            low = high;
          }
        if (inside)
          fill_stretch(begin, end, from, end.p);
        for (unsigned int k = 0; k + 1 < n_pieces; ++k)
          if (f(stationary[k]) < 0.)
            {
              const double   p = begin.p + stationary[k] * size;
              ContactElement there;
              find_elements<1>(begin, end, &p, &there);
              deepest = std::max(deepest, -there.gap);
            }
      }



      void
      CellFiller::fill_stretch(const CellEnd &begin,
                               const CellEnd &end,
                               const double   low,
                               const double   high)
      {
        using internal::ContactCell::gauss_points;
        constexpr unsigned int n_points = gauss_points.size();
        const double           half     = 0.5 * (high - low);
        double                 p[n_points];
        ContactElement         found[n_points];
        for (unsigned int i = 0; i < n_points; ++i)
          p[i] = low + half * (1. + gauss_points[i].first);
        find_elements<n_points>(begin, end, p, found);
        for (unsigned int i = 0; i < n_points; ++i)
          {
            // p measures twice the length of the intermediate curve.
            found[i].weight = 0.5 * gauss_points[i].second * half;
            deepest         = std::max(deepest, -found[i].gap);
            if (found[i].gap < reach - distance_at_contact)
              elements.push_back(found[i]);
          }
      }
    } // namespace



    double
    place_in_cell(const IntermediateGeometry  &geometry,
                  const CellEnd               &begin,
                  const CellEnd               &end,
                  const double                 distance_at_contact,
                  const double                 skin,
                  const bool                   aligned,
                  std::vector<ContactElement> &elements)
    {
      CellFiller filler(geometry, distance_at_contact, skin, aligned, elements);
      filler.fill(begin, end);
      return filler.deepest;
    }
  } // namespace Contact
} // namespace Heddle
