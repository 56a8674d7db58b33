#include <heddle/io/plate_output.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

namespace Heddle
{
  namespace IO
  {
    PlateOutput::PlateOutput(const std::string &directory,
                             const MPI_Comm     communicator,
                             const unsigned int resume_at)
      : communicator(communicator)
      , collection(directory, "plates", communicator, resume_at)
    {
    }



    void
    PlateOutput::write(const BoundingBox<2>        &extent,
                       const std::array<double, 2> &heights,
                       const std::array<double, 2> &forces,
                       const unsigned int           number,
                       const double                 time,
                       const std::string           &stage)
    {
      PatchFile<2> file({"force", "is_upper"});
      // All ranks know both plates.
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        for (unsigned int plate = 0; plate < heights.size(); ++plate)
          {
            PatchFile<2>::Patch patch;
            patch.patch_index    = plate;
            patch.reference_cell = ReferenceCells::Quadrilateral;
            patch.data.reinit(file.n_components(),
                              GeometryInfo<2>::vertices_per_cell);
            for (unsigned int v = 0; v < GeometryInfo<2>::vertices_per_cell;
                 ++v)
              {
                const Point<2> corner = extent.vertex(v);
                patch.vertices[v] =
                  Point<3>(corner[0], corner[1], heights[plate]);
                patch.data(0, v) = forces[plate];
                patch.data(1, v) = plate;
              }
            file.patches.push_back(patch);
          }
      file.write(collection.path(number), communicator);
      collection.add(number, time, stage);
    }
  } // namespace IO
} // namespace Heddle
