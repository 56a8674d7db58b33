#include <heddle/base/choice.h>
#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/number_text.h>
#include <heddle/contributions/crossing_enforcement.h>
#include <heddle/contributions/loads.h>
#include <heddle/contributions/section_damping.h>
#include <heddle/simulation/fiber_placement.h>
#include <heddle/simulation/matrix.h>
#include <heddle/simulation/scene.h>
#include <heddle/simulation/scene_notes.h>
#include <heddle/simulation/yarn_guides.h>
#include <heddle/textile/check_paths.h>
#include <heddle/textile/spun_yarns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Of a fiber; more are a slip of the finger. */
      constexpr unsigned int most_elements = 1000000;

      /** Where fibers have settled otherwise than the pattern wants. */
      const char *const what_helps_crossings =
        "; start with more crimp (Weave/Crimp factor), or interpenetrating "
        "with "
        "more ordering steps, and see to it that yarns do not slip off the "
        "ends "
        "of others (Weave/End length, Initial configuration/Axial tension) and "
        "that elements are short where fibers bend (Fiber/Elements per fiber)";
    } // namespace



    Scene::Scene(const Parameters       &parameters,
                 const std::string      &parameter_file,
                 const MPI_Comm          communicator,
                 const OwnContributions &make_own)
      : parameters(parameters)
      , make_own(make_own)
    {
      make_paths(parameter_file, communicator);
      Textile::check_paths(paths);
      fiber_space     = make_space(paths, parameters.fiber, communicator);
      fiber_densities = densities_of(*fiber_space, paths, parameters.fiber);
      initial_blocks  = place_on_paths(*fiber_space, paths);
      configuration   = std::make_unique<System::State>(*fiber_space);
      configuration->set(initial_blocks);
      configuration->accept();

      check_start();
      make_contributions();
      if (is_fabric() && parameters.restart.initial_configuration.empty())
        {
          add_settle_stages();
          if (woven && parameters.weave.description().start ==
                         Textile::Start::interpenetrating)
            add_order_stage();
        }
      if (parameters.fabric_loading.is_active())
        add_load_cases();
      else if (!parameters.supports.empty())
        {
          held_by = std::make_shared<Contributions::Supports>(
            *fiber_space, initial_blocks, parameters.supports, is_fabric());
          add_load_stage(word(StageKind::load), held_by);
        }
    }



    Scene::~Scene() = default;



    void
    Scene::make_paths(const std::string &parameter_file,
                      const MPI_Comm     communicator)
    {
      const unsigned int n_nodes = parameters.fiber.element()->n_nodes();
      if (!parameters.run.is_from_file())
        {
          woven =
            std::make_unique<Textile::Weave>(parameters.weave.description());
          const unsigned int n_elements = parameters.fiber.elements_per_fiber;
          require(n_elements <= most_elements,
                  "Fiber/Elements per fiber is " + std::to_string(n_elements) +
                    "; at most " + std::to_string(most_elements) +
                    " are possible.");
          paths = woven->paths(n_elements * (n_nodes - 1));
        }
      else
        {
          const std::string file =
            relative_to(parameter_file, parameters.centerlines.file);
          paths = Textile::read_paths(
            file, parameters.centerlines.reading(n_nodes), communicator);
          if (is_fabric())
            measured = std::make_unique<Textile::MeasuredFabric>(paths, file);
        }
    }



    void
    Scene::check_start() const
    {
      const auto weave = parameters.weave.description();
      if (!woven || weave.start != Textile::Start::crimped ||
          weave.crimp_factor > 0.)
        return;

      // The yarns are laid out so that all fibers are on their side: elements
      // that are too long for them follow them only so far.
      const std::string wrong = count_crossings().wrong_in_words();
      require(wrong.empty(),
              "Fiber/Elements per fiber: at the start " + wrong + ", since " +
                std::to_string(parameters.fiber.elements_per_fiber) +
                " elements are too few for the bends of a fiber; give more.");
    }



    Post::CrossingCount
    Scene::count_crossings(const PointMap &flattened) const
    {
      if (!woven)
        return {};
      std::vector<std::vector<unsigned int>> yarns(fiber_space->n_yarns());
      for (unsigned int f = 0; f < fiber_space->n_fibers(); ++f)
        yarns[fiber_space->fiber(f).yarn_id].push_back(f);
      std::vector<Post::OrderedFibers> pairs;
      for (const Textile::Crossing &crossing : woven->crossings())
        {
          const auto &warp = yarns[crossing.warp_yarn];
          const auto &weft = yarns[crossing.weft_yarn];
          if (crossing.warp_on_top)
            pairs.push_back({warp, weft});
          else
            pairs.push_back({weft, warp});
        }
      return Post::count_crossing_order(*configuration, pairs, flattened);
    }



    void
    Scene::make_contributions()
    {
      const bool straight = woven || parameters.centerlines.straight_when_free;
      fiber_elasticity    = std::make_shared<Contributions::FiberElasticity>(
        *fiber_space, straight ? place_straight(*fiber_space) : initial_blocks);
      if (parameters.contact.enabled && fibers_can_touch())
        fiber_contact = std::make_shared<Contributions::FiberContact>(
          *fiber_space, parameters.contact);
      if (fiber_contact && parameters.contact.has_friction())
        fiber_friction = std::make_shared<Contributions::FiberFriction>(
          *fiber_space, parameters.contact, *fiber_contact);
      if (is_fabric())
        guides = yarn_guides(*fiber_space, paths, parameters.settle);
    }



    bool
    Scene::fibers_can_touch() const
    {
      // A fiber closes a loop with its own radius at best.
      const System::Fiber &first = fiber_space->fiber(0);
      return fiber_space->n_fibers() > 1 ||
             first.length > 2. * numbers::PI * first.radius;
    }



    void
    Scene::add_order_stage()
    {
      require(fiber_contact != nullptr,
              "Contact/Enabled is false, but yarns that start "
              "'interpenetrating' are ordered by contact: enable it.");
      std::vector<Contributions::OrderedYarns> yarns;
      for (const Textile::Crossing &crossing : woven->crossings())
        if (crossing.warp_on_top)
          yarns.push_back({crossing.warp_yarn, crossing.weft_yarn});
        else
          yarns.push_back({crossing.weft_yarn, crossing.warp_yarn});

      const auto enforcement =
        std::make_shared<Contributions::CrossingEnforcement>(*fiber_space,
                                                             yarns);

      Stage stage(StageKind::order);
      stage.contributions = {fiber_elasticity, guides};
      add_section_damping(stage, /*with_friction=*/false);
      stage.contributions.push_back(fiber_contact);
      stage.contributions.push_back(enforcement);
      stage.solve = [this, enforcement, contributions = stage.contributions](
                      Log &log, SectionTimer &timer, StopRequest &stop) {
        OrderingStage ordering(
          parameters.ordering, parameters.linear_solver, log, timer, stop);
        const OrderingResult ordered =
          ordering.run(state(), contributions, *fiber_contact, *enforcement);
        Solver::NewtonResult result;
        result.iterations        = ordered.newton_iterations;
        result.factorizations    = ordered.factorizations;
        result.linear_iterations = ordered.linear_iterations;
        result.residual_ratio    = std::numeric_limits<double>::quiet_NaN();
        result.converged         = ordered.least_clearance > -2.;
        result.obstacle          = "fibers are on the wrong side of each other";
        return result;
      };

      // What follows holds the ghosts that it needs, and reports no
      // enforcement.
      all_stages.front().begin = [this, enforcement]() {
        state().set_ghost_fibers({});
        enforcement->end();
      };
      all_stages.insert(all_stages.begin(), stage);
    }



    void
    Scene::add_section_damping(Stage &stage, const bool with_friction) const
    {
      if (fiber_space->n_blocks_per_node() == 3)
        stage.contributions.push_back(
          std::make_shared<Contributions::SectionDamping>(with_friction));
    }



    void
    Scene::add_friction(Stage &stage) const
    {
      if (fiber_friction)
        stage.contributions.push_back(fiber_friction);
    }



    void
    Scene::add_settle_stages()
    {
      // The load factor k/n stands for the k-th of n thresholds.
      const std::vector<double> thresholds =
        parameters.settle.thresholds(parameters.contact.threshold);
      // Friction begins where the fibers have come to lie: it holds them there,
      // and is not what remains of their way.
      const bool with_friction = fiber_friction && parameters.settle.friction;
      if (with_friction)
        add_approach_stage(thresholds.front());

      Stage stage(StageKind::settle);
      stage.aim           = Solver::Aim::equilibrium_from_start;
      stage.contributions = {fiber_elasticity, guides};
      if (fiber_contact)
        {
          const double n           = thresholds.size();
          stage.plan.initial_step  = 1. / n;
          stage.plan.largest_step  = 1. / n;
          stage.plan.smallest_step = 1. / n;
          stage.set_up             = [        =,
                          contact = fiber_contact](const double load_factor) {
            // A run may go on with other thresholds than it began with.
            contact->set_threshold(
              thresholds[std::max(std::lround(load_factor * n), 1l) - 1]);
          };
          add_section_damping(stage, with_friction);
          stage.contributions.push_back(fiber_contact);
        }
      if (with_friction)
        {
          stage.aim = Solver::Aim::equilibrium_after_calm;
          add_friction(stage);
        }
      const std::string what_helps =
        fiber_contact
          ? what_helps_crossings
          : "; nothing keeps them apart: set Contact/Enabled to true";
      stage.objection =
        [what_helps](const Post::CrossingCount &crossings) -> std::string {
        std::string wrong = crossings.wrong_in_words();
        if (wrong.empty())
          wrong = crossings.apart_in_words();
        return wrong.empty() ? "" : wrong + what_helps;
      };
      all_stages.push_back(stage);
    }



    void
    Scene::add_approach_stage(const double threshold)
    {
      Stage stage(StageKind::approach);
      stage.contributions = {fiber_elasticity, guides};
      stage.aim           = Solver::Aim::calm_from_start;
      stage.set_up        = [contact = fiber_contact, threshold](const double) {
        contact->set_threshold(threshold);
      };
      add_section_damping(stage, /*with_friction=*/false);
      stage.contributions.push_back(fiber_contact);
      all_stages.push_back(stage);
    }



    double
    Scene::largest_radius(const YarnSet family) const
    {
      double largest = 0.;
      for (const Textile::FiberPath &path : paths)
        if (path.set == word(family))
          largest = std::max(largest, path.radius);
      return largest;
    }



    Contributions::FabricSize
    Scene::fabric_size() const
    {
      if (measured)
        {
          const auto n = measured->n_yarns();
          return {measured->width(), {{n[0], n[1]}}};
        }
      const Textile::WeaveDescription weave = parameters.weave.description();
      return {{{weave.warp.n_yarns * woven->warp_spacing(),
                weave.weft.n_yarns * woven->weft_spacing()}},
              {{weave.warp.n_yarns, weave.weft.n_yarns}}};
    }



    FibersAtSides
    Scene::fibers_at_sides() const
    {
      const auto    ends = Textile::ends_of_yarns(paths);
      FibersAtSides result;
      for (const YarnSet family : all_choices<YarnSet>())
        for (const unsigned int end : {0, 1})
          {
            std::string  names;
            unsigned int n_free = 0;
            for (unsigned int f = 0; f < paths.size(); ++f)
              if (paths[f].set == word(family))
                {
                  if (ends[f][end])
                    names += (names.empty() ? "" : ", ") + std::to_string(f);
                  else
                    ++n_free;
                }
            require(n_free == 0 || parameters.matrix.enabled || fiber_friction,
                    Textile::spun_yarns(paths, parameters.centerlines.file) +
                      ": set Contact/Friction coefficient, or enable the "
                      "matrix.");
            result[2 * static_cast<unsigned int>(family) + end] =
              n_free == 0 ? word(family) : names;
          }
      return result;
    }



    void
    Scene::add_load_cases()
    {
      const double curvature = parameters.fabric_loading.largest_curvature();
      // What lies beyond the axis of the cylinder would be turned inside out.
      const double half =
        largest_radius(YarnSet::warp) + largest_radius(YarnSet::weft);
      require(curvature * half < 1.,
              "Fabric loading/Curvature comes to " + number_text(curvature) +
                ", a radius of " + number_text(1. / curvature, 2) +
                " mm, and a warp and a weft fiber, half as thick as a fabric "
                "at least, are " +
                number_text(half) +
                " mm; bend it to a radius of more than that.");
      const Contributions::FabricSize size = fabric_size();
      fabric_cases = parameters.fabric_loading.cases(fibers_at_sides(),
                                                     parameters.matrix.enabled);
      for (const Contributions::FabricCase &test : fabric_cases)
        {
          const auto supports = std::make_shared<Contributions::FabricSupports>(
            *fiber_space, initial_blocks, test, size);
          add_load_stage(test.name, supports);
          all_stages.back().begins_initially = true;
          if (test.bending)
            all_stages.back().flattened = [this, supports](const auto &place) {
              return supports->flattened(place, configuration->load_factor);
            };
          all_stages.back().plan.reach(
            parameters.fabric_loading.turning_points());
        }
    }



    Solver::Contributions
    Scene::own_contributions() const
    {
      if (!make_own)
        return {};
      const auto own = make_own(*fiber_space, initial_blocks);
      for (const auto &one : own)
        require(one != nullptr,
                "A contribution of your own is a null pointer.");
      return own;
    }



    void
    Scene::add_load_stage(const std::string                           &name,
                          const std::shared_ptr<System::Contribution> &supports)
    {
      Stage stage(StageKind::load);
      stage.name      = name;
      stage.plan      = parameters.load_stepping.plan();
      stage.objection = [](const Post::CrossingCount &crossings) {
        return crossings.wrong_in_words();
      };
      stage.begin         = [this] { begin_loading(); };
      stage.contributions = {fiber_elasticity, supports};
      if (!parameters.loads.empty())
        stage.contributions.push_back(std::make_shared<Contributions::Loads>(
          *fiber_space, initial_blocks, parameters.loads, is_fabric()));
      if (parameters.plates.are_there())
        add_plates(stage);
      for (const auto &own : own_contributions())
        stage.contributions.push_back(own);
      // A matrix may hold axes alone: then nothing resists the spin of a
      // straight fiber.
      if (is_fabric() || parameters.matrix.enabled)
        add_section_damping(stage, fiber_friction != nullptr);
      if (fiber_contact)
        stage.contributions.push_back(fiber_contact);
      if (is_fabric() && fiber_contact)
        stage.set_up =
          [contact = fiber_contact,
           threshold =
             parameters.settle.thresholds(parameters.contact.threshold).back()](
            const double) { contact->set_threshold(threshold); };
      if (!is_fabric() && fiber_friction)
        stage.set_up = [this](const double load_factor) {
          // Fibers that are given in each other have no way behind them.
          fiber_friction->set_active(load_factor > 0. || !begins_overlapping);
        };
      add_friction(stage);
      // Reports, checkpoints and the summary know them by name.
      std::set<std::string> names;
      for (const auto &contribution : stage.contributions)
        require(names.insert(contribution->name()).second,
                "Two contributions are called \"" + contribution->name() +
                  "\"; give your own another name().");
      all_stages.push_back(stage);
    }



    BoundingBox<2>
    Scene::crossing_area() const
    {
      // Warp yarns lie beside each other along y, weft yarns along x.
      const auto width = fabric_size().width;
      Point<2>   lower, upper;
      for (const YarnSet family : all_choices<YarnSet>())
        {
          const unsigned int across = family == YarnSet::warp ? 1 : 0;
          double             low    = std::numeric_limits<double>::max();
          double             high   = -low;
          for (const Textile::FiberPath &path : paths)
            if (path.set == word(family))
              {
                double sum = 0.;
                for (const Tensor<1, 3> &point : path.points)
                  sum += point[across];
                low  = std::min(low, sum / path.points.size());
                high = std::max(high, sum / path.points.size());
              }
          const double half = 0.5 * width[static_cast<unsigned int>(family)];
          lower[across]     = 0.5 * (low + high) - half;
          upper[across]     = 0.5 * (low + high) + half;
        }
      return BoundingBox<2>({lower, upper});
    }



    void
    Scene::add_plates(Stage &stage) const
    {
      double                        threshold = parameters.contact.threshold;
      std::optional<BoundingBox<2>> covered;
      if (is_fabric())
        {
          threshold = parameters.settle.thresholds(threshold).back();
          covered   = crossing_area();
        }
      if (parameters.fabric_loading.is_active())
        {
          const auto ends = Textile::ends_of_yarns(paths);
          for (unsigned int f = 0; f < paths.size(); ++f)
            for (const unsigned int end : {0, 1})
              {
                const auto &place =
                  end == 0 ? paths[f].points.front() : paths[f].points.back();
                require(!ends[f][end] ||
                          !covered->point_inside(Point<2>(place[0], place[1])),
                        "Plates/Compression is given, but fiber " +
                          std::to_string(f) +
                          " (counted from 0) ends between the plates, where "
                          "it is held: plates reach beyond the outer yarns by "
                          "half of their distance; let the yarns reach further "
                          "(in a weave Weave/End length above 0.5).");
              }
        }
      stage.contributions.push_back(std::make_shared<Contributions::Plates>(
        *fiber_space, parameters.plates, threshold, covered));
      stage.plan.reach(parameters.plates.turning_points());
    }



    const Contributions::Plates *
    Scene::plates(const unsigned int stage) const
    {
      for (const auto &contribution : all_stages[stage].contributions)
        if (const auto *const found =
              dynamic_cast<const Contributions::Plates *>(contribution.get()))
          return found;
      return nullptr;
    }



    bool
    Scene::ends_initially(const unsigned int stage) const
    {
      return is_fabric() && !all_stages[stage].is_loaded() &&
             (stage + 1 == all_stages.size() ||
              all_stages[stage + 1].is_loaded());
    }



    void
    Scene::begin_loading()
    {
      if (is_fabric() && parameters.restart.stress_free)
        {
          fiber_elasticity->set_reference(state());
          if (fiber_contact)
            fiber_contact->forgive_penetration(state());
          if (fiber_friction)
            fiber_friction->forget();
        }
      begins_overlapping =
        !is_fabric() && fiber_friction &&
        !deepest_overlap(*this, parameters, parameters.contact.threshold)
           .empty();
      if (parameters.matrix.enabled && !composite)
        embed();
    }



    void
    Scene::embed()
    {
      composite = std::make_unique<Matrix>(
        parameters.matrix, state(), parameters.turn_sections());
      for (Stage &stage : all_stages)
        if (stage.is_loaded())
          {
            stage.contributions.push_back(composite->elasticity());
            stage.contributions.push_back(composite->coupling());
          }
    }



    void
    Scene::embed_as(const ArchiveReader &archive, const std::string &where)
    {
      Matrix::load(archive, state());
      embed();
      composite->check(archive, where);
    }
  } // namespace Simulation
} // namespace Heddle
