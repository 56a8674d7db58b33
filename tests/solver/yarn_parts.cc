// Yarns of 1, 2, 13, 36 and 102 fibers in no order, along and across: parts
// have the fibers of their yarn, each of them once; they differ by one fiber
// at most; the boxes around them, in the section at the middle, do not overlap.
#include <heddle/solver/yarn_parts.h>

#include <deal.II/base/bounding_box.h>

#include "../contributions/scene.h"

#include <algorithm>
#include <random>
#include <set>

class Yarns : public Scene
{
public:
  Yarns()
  {
    std::mt19937                           generator(1);
    std::uniform_real_distribution<double> number(-1., 1.);
    std::vector<Textile::FiberPath>        paths;
    for (unsigned int yarn = 0; yarn < sizes.size(); ++yarn)
      for (unsigned int i = 0; i < sizes[yarn]; ++i)
        {
          // A section that is twice as wide as high; yarns cross in one place.
          const double       u = 2. * number(generator), z = number(generator);
          const Tensor<1, 3> begin = yarn % 2 == 0 ? Tensor<1, 3>({-9., u, z})
                                                   : Tensor<1, 3>({u, -9., z});
          const Tensor<1, 3> along = yarn % 2 == 0
                                       ? Tensor<1, 3>({18., 0., 0.})
                                       : Tensor<1, 3>({0., 18., 0.});
          paths.push_back(straight_path(begin, begin + along, 5, 0.1));
          paths.back().yarn_id = yarn;
        }
    std::shuffle(paths.begin(), paths.end(), generator);
    build(paths);
  }

  /** The box around the middles of fibers, in their section. */
  BoundingBox<2>
  box(const Solver::FiberNumbers &fibers) const
  {
    std::vector<double> middles(2 * space->n_fibers(), 0.);
    for (const unsigned int f : fibers)
      if (space->owns(f))
        {
          const bool         along = space->fiber(f).yarn_id % 2 == 0;
          const Tensor<1, 3> middle =
            state->block(f, 2 * space->n_blocks_per_node());
          middles[2 * f]     = middle[along ? 1 : 0];
          middles[2 * f + 1] = middle[2];
        }
    Utilities::MPI::sum(middles, MPI_COMM_WORLD, middles);
    std::vector<Point<2>> points;
    for (const unsigned int f : fibers)
      points.emplace_back(middles[2 * f], middles[2 * f + 1]);
    return BoundingBox<2>(points);
  }

  const std::vector<unsigned int> sizes = {1, 2, 13, 36, 102};
};



int
main(int argc, char **argv)
{
  MPITest                                                   test(argc, argv);
  Yarns                                                     yarns;
  std::map<unsigned int, std::vector<Solver::FiberNumbers>> parts;
  for (const Solver::FiberNumbers &part : Solver::yarn_parts(*yarns.state))
    parts[yarns.space->fiber(part.front()).yarn_id].push_back(part);

  for (const auto &[yarn, of_yarn] : parts)
    {
      std::set<unsigned int> fibers;
      bool                   alike = true, apart = true;
      deallog << yarns.sizes[yarn] << " fibers, parts of";
      for (const Solver::FiberNumbers &part : of_yarn)
        {
          deallog << ' ' << part.size();
          for (const unsigned int f : part)
            {
              fibers.insert(f);
              alike = alike && yarns.space->fiber(f).yarn_id == yarn;
            }
          for (const Solver::FiberNumbers &other : of_yarn)
            if (&other != &part)
              apart =
                apart && yarns.box(part).get_neighbor_type(yarns.box(other)) ==
                           NeighborType::not_neighbors;
        }
      deallog << ": all " << (fibers.size() == yarns.sizes[yarn])
              << ", of one yarn " << alike << ", apart " << apart << std::endl;
    }
}
