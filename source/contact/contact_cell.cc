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
        /** Places and weights of the elements of a stretch, from -1 to 1. */
        constexpr std::array<std::pair<double, double>, 4> gauss_points = {
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
      CellEnd               end{p, q, 0., 0., FacingEnd::none};
      const FacingParticles particles = geometry.facing(p, end.q);
      end.squared_distance            = particles.squared_distance;
      end.slope                       = particles.slope;
      end.end                         = particles.end;
      return end;
    }



    namespace
    {
      /** One element at @p p; returns its gap. */
      double
      place_element(const IntermediateGeometry  &geometry,
                    const double                 p,
                    double                       q,
                    const double                 weight,
                    std::vector<ContactElement> &elements)
      {
        const FacingParticles particles = geometry.facing(p, q);
        ContactElement        element   = {};
        const double          distance  = std::sqrt(particles.squared_distance);
        element.s_a                     = particles.s_a;
        element.s_b                     = particles.s_b;
        element.weight                  = weight;
        element.gap    = distance - geometry.a.radius - geometry.b.radius;
        element.normal = particles.connection / distance;
        elements.push_back(element);
        return element.gap;
      }
    } // namespace



    namespace
    {
      /** The same within a cell in which no end of a fiber begins to face. */
      double
      place_in_smooth_cell(const IntermediateGeometry  &geometry,
                           const CellEnd               &begin,
                           const CellEnd               &end,
                           std::vector<ContactElement> &elements)
      {
        using namespace internal::ContactCell;
        const double size  = end.p - begin.p;
        const double reach = geometry.a.radius + geometry.b.radius;
        const double f0    = begin.squared_distance - reach * reach,
                     f1    = end.squared_distance - reach * reach,
                     m0 = size * begin.slope, m1 = size * end.slope;

        // The control polygon bounds the cubic: most cells end here.
        if (std::min({f0, f0 + m0 / 3., f1 - m1 / 3., f1}) >= 0.)
          return 0.;
        const Cubic f = {
          f0, m0, 3. * (f1 - f0) - 2. * m0 - m1, 2. * (f0 - f1) + m0 + m1};

        std::array<double, 2> stationary;
        const unsigned int    n_stationary = stationary_points(f, stationary);
        double                deepest      = 0.;
        const auto            guess        = [&](const double t) {
          return begin.q + t * (end.q - begin.q);
        };

        // Walk over the monotone pieces and collect stretches with f < 0.
        double stretch_begin = 0., low = 0.;
        bool   inside = f0 < 0.;
        for (unsigned int piece = 0; piece <= n_stationary; ++piece)
          {
            const double high = piece < n_stationary ? stationary[piece] : 1.;
            const bool   ends = piece == n_stationary;
            double       stretch_end = high;
            bool         complete    = inside && ends;
            if ((f(high) < 0.) != inside)
              {
                const double root = root_between(f, low, high);
                if (inside)
                  {
                    stretch_end = root;
                    complete    = true;
                  }
                else
                  {
                    stretch_begin = root;
                    complete      = ends;
                  }
                inside = !inside;
              }
            if (complete)
              {
                const double middle = 0.5 * (stretch_begin + stretch_end);
                const double half   = 0.5 * (stretch_end - stretch_begin);
                for (const auto &point : gauss_points)
                  {
                    const double t = middle + point.first * half;
                    // p measures twice the length of the intermediate curve.
                    deepest =
                      std::max(deepest,
                               -place_element(geometry,
                                              begin.p + t * size,
                                              guess(t),
                                              0.5 * point.second * half * size,
                                              elements));
                  }
              }
            low = high;
          }

        for (unsigned int k = 0; k < n_stationary; ++k)
          if (f(stationary[k]) < 0.)
            {
              double                q = guess(stationary[k]);
              const FacingParticles particles =
                geometry.facing(begin.p + stationary[k] * size, q);
              deepest = std::max(deepest,
                                 reach - std::sqrt(particles.squared_distance));
            }
        for (const CellEnd *cell_end : {&begin, &end})
          deepest =
            std::max(deepest, reach - std::sqrt(cell_end->squared_distance));
        return deepest;
      }
    } // namespace



    double
    place_elements(const IntermediateGeometry  &geometry,
                   const CellEnd               &begin,
                   const CellEnd               &end,
                   std::vector<ContactElement> &elements)
    {
      const double size    = end.p - begin.p;
      double       deepest = 0.;
      CellEnd      from    = begin;
      if (begin.end != end.end)
        {
          // The distance changes by no more than p: is there an overlap?
          if (std::sqrt(begin.squared_distance) +
                std::sqrt(end.squared_distance) - size >
              2. * (geometry.a.radius + geometry.b.radius))
            return 0.;
          for (unsigned int cut = 0; cut < 3 && from.end != end.end; ++cut)
            {
              CellEnd low = from, high = end;
              for (unsigned int step = 0; step < 45; ++step)
                {
                  const CellEnd middle = cell_end(
                    geometry, 0.5 * (low.p + high.p), 0.5 * (low.q + high.q));
                  (middle.end == from.end ? low : high) = middle;
                }
              if (low.p - from.p > 1e-9 * size)
                deepest = std::max(
                  deepest, place_in_smooth_cell(geometry, from, low, elements));
              from = high;
            }
        }
      if (end.p - from.p > 1e-9 * size)
        deepest = std::max(deepest,
                           place_in_smooth_cell(geometry, from, end, elements));
      return deepest;
    }
  } // namespace Contact
} // namespace Heddle
