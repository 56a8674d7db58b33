#ifndef heddle_tests_contact_random_fibers_h
#define heddle_tests_contact_random_fibers_h

#include <heddle/contact/contact_cells.h>

#include "knots.h"

/**
 * @p n_fibers around a few directions: many run along each other, others cross.
 * Their waves have about the height @p height.
 */
inline std::vector<Knots>
random_fibers(const unsigned int               n_fibers,
              const std::vector<Tensor<1, 3>> &directions,
              const double                     height,
              RandomNumbers                   &random)
{
  std::vector<Knots> knots;
  for (unsigned int f = 0; f < n_fibers; ++f)
    {
      const Tensor<1, 3> along = directions[f % directions.size()];
      const Tensor<1, 3> middle({random.between(-7., 7.),
                                 random.between(-7., 7.),
                                 random.between(-7., 7.)});
      const double       length = random.between(10., 30.);
      knots.emplace_back(
        wavy_line(middle - 0.5 * length * along, along, length, height, random),
        /*n_intervals=*/9);
    }
  return knots;
}



/** Their curves, of radius 1, all of them stale. */
inline Heddle::Contact::CurveList
curves_of(const std::vector<Knots> &knots)
{
  Heddle::Contact::CurveList curves;
  curves.reset(knots.size());
  for (unsigned int f = 0; f < knots.size(); ++f)
    curves.add({f, /*own=*/true, knots[f].curve(/*radius=*/1.), true});
  return curves;
}

#endif
