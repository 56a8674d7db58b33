// Written as a table and read again, the nodes of all fibers are the same to
// the last digit, in their order, with radius, set and yarn.
#include <heddle/post/centerline.h>
#include <heddle/simulation/fiber_placement.h>
#include <heddle/textile/csv_table.h>
#include <heddle/textile/path_reader.h>

#include <deal.II/base/mpi.h>

#include "../tests.h"

#include <sstream>

using namespace Heddle;



/** A straight fiber in four elements, of lengths that no decimals hold. */
Textile::FiberPath
fiber(const unsigned int number,
      const std::string &set,
      const unsigned int yarn)
{
  Textile::FiberPath path;
  path.yarn_id = yarn;
  for (unsigned int i = 0; i <= 4; ++i)
    path.points.push_back(Tensor<1, 3>({i / 3., number / 7., -1e-5 / 3.}));
  path.reference_length = 4. / 3.;
  path.radius           = 0.1 / (number + 3.);
  path.set              = set;
  return path;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);

  Simulation::FiberParameters           parameters;
  const std::vector<Textile::FiberPath> paths = {
    fiber(0, "warp", 0), fiber(1, "", Textile::no_id), fiber(2, "weft", 1)};
  const auto space = Simulation::make_space(paths, parameters, MPI_COMM_WORLD);
  System::State state(*space);
  const auto    blocks = Simulation::place_on_paths(*space, paths);
  std::copy(
    blocks.begin(), blocks.end(), state.fiber(space->owned_fibers().first));

  const std::string text = Post::centerlines_csv(state);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    {
      AssertThrow(text == "fiber,x,y,z,radius,set,yarn\n", ExcInternalError());
      return 0;
    }
  std::istringstream input(text);
  Textile::CsvTable  table(input,
                          "centerlines.csv",
                          {"fiber", "x", "y", "z", "radius", "set", "yarn"},
                          {});
  unsigned int       n_same = 0;
  for (unsigned int f = 0; f < paths.size(); ++f)
    for (const Tensor<1, 3> &point : paths[f].points)
      {
        table.next();
        n_same +=
          table.number("fiber") == f && table.number("x") == point[0] &&
          table.number("y") == point[1] && table.number("z") == point[2] &&
          table.number("radius") == paths[f].radius &&
          table.text("set") == paths[f].set &&
          table.text("yarn") == std::vector<std::string>{"0", "", "1"}[f];
      }
  deallog << n_same << " nodes are the same, more follow: " << table.next()
          << std::endl;

  std::istringstream   again(text);
  Textile::PathReading reading;
  reading.element_length = 1. / 3.;
  for (const Textile::FiberPath &path :
       Textile::read_paths(again, "centerlines.csv", reading))
    deallog << "set '" << path.set << "', yarn "
            << static_cast<int>(path.yarn_id) << ", radius " << path.radius
            << ", " << path.points.size() << " knots, to " << path.points.back()
            << std::endl;
}
