#include <heddle/base/normals.h>
#include <heddle/textile/fiber_volume.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** Points of a cylinder of radius 1 and length 1, the latter last, each
       * of which stands for an equal volume: seen along the axis a spiral whose
       * turns are as far from each other as its points (H. Vogel, A better way
       * to construct the sunflower head, 1979), seen across as even. Those of
       * another @p turn lie between them. */
      Point<3>
      point_of_cylinder(const unsigned int k,
                        const unsigned int n,
                        const double       turn)
      {
        const double golden_angle = numbers::PI * (3. - std::sqrt(5.));
        const double radius       = std::sqrt((k + 0.5) / n);
        return {radius * std::cos(k * golden_angle + turn),
                radius * std::sin(k * golden_angle + turn),
                std::fmod((k + 0.5) * numbers::SQRT2, 1.)};
      }



      /** A fiber at a face of the mesh lies in it with a part of its section,
       * which fewer points do not tell, however thin it is. */
      constexpr double least_points = 16.;
    } // namespace



    FiberVolumes
    fiber_volumes(const MatrixMesh &mesh, const std::vector<FiberAxis> &fibers)
    {
      FiberVolumes volumes;
      volumes.in_cells.resize(mesh.cells().size());
      const double spacing =
        0.25 * std::cbrt(mesh.volume() / mesh.cells().size());
      for (const FiberAxis &fiber : fibers)
        {
          const double       ratio = 2. * fiber.radius / spacing;
          const unsigned int n_across =
            std::max(least_points, std::ceil(ratio * ratio));
          unsigned int turn = 0;
          for (unsigned int i = 0; i + 1 < fiber.points.size(); ++i)
            {
              const Tensor<1, 3> piece  = fiber.points[i + 1] - fiber.points[i];
              const unsigned int n      = std::ceil(piece.norm() / spacing);
              const auto         across = two_normals(piece);
              const double volume = numbers::PI * fiber.radius * fiber.radius *
                                    piece.norm() / (n * n_across);
              for (unsigned int k = 0; k < n; ++k, ++turn)
                for (unsigned int j = 0; j < n_across; ++j)
                  {
                    const Point<3> point = point_of_cylinder(j, n_across, turn);
                    const auto     found = mesh.grid().locate(
                      fiber.points[i] + (k + point[2]) / n * piece +
                      fiber.radius *
                        (point[0] * across[0] + point[1] * across[1]));
                    if (found.cell == no_cell)
                      continue;
                    volumes.in_grid += volume;
                    const unsigned int cell = mesh.number_of(found.cell);
                    if (cell != no_cell)
                      volumes.in_cells[cell] += volume;
                  }
            }
        }
      return volumes;
    }
  } // namespace Textile
} // namespace Heddle
