// Prescribed motions are met exactly, sections turn as told, a support in a
// frame that lies askew answers like one along the axes, and the reactions of
// all supports and the loads sum to nothing, as do their moments. Zeros are
// printed as the number of radii, forces in units of the axial stiffness times
// 1e-6.
#include <heddle/base/choice.h>

#include "scene.h"

const double radius = 0.01;



double
rounded(const double x)
{
  return std::abs(x) < 1e-9 ? 0. : x;
}



std::unique_ptr<Scene>
make_scene(const std::string &element)
{
  auto scene = std::make_unique<Scene>();
  scene->fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  scene->fibers.degree                 = 2;
  scene->fibers.material.axial_modulus = 1. / (M_PI * radius * radius);
  return scene;
}



std::vector<Textile::FiberPath>
two_fibers(const Tensor<1, 3> &direction)
{
  std::vector<Textile::FiberPath> paths;
  for (const double y : {0., 0.5})
    {
      const Tensor<1, 3> begin({0., y, 0.});
      paths.push_back(straight_path(begin, begin + direction, 17, radius));
    }
  return paths;
}



/** Ends follow formulas, the middle keeps its height. */
void
test_displacements(const std::string &element)
{
  const auto scene = make_scene(element);
  scene->clamp("first end");
  auto &moved              = scene->add_support();
  moved.nodes.nodes        = Heddle::Contributions::ChosenNodes::last_end;
  moved.displacement       = {{"0.02*t*(1+y)", "free", "0.1*t*x"}};
  auto &middle             = scene->add_support();
  middle.nodes.nodes       = Heddle::Contributions::ChosenNodes::near_point;
  middle.nodes.point       = Point<3>(0.5, 0.25, 0.);
  middle.nodes.distance    = 0.26;
  middle.displacement[2]   = "0";
  auto &load               = scene->add_load();
  load.nodes.fibers        = "1";
  load.force_per_length[1] = "1e-5*t";
  scene->build(two_fibers(Tensor<1, 3>({1., 0., 0.})));
  const auto result = scene->solve(1.);
  deallog << element << ": converged " << result.converged;
  for (unsigned int f = 0; f < 2; ++f)
    {
      const unsigned int last = scene->last_node(f);
      const Tensor<1, 3> tip  = scene->block(f, last);
      deallog << ", missed by "
              << rounded((tip[0] - 1. - 0.02 * (1. + 0.5 * f)) / radius) << ' '
              << rounded((tip[2] - 0.1) / radius) << ' '
              << rounded(scene->block(f, last / 2)[2] / radius);
    }
  const auto values = scene->report();
  for (const std::string component : {"x", "y", "z"})
    {
      double sum = 0.;
      for (const std::string part :
           {"support_1", "support_2", "support_3", "load_1"})
        sum += values.at(part + "_force_" + component + "[N]");
      deallog << ", sum " << component << ' ' << rounded(sum);
    }
  deallog << ", pull " << 1e6 * values.at("support_2_force_x[N]") << std::endl;
}



/** The last section turns while the fiber stretches. */
void
test_turn(const std::string &element)
{
  const auto scene = make_scene(element);
  scene->clamp("first end");
  auto &turned           = scene->clamp("last end");
  turned.section         = Heddle::Contributions::SupportedSection::turned;
  turned.angle           = "0.5*t";
  turned.axis            = Tensor<1, 3>({0., 0., 2.});
  turned.displacement[0] = "0.02*t";
  scene->build(two_fibers(Tensor<1, 3>({1., 0., 0.})));
  const auto         result = scene->solve(1.);
  const unsigned int last   = scene->last_node();
  Tensor<1, 3>       normal = scene->block(0, last, 1);
  if (element == "director")
    normal = cross_product_3d(normal, scene->block(0, last, 2));
  deallog << element << ": converged " << result.converged << ", angle "
          << std::atan2(normal[1], normal[0]) << ", length of the vector "
          << normal.norm();
  const auto values = scene->report();
  for (const std::string component : {"x", "y", "z"})
    deallog << ", moment " << component << ' '
            << rounded(values.at("support_1_moment_" + component + "[N*mm]") +
                       values.at("support_2_moment_" + component + "[N*mm]"));
  deallog << std::endl;
}



/** Tip displacement of a cantilever along @p direction, across it. */
void
test_frame(const std::string &element, const Tensor<1, 3> &direction)
{
  const auto scene = make_scene(element);
  scene->clamp("first end");
  auto              &load = scene->add_load();
  const Tensor<1, 3> across =
    cross_product_3d(Tensor<1, 3>({0., 0., 1.}), direction);
  for (unsigned int d = 0; d < 2; ++d)
    load.force[d] = std::to_string(across[d]) + "*1e-4*t";
  scene->build(two_fibers(direction));
  const auto   result = scene->solve(1.);
  Tensor<1, 3> motion = scene->block(1, scene->last_node());
  motion -= direction + Tensor<1, 3>({0., 0.5, 0.});
  deallog << element << ": converged " << result.converged << ", along "
          << motion * direction << ", across " << motion * across << std::endl;
}



/** Only the x-component of the end tangents is held. */
void
test_tangent_component()
{
  const auto scene         = make_scene("hermite");
  auto      &held          = scene->clamp("both ends");
  held.section             = Heddle::Contributions::SupportedSection::free;
  held.held_tangent        = {"z"};
  auto &load               = scene->add_load();
  load.force_per_length[1] = load.force_per_length[2] = "1e-5*t";
  scene->build(two_fibers(Tensor<1, 3>({1., 0., 0.})));
  const auto         result  = scene->solve(1.);
  const Tensor<1, 3> tangent = scene->block(0, 0, 1);
  deallog << "one component: converged " << result.converged << ", slopes "
          << tangent[1] << ' ' << rounded(tangent[2]) << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  for (const std::string element : {"hermite", "director"})
    {
      test_displacements(element);
      test_turn(element);
      test_frame(element, Tensor<1, 3>({1., 0., 0.}));
      test_frame(element, Tensor<1, 3>({0.6, 0.8, 0.}));
    }
  test_tangent_component();
}
