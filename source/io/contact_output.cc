#include <heddle/io/contact_output.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace IO
  {
    namespace internal
    {
      namespace ContactOutput
      {
        struct Particle
        {
          Tensor<1, 3> position, direction; /**< [mm], of the centerline [-] */
        };



        Particle
        particle(const System::FiberSpace &space,
                 const System::State      &state,
                 const unsigned int        f,
                 const double              s)
        {
          std::array<double, 4> slopes;
          const auto            point = space.locate(f, s, slopes);
          Particle              result;
          for (unsigned int i = 0; i < point.blocks.size(); ++i)
            {
              const Tensor<1, 3> &block = state.block(f, point.blocks[i]);
              result.position += point.values[i] * block;
              result.direction += slopes[i] * block;
            }
          result.direction /= result.direction.norm();
          return result;
        }



        /** Zones are numbered per rank; return where this rank's begin. */
        unsigned int
        first_zone(const std::vector<Contact::ContactElement> &elements,
                   const MPI_Comm                              communicator)
        {
          unsigned int n_zones = 0;
          for (const auto &element : elements)
            n_zones = std::max(n_zones, element.zone + 1);

          unsigned int before = 0;
          const int    ierr   = MPI_Exscan(
            &n_zones, &before, 1, MPI_UNSIGNED, MPI_SUM, communicator);
          AssertThrowMPI(ierr);
          return before;
        }
      } // namespace ContactOutput
    }   // namespace internal



    ContactOutput::ContactOutput(const System::FiberSpace &space,
                                 const bool                with_friction,
                                 const std::string        &directory,
                                 const unsigned int        resume_at)
      : space(space)
      , with_friction(with_friction)
      , collection(directory, "contacts", space.communicator(), resume_at)
    {
    }



    std::vector<std::string>
    ContactOutput::fields(const bool with_friction)
    {
      std::vector<std::string> names = {"normal[3]",
                                        "gap",
                                        "penetration_ratio",
                                        "normal_force",
                                        "penalty",
                                        "weight",
                                        "contact_angle",
                                        "same_yarn",
                                        "fiber_id_a",
                                        "fiber_id_b",
                                        "zone_id"};
      if (with_friction)
        names.insert(names.end(), {"tangential_force[3]", "slip_ratio"});
      return names;
    }



    PatchFile<0>::Patch
    ContactOutput::patch(const Contact::ContactElement  &element,
                         const Contact::TangentialForce *friction,
                         const System::State            &state,
                         const unsigned int              zone_id) const
    {
      namespace helpers = internal::ContactOutput;

      const auto  &a              = space.fiber(element.fiber_a);
      const auto  &b              = space.fiber(element.fiber_b);
      const double smaller_radius = std::min(a.radius, b.radius);
      const auto   at_a =
        helpers::particle(space, state, element.fiber_a, element.s_a);
      const auto at_b =
        helpers::particle(space, state, element.fiber_b, element.s_b);
      const double cosine =
        std::min(1., std::abs(at_a.direction * at_b.direction));

      PatchFile<0>::Patch patch;
      patch.vertices[0] = Point<3>(0.5 * (at_a.position + at_b.position));

      std::vector<double> values = {
        element.normal[0],
        element.normal[1],
        element.normal[2],
        element.gap,
        std::max(0., -element.gap) / smaller_radius,
        element.force,
        element.penalty,
        element.weight,
        std::acos(cosine) * 180. / numbers::PI,
        a.yarn_id == b.yarn_id && a.yarn_id != numbers::invalid_unsigned_int
          ? 1.
          : 0.,
        static_cast<double>(element.fiber_a),
        static_cast<double>(element.fiber_b),
        static_cast<double>(zone_id)};
      if (friction)
        values.insert(values.end(),
                      {friction->on_a[0],
                       friction->on_a[1],
                       friction->on_a[2],
                       friction->ratio});
      patch.data.reinit(values.size(), 1);
      for (unsigned int c = 0; c < values.size(); ++c)
        patch.data(c, 0) = values[c];
      return patch;
    }



    void
    ContactOutput::write(const std::vector<Contact::ContactElement>  &elements,
                         const std::vector<Contact::TangentialForce> &friction,
                         const System::State                         &state,
                         const unsigned int                           number,
                         const double                                 time,
                         const std::string                           &stage)
    {
      Assert(friction.size() == (with_friction ? elements.size() : 0),
             ExcDimensionMismatch(friction.size(), elements.size()));
      const unsigned int first_zone =
        internal::ContactOutput::first_zone(elements, space.communicator());

      PatchFile<0> file(fields(with_friction));
      file.patches.reserve(elements.size());
      for (std::size_t i = 0; i < elements.size(); ++i)
        if (space.owns(elements[i].fiber_a))
          {
            file.patches.push_back(patch(elements[i],
                                         with_friction ? &friction[i] : nullptr,
                                         state,
                                         first_zone + elements[i].zone));
            file.patches.back().patch_index = file.patches.size() - 1;
          }
      file.write(collection.path(number), space.communicator());
      collection.add(number, time, stage);
    }
  } // namespace IO
} // namespace Heddle
