#ifndef heddle_system_contribution_h
#define heddle_system_contribution_h

#include <heddle/base/archive.h>
#include <heddle/system/block_system.h>
#include <heddle/system/state.h>

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace Heddle
{
  namespace System
  {
    /** Motion of the local blocks, ghosts included. */
    using Increment = std::vector<Tensor<1, 3>>;

    /**
     * What a node resists at most [N/mm]: its position has no digits for forces
     * below that times the last one.
     */
    struct NodeStiffness
    {
      std::vector<double> of_fibers; /**< of nodes of a fiber, by number */
      double              of_matrix = 0.;
    };

    /**
     * One physical term of the equilibrium. A scene is the list of its
     * contributions: what is not in the list costs nothing. The solver knows
     * this interface, and that of a NonsmoothContribution, and nothing else of
     * the physics.
     *
     * All members are collective unless said otherwise.
     */
    class Contribution
    {
    public:
      virtual ~Contribution() = default;

      /** "fiber contact": for logs, checkpoints, the summary and tests; no two
       * contributions have the same. */
      virtual std::string
      name() const = 0;

      /**
       * A step begins, or is searched afresh: the load factor of the state is
       * the new one. There may be several calls for one load factor.
       */
      virtual void
      begin_step(State &)
      {
      }

      /**
       * A stage begins in this configuration: motions that are prescribed from
       * now on count from it. A run that is resumed calls load() instead.
       * @note Collective.
       */
      virtual void
      begin_stage(const State &)
      {
      }

      /** Append the motions that this term prescribes in the current state. */
      virtual void
      constrain(const State &, std::vector<Constraint> &) const
      {
      }

      /** Say which blocks assemble() may couple, beside each with itself. */
      virtual void
      add_pattern(const State &, BlockPattern &)
      {
      }

      /**
       * Add residual and, if wanted, its derivative, the tangent. That is
       * symmetric: the matrix keeps one half of what BlockSystem::add() is
       * given. What is not goes to BlockSystem::unsymmetric_terms().
       */
      virtual void
      assemble(const State &state, BlockSystem &system) = 0;

      /**
       * A step is about to be taken: @p increment is all of it, of the
       * solution of the linear system the part that the line search chose.
       */
      virtual void
      predict(const State &, const Increment &)
      {
      }

      /**
       * Largest factor by which the step @p increment may be taken, perhaps
       * more than 1. Local: the solver takes the smallest over ranks and
       * contributions.
       */
      virtual double
      largest_step(const State &, const Increment &) const
      {
        return std::numeric_limits<double>::max();
      }

      /** Raise @p stiffness to what this term makes nodes resist. Local. */
      virtual void
      raise_stiffness(NodeStiffness &) const
      {
      }

      /**
       * What keeps the current state from being accepted although it is in
       * equilibrium ("penetration 0.04 above 0.02"), or nothing.
       */
      virtual std::string
      objection(const State &) const
      {
        return "";
      }

      /**
       * Equilibrium was found, or a loaded stage begins: @p system has the
       * forces, the reactions of what is held among them. Whether the step
       * counts is for accept_step() to say.
       */
      virtual void
      observe(const BlockSystem &)
      {
      }

      /** A force typical of this term, to judge residuals by, or 0 [N]. */
      virtual double
      typical_force() const
      {
        return 0.;
      }

      /**
       * The largest force by which this term draws fibers along all the time,
       * to judge residuals by where no term has a typical one, or 0 [N].
       */
      virtual double
      tension() const
      {
        return 0.;
      }

      /** Numbers for the log line of an iteration, "active 1843". */
      virtual std::string
      status() const
      {
        return "";
      }

      /**
       * Numbers for the history, by "name[unit]", always of the same names: the
       * first call is made before a stage begins, and tells the columns. No
       * other contribution may report the same, but that "external_work[N*mm]"
       * is the sum of all of them: what this term brings in, since the stage
       * began, belongs there, and what is stored in it to a name that ends in
       * "_energy[N*mm]". Otherwise it is missed in the balance of energies.
       */
      virtual void
      report(const State &, std::map<std::string, double> &) const
      {
      }

      /** The step is about to count; the last one still is accepted(). */
      virtual void
      accept_step(const State &)
      {
      }

      virtual void
      reject_step(State &)
      {
      }

      /**
       * Write to a checkpoint, under "name()/...", what a resumed run must
       * know and cannot compute from the state, and take it back from there.
       */
      virtual void
      save(ArchiveWriter &, const State &) const
      {
      }

      virtual void
      load(const ArchiveReader &, const State &)
      {
      }

      /**
       * Take what is useful from the checkpoint of another run, which ended in
       * the configuration where this one begins.
       */
      virtual void
      load_initial(const ArchiveReader &, const State &)
      {
      }
    };
  } // namespace System
} // namespace Heddle

#endif
