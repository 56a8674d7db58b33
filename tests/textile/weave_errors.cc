// A weave that cannot be is refused in one sentence.
#include <heddle/base/exceptions.h>
#include <heddle/textile/weave.h>

#include "../tests.h"

#include <functional>

using namespace Heddle::Textile;



void
refuse(const std::function<void(WeaveDescription &)> &spoil)
{
  WeaveDescription description;
  spoil(description);
  try
    {
      const Weave weave(description);
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
  refuse([](auto &weave) { weave.warp.n_yarns = 0; });
  refuse([](auto &weave) { weave.weft.spacing = -1.; });
  refuse([](auto &weave) { weave.warp.twist = 50.; });
  refuse([](auto &weave) { weave.end_length = -0.5; });
  refuse([](auto &weave) { weave.crimp_transition = 0.; });
  refuse([](auto &weave) { weave.crimp_factor = -1.; });
  refuse([](auto &weave) { weave.weft.packing.n_bundles = 0; });
  refuse([](auto &weave) { weave.warp.packing.radius = 0.; });
  refuse([](auto &weave) { weave.warp.packing.spacing = 1.9; });
  refuse([](auto &weave) { weave.warp.packing.perturbation = 1.5; });
  refuse([](auto &weave) {
    weave.warp.n_yarns = weave.weft.n_yarns = 1;
    weave.end_length                        = 0.;
  });
  refuse([](auto &weave) {
    weave.warp.n_yarns = weave.weft.n_yarns = 2;
    weave.warp.spacing = weave.weft.spacing = 0.03;
  });
}
