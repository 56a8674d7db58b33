#include <heddle/base/exceptions.h>
#include <heddle/simulation/matrix_estimate.h>
#include <heddle/textile/matrix_mesh.h>

#include <deal.II/base/bounding_box.h>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Whether there is a place in both that hold all of these. */
      bool
      has_any_within(const BoundingBox<3>            &mesh,
                     const std::vector<Tensor<1, 3>> &nodes)
      {
        const BoundingBox<3> of_fibers(
          std::vector<Point<3>>(nodes.begin(), nodes.end()));
        return of_fibers.get_neighbor_type(mesh) != NeighborType::not_neighbors;
      }
    } // namespace



    MatrixEstimate::MatrixEstimate(const MatrixParameters &parameters,
                                   const std::vector<Textile::FiberPath> &paths)
    {
      std::vector<Textile::FiberAxis> axes;
      std::vector<Tensor<1, 3>>       nodes;
      for (const Textile::FiberPath &path : paths)
        {
          axes.push_back({path.points, path.radius, path.yarn_id});
          nodes.insert(nodes.end(), path.points.begin(), path.points.end());
        }
      try
        {
          const Textile::MatrixMesh mesh(
            parameters.mesh.description(), axes, nodes);
          const BoundingBox<3> box(mesh.vertices());
          require(has_any_within(box, nodes),
                  "Matrix: the block lies beside all fibers; choose other "
                  "corners.");
          for (unsigned int d = 0; d < 3; ++d)
            extent[d] = box.side_length(d);
          n_cells = mesh.cells().size();
          n_nodes = mesh.vertices().size();

          // One more on each edge and face and in each cell. There are half as
          // many inner faces as sides of cells, and, after Euler, as many
          // edges as vertices and faces less cells.
          const double n_faces = 3. * n_cells + 0.5 * mesh.boundary().size();
          if (parameters.degree == 2)
            n_nodes = 2. * (n_nodes + n_faces);
        }
      catch (const InputError &error)
        {
          objection = error.what();
        }
    }
  } // namespace Simulation
} // namespace Heddle
