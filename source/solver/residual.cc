#include <heddle/base/reduce.h>
#include <heddle/solver/residual.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /**
       * Of the largest force of supports, or of the tension of guides, what
       * contacts count for at least where there are no loads: those that close
       * or open bear next to nothing, and forces that vanish are no measure. In
       * fabrics and strands they bear 5e-3 of it or more.
       */
      constexpr double least_part_of_reaction = 1e-3;

      /** The size of a force; what is no number is larger than all numbers. */
      double
      size_of(const Tensor<1, 3> &force)
      {
        const double size = force.norm();
        return std::isnan(size) ? std::numeric_limits<double>::infinity()
                                : size;
      }



      /**
       * Call @p action (block, fiber, node, scale) for the blocks of own
       * fibers. A block that is no position answers with a moment: per element
       * length, which is the scale, that is a force.
       */
      template <typename Action>
      void
      for_each_fiber_block(const System::State &state, const Action &action)
      {
        const System::FiberSpace &space = state.space;
        const unsigned int        n     = space.n_blocks_per_node();
        const auto                owned = space.owned_fibers();
        for (unsigned int f = owned.first; f < owned.second; ++f)
          {
            const double length =
              space.fiber(f).length / (space.fiber(f).n_nodes - 1);
            for (unsigned int b = 0; b < space.n_blocks(f); ++b)
              action(state.local_block(f) + b,
                     f,
                     b / n,
                     b % n == 0 ? 1. : 1. / length);
          }
      }



      /** The largest forces on a node [N]; moments as forces. */
      struct LargestForces
      {
        double unbalanced = 0.;
        double certain    = 0.; /**< unbalanced, above the last digits */
        double on_matrix  = 0.; /**< unbalanced, on nodes of the matrix */
        double residual   = 0.; /**< with what supports hold */
        double reaction   = 0.; /**< of supports, on positions */
      };



      /** Of unbalanced forces on positions. */
      struct MeanSquare
      {
        double sum = 0.; /**< [N^2] */
        double n   = 0.; /**< [-] */
      };



      /** What unbalanced forces are judged by [N]. */
      double
      typical_force(const Contributions &contributions,
                    const LargestForces &largest)
      {
        double of_contact = 0., of_loads = 0., tension = 0.;
        for (const auto &contribution : contributions)
          {
            const auto *const term =
              dynamic_cast<const System::NonsmoothContribution *>(
                contribution.get());
            double &of = term && term->is_nonsmooth() ? of_contact : of_loads;
            of         = std::max(of, contribution->typical_force());
            tension    = std::max(tension, contribution->tension());
          }
        if (of_loads > 0.)
          return std::max(of_loads, of_contact);
        if (of_contact == 0.)
          return std::max(tension, largest.residual);
        const double reaction =
          std::isfinite(largest.reaction) ? largest.reaction : 0.;
        return std::max(of_contact,
                        least_part_of_reaction * std::max(reaction, tension));
      }
    } // namespace



    Residual
    judge(const System::BlockSystem             &system,
          const Contributions                   &contributions,
          const std::vector<System::Constraint> &constraints,
          const System::NodeStiffness           &negligible)
    {
      const System::State      &state = system.state;
      const System::FiberSpace &space = state.space;
      std::vector<Tensor<1, 3>> unbalanced;
      system.unbalanced(unbalanced);

      LargestForces largest;
      MeanSquare    mean_square;
      const auto    of_position = [&](const unsigned int k) {
        mean_square.sum += unbalanced[k].norm_square();
        mean_square.n += 1.;
        largest.reaction = std::max(
          largest.reaction, size_of(system.residual()[k] - unbalanced[k]));
      };
      const auto of_block = [&](const unsigned int k,
                                const double       scale,
                                const double       last_digits) {
        const double force = scale * size_of(unbalanced[k]);
        largest.unbalanced = std::max(largest.unbalanced, force);
        largest.residual =
          std::max(largest.residual, scale * size_of(system.residual()[k]));
        if (force > last_digits)
          largest.certain = std::max(largest.certain, force);
      };
      for_each_fiber_block(state,
                           [&](const unsigned int k,
                               const unsigned int f,
                               const unsigned int,
                               const double scale) {
                             of_block(k, scale, negligible.of_fibers[f]);
                           });
      for (unsigned int k = 0; k < state.n_owned_fiber_blocks();
           k += space.n_blocks_per_node())
        of_position(k);
      for (unsigned int k = state.n_owned_fiber_blocks();
           k < state.n_owned_blocks();
           ++k)
        {
          of_position(k);
          of_block(k, 1., negligible.of_matrix);
          largest.on_matrix =
            std::max(largest.on_matrix, size_of(unbalanced[k]));
        }
      max_over_ranks(largest, space.communicator());
      sum_over_ranks(mean_square, space.communicator());

      const double typical = typical_force(contributions, largest);

      Residual residual;
      residual.largest_force = largest.unbalanced;
      if (largest.certain > 0.)
        {
          residual.mean_force   = std::sqrt(mean_square.sum / mean_square.n);
          residual.ratio        = largest.certain / typical;
          residual.matrix_ratio = largest.on_matrix / typical;
          residual.mean_ratio   = residual.mean_force / typical;
        }
      residual.pending = pending_motion(constraints, space.communicator());
      return residual;
    }



    double
    pending_motion(const std::vector<System::Constraint> &constraints,
                   const MPI_Comm                         communicator)
    {
      double largest = 0.;
      for (const auto &constraint : constraints)
        for (unsigned int d = 0; d < 3; ++d)
          if (constraint.fixed[d])
            largest = std::max(largest, std::abs(constraint.pending[d]));
      return Utilities::MPI::max(largest, communicator);
    }



    namespace
    {
      /** "fiber 3 of yarn 1", or "the matrix", and where in space. */
      std::string
      place_in_words(const System::State &state,
                     const unsigned int   block,
                     const unsigned int   fiber,
                     const unsigned int   node)
      {
        std::ostringstream text;
        text << std::setprecision(3);
        if (block >= state.n_owned_fiber_blocks())
          text << "the matrix";
        else
          {
            const unsigned int yarn = state.space.fiber(fiber).yarn_id;
            text << "fiber " << fiber;
            if (yarn != numbers::invalid_unsigned_int)
              text << " of yarn " << yarn;
          }
        const Tensor<1, 3> &place =
          state.current()[block >= state.n_owned_fiber_blocks()
                            ? block
                            : state.local_block(fiber) +
                                node * state.space.n_blocks_per_node()];
        text << " near (" << place[0] << ", " << place[1] << ", " << place[2]
             << ")";
        return text.str();
      }
    } // namespace



    std::string
    largest_imbalance(const System::BlockSystem &system,
                      const Contributions       &contributions)
    {
      const System::State      &state = system.state;
      const System::FiberSpace &space = state.space;
      std::vector<Tensor<1, 3>> unbalanced;
      system.unbalanced(unbalanced);
      double       largest = -1.;
      unsigned int fiber = 0, node = 0, block = 0;
      const auto   consider = [&](const unsigned int candidate,
                                const double       scale) {
        const double force = scale * size_of(unbalanced[candidate]);
        if (force <= largest)
          return false;
        largest = force;
        block   = candidate;
        return true;
      };
      for_each_fiber_block(state,
                           [&](const unsigned int candidate,
                               const unsigned int f,
                               const unsigned int i,
                               const double       scale) {
                             if (consider(candidate, scale))
                               {
                                 fiber = f;
                                 node  = i;
                               }
                           });
      for (unsigned int b = state.n_owned_fiber_blocks();
           b < state.n_owned_blocks();
           ++b)
        consider(b, 1.);

      // The rank that has it says where it is.
      const auto where =
        Utilities::MPI::min_max_avg(largest, space.communicator());
      std::string text;
      if (where.max_index ==
          Utilities::MPI::this_mpi_process(space.communicator()))
        {
          text              = place_in_words(state, block, fiber, node);
          std::string begin = ", where it touches fiber ";
          if (block < state.n_owned_fiber_blocks())
            for (const auto *term : nonsmooth_terms(contributions))
              for (const unsigned int other :
                   term->contacting_fibers(fiber, node))
                {
                  text += begin + std::to_string(other);
                  begin = ", ";
                }
        }
      return Utilities::MPI::broadcast(
        space.communicator(), text, where.max_index);
    }
  } // namespace Solver
} // namespace Heddle
