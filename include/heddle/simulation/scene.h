#ifndef heddle_simulation_scene_h
#define heddle_simulation_scene_h

#include <heddle/contributions/fiber_contact.h>
#include <heddle/contributions/fiber_elasticity.h>
#include <heddle/contributions/fiber_friction.h>
#include <heddle/contributions/supports.h>
#include <heddle/post/crossing_order.h>
#include <heddle/simulation/matrix_estimate.h>
#include <heddle/simulation/parameters.h>
#include <heddle/simulation/stage.h>
#include <heddle/system/state.h>
#include <heddle/textile/measured_fabric.h>
#include <heddle/textile/weave.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    class Matrix;

    /**
     * The objects of a computation in the order in which they depend on each
     * other: fibers, configuration, contributions, stages. What a scene does
     * not need is not there.
     */
    class Scene
    {
    public:
      /**
       * @p parameter_file is where the names of other files count from.
       * Throws InputError if no scene can be made of the parameters.
       * @note Collective.
       */
      Scene(const Parameters  &parameters,
            const std::string &parameter_file,
            const MPI_Comm     communicator);

      ~Scene();

      const System::FiberSpace &
      space() const
      {
        return *fiber_space;
      }

      /** The woven sample, or nullptr. */
      const Textile::Weave *
      weave() const
      {
        return woven.get();
      }

      /** Whether there are warp and weft, which settle before a load. */
      bool
      is_fabric() const
      {
        return parameters.run.is_fabric();
      }

      const Contributions::FiberElasticity &
      elasticity() const
      {
        return *fiber_elasticity;
      }

      /** Contact of the fibers, or nullptr if there is none. */
      const Contributions::FiberContact *
      contact() const
      {
        return fiber_contact.get();
      }

      /** The matrix in which the fibers are embedded, or nullptr yet. */
      const Matrix *
      matrix() const
      {
        return composite.get();
      }

      /**
       * Embed the fibers, as they lie in the state, in the matrix.
       * @note Collective.
       */
      void
      embed();

      /**
       * The same as they were embedded in the run that wrote @p archive. Throws
       * InputError, which begins with @p where, if that was another matrix.
       */
      void
      embed_as(const ArchiveReader &archive, const std::string &where);

      /**
       * Whether this stage is the one at whose end the initial configuration
       * is, from which fibers are loaded.
       */
      bool
      ends_initially(const unsigned int stage) const;

      /**
       * "3 of 36 crossings of fibers are not as the pattern wants them", or
       * nothing if all of them are, or if there is no weave.
       * @note Collective.
       */
      std::string
      wrong_crossings() const;

      /**
       * "3 of 36 pairs of fibers do not cross though the pattern wants it",
       * such as fibers that have slipped off the ends of others, or nothing.
       * @note Collective.
       */
      std::string
      lost_crossings() const;

      /**
       * How much of a matrix of the linear law has turned so far that another
       * one is right, or nothing.
       * @note Collective.
       */
      std::string
      turned_matrix() const;

      /**
       * What is to be said of fibers that were given lying in each other, by
       * more than half a radius or where supports hold them. Throw InputError
       * where supports do for good. Those of a weave are not looked at.
       * @note Collective.
       */
      std::vector<std::string>
      overlaps_at_start() const;

      /**
       * Why nothing may keep the plane of a bend, or nothing if something does.
       * @note Collective.
       */
      std::string
      missing_torsion() const;

      /** Whose elements are so short that contact takes all memory, or nothing.
       */
      std::string
      crumbled_fiber() const;

      /** Whose elements are too long for the points that they were read from,
       * or nothing. */
      std::string
      missed_points() const;

      /** Which fibers of a file turn back at some of their points, which may
       * not be in order; nothing if there are none. */
      std::string
      turned_back() const;

      /** Of all fibers when they are free; 0: not known [g/cm^3]. */
      const std::vector<double> &
      densities() const
      {
        return fiber_densities;
      }

      /** What is to be said of a fabric as it is described. */
      std::vector<std::string>
      notes() const;

      /**
       * What all contributions report, by name with unit. Of several of the
       * same name, those of load cases, the one of @p stage does.
       */
      std::map<std::string, double>
      report(const unsigned int stage = 0) const;

      const std::vector<Stage> &
      stages() const
      {
        return all_stages;
      }

      /** Names of the contributions of all stages, each once. */
      std::vector<std::string>
      contribution_names() const;

      /** How large the matrix will be, about; nothing if there is none. */
      MatrixEstimate
      estimated_matrix() const;

      /** Whether the tangent will be factorized, with such a matrix. */
      bool
      will_be_factorized(const double n_matrix_nodes) const;

      /**
       * What the solver will need, roughly, over all ranks, with a matrix of
       * so many nodes [bytes].
       */
      double
      estimated_memory(const double n_matrix_nodes) const;

      /** The time of one Newton iteration, roughly, of fibers in contact [s].
       */
      double
      estimated_seconds(const double n_matrix_nodes) const;

      /** The owned blocks at the start, displacements count from here. */
      const std::vector<Tensor<1, 3>> &
      initial() const
      {
        return initial_blocks;
      }

      /** The current configuration; at first the initial one. */
      System::State &
      state()
      {
        return *configuration;
      }

    private:
      /**
       * "penetration 0.6 of the radius ...", the deepest one of the fibers that
       * were given if it is above @p allowed radii, or nothing.
       * @note Collective.
       */
      std::string
      deepest_overlap(const double allowed) const;

      /** Contact of the fibers that were given, where they start. */
      std::unique_ptr<Contributions::FiberContact>
      contact_at_start(System::State &start) const;

      void
      make_paths(const std::string &parameter_file);

      /** @note Collective. */
      Post::CrossingCount
      count_crossings() const;

      /** Refuse yarns that begin on the wrong sides of each other. */
      void
      check_start() const;

      void
      make_contributions();

      bool
      fibers_can_touch() const;

      void
      add_order_stage();

      /** Holds the sections, where the element has any. */
      void
      add_section_damping(Stage &stage, const bool with_friction) const;

      /** After contact, if there is any. */
      void
      add_friction(Stage &stage) const;

      void
      add_settle_stages();

      /** A stage in which @p supports hold the fibers. */
      void
      add_load_stage(const std::string                           &name,
                     const std::shared_ptr<System::Contribution> &supports);

      /** What forces on the sides of the fabric are divided by. */
      Contributions::FabricSize
      fabric_size() const;

      /** Throw InputError if nothing would hold the fibers that end at none.
       */
      FibersAtSides
      fibers_at_sides() const;

      /** A stage for each load case of the fabric. */
      void
      add_load_cases();

      /** The fibers are about to be loaded from where they lie. */
      void
      begin_loading();

      const Parameters                               &parameters;
      std::unique_ptr<Textile::Weave>                 woven;
      std::unique_ptr<Textile::MeasuredFabric>        measured;
      std::vector<Textile::FiberPath>                 paths;
      std::unique_ptr<System::FiberSpace>             fiber_space;
      std::vector<double>                             fiber_densities;
      std::vector<Tensor<1, 3>>                       initial_blocks;
      std::unique_ptr<System::State>                  configuration;
      std::shared_ptr<Contributions::FiberElasticity> fiber_elasticity;
      std::shared_ptr<Contributions::FiberContact>    fiber_contact;
      std::shared_ptr<Contributions::FiberFriction>   fiber_friction;
      std::shared_ptr<System::Contribution>           guides;

      /** Those of the file, of fibers that are no fabric. */
      std::shared_ptr<Contributions::Supports> supports;

      std::unique_ptr<Matrix>                composite;
      std::vector<Contributions::FabricCase> fabric_cases;
      std::vector<Stage>                     all_stages;

      /** Whether fibers that were given lie deeper in each other than contact
       * allows. */
      bool begins_overlapping = false;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
