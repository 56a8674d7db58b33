// A cantilever of length 2 with E = A = 1 is bent to a quarter circle by an end
// moment, with I = 1e-4 and thinner, I = 1e-6. Errors relative to the length in
// units of 1e-6. As the strain of a line is a product with r', bending shortens
// the axis by I/A times the square of the curvature, 62 of these units for
// I = 1e-4, and the angle follows by twice that: the error that fine meshes
// keep belongs to the thickness, and goes with I.
#include "single_fiber.h"

double
error(const Kind &kind, const double inertia, const unsigned int n_elements)
{
  Heddle::Beam::Section section;
  section.axial     = 1.;
  section.bending   = inertia;
  section.torsion   = inertia;
  section.shear     = .5;
  section.thickness = .5;
  section.gradient  = .5 * inertia;

  SingleFiber fiber(kind, section, straight_line, /*length=*/2., n_elements);
  fiber.release_stretch();
  for (const double part : {.5, 1.})
    fiber.solve(Tensor<1, 3>(),
                Tensor<1, 3>({0., 0., part * .78539816339744 * inertia}));
  const Tensor<1, 3> exact({2. - .7267604552648, 1.2732395447352, 0.});
  return .5 * (fiber.tip() - exact).norm();
}



int
main()
{
  initlog();
  for (const Kind &kind : all_elements)
    for (const unsigned int n : {4, 8, 16, 32})
      {
        const double thick = error(kind, 1e-4, n);
        const double thin  = error(kind, 1e-6, n);
        const double limit = kind.degree == 1 ? 8e-4 : 5e-6;
        deallog << kind.name << ' ' << kind.degree << ", elements " << n
                << ": error " << micro(thick) << ", thin " << micro(thin)
                << verdict(n < 32 || (thick < 8e-4 && thin < limit))
                << std::endl;
      }
}
