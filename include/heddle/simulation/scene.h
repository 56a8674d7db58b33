#ifndef heddle_simulation_scene_h
#define heddle_simulation_scene_h

#include <heddle/contributions/fiber_contact.h>
#include <heddle/contributions/fiber_elasticity.h>
#include <heddle/contributions/fiber_friction.h>
#include <heddle/contributions/plates.h>
#include <heddle/contributions/supports.h>
#include <heddle/post/crossing_order.h>
#include <heddle/simulation/own_contributions.h>
#include <heddle/simulation/parameters.h>
#include <heddle/simulation/stage.h>
#include <heddle/system/state.h>
#include <heddle/textile/measured_fabric.h>
#include <heddle/textile/weave.h>

#include <deal.II/base/bounding_box.h>

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
       * @p parameter_file is where the names of other files count from,
       * @p make_own adds to the contributions of stages with loads.
       * Throws InputError if no scene can be made of the parameters.
       * @note Collective.
       */
      Scene(const Parameters       &parameters,
            const std::string      &parameter_file,
            const MPI_Comm          communicator,
            const OwnContributions &make_own = {});

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

      /** Where the fibers of all ranks start, and whose they are. */
      const std::vector<Textile::FiberPath> &
      fiber_paths() const
      {
        return paths;
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

      /** Friction of fibers in contact, or nullptr if there is none. */
      const Contributions::FiberFriction *
      friction() const
      {
        return fiber_friction.get();
      }

      /** The plates of a stage, or nullptr. */
      const Contributions::Plates *
      plates(const unsigned int stage) const;

      /** The supports of the file, of fibers that are no fabric, or nullptr. */
      const Contributions::Supports *
      supports() const
      {
        return held_by.get();
      }

      /** Contributions that are not heddle's, made anew for a stage with loads.
       */
      Solver::Contributions
      own_contributions() const;

      /** The matrix in which the fibers are embedded, or nullptr yet. */
      const Matrix *
      matrix() const
      {
        return composite.get();
      }

      /**
       * Embed the fibers in a matrix as they were in the run that wrote
       * @p archive. Throws InputError, which begins with @p where, if that was
       * another matrix.
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
       * How the fibers of a weave lie where its pattern has them cross, if it
       * is @p flattened again where a stage bends it; none without a weave.
       * @note Collective.
       */
      Post::CrossingCount
      count_crossings(const PointMap &flattened = {}) const;

      /** Of all fibers when they are free; 0: not known [g/cm^3]. */
      const std::vector<double> &
      densities() const
      {
        return fiber_densities;
      }

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
      void
      make_paths(const std::string &parameter_file,
                 const MPI_Comm     communicator);

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

      void
      add_approach_stage(const double threshold);

      /** A stage in which @p supports hold the fibers. */
      void
      add_load_stage(const std::string                           &name,
                     const std::shared_ptr<System::Contribution> &supports);

      /** Of a fabric: both widths, about the middle of the yarns [mm]. */
      BoundingBox<2>
      crossing_area() const;

      /** Plates that press on all fibers, in a fabric where its yarns cross. */
      void
      add_plates(Stage &stage) const;

      /** Of the fibers of this family [mm]. */
      double
      largest_radius(const YarnSet family) const;

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

      /** Add to @p values what this contribution reports. */
      void
      add_report(const System::Contribution    &contribution,
                 std::map<std::string, double> &values) const;

      /**
       * Embed the fibers, as they lie in the state, in the matrix.
       * @note Collective.
       */
      void
      embed();

      /** The fibers are about to be loaded from where they lie. */
      void
      begin_loading();

      const Parameters                               &parameters;
      const OwnContributions                          make_own;
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
      std::shared_ptr<Contributions::Supports> held_by;

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
