// What a user can do wrong with supports and loads is told in one sentence.
#include <heddle/base/choice.h>
#include <heddle/base/exceptions.h>
#include <heddle/base/parameter_file.h>

#include "scene.h"

#include <fstream>
#include <functional>

void
expect_error(const std::function<void()> &action)
{
  try
    {
      action();
      deallog << "FAIL: no error" << std::endl;
    }
  catch (const InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



/** Read a parameter file with these statements in one section. */
void
read(const std::string &list,
     const std::string &entry,
     const std::string &statements)
{
  {
    std::ofstream file("scene.prm");
    file << "subsection " << list << "\nsubsection " << entry << '\n'
         << statements << "\nend\nend\n";
  }
  expect_error([]() {
    const ParameterFile file("scene.prm");
    const auto          supports = Contributions::declare_supports(file);
    const auto          loads    = Contributions::declare_loads(file);
    file.apply();
  });
  // The complaint came from within the section of the entry.
  ParameterAcceptor::prm.leave_subsection();
  ParameterAcceptor::prm.leave_subsection();
  ParameterAcceptor::clear();
}



/** Build a scene of two fibers, of the set "warp" and of none. */
void
build(const std::function<void(Scene &)> &describe,
      const std::string                  &element = "hermite")
{
  expect_error([&]() {
    Scene scene;
    scene.fibers.element_kind =
      Heddle::choice<Heddle::Beam::ElementKind>(element);
    describe(scene);
    std::vector<Textile::FiberPath> paths;
    for (const double y : {0., 1.})
      paths.push_back(straight_path(Tensor<1, 3>({0., y, 0.}),
                                    Tensor<1, 3>({1., y, 0.}),
                                    /*n_knots=*/5,
                                    /*radius=*/0.01));
    paths[0].set = "warp";
    scene.build(paths);
    scene.solve(1.);
  });
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  read("Supports", "Support 1", "set Displacement x = 2*q");
  read("Supports", "Support 1", "set Displacement x = 2*");
  read("Supports", "Support 1", "set Nodes = last end");
  read("Supports", "Support 1", "set Section = turned\nset Turn axis = 0,0,0");
  read("Supports",
       "Support 1",
       "set Section = held\nset Held tangent components = x");
  read("Loads", "Load 1", "set Moment z = sin(");
  build([](Scene &scene) { scene.clamp("both ends", "wrap"); });
  build([](Scene &scene) { scene.clamp("both ends", "warp, 2"); });
  build([](Scene &scene) { scene.clamp("both ends", ""); });
  build([](Scene &scene) {
    scene.clamp("near point").nodes.point = Point<3>(0.5, 0.25, 0.);
  });
  build([](Scene &scene) {
    scene.clamp("first end");
    scene.clamp("first end", "1").displacement[1] = "t";
  });
  build([](Scene &scene) {
    scene.clamp("first end");
    scene.clamp("both ends").section =
      Heddle::Contributions::SupportedSection::turned;
  });
  build(
    [](Scene &scene) {
      auto &support        = scene.clamp("first end");
      support.section      = Heddle::Contributions::SupportedSection::free;
      support.held_tangent = {"x"};
    },
    "director");
  build([](Scene &scene) { scene.clamp("both ends").displacement[0] = "1/x"; });
}
