#ifndef heddle_system_state_h
#define heddle_system_state_h

#include <heddle/system/fiber_space.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Heddle
{
  namespace System
  {
    using namespace dealii;

    /**
     * The configuration of the fibers on this rank: all blocks of its own
     * fibers, and copies of those of the foreign fibers that come near them
     * (ghosts). The last accepted configuration is kept beside the current one.
     */
    class State
    {
    public:
      State(const FiberSpace &space);

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
       * From now on hold copies of these foreign fibers, and fetch them.
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

      unsigned int              owned_blocks;
      unsigned int              version = 0;
      std::vector<Tensor<1, 3>> blocks;
      std::vector<Tensor<1, 3>> accepted_blocks;
      std::vector<unsigned int> local_begin;
      std::vector<unsigned int> ghosts;

      /** For each rank: fibers sent to it, and fibers received from it. */
      std::vector<std::vector<unsigned int>> sent, received;
    };
  } // namespace System
} // namespace Heddle

#endif
