// In what friction is measured and remembered: the frame of two fibers, and
// their slip from step to step.
#include <heddle/contact/friction_memory.h>
#include <heddle/contact/pair_turning.h>

#include "../tests.h"
#include "knots.h"

#include <cmath>
#include <random>

using Heddle::Contact::pair_frame;
using namespace Heddle;

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



/**
 * The frame of two touching fibers is orthonormal, does not depend on which of
 * them is turned, and turns by little when they turn by little: at every angle
 * between them, and where the normal of both tangents changes its side. Its
 * turning is what differences give, with order two.
 */
void
frames()
{
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



/** Between fibers 0 and 1, at @p along the contact and slid by @p across. */
Contact::ContactElement
element(const double along, const double across, const int orientation)
{
  Contact::ContactElement result = {};
  result.fiber_a                 = 0;
  result.fiber_b                 = 1;
  result.orientation             = orientation;
  result.s_a                     = 10. + along + across;
  result.s_b                     = 20. + orientation * (along - across);
  result.weight                  = 0.2;
  return result;
}



/** What is remembered there, after a unit of @p slope per length. */
double
remembered(const Contact::FrictionMemory &memory,
           const double                   along,
           const double                   across,
           const int                      orientation)
{
  return memory.at(element(along, across, orientation), /*reach=*/0.5)
    .displacement[0];
}



void
check(const int orientation)
{
  std::vector<Contact::FrictionMemory::Record> records;
  for (unsigned int k = 0; k < 8; ++k)
    {
      const double along = 0.2 * k + (k % 2 ? 0.03 : 0.);
      const auto   place = element(along, 0., orientation);
      records.push_back({0,
                         1,
                         place.s_a,
                         place.s_b,
                         place.weight,
                         orientation,
                         Tensor<1, 3>({1. + along, 0., 0.}),
                         /*limit=*/0.1});
    }
  Contact::FrictionMemory memory;
  memory.set(records);

  double linear = 0., largest_jump = 0., largest_jump_of_touch = 0.;
  for (double along = 0.; along <= 1.4; along += 0.01)
    linear = std::max(
      linear,
      std::abs(remembered(memory, along, 0., orientation) - (1. + along)));
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> along_range(-1., 2.5),
    across_range(-0.6, 0.6);
  const double far = remembered(memory, 3., 0., orientation) +
                     remembered(memory, 0.7, 0.6, orientation);
  const double step  = 1e-7;
  const auto   touch = [&](const double along, const double reach) {
    return memory.touched(element(along, 0., orientation), reach);
  };
  for (unsigned int k = 0; k < 1000; ++k)
    {
      // Exactly at a record now and then: there jumps would be.
      const double along  = k % 2 ? along_range(random) : 0.4 * (k % 4),
                   across = k % 3 ? across_range(random) : 0.;
      const double here   = remembered(memory, along, across, orientation);
      for (const double a : {-step, step})
        for (const double b : {-0.9 * step, 1.1 * step})
          largest_jump = std::max(
            largest_jump,
            std::abs(remembered(memory, along + a, across + b, orientation) -
                     here));

      // It touched there, or as far as it moved: that must not jump either.
      const double reach = std::abs(across);
      largest_jump_of_touch =
        std::max({largest_jump_of_touch,
                  std::abs(touch(along + step, reach) - touch(along, reach)),
                  std::abs(touch(along, reach + step) - touch(along, reach))});
    }
  deallog << "orientation " << orientation << ": linear between records "
          << (linear < 1e-12) << ", nothing far away " << (far == 0.)
          << ", friction of the pair " << memory.limit(0, 1) << " and "
          << memory.limit(0, 2) << ", no jump " << (largest_jump < 1e2 * step)
          << std::endl;

  // Records end at 1.43, and both lengths are 0.2.
  deallog << "touched at the last one, within and beyond the reach: "
          << touch(1.43, 0.) << ' ' << touch(1.78, 0.) << ' '
          << touch(2.14, 0.4) << ' ' << touch(1.83, 0.) << ' '
          << touch(1.88, 0.) << ", no jump "
          << (largest_jump_of_touch < 1e2 * step) << std::endl;
}



/**
 * What is remembered of friction: the values of the records at their particles,
 * what is linear between them, nothing far from them, and no jump anywhere, for
 * fibers that run the same way and the opposite one.
 */
void
memory_of_slip()
{
  check(1);
  check(-1);
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Frame of two fibers", frames);
  run_part("Memory", memory_of_slip);
}
