#ifndef heddle_io_plate_output_h
#define heddle_io_plate_output_h

#include <heddle/io/collection.h>
#include <heddle/io/patch_file.h>

#include <deal.II/base/bounding_box.h>

#include <array>
#include <string>

namespace Heddle
{
  namespace IO
  {
    using namespace dealii;

    /** Two level plates as rectangles, with what presses on each. */
    class PlateOutput
    {
    public:
      PlateOutput(const std::string &directory,
                  const MPI_Comm     communicator,
                  const unsigned int resume_at = 0);

      /**
       * Write file @p number of the series: the plate below and that above at
       * their @p heights [mm], over all of @p extent, and the @p forces on them
       * [N].
       * @note Collective.
       */
      void
      write(const BoundingBox<2>        &extent,
            const std::array<double, 2> &heights,
            const std::array<double, 2> &forces,
            const unsigned int           number,
            const double                 time,
            const std::string           &stage);

    private:
      const MPI_Comm communicator;
      Collection     collection;
    };
  } // namespace IO
} // namespace Heddle

#endif
