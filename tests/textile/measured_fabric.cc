// Fibers of a measured fabric all run towards larger x or y, whichever end they
// begin at; its yarns are counted and their spacing is that of their middles. A
// file that is no fabric is refused in one sentence.
#include <heddle/base/exceptions.h>
#include <heddle/textile/measured_fabric.h>

#include "../tests.h"

using namespace Heddle::Textile;
using dealii::Tensor;



/** A straight fiber in the middle of which is the place @p across. */
FiberPath
fiber(const std::string &set,
      const unsigned int yarn,
      const double       across,
      const bool         backward = false)
{
  const unsigned int along = set == "weft" ? 1 : 0;
  FiberPath          path;
  for (unsigned int i = 0; i < 3; ++i)
    {
      Tensor<1, 3> point;
      point[along]     = backward ? 2. - i : i;
      point[1 - along] = across;
      point[2]         = 0.1 * i;
      path.points.push_back(point);
    }
  path.set     = set;
  path.yarn_id = yarn;
  return path;
}



void
refuse(std::vector<FiberPath> paths)
{
  try
    {
      MeasuredFabric(paths, "fibers.csv").spacing();
      deallog << "accepted" << std::endl;
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



int
main()
{
  initlog();
  std::vector<FiberPath> paths = {fiber("warp", 1, 4.),
                                  fiber("weft", 0, 1.),
                                  fiber("warp", 1, 6., /*backward=*/true),
                                  fiber("weft", 2, 0.75, true),
                                  fiber("warp", 3, 3.),
                                  fiber("warp", 4, 9.)};
  const MeasuredFabric   fabric(paths, "fibers.csv");
  for (const FiberPath &path : paths)
    deallog << path.set << " from " << path.points.front() << " to "
            << path.points.back() << std::endl;
  deallog << fabric.n_yarns()[0] << " warp yarns at " << fabric.spacing()[0]
          << ", " << fabric.n_yarns()[1] << " weft yarns at "
          << fabric.spacing()[1] << std::endl;

  // Lost while it was traced.
  deallog << "short: \"" << fabric.short_fibers() << '"' << std::endl;
  paths[2].points.pop_back();
  deallog << MeasuredFabric(paths, "fibers.csv").short_fibers() << std::endl;
  paths[0].points.erase(paths[0].points.begin());
  deallog << MeasuredFabric(paths, "fibers.csv").short_fibers() << std::endl;

  refuse({fiber("warp", 0, 1.), fiber("warp", no_id, 2.)});
  refuse({fiber("warp", 0, 1.), fiber("pile", 1, 2.)});
  refuse({fiber("warp", 0, 1.), fiber("warp", 1, 2.)});
  refuse({fiber("warp", 0, 1.), fiber("warp", 1, 2.), fiber("weft", 2, 2.)});
  paths[1].set = "warp";
  refuse(paths);
}
