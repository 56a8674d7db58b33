#ifndef heddle_textile_yarn_body_h
#define heddle_textile_yarn_body_h

#include <heddle/base/mean_line.h>
#include <heddle/textile/fiber_axis.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /**
     * The room that a yarn fills. At stations along its mean line, one fiber
     * radius apart, lies a section: the convex hull of the places where the
     * fiber axes pass, grown by the mean fiber radius.
     *
     * The fibers of a yarn do not all end in one plane. The body reaches one
     * radius beyond the end of the farthest one, so that a plane through the
     * ends of the yarns cuts it; all fibers that end there go straight on to
     * it, and those that end within the yarn (YarnReach) end.
     */
    class YarnBody
    {
    public:
      /** @pre At least one fiber. */
      explicit YarnBody(const std::vector<FiberAxis> &fibers);

      /**
       * How deep @p point lies below the surface of the nearest section;
       * negative outside [mm]. Sections at the ends are not a surface, but
       * what lies beyond them is outside, by its distance.
       */
      double
      depth(const Tensor<1, 3> &point) const;

      /** Mean radius of the fibers [mm]. */
      double
      fiber_radius() const
      {
        return radius;
      }

      /** A box around the body. */
      const BoundingBox<3> &
      box() const
      {
        return bounding_box;
      }

      /** Extent in z of the sections, in the mean over the stations [mm]. */
      double
      height() const
      {
        return mean_height;
      }

      /** The ends of the mean line, before it is extended [mm]. */
      const Tensor<1, 3> &
      end(const unsigned int which) const
      {
        return ends[which];
      }

    private:
      struct Section
      {
        CuttingPlane                plane;
        std::array<Tensor<1, 3>, 2> axes;

        /** Corners of the hull of the fiber axes, counter-clockwise. */
        std::vector<Point<2>> hull;
      };

      /** Lengthen @p lines, which all run the same way, and their mean line to
       * the ends of the body. */
      void
      extend(std::vector<Polyline> &lines, Polyline &mean) const;

      void
      add_section(const std::vector<Polyline> &lines,
                  const CuttingPlane          &plane);

      const Section &
      nearest_section(const Tensor<1, 3> &point) const;

      double                      radius = 0.;
      std::array<Tensor<1, 3>, 2> ends;
      std::vector<Section>        sections;
      BoundingBox<3>              bounding_box;
      double                      mean_height = 0.;
    };

    /** The bodies of all yarns; fibers that belong to none have no body. */
    std::vector<YarnBody>
    yarn_bodies(const std::vector<FiberAxis> &fibers);
  } // namespace Textile
} // namespace Heddle

#endif
