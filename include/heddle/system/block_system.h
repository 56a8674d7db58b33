#ifndef heddle_system_block_system_h
#define heddle_system_block_system_h

#include <heddle/system/block_pattern.h>
#include <heddle/system/constraints.h>
#include <heddle/system/local_blocks.h>
#include <heddle/system/pair_couplings.h>
#include <heddle/system/state.h>
#include <heddle/system/unsymmetric_terms.h>

#include <deal.II/base/tensor.h>

#include <petscmat.h>

#include <memory>
#include <vector>

namespace Heddle
{
  namespace System
  {
    using namespace dealii;

    /**
     * The linearised equilibrium of the fibers: residual (internal minus
     * external forces), tangent and prescribed values, assembled block by block
     * into one distributed PETSc matrix of 3x3 blocks.
     *
     * Every rank adds the terms of everything that touches its own fibers, and
     * keeps its own rows only. So nothing is sent during assembly, and a term
     * between fibers of two ranks is computed by both.
     *
     * Two parts of the tangent stay beside the matrix, for they are only ever
     * multiplied with: the unsymmetric one, and, if so wanted, what couples two
     * fibers.
     *
     * Components that are prescribed, see Constraints, are eliminated while
     * elements are added, which keeps the matrix symmetric, and from products
     * with what is beside it.
     */
    class BlockSystem
    {
    public:
      /** What add() is to use of what it is given. */
      enum class Want
      {
        residual,
        residual_and_tangent
      };

      /** Without or with the unsymmetric terms. */
      enum class Part
      {
        symmetric,
        whole
      };

      /**
       * Solvers that only multiply with the tangent may keep
       * @p couplings_apart from its matrix.
       */
      BlockSystem(const State &state, const bool couplings_apart = false);

      ~BlockSystem();

      BlockSystem(const BlockSystem &) = delete;
      BlockSystem &
      operator=(const BlockSystem &) = delete;

      /**
       * Create the tangent with this pattern.
       * @note Collective.
       */
      void
      set_pattern(const BlockPattern &pattern);

      /** Whether there is a pattern, made for the ghosts that the state has. */
      bool
      has_pattern() const
      {
        return matrix != nullptr && !is_of_others &&
               ghost_version == state.ghost_version();
      }

      /** From now on there is none: others will add to the tangent. */
      void
      forget_pattern()
      {
        is_of_others = true;
      }

      /** Prescribe these motions, and no others. */
      void
      set_constraints(const std::vector<Constraint> &constraints)
      {
        prescribed.set(constraints, state.n_local_blocks());
      }

      const Constraints &
      constraints() const
      {
        return prescribed;
      }

      /** Set to zero what @p want asks to be assembled. */
      void
      begin(const Want want);

      bool
      wants_tangent() const
      {
        return want == Want::residual_and_tangent;
      }

      /**
       * Largest number of blocks of one term: a point of a fiber in a
       * hexahedron of degree 2, four and 27.
       */
      static constexpr unsigned int max_blocks_of_term = 31;

      /**
       * Add the term of @p n local blocks, max_blocks_of_term at most:
       * @p residual (3n numbers) and @p tangent (3n x 3n by rows; not read if
       * not wanted), which is symmetric: one half is kept. Rows of foreign
       * blocks are left to their owners.
       */
      void
      add(const unsigned int  n,
          const unsigned int *blocks,
          const double       *residual,
          const double       *tangent);

      /**
       * Add a row of a constant stiffness to the tangent: the 3x3 blocks
       * @p values that couple the owned block @p row to @p n local blocks. It
       * is not a part of the residual.
       */
      void
      add_row(const unsigned int  row,
              const unsigned int  n,
              const unsigned int *columns,
              const Tensor<2, 3> *values);

      /**
       * Terms of the tangent that are no part of the matrix, to be added to by
       * all ranks that hold their blocks, where a tangent is wanted.
       */
      UnsymmetricTerms &
      unsymmetric_terms()
      {
        return unsymmetric;
      }

      /** Whether what couples fibers is to be kept beside the matrix, ... */
      bool
      keeps_couplings_apart() const
      {
        return couplings_apart;
      }

      /** ... where contact is ... */
      AxisCouplings &
      axis_couplings()
      {
        return of_axes;
      }

      const AxisCouplings &
      axis_couplings() const
      {
        return of_axes;
      }

      /** ... and where surfaces rub. */
      SectionCouplings &
      section_couplings()
      {
        return of_sections;
      }

      const SectionCouplings &
      section_couplings() const
      {
        return of_sections;
      }

      /**
       * Give back the memory of what couples blocks beside the matrix, where
       * the tangent is not needed until it is assembled anew.
       */
      void
      forget_couplings();

      /** Add to the residual of an owned block. */
      void
      add_force(const unsigned int block, const Tensor<1, 3> &force)
      {
        forces[block] += force;
      }

      /** Add @p value to the three diagonal entries of an owned block. */
      void
      add_diagonal(const unsigned int block, const double value);

      /**
       * Finish assembly.
       * @note Collective.
       */
      void
      end();

      /** Internal minus external forces on the owned blocks [N]. */
      const std::vector<Tensor<1, 3>> &
      residual() const
      {
        return forces;
      }

      /**
       * The residual without its constrained components: the unbalanced forces
       * of the owned blocks.
       */
      void
      unbalanced(std::vector<Tensor<1, 3>> &values) const;

      /** The same in the layout of the tangent and in its frames. */
      void
      get_unbalanced(Vec values) const;

      /**
       * The matrix of the tangent, n_dofs x n_dofs, of which one half is
       * stored: SBAIJ of block size 3.
       */
      Mat
      tangent() const
      {
        return matrix;
      }

      /** Whether blocks of different ranks have a place in the matrix. */
      bool
      couples_ranks() const
      {
        return any_foreign;
      }

      /** Whether any rank has unsymmetric terms, ... */
      bool
      has_unsymmetric_terms() const
      {
        return any_unsymmetric;
      }

      /** ... and symmetric ones that are not in the matrix. */
      bool
      has_couplings_apart() const
      {
        return any_couplings;
      }

      /**
       * Add to @p product what @p part of the tangent, without its matrix,
       * makes of @p vector, both in the layout of the tangent.
       * @note Collective.
       */
      void
      add_product_of_terms(const Part    part,
                           const double *vector,
                           double       *product) const;

      /** Vectors in the layout of the tangent, for the solver. */
      Vec
      right_hand_side() const
      {
        return rhs;
      }

      Vec
      solution() const
      {
        return increment;
      }

      /** Turn the solution of the linear system into the motion of blocks. */
      void
      extract_increment(std::vector<Tensor<1, 3>> &values) const;

      /**
       * Make a motion of blocks the solution, but for what is prescribed of
       * it; then it is @p values what the solution is turned into.
       */
      void
      replace_increment(std::vector<Tensor<1, 3>> &values);

      const State &state;

    private:
      /** Add a term to the tangent. */
      void
      insert(const unsigned int  n,
             const unsigned int *blocks,
             const double       *tangent);

      /**
       * Add @p value to the diagonal entries of an owned block, for components
       * that are @p fixed or for those that are not.
       */
      void
      add_to_diagonal(const unsigned int block,
                      const bool         fixed,
                      const double       value);

      /** Set the right-hand side, in the frames of the constraints. */
      void
      set_right_hand_side();

      /** Take what prescribed motion raises there to the right-hand side. */
      void
      lift_terms();

      /** Add to @p sum the forces that the terms of @p part raise. */
      void
      apply_terms(const Part                       part,
                  const std::vector<Tensor<1, 3>> &of_blocks,
                  std::vector<Tensor<1, 3>>       &sum) const;

      const bool couplings_apart;
      bool       is_of_others = false; /**< the pattern */
      Want       want         = Want::residual;

      UnsymmetricTerms                  unsymmetric;
      AxisCouplings                     of_axes;
      SectionCouplings                  of_sections;
      bool                              any_unsymmetric = false;
      bool                              any_couplings   = false;
      bool                              any_foreign     = false;
      mutable std::vector<Tensor<1, 3>> motion, raised; /**< by these terms */

      std::vector<Tensor<1, 3>> forces;
      /** Tangent times pending motion, in the frames of the constraints. */
      std::vector<Tensor<1, 3>> lifting;
      /** Of owned blocks, for components that are prescribed. */
      const std::vector<double> held_stiffnesses;

      Constraints           prescribed;
      std::vector<PetscInt> global_blocks;
      unsigned int          ghost_version = 0; /**< of the pattern */
      std::vector<double>   work;
      std::vector<PetscInt> row_columns;

      std::unique_ptr<LocalBlocks> own; /**< from begin() to end() */

      Mat matrix    = nullptr;
      Vec rhs       = nullptr;
      Vec increment = nullptr;
    };
  } // namespace System
} // namespace Heddle

#endif
