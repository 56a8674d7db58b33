#include <heddle/base/exceptions.h>
#include <heddle/base/normals.h>
#include <heddle/base/number_text.h>
#include <heddle/simulation/fiber_placement.h>

#include <deal.II/base/exceptions.h>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      template <typename PointsOfFiber>
      std::vector<Tensor<1, 3>>
      place_owned(const System::FiberSpace &space, const PointsOfFiber &points)
      {
        std::vector<Tensor<1, 3>> blocks(space.owned_blocks().second -
                                         space.owned_blocks().first);
        unsigned int              begin = 0;
        for (unsigned int f = space.owned_fibers().first;
             f < space.owned_fibers().second;
             ++f)
          {
            place_fiber(space, f, points(f), blocks.data() + begin);
            begin += space.n_blocks(f);
          }
        return blocks;
      }
    } // namespace



    std::unique_ptr<System::FiberSpace>
    make_space(const std::vector<Textile::FiberPath> &paths,
               const FiberParameters                 &parameters,
               const MPI_Comm                         communicator)
    {
      auto                   element     = parameters.element();
      const unsigned int     per_element = element->n_nodes() - 1;
      std::vector<FiberName> names;
      for (const Textile::FiberPath &path : paths)
        names.push_back({path.set, path.yarn_id});
      const std::vector<unsigned int> materials =
        parameters.materials_of(FiberNames(names));

      std::vector<System::FiberSpace::Description> descriptions;
      for (unsigned int f = 0; f < paths.size(); ++f)
        {
          const Textile::FiberPath &path = paths[f];
          Assert((path.points.size() - 1) % per_element == 0,
                 ExcMessage("A path has no whole number of elements."));
          const unsigned int n_elements =
            (path.points.size() - 1) / per_element;
          descriptions.push_back(
            {std::vector<double>(n_elements,
                                 path.reference_length / n_elements),
             path.radius,
             path.yarn_id,
             path.bundle_id,
             path.set,
             parameters.material_number(materials[f])
               .section(path.radius, path.filament_radius)});
        }
      return std::make_unique<System::FiberSpace>(
        communicator, std::move(element), descriptions);
    }



    std::vector<double>
    densities_of(const System::FiberSpace              &space,
                 const std::vector<Textile::FiberPath> &paths,
                 const FiberParameters                 &parameters)
    {
      const std::vector<unsigned int> materials =
        parameters.materials_of(space.names());
      std::vector<double> densities;
      for (unsigned int f = 0; f < paths.size(); ++f)
        {
          const double of_yarn = paths[f].density;
          const double of_material =
            parameters.material_number(materials[f]).density;
          if (of_yarn > 0. && of_material > 0. && of_yarn != of_material)
            throw InputError(
              (materials[f] == 0
                 ? std::string("Fiber")
                 : "Fiber/Material " + std::to_string(materials[f])) +
              ": \"Density\" is " + number_text(of_material) +
              " g/cm^3, but that of the " + paths[f].set +
              " yarns, which are of it, is " + number_text(of_yarn) +
              "; leave one of them out.");
          densities.push_back(of_yarn > 0. ? of_yarn : of_material);
        }
      return densities;
    }



    void
    place_fiber(const System::FiberSpace        &space,
                const unsigned int               fiber,
                const std::vector<Tensor<1, 3>> &points,
                Tensor<1, 3>                    *blocks)
    {
      const unsigned int n = points.size();
      AssertDimension(n, space.fiber(fiber).n_nodes);
      Tensor<1, 3> normal;
      for (unsigned int i = 0; i < n; ++i)
        {
          Tensor<1, 3> tangent;
          for (const auto &weight : space.tangent_weights(fiber, i))
            tangent += weight.second * points[weight.first];
          Tensor<1, 3> *node = blocks + i * space.n_blocks_per_node();
          node[0]            = points[i];
          if (space.n_blocks_per_node() == 2)
            {
              node[1] = tangent;
              continue;
            }

          // The normal of the node before, turned into this section.
          if (i == 0)
            normal = -two_normals(tangent)[1];
          normal -= (normal * tangent) / tangent.norm_square() * tangent;
          normal /= normal.norm();
          node[1] = normal;
          node[2] = cross_product_3d(tangent / tangent.norm(), normal);
        }
    }



    std::vector<Tensor<1, 3>>
    place_on_paths(const System::FiberSpace              &space,
                   const std::vector<Textile::FiberPath> &paths)
    {
      return place_owned(
        space, [&paths](const unsigned int f) { return paths[f].points; });
    }



    std::vector<Tensor<1, 3>>
    place_straight(const System::FiberSpace &space)
    {
      return place_owned(space, [&space](const unsigned int f) {
        std::vector<Tensor<1, 3>> points(space.fiber(f).n_nodes);
        for (unsigned int i = 0; i < points.size(); ++i)
          points[i][0] = space.node_positions(f)[i];
        return points;
      });
    }
  } // namespace Simulation
} // namespace Heddle
