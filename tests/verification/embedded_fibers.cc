// Fibers that are linked to an elastic matrix, against closed forms:
// - straight fibers through a block that is stretched evenly: no link has a
//   force, and the modulus is E_m + V_f E_f, for the matrix is there twice;
// - a fiber in a matrix of prescribed strain e, a bed of springs: b^2 = kappa /
//   EA, mean strain e (1 - tanh(bL/2) / (bL/2)), in the middle e (1 - 1 /
//   cosh(bL/2));
// - a fiber in a rigid matrix under the force per length q: q / kappa
//   everywhere;
// - 4 x 4 fibers in a block: below the force of fibers that are tied to the
//   hexahedra (CalculiX, and a program of truss elements), and tending to it.
// Errors and orders are printed to the screen; compared are bounds.
#include <heddle/base/choice.h>

#include "composite.h"

/** Relative error of the modulus, and the largest force of a link [N/mm]. */
void
stretch_evenly()
{
  constexpr double length = 10., strain = 1e-6, fiber_modulus = 1000.;
  const double     radius = std::sqrt(0.3 / numbers::PI);
  double           worst = 0., link = 0.;
  for (const std::string element : {"hermite", "director"})
    for (const unsigned int n_elements : {5, 12, 30})
      for (const unsigned int n_columns : {3, 8, 20})
        {
          Composite scene(mesh(n_columns,
                               (n_columns + 2) / 5,
                               Tensor<1, 3>({length, 1., 1.})) +
                          " set Poisson ratio = 0\n");
          scene.fibers.element_kind =
            Heddle::choice<Heddle::Beam::ElementKind>(element);
          scene.fibers.material.axial_modulus = fiber_modulus;
          scene.fibers.material.poisson_ratio = 0.;
          auto &ends                          = scene.add_support();
          ends.nodes.nodes  = Heddle::Contributions::ChosenNodes::first_end;
          ends.matrix_sides = {Contributions::MatrixSide::lower_x};
          ends.displacement = {{"0", "0", "0"}};
          auto &pull        = scene.add_support();
          pull.nodes.nodes  = Heddle::Contributions::ChosenNodes::last_end;
          pull.matrix_sides = {Contributions::MatrixSide::upper_x};
          pull.displacement = {{std::to_string(strain) + "*x", "0", "0"}};
          scene.embed({straight_path(Tensor<1, 3>({0., 0.41, 0.57}),
                                     Tensor<1, 3>({length, 0.41, 0.57}),
                                     n_elements + 1,
                                     radius)});
          scene.newton.residual_tolerance  = 1e-9;
          scene.newton.increment_tolerance = 1e-9;
          scene.step(1.);
          const auto   values   = scene.report();
          const double modulus  = values.at("support_2_force_x[N]") / strain;
          const double expected = 1. + 0.3 * fiber_modulus;
          worst = std::max(worst, std::abs(modulus / expected - 1.));
          link  = std::max(link,
                          values.at("largest_coupling_force_per_length[N/mm]"));
        }
  print("even strain, error of the modulus", 0, worst);
  print("even strain, link force per length over E_m e", 0, link / strain);
  deallog << "even strain: modulus to 1e-5 " << (worst < 1e-5)
          << ", no forces in links " << (link < 1e-5 * strain) << std::endl;
}



/** Errors of the mean strain and of that in the middle, relative. */
std::pair<double, double>
bed_of_springs(const std::string &element,
               const unsigned int n_elements,
               const unsigned int n_points)
{
  constexpr double length = 10., strain = 1e-5, radius = 0.01;
  constexpr double fiber_modulus = 1e5, kappa = 12.;
  Composite        scene(mesh(n_elements, 1, Tensor<1, 3>({length, 1., 1.})) +
                  " set Coupling stiffness factor = 12\n"
                         " set Coupling points per element = " +
                  std::to_string(n_points) + "\n");
  scene.fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  scene.fibers.material.axial_modulus = fiber_modulus;
  scene.fibers.material.poisson_ratio = 0.;
  auto &sides        = scene.hold({"x-", "x+", "y-", "y+", "z-", "z+"});
  sides.displacement = {{"1e-5*x", "0", "0"}};
  scene.embed({straight_path(Tensor<1, 3>({0., 0.5, 0.5}),
                             Tensor<1, 3>({length, 0.5, 0.5}),
                             n_elements + 1,
                             radius)});
  scene.newton.residual_tolerance  = 1e-9;
  scene.newton.increment_tolerance = 1e-9;
  scene.step(1.);

  const double area = numbers::PI * radius * radius;
  const double half = 0.5 * length * std::sqrt(kappa / (fiber_modulus * area));
  const double mean = strain * (1. - std::tanh(half) / half);
  const double middle = strain * (1. - 1. / std::cosh(half));

  const unsigned int last = scene.last_node(), center = last / 2;
  const double       mean_found =
    (scene.block(0, last)[0] - scene.block(0, 0)[0]) / length - 1.;
  const double h = length / last;
  const double middle_found =
    (scene.block(0, center + 1)[0] - scene.block(0, center - 1)[0]) / (2. * h) -
    1.;
  return {std::abs(mean_found / mean - 1.),
          std::abs(middle_found / middle - 1.)};
}



void
converge(const std::string &element, const unsigned int n_points)
{
  const std::string what = "bed of springs, " + element + ", " +
                           std::to_string(n_points) + " points, ";
  std::pair<double, double> coarse = {0., 0.}, fine = {0., 0.};
  for (const unsigned int n : {20, 40, 80})
    {
      coarse = fine;
      fine   = bed_of_springs(element, n, n_points);
      print(what + "mean strain", n, fine.first);
      print(what + "strain in the middle", n, fine.second);
    }
  const double order = std::log2(coarse.first / fine.first);
  print(what + "order", 80, order);
  deallog << what << "0.1 % " << (fine.first < 1e-3 && fine.second < 1e-3)
          << ", order at least 1.8 " << (order > 1.8 || fine.first < 1e-5)
          << std::endl;
}



/** Largest deviation from q / kappa, relative. */
double
lift_in_rigid_matrix(const std::string &element, const unsigned int n_points)
{
  Composite scene(
    mesh(5, 1, Tensor<1, 3>({10., 1., 1.})) +
    " set Coupling points per element = " + std::to_string(n_points) + "\n");
  scene.fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  scene.fibers.material.axial_modulus = 1000.;
  scene.fibers.material.poisson_ratio = 0.;
  auto &sides           = scene.hold({"x-", "x+", "y-", "y+", "z-", "z+"});
  sides.displacement    = {{"0", "0", "0"}};
  auto &load            = scene.add_load();
  load.force_per_length = {{"0", "0", "1e-4"}};
  scene.embed({straight_path(
    Tensor<1, 3>({0., 0.5, 0.5}), Tensor<1, 3>({10., 0.5, 0.5}), 14, 0.1)});
  scene.newton.residual_tolerance  = 1e-11;
  scene.newton.increment_tolerance = 1e-9;
  scene.step(1.);
  double worst = 0.;
  for (unsigned int i = 0; i <= scene.last_node(); ++i)
    worst = std::max(worst, std::abs((scene.block(0, i)[2] - 0.5) / 1e-4 - 1.));
  return worst;
}



/** Force that stretches the block of 4 x 4 fibers by 0.1 % [N]. */
double
pull_block(const unsigned int n_yz,
           const double       element_length,
           const double       factor)
{
  Composite scene(mesh(5 * n_yz, n_yz, Tensor<1, 3>({40., 8., 8.})) +
                  " set Youngs modulus = 100\n set Locking remedy = none\n"
                  " set Coupling stiffness factor = " +
                  std::to_string(factor) + "\n");
  scene.fibers.element_kind               = Heddle::Beam::ElementKind::hermite;
  scene.fibers.material.axial_modulus     = 1e5;
  scene.fibers.material.bending_stiffness = 1e-3;
  scene.hold({"x-"}).displacement[0]      = "0";
  scene.hold({"x+"}).displacement[0]      = "0.04";

  // The fibers next to an edge keep the block from floating.
  for (const std::string fiber : {"0", "3"})
    {
      auto &support        = scene.add_support();
      support.nodes.fibers = fiber;
      support.nodes.nodes  = Heddle::Contributions::ChosenNodes::first_end;
      support.displacement = {{"free", "0", fiber == "0" ? "0" : "free"}};
    }

  // On an edge between hexahedra a tied fiber is softer: published forces are
  // met 0.015 mm beside it.
  std::vector<Textile::FiberPath> paths;
  for (unsigned int i = 0; i < 16; ++i)
    {
      const double y = 1.015 + 2 * (i / 4), z = 1.015 + 2 * (i % 4);
      paths.push_back(straight_path(Tensor<1, 3>({5., y, z}),
                                    Tensor<1, 3>({35., y, z}),
                                    std::lround(30. / element_length) + 1,
                                    0.2));
    }
  scene.embed(paths);
  scene.step(1.);
  const auto values = scene.report();
  AssertThrow(std::abs(values.at("support_1_force_x[N]") +
                       values.at("support_2_force_x[N]")) < 1e-6,
              ExcMessage("Forces on the block are not in balance."));
  return values.at("support_2_force_x[N]");
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  stretch_evenly();
  for (const std::string element : {"hermite", "director"})
    for (const unsigned int n_points : {0, 2})
      converge(element, n_points);
  for (const std::string element : {"hermite", "director"})
    {
      const double nodes  = lift_in_rigid_matrix(element, 0);
      const double points = lift_in_rigid_matrix(element, 3);
      print("rigid matrix, " + element + ", links in nodes", 0, nodes);
      print("rigid matrix, " + element + ", three points", 3, points);
      deallog << "rigid matrix, " << element << ": to round-off "
              << (points < 1e-9) << std::endl;
    }

  const double       tied[] = {29.01471, 19.91163};
  const unsigned int n_yz[] = {4, 8};
  for (unsigned int i = 0; i < 2; ++i)
    {
      double before = 1.;
      for (const double factor : {1., 1e2, 1e4, 1e5})
        {
          const double error =
            std::abs(pull_block(n_yz[i], 0.5, factor) / tied[i] - 1.);
          print("block, factor " + std::to_string(factor), n_yz[i], error);
          if (factor == 1e5)
            deallog << "block of " << n_yz[i] << " layers: tied to 0.1 % "
                    << (error < 1e-3) << std::endl;
          else if (factor < 1e5)
            deallog << "  nearer " << (error < before) << std::endl;
          before = error;
        }
    }
}
