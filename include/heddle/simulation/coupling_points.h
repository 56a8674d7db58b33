#ifndef heddle_simulation_coupling_points_h
#define heddle_simulation_coupling_points_h

#include <heddle/contributions/fiber_matrix_coupling.h>
#include <heddle/system/matrix_space.h>
#include <heddle/system/state.h>
#include <heddle/textile/matrix_mesh.h>

#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /**
     * Finds the particles of fibers at which they are linked to the cells of a
     * matrix, and the length that each of them stands for.
     */
    class CouplingPoints
    {
    public:
      using Points = std::vector<Contributions::EmbeddedPoint>;

      /** Fibers are where @p state has them, in cells of @p matrix. Their
       * sections are linked too, if they shall be, and if there are any. */
      CouplingPoints(const System::State       &state,
                     const Textile::MatrixMesh &mesh,
                     const System::MatrixSpace &matrix,
                     const bool                 with_sections);

      /**
       * Take nodes of the fiber (Durville), each for the half of the intervals
       * next to it, as far as these lie in the matrix. Of an interval with a
       * node within and one outside, the part within gets Gauss points instead:
       * were the node within to stand for half of it, how a fiber that leaves
       * the matrix is gripped would depend on where its nodes happen to lie.
       */
      void
      add_nodes(const unsigned int fiber);

      /** Take @p n Gauss points of each of its elements. */
      void
      add_gauss_points(const unsigned int fiber, const unsigned int n);

      const Points &
      points() const
      {
        return found;
      }

    private:
      /** Whether the particle at arc length @p s [mm] lies in a cell. */
      bool
      contains(const unsigned int fiber, const double s) const;

      /** Where the fiber leaves the matrix between two particles [mm]. */
      double
      surface_between(const unsigned int fiber,
                      const double       inside,
                      const double       outside) const;

      /** Take Gauss points of the piece of the fiber between two particles. */
      void
      add_piece(const unsigned int fiber,
                const unsigned int n_points,
                const double       begin,
                const double       end);

      /**
       * Take the particle at arc length @p s [mm], with the section there,
       * which stands for @p length [mm], if a cell has it.
       */
      void
      add(const unsigned int           fiber,
          const double                 s,
          const System::MaterialPoint &particle,
          const double                 length);

      /** Of the shapes of the cell at this place of it [1/mm]. */
      std::vector<Tensor<1, 3>>
      gradients(const Textile::PlaceInCell &place) const;

      const System::State       &state;
      const Textile::MatrixMesh &mesh;
      const System::MatrixSpace &matrix;
      const bool                 with_sections;
      Points                     found;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
