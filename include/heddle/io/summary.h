#ifndef heddle_io_summary_h
#define heddle_io_summary_h

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Heddle
{
  namespace IO
  {
    /** How far a run or a stage has come. */
    enum class Status
    {
      running,
      converged,
      not_converged,
      stopped,
      failed
    };

    /** What files call it. */
    constexpr const char *
    word(const Status status)
    {
      switch (status)
        {
          case Status::running:
            return "running";
          case Status::converged:
            return "converged";
          case Status::not_converged:
            return "not converged";
          case Status::stopped:
            return "stopped";
          case Status::failed:
            return "failed";
        }
      return nullptr;
    }



    /** Seconds on the clock, and where they went. */
    struct WallTime
    {
      double total         = 0.;
      double detection     = 0.;
      double assembly      = 0.;
      double linear_solver = 0.;
      double line_search   = 0.;
      double output        = 0.;

      /** Call @p visit (name, value) for each of some wall times. */
      template <typename Visit, typename... Times>
      static void
      describe(const Visit &visit, Times &...times)
      {
        visit("total", times.total...);
        visit("detection", times.detection...);
        visit("assembly", times.assembly...);
        visit("linear_solver", times.linear_solver...);
        visit("line_search", times.line_search...);
        visit("output", times.output...);
      }
    };



    /** What one stage came to. A ratio that was not computed is NaN. */
    struct StageSummary
    {
      std::string   name;
      Status        status                  = Status::running;
      unsigned int  steps                   = 0;
      unsigned int  newton_iterations       = 0;
      unsigned int  factorizations          = 0;
      unsigned int  linear_iterations       = 0;
      std::uint64_t contact_elements        = 0;
      std::uint64_t active_contact_elements = 0;
      std::uint64_t n_dofs_per_rank         = 0; /**< own and copies, most */
      unsigned int  crossings_total         = 0;
      unsigned int  crossings_wrong         = 0;
      unsigned int  crossings_apart         = 0;

      /** Largest penetration over fiber radius [-]. */
      double max_penetration_ratio = std::numeric_limits<double>::quiet_NaN();

      /**
       * How far elastic fibers would be in each other under the force of a
       * contact, largest of all steps, over the radius [-], ...
       */
      double max_indentation_ratio = std::numeric_limits<double>::quiet_NaN();

      /** ... and in that step the work that would take over what energy there
       * is, twice [-]. */
      double indentation_work_ratio = std::numeric_limits<double>::quiet_NaN();

      /** Largest radius of a fiber over that of a bend of its axis [-]. */
      double max_bend_ratio = std::numeric_limits<double>::quiet_NaN();

      /** Largest unbalanced nodal force over the mean contact force [-]. */
      double residual_ratio = std::numeric_limits<double>::quiet_NaN();

      /** Number of its last file of fibers and contacts, -1 if none. */
      int last_output = -1;

      WallTime wall_time;

      /**
       * Call @p visit (name, value) for all that is told of the @p stage, in
       * the order of summary.json. A checkpoint keeps the same.
       */
      template <typename Visit, typename Stage>
      static void
      describe(const Visit &visit, Stage &stage)
      {
        visit("name", stage.name);
        visit("status", stage.status);
        visit("steps", stage.steps);
        visit("newton_iterations", stage.newton_iterations);
        visit("factorizations", stage.factorizations);
        visit("linear_iterations", stage.linear_iterations);
        visit("contact_elements", stage.contact_elements);
        visit("active_contact_elements", stage.active_contact_elements);
        visit("n_dofs_per_rank", stage.n_dofs_per_rank);
        visit("max_penetration_ratio", stage.max_penetration_ratio);
        visit("max_indentation_ratio", stage.max_indentation_ratio);
        visit("indentation_work_ratio", stage.indentation_work_ratio);
        visit("max_bend_ratio", stage.max_bend_ratio);
        visit("crossings_total", stage.crossings_total);
        visit("crossings_wrong", stage.crossings_wrong);
        visit("crossings_apart", stage.crossings_apart);
        visit("residual_ratio", stage.residual_ratio);
        visit("last_output", stage.last_output);
        visit("wall_time_s", stage.wall_time);
      }
    };



    /** What there is of a matrix, over all ranks. */
    struct MatrixSummary
    {
      std::uint64_t n_cells = 0;
      std::uint64_t n_nodes = 0;

      /** Coupling elements between fibers and matrix. */
      std::uint64_t n_links = 0;

      /** How often the stiffness was assembled since the run began. */
      unsigned int n_assemblies = 0;

      /** Of the cells [mm^3]. */
      double volume = 0.;

      /** Of fibers that lie in cells [mm^3]. */
      double doubled_volume = 0.;

      /** Mean distance of its outer surfaces [mm]. */
      double ply_thickness = 0.;

      /** Of the fibers between these surfaces, and within the sides [-]. */
      double ply_volume_fraction = 0.;

      /** Call @p visit (name, value) for all that is told of the @p matrix, in
       * the order of summary.json. */
      template <typename Visit>
      static void
      describe(const Visit &visit, const MatrixSummary &matrix)
      {
        visit("n_matrix_cells", matrix.n_cells);
        visit("n_matrix_nodes", matrix.n_nodes);
        visit("n_links", matrix.n_links);
        visit("n_matrix_assemblies", matrix.n_assemblies);
        visit("matrix_volume_mm3", matrix.volume);
        visit("doubled_volume_mm3", matrix.doubled_volume);
        visit("doubled_part", matrix.doubled_volume / matrix.volume);
        visit("ply_thickness_mm", matrix.ply_thickness);
        visit("ply_fiber_volume_fraction", matrix.ply_volume_fraction);
      }
    };



    /**
     * The numbers of a run for a script to read, summary.json. It is written
     * after every step, and when the run ends, whichever way it does.
     */
    struct Summary
    {
      Status      status = Status::running;
      std::string reason; /**< one sentence, unless all is well */

      std::uint64_t            n_fibers      = 0;
      std::uint64_t            n_fiber_nodes = 0;
      std::uint64_t            n_dofs        = 0;
      unsigned int             ranks         = 1;
      std::vector<std::string> contributions;

      /** Nothing unless fibers are embedded. */
      std::optional<MatrixSummary> matrix;

      std::vector<StageSummary> stages;

      /** Further results of a scene, with the unit in the name. */
      std::map<std::string, double> results;

      /** Programs and libraries that computed it, with their versions. */
      std::map<std::string, std::string> versions;

      /** The summary as JSON; numbers that are NaN become null. */
      std::string
      json() const;

      /** Write DIRECTORY/summary.json; to be called on one rank. */
      void
      write(const std::string &directory) const;
    };
  } // namespace IO
} // namespace Heddle

#endif
