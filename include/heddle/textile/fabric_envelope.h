#ifndef heddle_textile_fabric_envelope_h
#define heddle_textile_fabric_envelope_h

#include <heddle/textile/column_grid.h>
#include <heddle/textile/fiber_axis.h>

#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /** Heights at the corners of the columns, bilinear between them [mm]. */
    struct Envelope
    {
      std::vector<double> lower;
      std::vector<double> upper;
    };



    /**
     * Two smooth surfaces that hold all fibers between them as closely as the
     * columns allow.
     *
     * On a raster finer than the columns, H is the largest height of a fiber
     * surface nearby: of the axis plus the radius, over a strip as wide as the
     * fiber. The upper surface begins at the largest H around each corner,
     * or, where there is no fiber, at the mean of its neighbours. Then it is
     * smoothed, by the weights 1-2-1 along x and y, and raised by no more than
     * it takes to lie above H again, in turn, as often as it takes to smooth
     * over a length of three fiber radii: a membrane that is pulled over the
     * fabric. It spans holes between the yarns and follows the relief of
     * crossings. The lower surface is the same, upside down.
     *
     * Fibers outside the columns have no effect.
     * @pre At least one fiber lies over the columns.
     */
    Envelope
    fabric_envelope(const ColumnGrid             &columns,
                    const std::vector<FiberAxis> &fibers);
  } // namespace Textile
} // namespace Heddle

#endif
