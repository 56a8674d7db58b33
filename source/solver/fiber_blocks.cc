#include <heddle/solver/fiber_blocks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /**
       * First shift of an unstable fiber, over the largest stiffness of its
       * positions ...
       */
      constexpr double first_shift = 1e-8;

      /**
       * ... and of its section vectors or tangents, whose stiffness has another
       * unit. Sections of bent fibers that nothing holds yet need about so
       * much.
       */
      constexpr double first_section_shift = 1e-2;

      /**
       * The same, gentle: fibers that are wound around each other are hardly
       * unstable, and a motion that costs less than the shift is found late.
       */
      constexpr double gentle_section_shift = 1e-6;

      /** Both shifts grow by this factor until the fiber is stable, ... */
      constexpr double growth = 10.;

      /** ... but by no more than this. */
      constexpr double largest_growth = 1e8;



      bool
      is_zero(const double *block)
      {
        return std::all_of(
          block, block + 9, [](const double value) { return value == 0.; });
      }
    } // namespace



    FiberBlocks::FiberBlocks(const System::State &state)
      : state(state)
      , section_shift(first_section_shift)
      // An element couples its own blocks; contact couples the positions of
      // four nodes in a row, or the blocks of one interval.
      , n_offsets(std::max(state.space.element().n_blocks(),
                           state.space.n_blocks_per_node() == 2
                             ? 4u
                             : 3 * state.space.n_blocks_per_node() + 1))
      , coupled(state.space.n_blocks_per_node(),
                std::vector<bool>(n_offsets, false))
    {
      for (std::vector<bool> &of_kind : coupled)
        of_kind[0] = true;
    }



    void
    FiberBlocks::set_up(const System::LocalBlocks &tangent, const bool gentle)
    {
      section_shift = gentle ? gentle_section_shift : first_section_shift;
      if (find_couplings(tangent) || groups.empty())
        create();
      for (Group &group : groups)
        factorize(tangent, group);
    }



    void
    FiberBlocks::factorize(const System::LocalBlocks &tangent,
                           Group                     &group) const
    {
      // A compressed fiber may be unstable on its own: shift until it is not.
      std::array<double, n_lanes> grown  = {};
      bool                        stable = false;
      while (!stable)
        {
          group.factors.clear();
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            {
              unsigned int n_taken = 0;
              if (lane < group.fibers.size())
                {
                  take(tangent, group.fibers[lane], grown[lane], lane, group);
                  n_taken = n_rows(group.fibers[lane]);
                }
              for (unsigned int row = n_taken;
                   row < group.factors.structure().n_rows();
                   ++row)
                for (unsigned int d = 0; d < 3; ++d)
                  group.factors.add(
                    lane, group.factors.structure().position(row, row), d, 1.);
            }
          group.factors.factorize();
          stable = true;
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            if (!group.factors.is_positive_definite(lane))
              {
                AssertThrow(
                  grown[lane] <= largest_growth,
                  ExcMessage("The tangent of a fiber is not finite."));
                grown[lane] = std::max(growth * grown[lane], 1.);
                stable      = false;
              }
        }
    }



    void
    FiberBlocks::take(const System::LocalBlocks &tangent,
                      const unsigned int         fiber,
                      const double               grown,
                      const unsigned int         lane,
                      Group                     &group) const
    {
      const unsigned int  first = state.held_blocks(fiber).first;
      std::vector<double> largest(state.space.n_blocks_per_node(), 0.);
      for_each_block(
        tangent,
        fiber,
        [&](const unsigned int row,
            const unsigned int offset,
            const double      *block) {
          if (!coupled[kind(row)][offset])
            return;
          const unsigned int r = row - first;
          group.factors.set_block(
            lane, group.factors.structure().position(r, r + offset), block);
          if (offset == 0)
            for (unsigned int d = 0; d < 3; ++d)
              largest[kind(row)] =
                std::max(largest[kind(row)], std::abs(block[4 * d]));
        });
      if (grown == 0.)
        return;
      for (unsigned int r = 0; r < n_rows(fiber); ++r)
        for (unsigned int d = 0; d < 3; ++d)
          {
            const unsigned int of    = kind(first + r);
            const double       shift = of == 0 ? first_shift : section_shift;
            group.factors.add(lane,
                              group.factors.structure().position(r, r),
                              d,
                              shift * grown * largest[of]);
          }
    }



    void
    FiberBlocks::apply(const double *residual, double *result) const
    {
      for (const Group &group : groups)
        {
          std::array<const double *, n_lanes> residuals = {};
          std::array<double *, n_lanes>       results   = {};
          std::array<unsigned int, n_lanes>   sizes     = {};
          for (unsigned int lane = 0; lane < group.fibers.size(); ++lane)
            {
              const unsigned int f     = group.fibers[lane];
              const unsigned int begin = 3 * state.held_blocks(f).first;
              residuals[lane]          = residual + begin;
              results[lane]            = result + begin;
              sizes[lane]              = n_rows(f);
            }
          group.factors.solve(residuals, sizes, results);
        }
    }



    template <typename Action>
    void
    FiberBlocks::for_each_block(const System::LocalBlocks &tangent,
                                const unsigned int         fiber,
                                const Action              &action) const
    {
      const auto held = state.held_blocks(fiber);
      for (unsigned int row = held.first; row < held.second; ++row)
        tangent.for_each_of_upper_row(
          row, [&](const unsigned int column, const double *block) {
            if (column < held.second && column - row < n_offsets)
              action(row, column - row, block);
          });
    }



    bool
    FiberBlocks::find_couplings(const System::LocalBlocks &tangent)
    {
      bool       more  = false;
      const auto owned = state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        for_each_block(tangent,
                       f,
                       [&](const unsigned int row,
                           const unsigned int offset,
                           const double      *block) {
                         if (!coupled[kind(row)][offset] && !is_zero(block))
                           {
                             coupled[kind(row)][offset] = true;
                             more                       = true;
                           }
                       });
      return more;
    }



    void
    FiberBlocks::create()
    {
      groups.clear();
      const auto                owned = state.space.owned_fibers();
      std::vector<unsigned int> fibers(owned.second - owned.first);
      std::iota(fibers.begin(), fibers.end(), owned.first);
      std::stable_sort(fibers.begin(),
                       fibers.end(),
                       [this](const unsigned int f, const unsigned int g) {
                         return n_rows(f) < n_rows(g);
                       });

      std::shared_ptr<const FactorStructure> last;
      for (auto first = fibers.begin(); first != fibers.end();)
        {
          const auto end =
            first + std::min<std::ptrdiff_t>(n_lanes, fibers.end() - first);
          const unsigned int longest = n_rows(*(end - 1));
          if (!last || last->n_rows() != longest)
            last = structure(longest);
          groups.push_back({{first, end}, CholeskyLanes(last)});
          first = end;
        }
    }



    std::shared_ptr<const FactorStructure>
    FiberBlocks::structure(const unsigned int n_rows) const
    {
      std::vector<std::vector<unsigned int>> columns(n_rows);
      for (unsigned int row = 0; row < n_rows; ++row)
        for (unsigned int column = row;
             column < std::min(n_rows, row + n_offsets);
             ++column)
          if (coupled[kind(row)][column - row])
            columns[row].push_back(column);
      return std::make_shared<const FactorStructure>(columns);
    }
  } // namespace Solver
} // namespace Heddle
