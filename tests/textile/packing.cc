// No two fibers of a yarn overlap, however they are packed and shaken; equal
// seeds give equal yarns, other seeds and other yarns give other ones.
#include <heddle/textile/packing.h>

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



int
main()
{
  initlog();
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
