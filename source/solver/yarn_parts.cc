#include <heddle/solver/yarn_parts.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /**
       * Fibers of a part, at most, as long as that makes no more than so many
       * parts of a yarn, for the coarse system grows with them. In load steps
       * of the paper's fabric parts of 36, 18, 12, 9 and 6 fibers take 45, 36,
       * 30, 34 and 31 iterations of conjugate gradients
       * (doc/what_was_tried.md).
       */
      constexpr unsigned int largest_part = 12;
      constexpr unsigned int most_parts   = 4;

      using Places = std::vector<Tensor<1, 3>>;



      /** The middle node of every fiber [mm]. */
      Places
      middles(const System::State &state)
      {
        const System::FiberSpace &space = state.space;
        std::vector<double>       numbers(3 * space.n_fibers(), 0.);
        const auto                owned = space.owned_fibers();
        for (unsigned int f = owned.first; f < owned.second; ++f)
          {
            const unsigned int middle =
              space.n_blocks_per_node() * (space.fiber(f).n_nodes / 2);
            for (unsigned int d = 0; d < 3; ++d)
              numbers[3 * f + d] = state.block(f, middle)[d];
          }
        Utilities::MPI::sum(numbers, space.communicator(), numbers);

        Places places(space.n_fibers());
        for (unsigned int f = 0; f < places.size(); ++f)
          for (unsigned int d = 0; d < 3; ++d)
            places[f][d] = numbers[3 * f + d];
        return places;
      }



      /** The direction of the axes in which @p fibers are furthest apart. */
      unsigned int
      longest_side(const FiberNumbers &fibers, const Places &places)
      {
        Tensor<1, 3> size;
        for (unsigned int d = 0; d < 3; ++d)
          {
            const auto ends = std::minmax_element(
              fibers.begin(), fibers.end(), [&](const auto a, const auto b) {
                return places[a][d] < places[b][d];
              });
            size[d] = places[*ends.second][d] - places[*ends.first][d];
          }
        return std::max_element(size.begin_raw(), size.end_raw()) -
               size.begin_raw();
      }



      /** Add @p n_parts of @p fibers to @p parts. */
      void
      divide(FiberNumbers               fibers,
             const unsigned int         n_parts,
             const Places              &places,
             std::vector<FiberNumbers> &parts)
      {
        if (n_parts == 1)
          {
            parts.push_back(std::move(fibers));
            return;
          }
        const unsigned int d = longest_side(fibers, places);
        std::sort(
          fibers.begin(), fibers.end(), [&](const auto a, const auto b) {
            return std::make_pair(places[a][d], a) <
                   std::make_pair(places[b][d], b);
          });
        const unsigned int half = n_parts / 2;
        const auto where = fibers.begin() + fibers.size() * half / n_parts;
        divide({fibers.begin(), where}, half, places, parts);
        divide({where, fibers.end()}, n_parts - half, places, parts);
      }
    } // namespace



    std::vector<FiberNumbers>
    yarn_parts(const System::State &state)
    {
      std::map<unsigned int, FiberNumbers> yarns;
      for (unsigned int f = 0; f < state.space.n_fibers(); ++f)
        yarns[state.space.fiber(f).yarn_id].push_back(f);

      const Places              places = middles(state);
      std::vector<FiberNumbers> parts;
      for (const auto &[yarn, fibers] : yarns)
        if (fibers.size() > 1)
          {
            const unsigned int n_parts =
              (fibers.size() + largest_part - 1) / largest_part;
            divide(fibers, std::min(n_parts, most_parts), places, parts);
          }
      return parts;
    }
  } // namespace Solver
} // namespace Heddle
