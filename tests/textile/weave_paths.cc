// Fibers come warp first, yarn by yarn, with knots equally spaced in arc
// length; straight ones have their own length, twisted ones that of a helix,
// and crimped ones that of a cosine.
#include <heddle/textile/weave.h>

#include <deal.II/base/numbers.h>

#include "../tests.h"

using namespace Heddle::Textile;



/** Largest minus smallest distance of neighbouring knots over their mean. */
double
unevenness(const FiberPath &fiber)
{
  double smallest = 1e300, largest = 0.;
  for (unsigned int i = 1; i < fiber.points.size(); ++i)
    {
      const double h = (fiber.points[i] - fiber.points[i - 1]).norm();
      smallest       = std::min(smallest, h);
      largest        = std::max(largest, h);
    }
  return (largest - smallest) / largest;
}



void
print(const std::string &name, const WeaveDescription &description)
{
  const Weave weave(description);
  const auto  fibers = weave.paths(400);
  double      uneven = 0.;
  for (const FiberPath &fiber : fibers)
    uneven = std::max(uneven, unevenness(fiber));

  deallog << name << ": " << fibers.size() << " fibers of "
          << fibers[0].points.size() << " knots, uneven by less than "
          << (uneven < 1e-3 ? "1e-3" : "1") << std::endl;
  for (const unsigned int f : {0u, 23u, 24u, 59u})
    deallog << "  fiber " << f << ": yarn " << fibers[f].yarn_id << ", bundle "
            << fibers[f].bundle_id << ", set " << fibers[f].set << ", length "
            << fibers[f].reference_length << ", from " << fibers[f].points[0]
            << std::endl;
}



int
main()
{
  initlog();
  WeaveDescription description;
  description.start                          = Start::interpenetrating;
  description.warp.n_yarns                   = 2;
  description.warp.packing.n_bundles         = 2;
  description.warp.packing.fibers_per_bundle = 6;
  description.warp.packing.radius            = 1.;
  description.warp.packing.spacing           = 2.2;
  description.warp.spacing                   = 30.;
  description.weft                           = description.warp;
  description.weft.n_yarns                   = 3;
  description.weft.spacing                   = 40.;
  print("straight", description);

  description.warp.twist = 0.01;
  print("twisted warp", description);
  const double across =
    pack_yarn(description.warp.packing, 0).positions[0].norm();
  const double rate = 2. * numbers::PI * description.warp.twist * across;
  deallog << "  helix of fiber 0: " << 120. * std::sqrt(1. + rate * rate)
          << std::endl;

  description.warp.twist   = 0.;
  description.start        = Start::crimped;
  description.crimp_factor = 1.5;
  print("crimped", description);
}
