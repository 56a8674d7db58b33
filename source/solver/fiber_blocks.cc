#include <heddle/solver/fiber_blocks.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      constexpr unsigned int size = CholeskyBlocks::size;

      /**
       * So many rows, at least, are factorized together, if there are so many:
       * some 300 kB.
       */
      constexpr unsigned int rows_of_group = 512;

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
          block, block + size, [](const double value) { return value == 0.; });
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
        {
          double *values = group.blocks->values();
          std::fill(values, values + size * group.blocks->n_blocks(), 0.);
          for_each_block(
            tangent,
            group.first_fiber,
            group.end_fiber,
            [&](const unsigned int row,
                const unsigned int offset,
                const double      *block) {
              if (coupled[kind(row)][offset])
                std::copy_n(
                  block, size, values + size * position(group, row, offset));
            });
          factorize(group);
        }
    }



    void
    FiberBlocks::factorize(Group &group)
    {
      // A compressed fiber may be unstable on its own: shift until it is not.
      for (double grown = 0.;;)
        {
          group.blocks->factorize();
          const std::vector<unsigned int> unstable = find_unstable(group);
          if (unstable.empty())
            return;
          AssertThrow(grown <= largest_growth,
                      ExcMessage("The tangent of a fiber is not finite."));
          const double next = std::max(growth * grown, 1.);
          for (const unsigned int f : unstable)
            shift(group, f, grown, next);
          grown = next;
        }
    }



    PetscErrorCode
    FiberBlocks::apply(const double *residual, double *result) const
    {
      PetscErrorCode code = 0;
      for (const Group &group : groups)
        if (code == 0)
          code = group.blocks->solve(residual + 3 * group.first_row,
                                     result + 3 * group.first_row);
      return code;
    }



    template <typename Action>
    void
    FiberBlocks::for_each_block(const System::LocalBlocks &tangent,
                                const unsigned int         first_fiber,
                                const unsigned int         end_fiber,
                                const Action              &action) const
    {
      for (unsigned int f = first_fiber; f < end_fiber; ++f)
        {
          const auto held = state.held_blocks(f);
          for (unsigned int row = held.first; row < held.second; ++row)
            tangent.for_each_of_upper_row(
              row, [&](const unsigned int column, const double *block) {
                if (column < held.second && column - row < n_offsets)
                  action(row, column - row, block);
              });
        }
    }



    bool
    FiberBlocks::find_couplings(const System::LocalBlocks &tangent)
    {
      bool       more  = false;
      const auto owned = state.space.owned_fibers();
      for_each_block(tangent,
                     owned.first,
                     owned.second,
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
      rank_of_offset.assign(coupled.size(),
                            std::vector<unsigned int>(n_offsets + 1, 0));
      for (unsigned int k = 0; k < coupled.size(); ++k)
        for (unsigned int offset = 0; offset < n_offsets; ++offset)
          rank_of_offset[k][offset + 1] =
            rank_of_offset[k][offset] + (coupled[k][offset] ? 1 : 0);

      row_begin.assign(1, 0);
      const auto   owned = state.space.owned_fibers();
      unsigned int first = owned.first;
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const unsigned int end = state.held_blocks(f).second;
          if (end - state.held_blocks(first).first >= rows_of_group ||
              f + 1 == owned.second)
            {
              add_group(first, f + 1);
              first = f + 1;
            }
        }
    }



    void
    FiberBlocks::add_group(const unsigned int first_fiber,
                           const unsigned int end_fiber)
    {
      const unsigned int first_row = state.held_blocks(first_fiber).first;
      std::vector<std::vector<PetscInt>> columns;
      for (unsigned int f = first_fiber; f < end_fiber; ++f)
        {
          const auto held = state.held_blocks(f);
          for (unsigned int row = held.first; row < held.second; ++row)
            {
              columns.emplace_back();
              for (unsigned int column = row;
                   column < std::min(held.second, row + n_offsets);
                   ++column)
                if (coupled[kind(row)][column - row])
                  columns.back().push_back(column - first_row);
              row_begin.push_back(row_begin.back() + columns.back().size());
            }
        }
      groups.push_back({first_fiber,
                        end_fiber,
                        first_row,
                        std::make_unique<CholeskyBlocks>(columns)});
    }



    void
    FiberBlocks::shift(Group             &group,
                       const unsigned int fiber,
                       const double       before,
                       const double       after)
    {
      double    *values            = group.blocks->values();
      const auto held              = state.held_blocks(fiber);
      const auto for_each_diagonal = [&](const auto &action) {
        for (unsigned int row = held.first; row < held.second; ++row)
          for (unsigned int d = 0; d < 3; ++d)
            action(kind(row), values[size * position(group, row, 0) + 4 * d]);
      };
      std::vector<double> largest(state.space.n_blocks_per_node(), 0.);
      for_each_diagonal([&](const unsigned int kind, const double value) {
        largest[kind] = std::max(largest[kind], std::abs(value));
      });

      // What was added last is in the largest ones, too.
      for_each_diagonal([&](const unsigned int kind, double &value) {
        const double first = kind == 0 ? first_shift : section_shift;
        value +=
          first * (after - before) / (1. + first * before) * largest[kind];
      });
    }



    std::vector<unsigned int>
    FiberBlocks::find_unstable(const Group &group) const
    {
      std::vector<unsigned int> unstable;
      for (unsigned int f = group.first_fiber; f < group.end_fiber; ++f)
        {
          const auto held = state.held_blocks(f);
          for (unsigned int row = held.first; row < held.second; ++row)
            if (!group.blocks->is_positive_definite(row - group.first_row))
              {
                unstable.push_back(f);
                break;
              }
        }
      return unstable;
    }
  } // namespace Solver
} // namespace Heddle
