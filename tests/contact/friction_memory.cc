// What a contact remembers of friction depends continuously on the particles
// that ask: along the contact, past its ends, and close to a right angle, where
// the element may run across the line on which the records lie.
#include <heddle/contact/friction_memory.h>

#include "../tests.h"

#include <cmath>

using namespace Heddle;

/** Eight records of the fibers 0 and 1 at the places of two cells. */
Contact::FrictionMemory
memory(const int orientation)
{
  std::vector<Contact::FrictionMemory::Record> records;
  const double place[4] = {-0.861, -0.340, 0.340, 0.861};
  for (const double middle : {-1., 1.})
    for (const double x : place)
      {
        // Fibers at a right angle, with their arc lengths over the length of
        // the intermediate curve between them.
        const double s      = (middle + x) * std::sqrt(2.);
        const double weight = std::abs(x) < 0.5 ? 0.652 : 0.348;
        records.push_back({0,
                           1,
                           s,
                           orientation * s,
                           weight,
                           orientation,
                           Tensor<1, 3>({std::cos(s), std::sin(s), 0.}),
                           1.});
      }
  Contact::FrictionMemory result;
  result.set(records);
  return result;
}



/**
 * Largest change of the displacement between two elements, over the largest
 * distance of their particles: on a line of elements of @p orientation, by the
 * distance @p aside from that of the records.
 */
double
steepness(const Contact::FrictionMemory &memory,
          const int                      orientation,
          const double                   aside)
{
  const double step    = 1e-4;
  double       largest = 0.;
  Tensor<1, 3> before;
  for (int i = -40000; i <= 40000; ++i)
    {
      const double            s       = (i + 0.5) * step;
      Contact::ContactElement element = {};
      element.fiber_b                 = 1;
      element.orientation             = orientation;
      element.s_a                     = s;
      element.s_b                     = orientation * s + aside;
      const Tensor<1, 3> now = memory.at(element, /*reach=*/9.).displacement;
      if (i > -40000)
        largest = std::max(largest, (now - before).norm() / step);
      before = now;
    }
  return largest;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  for (const int of_records : {1, -1})
    for (const int of_element : {1, -1})
      for (const double aside : {0., 1e-5, 0.1, -0.3})
        {
          const double largest =
            steepness(memory(of_records), of_element, aside);
          deallog << "records " << of_records << ", element " << of_element
                  << ", aside " << aside << ": continuous " << (largest < 2.)
                  << (largest < 2. ? "" : " FAIL") << std::endl;
        }
}
