// The orientation of a zone: that of its fibers where they are closest or, near
// a right angle, the one that was known, also where a thin fiber lies around a
// thick one and is as close to it in places that are at angles to either side.
#include <heddle/contact/proximity_zone.h>

#include "../tests.h"
#include "knots.h"

#include <vector>

/** The zone of a thick fiber along y and one on @p path, by what was @p known.
 */
Heddle::Contact::ProximityZone
zone_of(const Path &path, const int known)
{
  const Knots along(
    [](const double t) {
      return Tensor<1, 3>({0., 20. * t - 10., 0.});
    },
    5);
  const Knots across(path, 8);
  const auto  a = along.curve(1.), b = across.curve(0.2);
  const auto  candidates =
    Heddle::Contact::find_candidates({{0, true, a}, {1, true, b}}, 1.);
  std::vector<Heddle::Contact::CandidatePair> pairs;
  for (const auto &pair : candidates)
    if (pair.fiber_a != pair.fiber_b)
      pairs.push_back(pair);
  const auto zones = Heddle::Contact::find_zones(
    pairs.data(), pairs.data() + pairs.size(), a, b, [known](double, double) {
      return known;
    });
  AssertThrow(zones.size() == 1, ExcInternalError());
  return zones[0];
}



void
find(const std::string &name, const Path &path)
{
  deallog << name << ":";
  for (const int known : {-1, 0, 1})
    deallog << " known " << known << " found "
            << zone_of(path, known).orientation;
  deallog << std::endl;
}



/** Straight, at this cosine to the thick one. */
Path
straight(const double cosine)
{
  return [cosine](const double t) {
    return Tensor<1, 3>({(4. * t - 2.) * std::sqrt(1. - cosine * cosine),
                         (4. * t - 2.) * cosine,
                         1.2});
  };
}



/** Around it, first downwards and then upwards, and closer by a part of @p tilt
 * at one end. */
Path
around(const double tilt)
{
  return [tilt](const double t) {
    const double phi    = 2. * t - 1.;
    const double radius = 1.2 * (1. + tilt * phi);
    return Tensor<1, 3>(
      {radius * std::sin(phi), 0.4 * phi * phi, radius * std::cos(phi)});
  };
}



int
main()
{
  initlog();
  for (const double cosine : {0.5, 0.2, 0.05, -0.05, -0.2, -0.5})
    find("straight, cosine " + std::to_string(cosine).substr(0, 5),
         straight(cosine));
  for (const double tilt : {-3e-3, 3e-3})
    find(std::string("around, closer at the ") +
           (tilt > 0. ? "first" : "last") + " end",
         around(tilt));

  // The penalty of the zone goes with it.
  const double jump = std::abs(zone_of(around(1e-5), 1).cosine -
                               zone_of(around(-1e-5), 1).cosine);
  deallog << "where the other end gets closer the cosine jumps by "
          << (jump < 0.01 ? "less than 0.01" : std::to_string(jump))
          << std::endl;
}
