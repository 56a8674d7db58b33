#ifndef heddle_post_centerline_h
#define heddle_post_centerline_h

#include <heddle/base/polyline.h>
#include <heddle/system/state.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Post
  {
    /**
     * Return points of the smooth centerline of fiber @p f in its current
     * place: @p n_pieces between neighbouring nodes, at equal steps of
     * reference arc length, both ends of the fiber included.
     *
     * @pre This rank has the fiber, as owner or as a copy.
     */
    Polyline
    centerline(const System::State &state,
               const unsigned int   f,
               const unsigned int   n_pieces);

    /**
     * Collect the centerlines of all fibers on rank 0; the result of the other
     * ranks is empty.
     * @note Collective.
     */
    std::vector<Polyline>
    gather_centerlines(const System::State &state, const unsigned int n_pieces);

    /**
     * Return the nodes of all fibers, to the last digit, as the table that
     * Textile::read_paths() takes; on other ranks than 0 without any lines.
     * @note Collective.
     */
    std::string
    centerlines_csv(const System::State &state);
  } // namespace Post
} // namespace Heddle

#endif
