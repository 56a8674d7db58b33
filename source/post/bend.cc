#include <heddle/post/bend.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

namespace Heddle
{
  namespace Post
  {
    std::string
    Bend::in_words() const
    {
      std::ostringstream text;
      text << std::setprecision(2) << "fiber " << fiber << " is bent to "
           << 1. / ratio << " times its own radius near ("
           << std::setprecision(3) << position[0] << ", " << position[1] << ", "
           << position[2] << ")";
      return text.str();
    }



    Bend
    sharpest_bend(const System::State &state)
    {
      const System::FiberSpace &space = state.space;
      Bend                      bend;
      std::vector<Tensor<1, 3>> positions, tangents;
      const auto                range = space.owned_fibers();
      for (unsigned int f = range.first; f < range.second; ++f)
        {
          const System::Fiber &fiber = space.fiber(f);
          positions.resize(fiber.n_nodes);
          tangents.resize(fiber.n_nodes);
          space.centerline_knots(f,
                                 space.all_nodes(f),
                                 state.fiber(f),
                                 positions.data(),
                                 tangents.data());
          // The second derivative of a cubic is largest at one of its ends.
          const double *nodes = space.node_positions(f);
          for (unsigned int i = 0; i + 1 < fiber.n_nodes; ++i)
            {
              const double       h    = nodes[i + 1] - nodes[i];
              const Tensor<1, 3> mean = (positions[i + 1] - positions[i]) / h;
              const auto         take = [&](const unsigned int  node,
                                    const Tensor<1, 3> &second) {
                const Tensor<1, 3> &t     = tangents[node];
                const double        ratio = fiber.radius *
                                     cross_product_3d(t, second).norm() /
                                     std::pow(t.norm(), 3);
                if (ratio > bend.ratio)
                  bend = {ratio, f, Point<3>(positions[node])};
              };
              take(i,
                   (6. * mean - 4. * tangents[i] - 2. * tangents[i + 1]) / h);
              take(i + 1,
                   (2. * tangents[i] + 4. * tangents[i + 1] - 6. * mean) / h);
            }
        }
      const auto sharpest =
        Utilities::MPI::min_max_avg(bend.ratio, space.communicator());
      return Utilities::MPI::broadcast(
        space.communicator(), bend, sharpest.max_index);
    }
  } // namespace Post
} // namespace Heddle
