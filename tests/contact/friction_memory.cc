// What is remembered of friction: the values of the records at their particles,
// what is linear between them, nothing far from them, and no jump anywhere, for
// fibers that run the same way and the opposite one.
#include <heddle/contact/friction_memory.h>

#include "../tests.h"

#include <random>

using namespace Heddle;

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



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  check(1);
  check(-1);
}
