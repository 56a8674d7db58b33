#include <heddle/base/reduce.h>
#include <heddle/contributions/fiber_matrix_coupling.h>

#include <algorithm>

namespace Heddle
{
  namespace Contributions
  {
    FiberMatrixCoupling::FiberMatrixCoupling(
      const System::MatrixSpace        &matrix,
      const System::State              &state,
      const std::vector<EmbeddedPoint> &points,
      const double                      stiffness)
    {
      Places places;
      for (const EmbeddedPoint &point : points)
        {
          EmbeddedLink embedded   = {};
          embedded.fiber          = point.fiber;
          embedded.length         = point.length;
          embedded.link.stiffness = stiffness * point.length;

          // A node is one block: those of no weight are left out.
          unsigned int &n = embedded.link.n;
          for (unsigned int i = 0; i < point.particle.blocks.size(); ++i)
            if (point.particle.values[i] != 0.)
              {
                embedded.fiber_blocks[n]   = point.particle.blocks[i];
                embedded.link.weights[n++] = point.particle.values[i];
              }
          embedded.link.n_of_fiber = n;
          for (unsigned int a = 0; a < point.shapes.size(); ++a)
            {
              embedded.matrix_blocks[a] =
                state.matrix_block(matrix.cell(point.cell)[a]);
              embedded.link.weights[n++] = -point.shapes[a];
            }
          find_places(embedded, state, places);
          embedded.link.offset = embedded.link.stretch(places.places.data());
          links.push_back(embedded);

          if (!point.gradients.empty())
            add_section(point, embedded.link.stiffness, matrix, state);
        }
    }



    void
    FiberMatrixCoupling::add_section(const EmbeddedPoint       &point,
                                     const double               stiffness,
                                     const System::MatrixSpace &matrix,
                                     const System::State       &state)
    {
      const double    radius   = state.space.fiber(point.fiber).radius;
      EmbeddedSection embedded = {};
      embedded.fiber           = point.fiber;
      embedded.link.stiffness  = stiffness * radius * radius;

      std::array<Tensor<1, 3>, 2> vectors;
      unsigned int               &n = embedded.link.n;
      for (unsigned int i = 0; i < point.section.values.size(); ++i)
        if (point.section.values[i] != 0.)
          {
            embedded.link.weights[n / 2] = point.section.values[i];
            for (unsigned int alpha = 0; alpha < 2; ++alpha)
              {
                const unsigned int block   = point.section.blocks[i] + alpha;
                embedded.fiber_blocks[n++] = block;
                vectors[alpha] +=
                  point.section.values[i] *
                  state.current()[state.local_block(point.fiber) + block];
              }
          }
      embedded.link.n_of_fiber = n;
      for (unsigned int a = 0; a < point.gradients.size(); ++a, ++n)
        {
          embedded.matrix_blocks[a] =
            state.matrix_block(matrix.cell(point.cell)[a]);
          for (unsigned int alpha = 0; alpha < 2; ++alpha)
            embedded.link.slopes[a][alpha] =
              point.gradients[a] * vectors[alpha];
        }
      sections.push_back(embedded);
    }



    template <class Embedded>
    void
    FiberMatrixCoupling::find_places(const Embedded      &embedded,
                                     const System::State &state,
                                     Places              &places)
    {
      const unsigned int n_of_fiber = embedded.link.n_of_fiber;
      for (unsigned int a = 0; a < embedded.link.n; ++a)
        {
          places.blocks[a] =
            a < n_of_fiber
              ? state.local_block(embedded.fiber) + embedded.fiber_blocks[a]
              : embedded.matrix_blocks[a - n_of_fiber];
          places.places[a] = state.current()[places.blocks[a]];
        }
    }



    void
    FiberMatrixCoupling::add_pattern(const System::State  &state,
                                     System::BlockPattern &pattern)
    {
      Places     places;
      const auto couple = [&](const auto &embedded) {
        find_places(embedded, state, places);
        pattern.couple(embedded.link.n, places.blocks.data());
      };
      for (const EmbeddedLink &embedded : links)
        couple(embedded);
      for (const EmbeddedSection &embedded : sections)
        couple(embedded);
    }



    void
    FiberMatrixCoupling::assemble(const System::State &state,
                                  System::BlockSystem &system)
    {
      assemble_links(links, state, system);
      assemble_links(sections, state, system);
    }



    template <class Embedded>
    void
    FiberMatrixCoupling::assemble_links(const std::vector<Embedded> &links,
                                        const System::State         &state,
                                        System::BlockSystem         &system)
    {
      constexpr unsigned int       max_dofs = 3 * Coupling::max_weights;
      std::array<double, max_dofs> residual;
      std::array<double, max_dofs * max_dofs> tangent;
      Places                                  places;
      for (const Embedded &embedded : links)
        {
          find_places(embedded, state, places);
          embedded.link.assemble(places.places.data(),
                                 residual.data(),
                                 system.wants_tangent() ? tangent.data()
                                                        : nullptr);
          system.add(embedded.link.n,
                     places.blocks.data(),
                     residual.data(),
                     tangent.data());
        }
    }



    void
    FiberMatrixCoupling::raise_stiffness(System::NodeStiffness &stiffness) const
    {
      for (const EmbeddedLink &embedded : links)
        for (double *of_node :
             {&stiffness.of_fibers[embedded.fiber], &stiffness.of_matrix})
          *of_node = std::max(*of_node, embedded.link.stiffness);
    }



    void
    FiberMatrixCoupling::report(const System::State           &state,
                                std::map<std::string, double> &values) const
    {
      struct
      {
        double energy = 0., n_elements = 0.;
      } sums;
      double largest_force = 0.;
      for (const EmbeddedLink &embedded : links)
        if (state.space.owns(embedded.fiber))
          {
            Places places;
            find_places(embedded, state, places);
            const double stretch =
              embedded.link.stretch(places.places.data()).norm();
            sums.energy += 0.5 * embedded.link.stiffness * stretch * stretch;
            sums.n_elements += 1.;
            largest_force =
              std::max(largest_force,
                       embedded.link.stiffness * stretch / embedded.length);
          }
      for (const EmbeddedSection &embedded : sections)
        if (state.space.owns(embedded.fiber))
          {
            Places places;
            find_places(embedded, state, places);
            const double turn = embedded.link.turn(places.places.data());
            sums.energy += 0.5 * embedded.link.stiffness * turn * turn;
          }
      sum_over_ranks(sums, state.space.communicator());
      max_over_ranks(largest_force, state.space.communicator());
      values["coupling_energy[N*mm]"]                   = sums.energy;
      values["coupling_elements[-]"]                    = sums.n_elements;
      values["largest_coupling_force_per_length[N/mm]"] = largest_force;
    }



    std::vector<FiberMatrixCoupling::Point>
    FiberMatrixCoupling::points(const System::State &state) const
    {
      std::vector<Point> result;
      for (const EmbeddedLink &embedded : links)
        if (state.space.owns(embedded.fiber))
          {
            Places places;
            find_places(embedded, state, places);
            Tensor<1, 3> position;
            for (unsigned int a = 0; a < embedded.link.n_of_fiber; ++a)
              position += embedded.link.weights[a] * places.places[a];
            result.push_back({embedded.fiber,
                              position,
                              embedded.link.force(places.places.data()),
                              embedded.length});
          }
      return result;
    }
  } // namespace Contributions
} // namespace Heddle
