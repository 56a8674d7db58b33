#include <heddle/contributions/near_fibers.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Largest x, y, z, -x, -y and -z: maxima, so that ranks can merge them.
       */
      using Box = std::array<double, 6>;



      Box
      empty_box()
      {
        Box box;
        box.fill(-std::numeric_limits<double>::max());
        return box;
      }



      void
      merge(Box &box, const Box &other)
      {
        for (unsigned int k = 0; k < 6; ++k)
          box[k] = std::max(box[k], other[k]);
      }



      bool
      meet(const Box &a, const Box &b)
      {
        for (unsigned int d = 0; d < 3; ++d)
          if (a[d] + b[d + 3] <= 0. || b[d] + a[d + 3] <= 0.)
            return false;
        return true;
      }



      /** Boxes of the cubics of an own fiber: those of their control points. */
      std::vector<Box>
      interval_boxes(const System::FiberSpace &space,
                     const Centerlines        &centerlines,
                     const unsigned int        f,
                     const double              margin)
      {
        const Contact::Curve curve = centerlines.curve(f);
        std::vector<Box>     boxes(space.fiber(f).n_nodes - 1, empty_box());
        for (unsigned int i = 0; i < boxes.size(); ++i)
          for (const Tensor<1, 3> &x : Contact::control_points(curve, i))
            merge(boxes[i],
                  {{margin + x[0],
                    margin + x[1],
                    margin + x[2],
                    margin - x[0],
                    margin - x[1],
                    margin - x[2]}});
        return boxes;
      }



      /** Grow @p near, nodes of the fiber of @p boxes, by what meets @p other.
       */
      void
      add_near(const std::vector<Box> &boxes,
               const Box              &other,
               System::NodeRange      &near)
      {
        const unsigned int n = boxes.size();
        unsigned int       i = 0;
        for (const unsigned int end = near.empty() ? n : near.begin; i < end;
             ++i)
          if (meet(boxes[i], other))
            {
              near = {i, near.empty() ? i + 2 : near.end};
              break;
            }
        for (i = n; !near.empty() && i + 1 > near.end; --i)
          if (meet(boxes[i - 1], other))
            near.end = i + 1;
      }
    } // namespace



    std::vector<System::GhostFiber>
    find_near_fibers(const System::FiberSpace &space,
                     const Centerlines        &centerlines,
                     const double              margin)
    {
      const auto                    owned = space.owned_fibers();
      std::vector<std::vector<Box>> own_boxes;
      std::vector<double>           boxes(6 * space.n_fibers(),
                                -std::numeric_limits<double>::max());
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          own_boxes.push_back(interval_boxes(space, centerlines, f, margin));
          Box whole = empty_box();
          for (const Box &box : own_boxes.back())
            merge(whole, box);
          std::copy(whole.begin(), whole.end(), boxes.begin() + 6 * f);
        }
      std::vector<double> all_boxes(boxes.size());
      Utilities::MPI::max(boxes, space.communicator(), all_boxes);
      const auto box = [&all_boxes](const unsigned int f) {
        Box result;
        std::copy_n(all_boxes.begin() + 6 * f, 6, result.begin());
        return result;
      };

      // Most fibers of a fabric cross those of the other direction, so that
      // none is found faster in a tree of boxes than one by one.
      const std::pair<unsigned int, unsigned int> foreign[] = {
        {0, owned.first}, {owned.second, space.n_fibers()}};
      // What one rank gets is in ascending order, and ranks are, too.
      std::map<unsigned int, std::vector<System::GhostFiber>> near;
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const Box                                 own = box(f);
          std::map<unsigned int, System::NodeRange> near_rank;
          for (const auto &range : foreign)
            for (unsigned int g = range.first; g < range.second; ++g)
              {
                const Box other = box(g);
                if (meet(own, other))
                  add_near(own_boxes[f - owned.first],
                           other,
                           near_rank[space.owner(g)]);
              }
          for (const auto &piece : near_rank)
            if (!piece.second.empty())
              near[piece.first].push_back(
                {f, space.nodes_below(f, piece.second)});
        }
      std::vector<System::GhostFiber> received;
      for (const auto &from :
           Utilities::MPI::some_to_some(space.communicator(), near))
        received.insert(received.end(), from.second.begin(), from.second.end());
      return received;
    }



    bool
    holds(const System::State                   &state,
          const std::vector<System::GhostFiber> &near)
    {
      return std::all_of(
        near.begin(), near.end(), [&state](const System::GhostFiber &ghost) {
          return state.held_nodes(ghost.fiber).contains(ghost.nodes);
        });
    }



    std::vector<System::GhostFiber>
    lengthened(const System::FiberSpace       &space,
               std::vector<System::GhostFiber> near,
               const unsigned int              n_nodes)
    {
      for (System::GhostFiber &ghost : near)
        ghost.nodes = space.lengthened(ghost.fiber, ghost.nodes, n_nodes);
      return near;
    }
  } // namespace Contributions
} // namespace Heddle
