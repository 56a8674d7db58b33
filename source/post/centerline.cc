#include <heddle/base/gather.h>
#include <heddle/post/centerline.h>

#include <deal.II/base/numbers.h>

#include <limits>
#include <sstream>

namespace Heddle
{
  namespace Post
  {
    Polyline
    centerline(const System::State &state,
               const unsigned int   f,
               const unsigned int   n_pieces)
    {
      const System::FiberSpace &space   = state.space;
      const unsigned int        n_nodes = space.fiber(f).n_nodes;
      const double             *nodes   = space.node_positions(f);
      Polyline                  positions(n_nodes);
      Polyline                  tangents(n_nodes);
      space.centerline_knots(f,
                             space.all_nodes(f),
                             state.fiber(f),
                             positions.data(),
                             tangents.data());

      Polyline line(1, positions[0]);
      for (unsigned int i = 0; i + 1 < n_nodes; ++i)
        for (unsigned int k = 1; k <= n_pieces; ++k)
          {
            const double h = nodes[i + 1] - nodes[i];
            const double s = static_cast<double>(k) / n_pieces;
            const double r = 1. - s;
            line.push_back(r * r * (1. + 2. * s) * positions[i] +
                           s * s * (1. + 2. * r) * positions[i + 1] +
                           h * s * r * (r * tangents[i] - s * tangents[i + 1]));
          }
      return line;
    }



    std::vector<Polyline>
    gather_centerlines(const System::State &state, const unsigned int n_pieces)
    {
      // The number of points per fiber is known.
      std::vector<double> own;
      const auto          range = state.space.owned_fibers();
      for (unsigned int f = range.first; f < range.second; ++f)
        for (const Tensor<1, 3> &point : centerline(state, f, n_pieces))
          own.insert(own.end(), {point[0], point[1], point[2]});
      const std::vector<double> all =
        gather_on_first(own, state.space.communicator());

      std::vector<Polyline> lines;
      const double         *next = all.data();
      for (unsigned int f = 0; next != all.data() + all.size(); ++f)
        {
          lines.emplace_back((state.space.fiber(f).n_nodes - 1) * n_pieces + 1);
          for (Tensor<1, 3> &point : lines.back())
            for (unsigned int d = 0; d < 3; ++d)
              point[d] = *next++;
        }
      return lines;
    }



    std::string
    centerlines_csv(const System::State &state)
    {
      const auto         lines = gather_centerlines(state, /*n_pieces=*/1);
      std::ostringstream out;
      out.precision(std::numeric_limits<double>::max_digits10);
      out << "fiber,x,y,z,radius,set,yarn\n";
      for (unsigned int f = 0; f < lines.size(); ++f)
        {
          const System::Fiber &fiber = state.space.fiber(f);
          const std::string    yarn =
            fiber.yarn_id == numbers::invalid_unsigned_int
                 ? ""
                 : std::to_string(fiber.yarn_id);
          for (const Tensor<1, 3> &node : lines[f])
            out << f << ',' << node[0] << ',' << node[1] << ',' << node[2]
                << ',' << fiber.radius << ',' << fiber.set << ',' << yarn
                << '\n';
        }
      return out.str();
    }
  } // namespace Post
} // namespace Heddle
