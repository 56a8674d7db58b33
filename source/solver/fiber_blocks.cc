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
      unstable = false;
      for (Group &group : groups)
        {
          take(tangent, group);
          factorize(group);
        }
    }



    void
    FiberBlocks::take(const System::LocalBlocks &tangent, Group &group) const
    {
      const BlockStructure &structure = group.bands.structure();
      const double          one[9]    = {1., 0., 0., 0., 1., 0., 0., 0., 1.};
      group.bands.clear();
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        {
          unsigned int n_taken = 0;
          if (lane < group.fibers.size())
            {
              const unsigned int fiber = group.fibers[lane];
              const unsigned int first = state.held_blocks(fiber).first;
              n_taken                  = n_rows(fiber);
              for_each_block(
                tangent,
                fiber,
                [&](const unsigned int row,
                    const unsigned int offset,
                    const double      *block) {
                  const unsigned int r = row - first;
                  if (coupled[kind(row)][offset])
                    group.bands.set_block(
                      lane, structure.position(r, r + offset), block);
                },
                [](const double *) {});
            }
          for (unsigned int row = n_taken; row < structure.n_rows(); ++row)
            group.bands.set_block(lane, structure.row_begin[row], one);
        }
    }



    void
    FiberBlocks::factorize(Group &group)
    {
      // A compressed fiber may be unstable on its own: shift until it is not.
      std::array<double, n_lanes> grown  = {};
      bool                        stable = false;
      while (!stable)
        {
          group.factors.take(group.bands);
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            if (grown[lane] > 0.)
              shift(lane, grown[lane], group);
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
                unstable    = true;
              }
        }
    }



    void
    FiberBlocks::shift(const unsigned int lane,
                       const double       grown,
                       Group             &group) const
    {
      Assert(lane < group.fibers.size(), ExcInternalError());
      const unsigned int  n     = n_rows(group.fibers[lane]);
      const unsigned int  first = state.held_blocks(group.fibers[lane]).first;
      std::vector<double> largest(state.space.n_blocks_per_node(), 0.);
      for (unsigned int r = 0; r < n; ++r)
        for (unsigned int d = 0; d < 3; ++d)
          largest[kind(first + r)] =
            std::max(largest[kind(first + r)],
                     std::abs(group.bands.diagonal(lane, r, d)));
      for (unsigned int r = 0; r < n; ++r)
        for (unsigned int d = 0; d < 3; ++d)
          {
            const unsigned int of = kind(first + r);
            group.factors.add(lane,
                              r,
                              d,
                              (of == 0 ? first_shift : section_shift) * grown *
                                largest[of]);
          }
    }



    void
    FiberBlocks::apply(const double *residual, double *result) const
    {
      for (const Group &group : groups)
        group.factors.solve(parts(group, residual), results(group, result));
    }



    void
    FiberBlocks::multiply(const double *vector, double *product) const
    {
      for (const Group &group : groups)
        group.bands.multiply(parts(group, vector), results(group, product));
    }



    MatrixLanes::Vectors
    FiberBlocks::parts(const Group &group, const double *vector) const
    {
      MatrixLanes::Vectors found = {};
      for (unsigned int lane = 0; lane < group.fibers.size(); ++lane)
        {
          const unsigned int fiber = group.fibers[lane];
          found.begin[lane]  = vector + 3 * state.held_blocks(fiber).first;
          found.n_rows[lane] = n_rows(fiber);
        }
      return found;
    }



    std::array<double *, FiberBlocks::n_lanes>
    FiberBlocks::results(const Group &group, double *vector) const
    {
      std::array<double *, n_lanes> found = {};
      for (unsigned int lane = 0; lane < group.fibers.size(); ++lane)
        found[lane] = vector + 3 * state.held_blocks(group.fibers[lane]).first;
      return found;
    }



    template <typename Action, typename OtherAction>
    void
    FiberBlocks::for_each_block(const System::LocalBlocks &tangent,
                                const unsigned int         fiber,
                                const Action              &action,
                                const OtherAction         &others) const
    {
      const auto held = state.held_blocks(fiber);
      for (unsigned int row = held.first; row < held.second; ++row)
        tangent.for_each_of_upper_row(
          row, [&](const unsigned int column, const double *block) {
            if (column < held.second && column - row < n_offsets)
              action(row, column - row, block);
            else
              others(block);
          });
    }



    bool
    FiberBlocks::find_couplings(const System::LocalBlocks &tangent)
    {
      bool more        = false;
      no_others        = state.matrix() == nullptr;
      const auto owned = state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        for_each_block(
          tangent,
          f,
          [&](const unsigned int row,
              const unsigned int offset,
              const double      *block) {
            if (!coupled[kind(row)][offset] && !is_zero(block))
              {
                coupled[kind(row)][offset] = true;
                more                       = true;
              }
          },
          [&](const double *block) {
            no_others = no_others && is_zero(block);
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

      std::shared_ptr<const BlockStructure>  of_bands;
      std::shared_ptr<const FactorStructure> of_factors;
      for (auto first = fibers.begin(); first != fibers.end();)
        {
          const auto end =
            first + std::min<std::ptrdiff_t>(n_lanes, fibers.end() - first);
          const unsigned int longest = n_rows(*(end - 1));
          if (!of_bands || of_bands->n_rows() != longest)
            {
              of_bands   = structure(longest);
              of_factors = std::make_shared<const FactorStructure>(*of_bands);
            }
          groups.push_back(
            {{first, end}, MatrixLanes(of_bands), CholeskyLanes(of_factors)});
          first = end;
        }
    }



    std::shared_ptr<const BlockStructure>
    FiberBlocks::structure(const unsigned int n_rows) const
    {
      std::vector<std::vector<unsigned int>> columns(n_rows);
      for (unsigned int row = 0; row < n_rows; ++row)
        for (unsigned int column = row;
             column < std::min(n_rows, row + n_offsets);
             ++column)
          if (coupled[kind(row)][column - row])
            columns[row].push_back(column);
      return std::make_shared<const BlockStructure>(columns);
    }
  } // namespace Solver
} // namespace Heddle
