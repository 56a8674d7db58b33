#ifndef heddle_system_state_h
#define heddle_system_state_h

#include <heddle/system/fiber_space.h>
#include <heddle/system/ghost_exchange.h>
#include <heddle/system/matrix_space.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Heddle
{
  namespace System
  {
    using namespace dealii;

    /**
     * The configuration on this rank: all blocks of its own fibers and, where
     * there is a matrix, of its own nodes of it; and copies of those of others
     * that come near them (ghosts). The last accepted configuration is kept
     * beside the current one.
     *
     * In the arrays of blocks own fibers come first, then own nodes of the
     * matrix, foreign nodes of it, and foreign fibers.
     */
    class State
    {
    public:
      State(const FiberSpace &space);

      /**
       * From now on there is a matrix, or another one, at rest in its reference
       * configuration. This rank holds copies of these foreign nodes, in
       * ascending order, and, whatever set_ghost_fibers() says, of these
       * foreign fibers.
       * @note Collective.
       */
      void
      set_matrix(const MatrixSpace               *matrix,
                 const std::vector<unsigned int> &ghost_nodes,
                 const std::vector<unsigned int> &linked_fibers);

      /** The matrix, or nullptr. */
      const MatrixSpace *
      matrix() const
      {
        return matrix_space;
      }

      /** Blocks of fiber @p f, owned or ghost. */
      Tensor<1, 3> *
      fiber(const unsigned int f)
      {
        return blocks.data() + local_begin[f];
      }

      const Tensor<1, 3> *
      fiber(const unsigned int f) const
      {
        return blocks.data() + local_begin[f];
      }

      /** Whether this rank holds the blocks of fiber @p f. */
      bool
      has(const unsigned int f) const
      {
        return local_begin[f] != absent;
      }

      /** Position of block 0 of fiber @p f in arrays of n_local_blocks(). */
      unsigned int
      local_block(const unsigned int f) const
      {
        return local_begin[f];
      }

      bool
      has_matrix_node(const unsigned int node) const;

      /** Position of the block of @p node of the matrix, owned or ghost. */
      unsigned int
      matrix_block(const unsigned int node) const;

      /** Reference place of the node of the matrix with this local block. */
      const Point<3> &
      matrix_reference(const unsigned int block) const
      {
        return matrix_space->reference(block < owned_blocks
                                         ? block - owned_fiber_blocks +
                                             matrix_space->owned_nodes().first
                                         : ghost_nodes[block - owned_blocks]);
      }

      /** Number of blocks held here; the owned ones come first. */
      unsigned int
      n_local_blocks() const
      {
        return blocks.size();
      }

      unsigned int
      n_owned_blocks() const
      {
        return owned_blocks;
      }

      /** Of the owned blocks those of fibers; they come before the others. */
      unsigned int
      n_owned_fiber_blocks() const
      {
        return owned_fiber_blocks;
      }

      /** Unknowns of the whole scene, over all ranks. */
      unsigned int
      n_dofs() const
      {
        return space.n_dofs() +
               (matrix_space ? 3 * matrix_space->n_nodes() : 0);
      }

      /**
       * Numbers of the local blocks in the whole system, where the blocks of a
       * rank follow those of the ranks before it.
       */
      std::vector<int>
      global_blocks() const;

      /** Grows whenever fields are added: then the system is another one. */
      unsigned int
      field_version() const
      {
        return fields;
      }

      /** Grows whenever the ghosts, and with them local numbers, change. */
      unsigned int
      ghost_version() const
      {
        return version;
      }

      /** Fibers whose copies are held, in ascending order. */
      const std::vector<unsigned int> &
      ghost_fibers() const
      {
        return ghosts;
      }

      /**
       * From now on hold copies of these foreign fibers, and of those that are
       * linked to own nodes of the matrix, and fetch them.
       * @note Collective.
       */
      void
      set_ghost_fibers(const std::vector<unsigned int> &fibers);

      /**
       * Fetch the owners' values of the ghosts, of the configuration itself or
       * of any array @p values of n_local_blocks().
       * @note Collective.
       */
      void
      update_ghosts();
      void
      update_ghosts(std::vector<Tensor<1, 3>> &values) const;

      /** Add @p factor times @p increment (n_local_blocks() entries). */
      void
      move(const double factor, const std::vector<Tensor<1, 3>> &increment);

      /** Go to the configuration @p values (n_local_blocks() entries). */
      void
      set(const std::vector<Tensor<1, 3>> &values)
      {
        blocks = values;
      }

      /** Keep the current configuration; return to the one kept. */
      void
      accept();
      void
      reject();

      /** The kept configuration, to measure motion over a step. */
      const std::vector<Tensor<1, 3>> &
      accepted() const
      {
        return accepted_blocks;
      }

      const std::vector<Tensor<1, 3>> &
      current() const
      {
        return blocks;
      }

      double       load_factor = 0.;
      unsigned int step        = 0;

      const FiberSpace &space;

    private:
      static constexpr unsigned int absent = static_cast<unsigned int>(-1);

      /** Own fibers, all nodes of the matrix: what precedes ghost fibers. */
      unsigned int
      n_fixed_blocks() const
      {
        return owned_blocks + ghost_nodes.size();
      }

      const MatrixSpace        *matrix_space = nullptr;
      unsigned int              owned_fiber_blocks;
      unsigned int              owned_blocks;
      unsigned int              version = 0;
      unsigned int              fields  = 0;
      std::vector<Tensor<1, 3>> blocks;
      std::vector<Tensor<1, 3>> accepted_blocks;
      std::vector<unsigned int> local_begin;
      std::vector<unsigned int> ghosts;
      std::vector<unsigned int> ghost_nodes;
      std::vector<unsigned int> linked_fibers;
      GhostExchange             fiber_exchange, node_exchange;
    };
  } // namespace System
} // namespace Heddle

#endif
