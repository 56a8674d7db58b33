// What fibers that are lines do not give in a matrix:
// - the stiffness across them, which is that of the matrix in plane strain at
//   best, where that of a composite is 2.28 E_m (Halpin and Tsai);
// - a limit in finer hexahedra: they see a line load, and the matrix yields by
//   ln 2 / 2 pi G more whenever they are halved;
// - bending with stiff links, several of them in each hexahedron of degree 1,
//   in which the fiber has to stay straight.
// All are printed to the screen; compared are rounded numbers.
#include "composite.h"

/** Modulus across fibers along x that take 30 % of the volume, over E_m. */
double
modulus_across(const double poisson_ratio, const double factor)
{
  constexpr double length = 2.;
  Composite        scene(
    mesh(8, 4, Tensor<1, 3>({length, 1., 1.})) +
    " set Poisson ratio = " + std::to_string(poisson_ratio) +
    "\n set Coupling stiffness factor = " + std::to_string(factor) + "\n");
  scene.fibers.element_kind           = Heddle::Beam::ElementKind::hermite;
  scene.fibers.material.axial_modulus = 1000.;
  scene.hold({"x-"}).displacement[0]  = "0";
  scene.hold({"z-"}).displacement[2]  = "0";
  scene.hold({"y-"}).displacement[1]  = "0";
  scene.hold({"y+"}).displacement[1]  = "1e-5";
  std::vector<Textile::FiberPath> paths;
  for (unsigned int i = 0; i < 16; ++i)
    {
      const double y = (i / 4 + 0.5) / 4., z = (i % 4 + 0.5) / 4.;
      paths.push_back(straight_path(Tensor<1, 3>({0., y, z}),
                                    Tensor<1, 3>({length, y, z}),
                                    17,
                                    std::sqrt(0.3 / 16. / numbers::PI)));
    }
  scene.embed(paths);
  scene.newton.residual_tolerance  = 1e-8;
  scene.newton.increment_tolerance = 1e-8;
  scene.step(1.);
  return scene.report().at("support_4_force_y[N]") / (1e-5 * length);
}



/**
 * By how much the matrix yields to a force per length along a fiber, times E_m:
 * @p n_cells hexahedra between walls that are 16 diameters apart.
 */
double
yielding_along(const unsigned int n_cells)
{
  constexpr double diameter = 0.2, side = 16. * diameter;
  const double     length = 2. * side / n_cells;
  Composite        scene(mesh(2, n_cells, Tensor<1, 3>({length, side, side})) +
                  " set Poisson ratio = 0.3\n"
                         " set Coupling points per element = 2\n");
  scene.fibers.element_kind           = Heddle::Beam::ElementKind::director;
  scene.fibers.material.axial_modulus = 1000.;
  scene.fibers.material.poisson_ratio = 0.;
  scene.hold({"y-", "y+", "z-", "z+"}).displacement = {{"0", "0", "0"}};
  // Only displacements along the fiber: those do not depend on x.
  scene.hold({"x-", "x+"}).displacement = {{"free", "0", "0"}};
  scene.add_load().force_per_length     = {{"1e-6", "0", "0"}};
  // Nothing else keeps the fiber from turning about its axis.
  auto &held       = scene.add_support();
  held.nodes.nodes = Heddle::Contributions::ChosenNodes::first_end;
  held.section     = Heddle::Contributions::SupportedSection::held;
  scene.embed({straight_path(Tensor<1, 3>({0., side / 2, side / 2}),
                             Tensor<1, 3>({length, side / 2, side / 2}),
                             5,
                             diameter / 2)});
  scene.newton.residual_tolerance  = 1e-9;
  scene.newton.increment_tolerance = 1e-9;
  scene.step(1.);
  constexpr double of_links = 1.;
  return (scene.block(0, 2)[0] - length / 2) / 1e-6 - of_links;
}



/**
 * Stiffness in bending of a block of ten hexahedra along its fiber [N mm^2];
 * without bending stiffness of the fiber if @p modulus is next to nothing.
 */
double
bend(const double       modulus,
     const unsigned int degree,
     const unsigned int n_per_cell,
     const double       factor)
{
  constexpr double   length = 10., displacement = 0.01;
  constexpr unsigned n_cells = 10;
  Composite          scene(
    mesh(n_cells, 2, Tensor<1, 3>({length, 1., 1.})) +
    " set Poisson ratio = 0\n set Degree = " + std::to_string(degree) +
    "\n set Coupling stiffness factor = " + std::to_string(factor) + "\n");
  scene.fibers.element_kind           = Heddle::Beam::ElementKind::hermite;
  scene.fibers.material.axial_modulus = modulus;
  scene.fibers.material.poisson_ratio = 0.;
  scene.hold({"x-"}).displacement     = {{"0", "0", "0"}};
  scene.hold({"x+"}).displacement[2]  = std::to_string(displacement);
  scene.embed({straight_path(Tensor<1, 3>({0., 0.5, 0.5}),
                             Tensor<1, 3>({length, 0.5, 0.5}),
                             n_cells * n_per_cell + 1,
                             0.1)});
  scene.newton.residual_tolerance  = 1e-4;
  scene.newton.increment_tolerance = 1e-4;
  AssertThrow(scene.step(1.).converged, ExcMessage("No equilibrium."));
  return scene.report().at("support_2_force_z[N]") / displacement *
         std::pow(length, 3) / 3.;
}



/** To two decimals. */
double
rounded(const double value)
{
  return std::round(value * 100.) / 100.;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  for (const double poisson_ratio : {0., 0.3})
    for (const double factor : {1., 1e3})
      {
        const double modulus = modulus_across(poisson_ratio, factor);
        print(
          "across, factor " + std::to_string(factor), poisson_ratio, modulus);
        deallog << "across, Poisson ratio " << poisson_ratio << ", factor "
                << factor << ": " << rounded(modulus) << std::endl;
      }

  const double per_halving = std::log(2.) / (2. * numbers::PI) * 2.6;
  double       before      = 0.;
  for (const unsigned int n_cells : {4, 8, 16, 32, 64})
    {
      const double yielding = yielding_along(n_cells);
      print("yielding of the matrix", n_cells, yielding);
      print("more than before over the limit",
            n_cells,
            (yielding - before) / per_halving);
      deallog << "hexahedra of " << 16. / n_cells << " diameters: stiffness "
              << rounded(1. / (1. + yielding));
      if (before > 0.)
        deallog << ", more yielding than before over the limit "
                << rounded((yielding - before) / per_halving);
      deallog << std::endl;
      before = yielding;
    }

  constexpr double stiffness = 1000. * 0.25 * numbers::PI * 1e-4;
  for (const unsigned int degree : {1, 2})
    {
      const double matrix_alone = bend(1e-6, degree, 1, 1.);
      for (const double factor : {1., 1e3, 1e5})
        for (const unsigned int n_per_cell : {1, 2, 4, 8})
          {
            const double added =
              (bend(1000., degree, n_per_cell, factor) - matrix_alone) /
              stiffness;
            print("bending, degree " + std::to_string(degree) + ", factor " +
                    std::to_string(factor),
                  n_per_cell,
                  added);
            deallog << "bending, degree " << degree << ", factor " << factor
                    << ", " << n_per_cell << " per hexahedron: the fiber adds "
                    << rounded(added) << std::endl;
          }
    }
}
