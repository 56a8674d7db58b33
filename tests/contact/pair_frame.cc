// The frame of two touching fibers is orthonormal, does not depend on which of
// them is turned, and turns by little when they turn by little: at every angle
// between them, and where the normal of both tangents changes its side. Its
// turning is what differences give, with order two.
#include <heddle/contact/pair_turning.h>

#include "../tests.h"
#include "knots.h"

#include <cmath>

using Heddle::Contact::pair_frame;

/** Unit vector at @p angle to x in the plane, rising by @p slope. */
Tensor<1, 3>
tangent(const double angle, const double slope)
{
  return Tensor<1, 3>({std::cos(slope) * std::cos(angle),
                       std::cos(slope) * std::sin(angle),
                       std::sin(slope)});
}



/** pair_turning() against differences of the frame, for random motions. */
void
turning(const int orientation)
{
  RandomNumbers random(7);
  double        errors[2] = {0., 0.};
  for (unsigned int trial = 0; trial < 50; ++trial)
    {
      Tensor<1, 3> start[3], motion[3];
      for (unsigned int i = 0; i < 3; ++i)
        {
          start[i]  = random.between(0.5, 2.) * random.direction();
          motion[i] = random.direction();
        }
      // The fibers run alike as far as the orientation says.
      if (orientation * (start[0] * start[1]) < 0.)
        start[1] *= -1.;
      const auto frame_at = [&](const double h) {
        return pair_frame(start[0] + h * motion[0],
                          start[1] + h * motion[1],
                          orientation,
                          start[2] + h * motion[2]);
      };
      const auto exact = Heddle::Contact::pair_turning(
        start[0], start[1], orientation, start[2]);
      Tensor<1, 3> rotation;
      for (unsigned int k = 0; k < 3; ++k)
        rotation[k] = exact.by_tangent[0][k] * motion[0] +
                      exact.by_tangent[1][k] * motion[1] +
                      exact.by_connection[k] * motion[2];
      const Tensor<2, 3> now = frame_at(0.);
      for (unsigned int i = 0; i < 2; ++i)
        {
          const double       h = i == 0 ? 1e-4 : 5e-5;
          const Tensor<2, 3> change =
            (frame_at(h) - frame_at(-h)) * transpose(now) / (2. * h);
          const Tensor<1, 3> turned(
            {-change[2][1], -change[0][2], change[0][1]});
          errors[i] =
            std::max(errors[i], (turned - rotation).norm() / rotation.norm());
        }
    }
  const long order = std::lround(std::log2(errors[0] / errors[1]));
  deallog << "orientation " << orientation
          << ": turning against differences, order " << order
          << (order == 2 && errors[1] < 1e-3 ? "" : " FAIL") << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  // From below the horizontal to above it, past another fiber at some angle.
  const double       step = 1e-4;
  const Tensor<1, 3> up({0., 0., 2.});
  for (const double slope : {0., 0.02, 0.1})
    {
      double turned = 0., skew = 0.;
      for (int i = -15000; i < 15000; ++i)
        {
          Tensor<2, 3> frame[2];
          for (unsigned int k = 0; k < 2; ++k)
            frame[k] = pair_frame(
              tangent(0., slope), tangent((i + 0.5 + k) * step, -slope), 1, up);
          turned = std::max(turned, (frame[1] - frame[0]).norm() / step);
          skew   = std::max(
            skew,
            (frame[0] * transpose(frame[0]) - unit_symmetric_tensor<3>())
              .norm());
        }
      deallog << "slopes " << slope << ": orthonormal " << (skew < 1e-12)
              << ", turns by less than 4 times what the fibers turn "
              << (turned < 4.) << (turned < 4. ? "" : " FAIL") << std::endl;
    }
  turning(1);
  turning(-1);
}
