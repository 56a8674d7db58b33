#include <heddle/base/reduce.h>
#include <heddle/contributions/fiber_elasticity.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numeric>
#include <sstream>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** No fiber bears more in compression, by far [-]. */
      constexpr double largest_strain = 0.3;

      /** An element that is less aligned is turned back on itself [-]. */
      constexpr double least_aligned = 0.1;

      /** Nodes come no closer in an iteration than this part of the way. */
      constexpr double largest_approach = 0.8;
    } // namespace



    template <typename Action>
    void
    FiberElasticity::for_each_element(const System::State &state,
                                      const Action        &action) const
    {
      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        for (unsigned int e = 0; e < space.fiber(f).n_elements; ++e)
          action(f, e, state.local_block(f) + space.first_block_of_element(e));
    }



    FiberElasticity::FiberElasticity(
      const System::FiberSpace        &space,
      const std::vector<Tensor<1, 3>> &configuration)
      : space(space)
    {
      const auto   owned      = space.owned_fibers();
      unsigned int n_elements = 0, block = 0;
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          first_element.push_back(n_elements);
          n_elements += space.fiber(f).n_elements;
        }
      reference.resize(std::size_t(n_elements) * space.element().n_strains());
      stresses.resize(reference.size());
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          for (unsigned int e = 0; e < space.fiber(f).n_elements; ++e)
            space.element().strains(configuration.data() + block +
                                      space.first_block_of_element(e),
                                    space.element_length(f, e),
                                    reference.data() + offset(f, e));
          block += space.n_blocks(f);
        }
    }



    void
    FiberElasticity::set_reference(const System::State &state)
    {
      keep_first_reference();
      for_each_element(
        state,
        [&](const unsigned int f, const unsigned int e, unsigned int first) {
          space.element().strains(state.current().data() + first,
                                  space.element_length(f, e),
                                  reference.data() + offset(f, e));
        });
      predicted = false;
    }



    void
    FiberElasticity::keep_first_reference()
    {
      if (!reference_was_set)
        first_reference = reference;
      reference_was_set = true;
    }



    void
    FiberElasticity::begin_step(System::State &)
    {
      predicted = false;
    }



    void
    FiberElasticity::add_pattern(const System::State  &state,
                                 System::BlockPattern &pattern)
    {
      std::array<unsigned int, Beam::Element::max_blocks> blocks;
      for_each_element(
        state, [&](unsigned int, unsigned int, const unsigned int first) {
          std::iota(blocks.begin(), blocks.end(), first);
          pattern.couple(space.element().n_blocks(), blocks.data());
        });
    }



    void
    FiberElasticity::assemble(const System::State &state,
                              System::BlockSystem &system)
    {
      constexpr unsigned int max_dofs = 3 * Beam::Element::max_blocks;
      std::array<unsigned int, Beam::Element::max_blocks> blocks;
      std::array<double, max_dofs>                        residual;
      std::array<double, max_dofs * max_dofs>             tangent;

      const Beam::Element &element = space.element();
      for_each_element(
        state,
        [&](const unsigned int f, const unsigned int e, unsigned int first) {
          element.assemble(space.fiber(f).section,
                           state.current().data() + first,
                           space.element_length(f, e),
                           reference_strains(f, e),
                           predicted ? stresses.data() + offset(f, e) : nullptr,
                           residual.data(),
                           system.wants_tangent() ? tangent.data() : nullptr);
          std::iota(blocks.begin(), blocks.end(), first);
          system.add(
            element.n_blocks(), blocks.data(), residual.data(), tangent.data());
        });
    }



    void
    FiberElasticity::predict(const System::State     &state,
                             const System::Increment &increment)
    {
      for_each_element(
        state,
        [&](const unsigned int f, const unsigned int e, unsigned int first) {
          space.element().predict_stresses(space.fiber(f).section,
                                           state.current().data() + first,
                                           increment.data() + first,
                                           space.element_length(f, e),
                                           reference_strains(f, e),
                                           stresses.data() + offset(f, e));
        });
      predicted = true;
    }



    std::pair<unsigned int, unsigned int>
    FiberElasticity::count_elements() const
    {
      std::pair<unsigned int, unsigned int> count = {0, 0};
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        {
          count.first += space.fiber(f).n_elements;
          if (f < space.owned_fibers().first)
            count.second += space.fiber(f).n_elements;
        }
      return count;
    }



    void
    FiberElasticity::save(ArchiveWriter &archive, const System::State &) const
    {
      if (!reference_was_set)
        return;
      const auto count = count_elements();
      archive.write(name() + "/reference strains",
                    count.second,
                    count.first,
                    reference,
                    space.element().n_strains());
    }



    void
    FiberElasticity::load(const ArchiveReader &archive, const System::State &)
    {
      if (!archive.has(name() + "/reference strains"))
        return;
      keep_first_reference();
      reference = archive.read(name() + "/reference strains",
                               count_elements().second,
                               reference.size() / space.element().n_strains(),
                               space.element().n_strains());
    }



    void
    FiberElasticity::load_initial(const ArchiveReader &archive,
                                  const System::State &state)
    {
      if (reference_was_set)
        reference = first_reference;
      reference_was_set = false;
      load(archive, state);
    }



    void
    FiberElasticity::raise_stiffness(System::NodeStiffness &stiffness) const
    {
      const bool has_sections = space.n_blocks_per_node() == 3;
      const auto owned        = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const System::Fiber &fiber = space.fiber(f);
          const double         h     = fiber.length / (fiber.n_nodes - 1);
          const double bending   = has_sections ? 0. : fiber.section.bending;
          stiffness.of_fibers[f] = std::max({stiffness.of_fibers[f],
                                             fiber.section.axial / h,
                                             12. * bending / (h * h * h)});
        }
    }



    double
    FiberElasticity::largest_step(const System::State     &state,
                                  const System::Increment &increment) const
    {
      // Of nodes that are c apart, and to move by d against each other.
      double             factor = std::numeric_limits<double>::max();
      const unsigned int n      = space.n_blocks_per_node();
      for_each_element(
        state, [&](unsigned int, unsigned int, const unsigned int first) {
          for (unsigned int i = 0; i + 1 < space.element().n_nodes(); ++i)
            {
              const unsigned int a = first + i * n, b = a + n;
              const Tensor<1, 3> c = state.current()[b] - state.current()[a];
              const double       approach = -(increment[b] - increment[a]) * c;
              if (factor * approach > largest_approach * c.norm_square())
                factor = largest_approach * c.norm_square() / approach;
            }
        });
      return factor;
    }



    std::string
    FiberElasticity::objection(const System::State &state) const
    {
      double             largest = 0.;
      std::ostringstream worst;
      for_each_element(
        state,
        [&](const unsigned int f, const unsigned int e, unsigned int first) {
          const Tensor<1, 3> *blocks = state.current().data() + first;
          const double        length = space.element_length(f, e);
          const auto          split  = space.element().energy_split(
            space.fiber(f).section, blocks, length, reference_strains(f, e));
          double strain =
            std::sqrt(2. * (split.axial + split.shear + split.section) /
                      (space.fiber(f).section.axial * length));
          const bool turned_back =
            space.element().alignment(blocks, length) < least_aligned;
          if (turned_back)
            strain = std::numeric_limits<double>::max();
          else if (strain > largest_strain &&
                   space.element()
                       .section_state(space.fiber(f).section,
                                      blocks,
                                      length,
                                      reference_strains(f, e))
                       .axial_strain > 0.)
            return;
          if (strain > largest)
            {
              largest = strain;
              worst.str("");
              worst << std::setprecision(3);
              if (turned_back)
                worst << "an element of fiber " << f << " near ("
                      << blocks[0][0] << ", " << blocks[0][1] << ", "
                      << blocks[0][2] << ") is turned back on itself";
              else
                worst << "fiber " << f << " is strained by " << strain
                      << " near (" << blocks[0][0] << ", " << blocks[0][1]
                      << ", " << blocks[0][2] << "), in compression";
            }
        });
      const auto where =
        Utilities::MPI::min_max_avg(largest, space.communicator());
      return where.max < largest_strain
               ? ""
               : Utilities::MPI::broadcast(
                   space.communicator(), worst.str(), where.max_index);
    }



    void
    FiberElasticity::report(const System::State           &state,
                            std::map<std::string, double> &values) const
    {
      Beam::Element::EnergySplit energy;
      double largest_stress = -std::numeric_limits<double>::max();
      for_each_element(
        state,
        [&](const unsigned int f, const unsigned int e, unsigned int first) {
          const System::Fiber &fiber  = space.fiber(f);
          const Tensor<1, 3>  *blocks = state.current().data() + first;
          const double         length = space.element_length(f, e);
          const double        *free   = reference_strains(f, e);
          const Beam::Element::EnergySplit split =
            space.element().energy_split(fiber.section, blocks, length, free);
          const auto state_of_section =
            space.element().section_state(fiber.section, blocks, length, free);
          largest_stress =
            std::max(largest_stress,
                     fiber.section.largest_stress(fiber.radius,
                                                  state_of_section.axial_strain,
                                                  state_of_section.curvature));
          energy.axial += split.axial;
          energy.bending += split.bending;
          energy.shear += split.shear;
          energy.torsion += split.torsion;
          energy.section += split.section;
        });
      sum_over_ranks(energy, space.communicator());
      values["axial_energy[N*mm]"]   = energy.axial;
      values["bending_energy[N*mm]"] = energy.bending;
      values["shear_energy[N*mm]"]   = energy.shear;
      values["torsion_energy[N*mm]"] = energy.torsion;
      values["section_energy[N*mm]"] = energy.section;
      max_over_ranks(largest_stress, space.communicator());
      values["max_fiber_stress[MPa]"] = largest_stress;
    }
  } // namespace Contributions
} // namespace Heddle
