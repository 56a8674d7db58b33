#ifndef heddle_contact_pair_frame_h
#define heddle_contact_pair_frame_h

#include <deal.II/base/tensor.h>

#include <cmath>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    namespace internal
    {
      /** The squared tangent of the angle at which both normals count alike. */
      constexpr double pair_frame_blend = 0.1;
    } // namespace internal



    /**
     * An orthonormal frame that turns with two touching fibers, by its rows:
     * along the intermediate geometry, across it, and normal to both fibers.
     *
     * The normal is that of the two tangents where the fibers cross. Parallel
     * fibers have none; there it is the connection of the axes, so that a fiber
     * that travels around its neighbour takes the frame along. Some twenty
     * degrees pass from one to the other: a sharper change turns the frame at
     * small angles by far more than the fibers turn, and friction with it.
     *
     * @p tangent_a, @p tangent_b and @p connection (from b to a) need not be
     * of length one; @p orientation is whether the fibers run the same way.
     */
    inline Tensor<2, 3>
    pair_frame(const Tensor<1, 3> &tangent_a,
               const Tensor<1, 3> &tangent_b,
               const int           orientation,
               const Tensor<1, 3> &connection)
    {
      // Of the tangents a and b only the first row needs to know the lengths:
      // in the other ones both terms have the same factors.
      const double aa = tangent_a * tangent_a, bb = tangent_b * tangent_b,
                   ab            = tangent_a * tangent_b;
      const Tensor<1, 3> crossed = cross_product_3d(tangent_a, tangent_b);

      Tensor<2, 3> frame;
      frame[0] = tangent_a + orientation * std::sqrt(aa / bb) * tangent_b;
      frame[0] /= frame[0].norm();
      frame[2] = (crossed * connection) * crossed +
                 internal::pair_frame_blend * ab * ab * connection;
      frame[2] -= (frame[2] * frame[0]) * frame[0];
      frame[2] /= frame[2].norm();
      frame[1] = cross_product_3d(frame[2], frame[0]);
      return frame;
    }
  } // namespace Contact
} // namespace Heddle

#endif
