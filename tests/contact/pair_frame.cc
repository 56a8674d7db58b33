// The frame of two touching fibers is orthonormal, does not depend on which of
// them is turned, and turns by little when they turn by little: at every angle
// between them, and where the normal of both tangents changes its side.
#include <heddle/contact/pair_frame.h>

#include "../tests.h"

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
}
