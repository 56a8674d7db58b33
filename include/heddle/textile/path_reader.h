#ifndef heddle_textile_path_reader_h
#define heddle_textile_path_reader_h

#include <heddle/textile/fiber_path.h>
#include <heddle/textile/interpolation.h>

#include <mpi.h>

#include <istream>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /** How a file of centerlines is to be understood. */
    struct PathReading
    {
      /** Length of an element; each fiber gets the nearest number of them [mm].
       */
      double element_length = 0.;

      /** Intervals between knots in one element. */
      unsigned int knots_per_element = 1;

      /** Radius of all fibers [mm]; 0: from the column `radius`. */
      double radius = 0.;

      /**
       * Size of the file's unit of length [mm], such as the edge of a voxel. A
       * column `radius` is in this unit too.
       */
      double scale = 1.;

      Interpolation interpolation = Interpolation::spline;

      /** Of the fibers as they lie in the file, along their axes [-]. */
      double axial_strain = 0.;
    };



    /**
     * Read fibers from a CsvTable: a header that names the columns
     * in any order, `fiber,x,y,z[,radius][,set][,yarn]`, then one line per
     * point, the points of a fiber in their order along it. Fibers are told
     * apart by the word in column `fiber` and numbered in the order in which
     * they appear, and so are yarns; without a word there a fiber belongs to
     * none. Blank lines and everything behind a `#` are skipped. The radius of
     * a fiber is the mean over its points, its set and its yarn must be the
     * same at all, and so must the set of all fibers of a yarn.
     *
     * The knots returned are equally spaced along an interpolating curve, and
     * the reference length is the arc length of this curve, less what it is
     * strained by.
     *
     * Throws InputError, with file, line, what was found and what to do.
     *
     * The first rank reads for all of them.
     * @note Collective.
     */
    std::vector<FiberPath>
    read_paths(const std::string &file_name,
               const PathReading &reading,
               const MPI_Comm     communicator);

    /** The same, by each rank for itself, from a stream that messages call
     * @p name. */
    std::vector<FiberPath>
    read_paths(std::istream      &input,
               const std::string &name,
               const PathReading &reading);
  } // namespace Textile
} // namespace Heddle

#endif
