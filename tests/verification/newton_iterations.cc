// A cantilever of unit length under the tip force P L^2 / EI = 10 in one load
// step: Newton with mixed integration points needs at most 9 iterations,
// counted until the increment is below 1e-8 of the length, whatever the
// slenderness.
#include "single_fiber.h"

int
main()
{
  initlog();
  for (const Kind &kind : all_elements)
    for (const double slenderness : {10., 100., 1000., 10000.})
      {
        const auto section =
          Heddle::Beam::circular_section(.5 / slenderness, 1., 1. / 2.6, .3);
        SingleFiber fiber(kind,
                          section,
                          straight_line,
                          /*length=*/1.,
                          /*n_elements=*/16);
        fiber.release_stretch();
        const unsigned int n =
          fiber.solve(Tensor<1, 3>({0., 10. * section.bending, 0.}));
        deallog << kind.name << ' ' << kind.degree << ", slenderness "
                << slenderness << ": iterations " << n << verdict(n <= 9)
                << std::endl;
      }
}
