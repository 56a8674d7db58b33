#ifndef heddle_contributions_external_work_h
#define heddle_contributions_external_work_h

#include <heddle/base/archive.h>
#include <heddle/system/state.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * The work of forces on blocks, step by step: that of the mean of the
     * forces before and after a step on the motion of the step, exact for
     * forces that grow in proportion to it. Of what turns it is the work of the
     * mean moment on the angle, for the chord of a turn by $\alpha$ has
     * $\sin \alpha / \alpha$ of that.
     */
    class ExternalWork
    {
    public:
      /** The forces on the owned blocks of @p state as they are now. */
      void
      set_forces(const std::vector<Tensor<1, 3>> &forces)
      {
        now = forces;
      }

      /** How an owned block turned in a step. */
      struct Turn
      {
        unsigned int block;
        Tensor<1, 3> rotation; /**< [rad] */

        /** From the middle of the turn, before it: a section vector itself, or
         * the place in a body [-, mm]. */
        Tensor<1, 3> lever;
      };

      /**
       * Add the work from the accepted to the current configuration, with what
       * turned.
       */
      void
      add_step(const System::State &state, const std::vector<Turn> &turns = {});

      /** @return the work since the start, over all ranks [N mm]. */
      double
      value() const
      {
        return work;
      }

      /** @note Collective. */
      void
      save(ArchiveWriter       &archive,
           const std::string   &name,
           const System::State &state) const;

      void
      load(const ArchiveReader &archive,
           const std::string   &name,
           const System::State &state);

    private:
      std::vector<Tensor<1, 3>> before, now; /**< on owned blocks [N] */
      double                    work = 0.;   /**< [N mm] */
    };
  } // namespace Contributions
} // namespace Heddle

#endif
