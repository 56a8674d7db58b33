#ifndef heddle_textile_measured_fabric_h
#define heddle_textile_measured_fabric_h

#include <heddle/base/columns.h>
#include <heddle/textile/fiber_path.h>

#include <array>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /**
     * Warp and weft of a fabric whose centerlines were measured, for instance
     * by tomography: of the sets "warp", along x, and "weft", along y.
     */
    class MeasuredFabric
    {
    public:
      /**
       * Take @p paths of the file @p name, in which every fiber belongs to a
       * yarn. They are turned so that they run towards larger x and y, for who
       * follows a fiber in a picture may begin at either end. Throws
       * InputError if a fiber belongs to no yarn, to another set, or runs along
       * the other axis, or if there is no warp or no weft.
       */
      MeasuredFabric(std::vector<FiberPath> &paths, const std::string &name);

      /** Of the warp and of the weft. */
      std::array<unsigned int, 2>
      n_yarns() const;

      /**
       * How wide the fabric is across the warp and across the weft: the number
       * of yarns side by side times their mean distance [mm]. Yarns of several
       * layers that lie over each other count once. Throws InputError if there
       * are no two side by side.
       */
      std::array<double, 2>
      width() const;

    private:
      const std::string name;

      /** Where the middles of the yarns lie across them. */
      std::array<std::vector<YarnPlace>, 2> yarns_of;
    };
  } // namespace Textile
} // namespace Heddle

#endif
