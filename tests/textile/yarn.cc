// Fibers of a yarn do not overlap, however they are packed, and the depth of a
// point in them is known.
#include <heddle/textile/packing.h>
#include <heddle/textile/yarn_body.h>

#include <deal.II/base/numbers.h>

#include "../tests.h"

using namespace Heddle::Textile;

double
smallest_distance(const PackedSection &section)
{
  double smallest = 1e300;
  for (unsigned int i = 0; i < section.positions.size(); ++i)
    for (unsigned int j = 0; j < i; ++j)
      smallest =
        std::min(smallest, section.positions[i].distance(section.positions[j]));
  return smallest;
}



void
shake(Packing packing)
{
  packing.perturbation = 1.;
  double smallest      = 1e300;
  for (packing.seed = 1; packing.seed <= 5; ++packing.seed)
    for (unsigned int yarn = 0; yarn < 8; ++yarn)
      smallest =
        std::min(smallest, smallest_distance(pack_yarn(packing, yarn)));
  deallog << "  shaken: overlap " << (smallest < 2. * packing.radius)
          << ", moved " << (smallest < 0.995 * packing.spacing * packing.radius)
          << std::endl;

  packing.seed     = 1;
  const auto first = pack_yarn(packing, 0).positions;
  const bool again = first == pack_yarn(packing, 0).positions;
  const bool yarn  = first == pack_yarn(packing, 1).positions;
  packing.seed     = 2;
  const bool seed  = first == pack_yarn(packing, 0).positions;
  deallog << "  equal again " << again << ", for another yarn " << yarn
          << ", for another seed " << seed << std::endl;
}



/**
 * No two fibers of a yarn overlap, however they are packed and shaken; equal
 * seeds give equal yarns, other seeds and other yarns give other ones.
 */
void
packings()
{
  for (const Layout layout : {Layout::rows, Layout::hexagonal})
    for (const unsigned int n_bundles : {1, 3})
      for (const unsigned int n_fibers : {1, 6, 7, 12})
        {
          Packing packing;
          packing.n_bundles         = n_bundles;
          packing.fibers_per_bundle = n_fibers;
          packing.radius            = 0.0045;
          packing.layout            = layout;
          const auto   section      = pack_yarn(packing, 0);
          const double scale        = 1. / packing.radius;

          deallog << (layout == Layout::rows ? "rows " : "hexagonal ")
                  << n_bundles << " x " << n_fibers << ": "
                  << section.positions.size() << " fibers, width "
                  << scale * section.width << " R, height "
                  << scale * section.height << " R, outermost axis "
                  << scale * section.radius << " R" << std::endl;
          if (packing.n_fibers() > 1)
            {
              deallog << "  smallest distance "
                      << scale * smallest_distance(section) << " R"
                      << std::endl;
              shake(packing);
            }
        }
}



/** Fibers parallel to @p direction on a circle, and one in its middle. */
std::vector<FiberAxis>
round_yarn(const Tensor<1, 3> &direction,
           const unsigned int  n_fibers,
           const double        yarn_radius)
{
  Tensor<1, 3> vertical;
  vertical[2]         = 1.;
  Tensor<1, 3> across = cross_product_3d(vertical, direction);
  across /= across.norm();
  const Tensor<1, 3> up = cross_product_3d(direction, across);

  std::vector<FiberAxis> fibers;
  for (unsigned int f = 0; f <= n_fibers; ++f)
    {
      const double       angle  = 2. * numbers::PI * f / n_fibers;
      const double       radius = f == n_fibers ? 0. : yarn_radius;
      const Tensor<1, 3> place =
        radius * (std::cos(angle) * across + std::sin(angle) * up);
      fibers.push_back({{}, 0.01, 3});
      // Ends are ragged.
      const double begin = -1. + 0.005 * (f % 2);
      for (unsigned int i = 0; i <= 20; ++i)
        fibers.back().points.push_back(
          place + (begin + (1. - begin) * 0.05 * i) * direction);
    }
  return fibers;
}



/**
 * The depth in a round yarn is known in closed form, whatever its direction;
 * beyond its ends is outside. Yarns of one and of two fibers have bodies, too.
 */
void
bodies()
{
  const double yarn_radius = 0.1;
  for (const Tensor<1, 3> &way : {Tensor<1, 3>({1., 0., 0.}),
                                  Tensor<1, 3>({0., 2., 0.}),
                                  Tensor<1, 3>({1., -1., 0.4})})
    {
      const Tensor<1, 3> direction = way / way.norm();
      const YarnBody     body(round_yarn(direction, 360, yarn_radius));
      Tensor<1, 3>       vertical;
      vertical[2]         = 1.;
      Tensor<1, 3> across = cross_product_3d(vertical, direction);
      across /= across.norm();
      const Tensor<1, 3> up = cross_product_3d(direction, across);

      double error = 0., error_beyond = 0.;
      for (unsigned int i = 0; i < 1000; ++i)
        {
          const double       angle = 0.7 * i, r = 2e-4 * i;
          const Tensor<1, 3> place =
            r * (std::cos(angle) * across + std::sin(angle) * up);
          const double exact = yarn_radius + 0.01 - r;
          for (const double s : {-0.99, -0.5, 0.123, 0.99})
            error = std::max(
              error, std::abs(body.depth(s * direction + place) - exact));
          // The body ends a fiber radius beyond the last end.
          const double end = -std::hypot(0.02, std::max(0., -exact));
          for (const double s : {-1.03, 1.03})
            error_beyond = std::max(
              error_beyond, std::abs(body.depth(s * direction + place) - end));
        }
      deallog << "error of the depth below 2e-4 of the yarn: "
              << (error < 2e-4 * yarn_radius) << ", beyond the ends "
              << (error_beyond < 2e-4 * yarn_radius) << ", height / 2 "
              << body.height() / 2. << std::endl;
    }

  std::vector<FiberAxis> two(2);
  for (unsigned int f = 0; f < 2; ++f)
    {
      two[f].radius  = 1.;
      two[f].yarn_id = f;
      two[f].points  = {Tensor<1, 3>({-9., 0., 3. * f}),
                        Tensor<1, 3>({9., 0., 3. * f})};
    }
  const Tensor<1, 3> between({0.3, 0.5, 1.5});
  for (const YarnBody &body : yarn_bodies(two))
    deallog << "one fiber: " << body.depth(between) << std::endl;
  two[0].yarn_id = two[1].yarn_id = 7;
  for (const YarnBody &body : yarn_bodies(two))
    deallog << "two fibers: " << body.depth(between) << std::endl;
  // Of staple fibers that begin and end along it, given from either end.
  std::vector<FiberAxis> spun;
  for (unsigned int f = 0; f < 2; ++f)
    for (const bool first : {true, false})
      {
        spun.push_back(two[f]);
        spun.back().points[first ? 1 : 0][0] = 5. * f - 2.;
        if (!first)
          std::swap(spun.back().points[0], spun.back().points[1]);
      }
  for (const YarnBody &body : yarn_bodies(spun))
    deallog << "spun: " << body.depth(between) << ", at the ends "
            << body.depth(Tensor<1, 3>({-9., 0.5, 1.5})) << " and "
            << body.depth(Tensor<1, 3>({9., 0.5, 1.5})) << std::endl;
  two[0].yarn_id = two[1].yarn_id = no_id;
  deallog << "without yarns: " << yarn_bodies(two).size() << " bodies"
          << std::endl;
}



int
main()
{
  initlog();
  run_part("Packing", packings);
  run_part("Depth in a yarn", bodies);
}
