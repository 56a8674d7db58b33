#ifndef heddle_io_matrix_output_h
#define heddle_io_matrix_output_h

#include <heddle/io/collection.h>
#include <heddle/io/patch_file.h>
#include <heddle/system/state.h>

#include <deal.II/base/symmetric_tensor.h>

#include <functional>
#include <string>
#include <vector>

namespace Heddle
{
  namespace IO
  {
    using namespace dealii;

    /** Means over a cell of the matrix. */
    struct CellMeans
    {
      SymmetricTensor<2, 3> strain;         /**< [-] */
      SymmetricTensor<2, 3> stress;         /**< Cauchy's [MPa] */
      double                von_mises = 0.; /**< [MPa] */
    };

    /** A link of a fiber to the matrix. */
    struct LinkPoint
    {
      unsigned int fiber;
      Tensor<1, 3> position; /**< [mm] */
      Tensor<1, 3> force;    /**< on the fiber [N] */
      double       length;   /**< of fiber [mm] */
    };

    /**
     * The hexahedra of the matrix where they are now, with displacements from
     * the reference configuration and the means of strain and stress; and the
     * links to the fibers as points.
     */
    class MatrixOutput
    {
    public:
      MatrixOutput(const std::string &directory,
                   const MPI_Comm     communicator,
                   const unsigned int resume_at = 0);

      /**
       * Write file @p number of both series. A cell is written by the rank that
       * owns its first node, and asked of @p means there.
       * @note Collective.
       */
      void
      write(const System::State                                &state,
            const std::function<CellMeans(const unsigned int)> &means,
            const std::vector<LinkPoint>                       &links,
            const unsigned int                                  number,
            const double                                        time,
            const std::string                                  &stage);

    private:
      void
      write_cells(const System::State                                &state,
                  const std::function<CellMeans(const unsigned int)> &means,
                  const std::string                                  &path);

      void
      write_links(const std::vector<LinkPoint> &links, const std::string &path);

      const MPI_Comm communicator;
      Collection     cells, points;
    };
  } // namespace IO
} // namespace Heddle

#endif
