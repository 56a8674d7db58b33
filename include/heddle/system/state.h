#ifndef heddle_system_state_h
#define heddle_system_state_h

#include <heddle/system/fiber_space.h>
#include <heddle/system/ghost_exchange.h>
#include <heddle/system/matrix_space.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/tensor.h>

#include <utility>
#include <vector>

namespace Heddle
{
  namespace System
  {
    using namespace dealii;

    /** A foreign fiber and its nodes of which a rank holds copies. */
    struct GhostFiber
    {
      unsigned int fiber;
      NodeRange    nodes;

      /** To be sent to other ranks. */
      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &fiber &nodes.begin &nodes.end;
      }
    };

    /**
     * The configuration on this rank: all blocks of its own fibers and, where
     * there is a matrix, of its own nodes of it; and copies of those of others
     * that come near them (ghosts), of fibers the nodes between two. The last
     * accepted configuration is kept beside the current one.
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
       * foreign fibers, each once, in ascending order.
       * @note Collective.
       */
      void
      set_matrix(const MatrixSpace               *matrix,
                 const std::vector<unsigned int> &ghost_nodes,
                 const std::vector<GhostFiber>   &linked_fibers);

      /** The matrix, or nullptr. */
      const MatrixSpace *
      matrix() const
      {
        return matrix_space;
      }

      /** Blocks of fiber @p f, which is held whole. */
      Tensor<1, 3> *
      fiber(const unsigned int f)
      {
        Assert(held[f] == space.all_nodes(f),
               ExcMessage("This rank does not have the whole fiber."));
        return blocks.data() + local_begin[f];
      }

      const Tensor<1, 3> *
      fiber(const unsigned int f) const
      {
        Assert(held[f] == space.all_nodes(f),
               ExcMessage("This rank does not have the whole fiber."));
        return blocks.data() + local_begin[f];
      }

      /** Nodes of fiber @p f whose blocks this rank holds, owned or ghost. */
      const NodeRange &
      held_nodes(const unsigned int f) const
      {
        return held[f];
      }

      /** Whether it holds any of them. */
      bool
      has(const unsigned int f) const
      {
        return !held[f].empty();
      }

      bool
      has(const unsigned int f, const unsigned int block) const
      {
        const unsigned int node = block / space.n_blocks_per_node();
        return node >= held[f].begin && node < held[f].end;
      }

      /** The local blocks [first, second) of the nodes held_nodes(@p f). */
      std::pair<unsigned int, unsigned int>
      held_blocks(const unsigned int f) const
      {
        const unsigned int n = space.n_blocks_per_node();
        return {local_begin[f] + int(n * held[f].begin),
                local_begin[f] + int(n * held[f].end)};
      }

      /**
       * Position of block 0 of fiber @p f in arrays of n_local_blocks(), to
       * which the number of a block that is held is to be added: it is negative
       * where the array begins behind block 0.
       */
      int
      local_block(const unsigned int f) const
      {
        return local_begin[f];
      }

      /** Block @p b of fiber @p f, which is held. */
      const Tensor<1, 3> &
      block(const unsigned int f, const unsigned int b) const
      {
        Assert(has(f, b), ExcMessage("This block of the fiber is not held."));
        return blocks[local_begin[f] + int(b)];
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

      /**
       * From now on hold copies of these foreign fibers, each once, in
       * ascending order, and of those that are linked to own nodes of the
       * matrix, and fetch them.
       * @note Collective.
       */
      void
      set_ghost_fibers(const std::vector<GhostFiber> &fibers);

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
        AssertDimension(values.size(), blocks.size());
        blocks = values;
      }

      /**
       * The same with the first of @p values, those of the owned blocks:
       * ghosts, which may be others by now, are fetched.
       * @note Collective.
       */
      void
      set_owned(const std::vector<Tensor<1, 3>> &values);

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
      std::vector<NodeRange>    held;
      std::vector<int>          local_begin;
      std::vector<GhostFiber>   ghosts;
      std::vector<unsigned int> ghost_nodes;
      std::vector<GhostFiber>   linked_fibers;
      GhostExchange             fiber_exchange, node_exchange;
    };
  } // namespace System
} // namespace Heddle

#endif
