#include <heddle/base/yarn_set.h>
#include <heddle/io/fiber_output.h>

#include <deal.II/grid/reference_cell.h>

#include <algorithm>

namespace Heddle
{
  namespace IO
  {
    namespace internal
    {
      namespace FiberOutput
      {
        constexpr unsigned int n_section_values = 13;

        using SectionValues = std::array<double, n_section_values>;



        SectionValues
        to_values(const System::Fiber               &fiber,
                  const Beam::Element::SectionState &s)
        {
          return {{s.axial_strain,
                   s.shear_strain[0],
                   s.shear_strain[1],
                   s.twist,
                   s.curvature[0],
                   s.curvature[1],
                   s.axial_force,
                   s.shear_force[0],
                   s.shear_force[1],
                   s.torque,
                   s.bending_moment[0],
                   s.bending_moment[1],
                   fiber.section.largest_stress(
                     fiber.radius, s.axial_strain, s.curvature)}};
        }



        /** What the elements of one fiber say, and where their middles are. */
        struct SectionCurve
        {
          std::vector<double>        middles;
          std::vector<SectionValues> values;

          SectionValues
          at(const double s) const
          {
            if (middles.size() == 1)
              return values.front();
            // Beyond the outermost middles the lines go on.
            const std::size_t found =
              std::upper_bound(middles.begin(), middles.end(), s) -
              middles.begin();
            const std::size_t after =
              std::min(std::max<std::size_t>(found, 1), middles.size() - 1);
            const std::size_t before = after - 1;
            const double      t =
              (s - middles[before]) / (middles[after] - middles[before]);
            SectionValues result;
            for (unsigned int c = 0; c < n_section_values; ++c)
              result[c] = (1. - t) * values[before][c] + t * values[after][c];
            return result;
          }
        };



        SectionCurve
        section_curve(
          const System::FiberSpace                        &space,
          const System::State                             &state,
          const Heddle::IO::FiberOutput::ReferenceStrains &reference_strains,
          const unsigned int                               f)
        {
          const auto  &fiber = space.fiber(f);
          SectionCurve curve;
          double       begin = 0.;
          for (unsigned int e = 0; e < fiber.n_elements; ++e)
            {
              const double length = space.element_length(f, e);
              curve.middles.push_back(begin + 0.5 * length);
              curve.values.push_back(
                to_values(fiber,
                          space.element().section_state(
                            fiber.section,
                            state.fiber(f) + space.first_block_of_element(e),
                            length,
                            reference_strains(f, e))));
              begin += length;
            }
          return curve;
        }



        /** Arc lengths of the points that are drawn, both ends included. */
        std::vector<double>
        stations(const System::FiberSpace &space,
                 const unsigned int        n_subdivisions,
                 const unsigned int        f)
        {
          const auto         &fiber = space.fiber(f);
          std::vector<double> result(1, 0.);
          double              begin = 0.;
          for (unsigned int e = 0; e < fiber.n_elements; ++e)
            {
              const double length = space.element_length(f, e);
              for (unsigned int i = 1; i <= n_subdivisions; ++i)
                result.push_back(begin + length * i / n_subdivisions);
              begin += length;
            }
          // Sums of element lengths may exceed the fiber by a rounding error.
          result.back() = fiber.length;
          return result;
        }



        /** Unit vector along g_1 of the section at the arc length @p s. */
        Tensor<1, 3>
        first_direction(const System::FiberSpace &space,
                        const System::State      &state,
                        const unsigned int        f,
                        const double              s)
        {
          const System::SectionPoint section = space.locate_section(f, s);
          Tensor<1, 3>               g;
          for (unsigned int i = 0; i < 2; ++i)
            g += section.values[i] * state.block(f, section.blocks[i]);
          return g / g.norm();
        }



        /** A fiber of no yarn or no bundle shows -1. */
        double
        id(const unsigned int number)
        {
          return static_cast<int>(number);
        }
      } // namespace FiberOutput
    }   // namespace internal



    FiberOutput::FiberOutput(const System::FiberSpace &space,
                             const unsigned int        n_subdivisions,
                             const std::string        &directory,
                             const unsigned int        resume_at)
      : space(space)
      , n_subdivisions(n_subdivisions)
      , collection(directory, "fibers", space.communicator(), resume_at)
    {
    }



    std::vector<std::string>
    FiberOutput::fields() const
    {
      std::vector<std::string> names = {"displacement[3]",
                                        "cross_section_radius",
                                        "fiber_id",
                                        "bundle_id",
                                        "yarn_id",
                                        "is_warp",
                                        "arc_length",
                                        "axial_strain",
                                        "shear_strain_2",
                                        "shear_strain_3",
                                        "twist",
                                        "curvature_2",
                                        "curvature_3",
                                        "axial_force",
                                        "shear_force_2",
                                        "shear_force_3",
                                        "torque",
                                        "bending_moment_2",
                                        "bending_moment_3",
                                        "max_fiber_stress"};
      if (has_sections())
        names.push_back("direction_2[3]");
      return names;
    }



    bool
    FiberOutput::has_sections() const
    {
      return space.n_blocks_per_node() > 2;
    }



    PatchFile<1>::Patch
    FiberOutput::patch(const System::State             &state,
                       const std::vector<Tensor<1, 3>> &initial,
                       const ReferenceStrains          &reference_strains,
                       const unsigned int               f) const
    {
      namespace helpers = internal::FiberOutput;

      const auto &fiber = space.fiber(f);
      const auto  curve =
        helpers::section_curve(space, state, reference_strains, f);
      const auto stations = helpers::stations(space, n_subdivisions, f);

      const unsigned int n_rows =
        3 + 6 + helpers::n_section_values + (has_sections() ? 3 : 0) + 3;
      PatchFile<1>::Patch patch;
      patch.n_subdivisions       = stations.size() - 1;
      patch.reference_cell       = ReferenceCells::Line;
      patch.points_are_available = true;
      patch.data.reinit(n_rows, stations.size());

      for (unsigned int i = 0; i < stations.size(); ++i)
        {
          const double s     = stations[i];
          const auto   point = space.locate(f, s);
          const auto   x     = point.position(state.fiber(f));
          const auto   start =
            point.position(initial.data() + state.local_block(f));
          const auto section = curve.at(s);

          unsigned int row = 0;
          const auto   put = [&](const double value) {
            patch.data(row++, i) = value;
          };
          for (unsigned int d = 0; d < 3; ++d)
            put(x[d] - start[d]);
          put(fiber.radius);
          put(f);
          put(helpers::id(fiber.bundle_id));
          put(helpers::id(fiber.yarn_id));
          put(fiber.set == word(YarnSet::warp) ? 1. : 0.);
          put(s);
          for (const double value : section)
            put(value);
          if (has_sections())
            {
              const auto g = helpers::first_direction(space, state, f, s);
              for (unsigned int d = 0; d < 3; ++d)
                put(g[d]);
            }
          // The points themselves come last: so the patch wants it.
          for (unsigned int d = 0; d < 3; ++d)
            put(x[d]);
          if (i == 0)
            patch.vertices[0] = Point<3>(x);
          patch.vertices[1] = Point<3>(x);
        }
      return patch;
    }



    void
    FiberOutput::write(const System::State             &state,
                       const std::vector<Tensor<1, 3>> &initial,
                       const ReferenceStrains          &reference_strains,
                       const unsigned int               number,
                       const double                     time,
                       const std::string               &stage)
    {
      PatchFile<1> file(fields());
      const auto   owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          file.patches.push_back(patch(state, initial, reference_strains, f));
          file.patches.back().patch_index = file.patches.size() - 1;
        }
      file.write(collection.path(number), space.communicator());
      collection.add(number, time, stage);
    }
  } // namespace IO
} // namespace Heddle
