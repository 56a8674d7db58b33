#ifndef heddle_contact_pair_turning_h
#define heddle_contact_pair_turning_h

#include <heddle/contact/pair_frame.h>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    /**
     * How pair_frame() turns when two fibers move. The rotation about row k of
     * the frame is
     * @f[ \delta\omega_k = T^a_k \cdot \delta t_a + T^b_k \cdot \delta t_b
     *     + C_k \cdot \delta c @f]
     * for the tangents t and the connection c that the frame was made of.
     */
    struct PairTurning
    {
      Tensor<1, 3> by_tangent[2][3]; /**< [-] */
      Tensor<1, 3> by_connection[3]; /**< [1/mm] */
    };



    inline PairTurning
    pair_turning(const Tensor<1, 3> &tangent_a,
                 const Tensor<1, 3> &tangent_b,
                 const int           orientation,
                 const Tensor<1, 3> &connection)
    {
      const double       blend   = internal::pair_frame_blend;
      const Tensor<1, 3> a       = tangent_a / tangent_a.norm();
      const Tensor<1, 3> b       = orientation * tangent_b / tangent_b.norm();
      const Tensor<1, 3> n       = connection / connection.norm();
      const Tensor<1, 3> crossed = cross_product_3d(a, b);
      const double       cosine  = a * b;
      const Tensor<2, 3> frame =
        pair_frame(tangent_a, tangent_b, orientation, connection);
      const Tensor<1, 3> along = frame[0], across = frame[1], up = frame[2];
      const double       sum = (a + b).norm();

      // The third row is the part of m normal to the first one, normalised.
      const Tensor<1, 3> m =
        (crossed * n) * crossed + blend * cosine * cosine * n;
      const double height = up * m;

      // The derivatives by the unit vectors: along' . up, across' . along and
      // up' . across are the rotations.
      Tensor<1, 3> by_a[3], by_b[3];
      by_a[1] = by_b[1] = -1. / sum * up;
      by_a[2] = by_b[2] = 1. / sum * across;
      by_a[0] =
        -1. / height *
        ((crossed * across) * cross_product_3d(b, n) +
         (crossed * n) * cross_product_3d(b, across) +
         2. * blend * cosine * (n * across) * b - ((m * along) / sum) * across);
      by_b[0] =
        -1. / height *
        ((crossed * across) * cross_product_3d(n, a) +
         (crossed * n) * cross_product_3d(across, a) +
         2. * blend * cosine * (n * across) * a - ((m * along) / sum) * across);

      const auto normal_part = [](const Tensor<1, 3> &v,
                                  const Tensor<1, 3> &unit) {
        return v - (v * unit) * unit;
      };
      PairTurning result;
      for (unsigned int k = 0; k < 3; ++k)
        {
          result.by_tangent[0][k] = normal_part(by_a[k], a) / tangent_a.norm();
          result.by_tangent[1][k] =
            orientation * normal_part(by_b[k], b) / tangent_b.norm();
        }
      result.by_connection[0] =
        -1. / (height * connection.norm()) *
        normal_part(
          (crossed * across) * crossed + blend * cosine * cosine * across, n);
      return result;
    }
  } // namespace Contact
} // namespace Heddle

#endif
