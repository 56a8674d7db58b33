#include <heddle/base/exceptions.h>
#include <heddle/base/number_text.h>
#include <heddle/textile/packing.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      const double row_distance = std::sqrt(0.75);



      /** Staggered rows on a lattice of spacing 1, bundles side by side. */
      std::vector<Point<2>>
      rows(const unsigned int n_bundles, const unsigned int n_fibers)
      {
        const unsigned int n_rows =
          std::max(1L, std::lround(std::sqrt(0.75 * n_fibers)));
        const unsigned int n_columns = (n_fibers + n_rows - 1) / n_rows;

        std::vector<Point<2>> positions;
        for (unsigned int bundle = 0; bundle < n_bundles; ++bundle)
          for (unsigned int f = 0; f < n_fibers; ++f)
            {
              const unsigned int row = f / n_columns;
              positions.emplace_back(bundle * n_columns + f % n_columns +
                                       (row % 2 == 1 ? 0.5 : 0.),
                                     row * row_distance);
            }
        return positions;
      }



      /** The @p n_fibers sites of a hexagonal lattice nearest to @p center. */
      std::vector<Point<2>>
      nearest_sites(const unsigned int n_fibers, const Point<2> &center)
      {
        const int             reach = std::ceil(std::sqrt(n_fibers)) + 2;
        std::vector<Point<2>> sites;
        for (int row = -reach; row <= reach; ++row)
          for (int column = -reach; column <= reach; ++column)
            sites.emplace_back(column + (row % 2 != 0 ? 0.5 : 0.) - center[0],
                               row * row_distance - center[1]);

        // Sites at equal distance are told apart by their angle; rounding
        // keeps the last digit from deciding what is equal.
        const auto key = [](const Point<2> &p) {
          return std::make_tuple(std::lround(1e6 * p.norm_square()),
                                 std::lround(1e6 * std::atan2(p[1], p[0])));
        };
        std::sort(sites.begin(),
                  sites.end(),
                  [&](const Point<2> &a, const Point<2> &b) {
                    return key(a) < key(b);
                  });
        sites.resize(n_fibers);
        return sites;
      }



      /**
       * The roundest of the pieces about a site, about the middle of three and
       * about the middle of two, on a lattice of spacing 1; cut in sectors, one
       * for each bundle.
       */
      std::vector<Point<2>>
      hexagonal(const unsigned int n_bundles, const unsigned int n_per_bundle)
      {
        std::vector<Point<2>> best;
        for (const Point<2> &center : {Point<2>(0., 0.),
                                       Point<2>(0.5, row_distance / 3.),
                                       Point<2>(0.5, 0.)})
          {
            const auto sites = nearest_sites(n_bundles * n_per_bundle, center);
            if (best.empty() || sites.back().norm() < best.back().norm() - 1e-9)
              best = sites;
          }
        if (n_bundles > 1)
          std::stable_sort(
            best.begin(), best.end(), [](const Point<2> &a, const Point<2> &b) {
              return std::atan2(a[1], a[0]) < std::atan2(b[1], b[0]) - 1e-9;
            });
        return best;
      }



      /** Move the middle of the box of @p section to zero and measure it. */
      void
      center_and_measure(PackedSection &section, const double fiber_radius)
      {
        Point<2> lowest  = section.positions[0];
        Point<2> highest = section.positions[0];
        for (const Point<2> &p : section.positions)
          for (unsigned int d = 0; d < 2; ++d)
            {
              lowest[d]  = std::min(lowest[d], p[d]);
              highest[d] = std::max(highest[d], p[d]);
            }

        section.width  = highest[0] - lowest[0] + 2. * fiber_radius;
        section.height = highest[1] - lowest[1] + 2. * fiber_radius;
        for (Point<2> &p : section.positions)
          {
            p -= 0.5 * (lowest + (highest - Point<2>()));
            section.radius = std::max(section.radius, p.norm());
          }
      }



      /** A shift uniform over the disc of radius @p reach. */
      Tensor<1, 2>
      random_shift(const double        reach,
                   const std::uint64_t seed,
                   const unsigned int  yarn,
                   const unsigned int  fiber)
      {
        std::seed_seq   sequence{static_cast<std::uint32_t>(seed),
                               static_cast<std::uint32_t>(seed >> 32),
                               static_cast<std::uint32_t>(yarn),
                               static_cast<std::uint32_t>(fiber)};
        std::mt19937_64 generator(sequence);

        // The distributions of the standard library differ between its
        // implementations; the generators do not.
        const auto uniform = [&]() {
          return static_cast<double>(generator() >> 11) * std::ldexp(1., -53);
        };
        const double distance = reach * std::sqrt(uniform());
        const double angle    = 2. * numbers::PI * uniform();
        return Tensor<1, 2>(
          {distance * std::cos(angle), distance * std::sin(angle)});
      }
    } // namespace



    void
    check_packing(const Packing &packing, const std::string &where)
    {
      const auto refuse = [&](const std::string &sentence) {
        throw InputError(where + ": " + sentence);
      };
      if (packing.n_fibers() == 0)
        refuse("a yarn has no fibers; give at least one bundle of one fiber.");
      if (!(packing.radius > 0.) || !std::isfinite(packing.radius))
        refuse("the fiber radius is " + number_text(packing.radius) +
               " mm; it must be positive.");
      if (!(packing.spacing >= 2.) || !std::isfinite(packing.spacing))
        refuse("the spacing is " + number_text(packing.spacing) +
               " fiber radii, so that neighbours overlap; give at least 2.");
      if (!(packing.perturbation >= 0. && packing.perturbation <= 1.))
        refuse("the perturbation is " + number_text(packing.perturbation) +
               "; it must lie between 0 and 1, beyond which neighbours may "
               "overlap.");
    }



    PackedSection
    pack_yarn(const Packing &packing, const unsigned int yarn)
    {
      check_packing(packing, "Packing of a yarn");

      PackedSection section;
      section.positions =
        packing.layout == Layout::rows
          ? rows(packing.n_bundles, packing.fibers_per_bundle)
          : hexagonal(packing.n_bundles, packing.fibers_per_bundle);
      for (Point<2> &p : section.positions)
        p *= packing.spacing * packing.radius;
      center_and_measure(section, packing.radius);

      const double reach =
        packing.perturbation * (0.5 * packing.spacing - 1.) * packing.radius;
      if (reach > 0.)
        for (unsigned int f = 0; f < section.positions.size(); ++f)
          section.positions[f] += random_shift(reach, packing.seed, yarn, f);
      return section;
    }
  } // namespace Textile
} // namespace Heddle
