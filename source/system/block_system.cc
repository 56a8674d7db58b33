#include <heddle/base/petsc.h>
#include <heddle/system/block_system.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace Heddle
{
  namespace System
  {
    namespace
    {
      bool
      on_any_rank(const State &state, const bool here)
      {
        return Utilities::MPI::max(here ? 1 : 0, state.space.communicator()) >
               0;
      }



      /**
       * What stands in the rows of prescribed components of owned blocks: E A
       * per element length of positions, times that length of other blocks of a
       * fiber, which is as stiff as fibers are, in any unit. Nodes of a matrix
       * keep 1: no correction spreads over what it holds.
       */
      std::vector<double>
      stiffnesses_of_held(const State &state)
      {
        const FiberSpace   &space = state.space;
        std::vector<double> stiffnesses(state.n_owned_blocks(), 1.);
        const auto          owned = space.owned_fibers();
        for (unsigned int f = owned.first; f < owned.second; ++f)
          {
            const Fiber &fiber     = space.fiber(f);
            const double length    = fiber.length / fiber.n_elements;
            const double stiffness = fiber.section.axial / length;
            for (unsigned int b = 0; b < space.n_blocks(f); ++b)
              stiffnesses[state.local_block(f) + b] =
                b % space.n_blocks_per_node() == 0
                  ? stiffness
                  : stiffness * length * length;
          }
        return stiffnesses;
      }



      /** Write the values of owned blocks into a vector. */
      void
      fill(Vec vector, const std::vector<Tensor<1, 3>> &of_blocks)
      {
        double *values;
        petsc(VecGetArray(vector, &values));
        for (unsigned int b = 0; b < of_blocks.size(); ++b)
          for (unsigned int d = 0; d < 3; ++d)
            values[3 * b + d] = of_blocks[b][d];
        petsc(VecRestoreArray(vector, &values));
      }


    } // namespace



    BlockSystem::BlockSystem(const State &state, const bool couplings_apart)
      : state(state)
      , couplings_apart(couplings_apart)
      , held_stiffnesses(stiffnesses_of_held(state))
    {
      const PetscInt n_owned = 3 * state.n_owned_blocks();
      petsc(VecCreateMPI(
        state.space.communicator(), n_owned, PETSC_DETERMINE, &increment));
      petsc(VecDuplicate(increment, &rhs));
    }



    BlockSystem::~BlockSystem()
    {
      own.reset();
      MatDestroy(&matrix);
      VecDestroy(&rhs);
      VecDestroy(&increment);
    }



    void
    BlockSystem::set_pattern(const BlockPattern &pattern)
    {
      const unsigned int n_owned = state.n_owned_blocks();
      global_blocks              = state.global_blocks();
      ghost_version              = state.ghost_version();
      is_of_others               = false;

      std::vector<PetscInt> row_begin(1, 0), columns;
      const auto            blocks  = pattern.columns();
      bool                  foreign = false;
      for (unsigned int row = 0; row < n_owned; ++row)
        {
          const auto begin = columns.size();
          for (const unsigned int block : blocks[row])
            {
              foreign = foreign || block >= n_owned;
              if (global_blocks[block] >= global_blocks[row])
                columns.push_back(global_blocks[block]);
            }
          std::sort(columns.begin() + begin, columns.end());
          row_begin.push_back(columns.size());
        }

      any_foreign = on_any_rank(state, foreign);

      own.reset();
      petsc(MatDestroy(&matrix));
      petsc(MatCreate(state.space.communicator(), &matrix));
      petsc(MatSetSizes(
        matrix, 3 * n_owned, 3 * n_owned, PETSC_DETERMINE, PETSC_DETERMINE));
      petsc(MatSetType(matrix, MATSBAIJ));
      petsc(MatSetBlockSize(matrix, 3));
      petsc(MatSeqSBAIJSetPreallocationCSR(
        matrix, 3, row_begin.data(), columns.data(), nullptr));
      petsc(MatMPISBAIJSetPreallocationCSR(
        matrix, 3, row_begin.data(), columns.data(), nullptr));
      petsc(MatSetOption(matrix, MAT_IGNORE_LOWER_TRIANGULAR, PETSC_TRUE));
      petsc(MatSetOption(matrix, MAT_NEW_NONZERO_LOCATION_ERR, PETSC_TRUE));
      petsc(MatSetOption(matrix, MAT_NO_OFF_PROC_ENTRIES, PETSC_TRUE));
    }



    void
    BlockSystem::begin(const Want new_want)
    {
      want = new_want;
      prescribed.set_n_blocks(state.n_local_blocks());
      forces.assign(state.n_owned_blocks(), Tensor<1, 3>());
      if (wants_tangent())
        {
          lifting.assign(state.n_owned_blocks(), Tensor<1, 3>());
          unsymmetric.clear();
          of_axes.clear();
          of_sections.clear();
          // PETSc zeroes assembled matrices only: finish what was not.
          own.reset();
          petsc(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
          petsc(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
          petsc(MatZeroEntries(matrix));
          own = std::make_unique<LocalBlocks>(matrix);
        }
    }



    void
    BlockSystem::forget_couplings()
    {
      unsymmetric = UnsymmetricTerms();
      of_axes     = AxisCouplings();
      of_sections = SectionCouplings();
    }



    void
    BlockSystem::add(const unsigned int  n,
                     const unsigned int *blocks,
                     const double       *residual,
                     const double       *tangent)
    {
      AssertThrow(n <= max_blocks_of_term,
                  ExcIndexRange(n, 0, max_blocks_of_term + 1));
      const unsigned int n_owned = state.n_owned_blocks();
      for (unsigned int i = 0; i < n; ++i)
        if (blocks[i] < n_owned)
          for (unsigned int d = 0; d < 3; ++d)
            forces[blocks[i]][d] += residual[3 * i + d];
      if (!wants_tangent())
        return;

      if (prescribed.is_any_constrained(n, blocks))
        {
          work.assign(tangent, tangent + 9 * n * n);
          prescribed.eliminate(n, blocks, work.data(), lifting);
          tangent = work.data();
        }

      insert(n, blocks, tangent);
    }



    void
    BlockSystem::insert(const unsigned int  n,
                        const unsigned int *blocks,
                        const double       *tangent)
    {
      // In ascending order own blocks come first.
      const unsigned int n_owned = state.n_owned_blocks();
      std::array<unsigned int, max_blocks_of_term> places, sorted;
      std::iota(places.begin(), places.begin() + n, 0);
      if (!std::is_sorted(blocks, blocks + n))
        std::sort(places.begin(),
                  places.begin() + n,
                  [blocks](const unsigned int i, const unsigned int j) {
                    return blocks[i] < blocks[j];
                  });
      unsigned int n_own = 0;
      for (unsigned int k = 0; k < n; ++k)
        {
          sorted[k] = blocks[places[k]];
          n_own += sorted[k] < n_owned ? 1 : 0;
        }

      // Rows of other ranks are theirs to add.
      std::array<double, 9 * max_blocks_of_term> row_values;
      std::array<PetscInt, max_blocks_of_term>   columns;
      for (unsigned int r = 0; r < n_own; ++r)
        {
          const double *rows = tangent + 9 * n * places[r];
          own->add_to_row(
            sorted[r], n_own, sorted.data(), places.data(), rows, 3 * n);
          const unsigned int n_foreign = n - n_own;
          if (n_foreign == 0)
            continue;
          for (unsigned int k = 0; k < n_foreign; ++k)
            {
              columns[k] = global_blocks[sorted[n_own + k]];
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int j = 0; j < 3; ++j)
                  row_values[3 * (n_foreign * i + k) + j] =
                    rows[3 * n * i + 3 * places[n_own + k] + j];
            }
          const PetscInt row = global_blocks[sorted[r]];
          petsc(MatSetValuesBlocked(matrix,
                                    1,
                                    &row,
                                    n_foreign,
                                    columns.data(),
                                    row_values.data(),
                                    ADD_VALUES));
        }
    }



    void
    BlockSystem::add_row(const unsigned int  row,
                         const unsigned int  n,
                         const unsigned int *columns,
                         const Tensor<2, 3> *values)
    {
      const PetscInt here = global_blocks[row];
      work.resize(9 * n);
      row_columns.resize(n);
      for (unsigned int k = 0; k < n; ++k)
        {
          if (prescribed.is_constrained(columns[k]))
            lifting[row] += prescribed.in_frame(
              row, values[k] * prescribed.motion(columns[k]));
          const Tensor<2, 3> value =
            prescribed.constrained(row, columns[k], values[k]);
          row_columns[k] = global_blocks[columns[k]];
          for (unsigned int e = 0; e < 3; ++e)
            for (unsigned int d = 0; d < 3; ++d)
              work[3 * n * e + 3 * k + d] = value[e][d];
        }
      petsc(MatSetValuesBlocked(
        matrix, 1, &here, n, row_columns.data(), work.data(), ADD_VALUES));
    }



    void
    BlockSystem::add_to_diagonal(const unsigned int block,
                                 const bool         fixed,
                                 const double       value)
    {
      const PetscInt row       = global_blocks[block];
      double         values[9] = {};
      for (unsigned int d = 0; d < 3; ++d)
        if (prescribed.is_fixed(block, d) == fixed)
          values[4 * d] = value;
      petsc(MatSetValuesBlocked(matrix, 1, &row, 1, &row, values, ADD_VALUES));
    }



    void
    BlockSystem::add_diagonal(const unsigned int block, const double value)
    {
      add_to_diagonal(block, /*fixed=*/false, value);
    }



    void
    BlockSystem::end()
    {
      if (!wants_tangent())
        return;

      any_unsymmetric = on_any_rank(state, !unsymmetric.empty());
      any_couplings =
        on_any_rank(state, !of_axes.empty() || !of_sections.empty());
      lift_terms();
      set_right_hand_side();
      for (unsigned int b = 0; b < state.n_owned_blocks(); ++b)
        if (prescribed.is_constrained(b))
          add_to_diagonal(b, /*fixed=*/true, held_stiffnesses[b]);
      own.reset();
      petsc(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
      petsc(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    }



    void
    BlockSystem::set_right_hand_side()
    {
      // What a prescribed motion raises is in there, the motion itself in
      // extract_increment(): its component has the equation stiffness * motion
      // = 0, and adds nothing to the norms by which iterative solvers stop.
      std::vector<Tensor<1, 3>> balancing = forces;
      prescribed.turn_into_frames(balancing);
      for (unsigned int b = 0; b < balancing.size(); ++b)
        balancing[b] = -balancing[b] - lifting[b];
      prescribed.clear_fixed(balancing);
      fill(rhs, balancing);
    }



    void
    BlockSystem::lift_terms()
    {
      if (!any_unsymmetric && !any_couplings)
        return;
      motion.assign(state.n_local_blocks(), Tensor<1, 3>());
      prescribed.add_motion(motion);
      raised.assign(state.n_owned_blocks(), Tensor<1, 3>());
      apply_terms(Part::whole, motion, raised);
      prescribed.turn_into_frames(raised);
      for (unsigned int b = 0; b < raised.size(); ++b)
        lifting[b] += raised[b];
    }



    void
    BlockSystem::apply_terms(const Part                       part,
                             const std::vector<Tensor<1, 3>> &of_blocks,
                             std::vector<Tensor<1, 3>>       &sum) const
    {
      of_axes.add_product(of_blocks, sum);
      of_sections.add_product(of_blocks, sum);
      if (part == Part::whole)
        unsymmetric.add_product(of_blocks, sum);
    }



    void
    BlockSystem::add_product_of_terms(const Part    part,
                                      const double *vector,
                                      double       *product) const
    {
      if (!any_couplings && (part == Part::symmetric || !any_unsymmetric))
        return;

      // Prescribed components have no part in it: what they raise is lifted.
      const unsigned int n_owned = state.n_owned_blocks();
      motion.resize(state.n_local_blocks());
      for (unsigned int b = 0; b < n_owned; ++b)
        for (unsigned int d = 0; d < 3; ++d)
          motion[b][d] = vector[3 * b + d];
      prescribed.clear_fixed(motion);
      prescribed.turn_out_of_frames(motion);
      state.update_ghosts(motion);

      raised.assign(n_owned, Tensor<1, 3>());
      apply_terms(part, motion, raised);
      prescribed.turn_into_frames(raised);
      prescribed.clear_fixed(raised);
      for (unsigned int b = 0; b < n_owned; ++b)
        for (unsigned int d = 0; d < 3; ++d)
          product[3 * b + d] += raised[b][d];
    }



    void
    BlockSystem::unbalanced(std::vector<Tensor<1, 3>> &values) const
    {
      values = forces;
      prescribed.turn_into_frames(values);
      prescribed.clear_fixed(values);
      prescribed.turn_out_of_frames(values);
    }



    void
    BlockSystem::get_unbalanced(Vec values) const
    {
      std::vector<Tensor<1, 3>> of_blocks = forces;
      prescribed.turn_into_frames(of_blocks);
      prescribed.clear_fixed(of_blocks);
      fill(values, of_blocks);
    }



    void
    BlockSystem::extract_increment(std::vector<Tensor<1, 3>> &values) const
    {
      values.resize(state.n_local_blocks());
      const double *solution;
      petsc(VecGetArrayRead(increment, &solution));
      for (unsigned int b = 0; b < state.n_owned_blocks(); ++b)
        for (unsigned int d = 0; d < 3; ++d)
          values[b][d] = solution[3 * b + d];
      petsc(VecRestoreArrayRead(increment, &solution));
      prescribed.set_pending(values);
      prescribed.turn_out_of_frames(values);
      state.update_ghosts(values);
    }



    void
    BlockSystem::replace_increment(std::vector<Tensor<1, 3>> &values)
    {
      values.resize(state.n_owned_blocks());
      prescribed.turn_into_frames(values);
      prescribed.clear_fixed(values);
      fill(increment, values);
      extract_increment(values);
    }
  } // namespace System
} // namespace Heddle
