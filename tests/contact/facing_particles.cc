// Particles that face each other lie in one plane normal to the intermediate
// geometry; the slope of their squared distance agrees with differences, at
// ends of fibers too; exchange of the fibers and rigid motion change nothing.
#include <heddle/contact/intermediate_geometry.h>

#include "../tests.h"
#include "knots.h"

using Heddle::Contact::Curve;
using Heddle::Contact::FacingParticles;
using Heddle::Contact::IntermediateGeometry;

constexpr unsigned int n_intervals = 12;

/** Two wavy fibers at an angle, close to each other in their middles. */
struct Pair
{
  Pair(const double angle, RandomNumbers &random)
    : a(wavy_line(Tensor<1, 3>({-20., 0., 0.}),
                  Tensor<1, 3>({1., 0., 0.}),
                  /*length=*/40.,
                  /*height=*/1.,
                  random),
        n_intervals)
    , b(wavy_line(Tensor<1, 3>({-20. * std::cos(angle),
                                -20. * std::sin(angle),
                                random.between(1.5, 3.)}),
                  Tensor<1, 3>({std::cos(angle), std::sin(angle), 0.}),
                  40.,
                  1.,
                  random),
        n_intervals)
    , orientation(std::cos(angle) >= 0. ? 1 : -1)
  {
  }

  IntermediateGeometry
  geometry() const
  {
    return {a.curve(1.), b.curve(1.), orientation};
  }

  Knots a, b;
  int   orientation;
};



/** Largest deviations from what is claimed, over pairs and places. */
struct Deviations
{
  double plane = 0., coarse_slope = 0., fine_slope = 0., end_slope = 0.,
         exchange = 0., motion = 0.;
};



void
move_rigidly(Knots &knots, const Tensor<2, 3> &turn, const Tensor<1, 3> &shift)
{
  for (auto &x : knots.positions)
    x = turn * x + shift;
  for (auto &t : knots.tangents)
    t = turn * t;
}



void
examine(Pair &pair, const double p, RandomNumbers &random, Deviations &result)
{
  const IntermediateGeometry geometry = pair.geometry();
  double                     q        = pair.orientation > 0 ? 0. : 40.;
  const FacingParticles      facing   = geometry.facing(p, q);
  unsigned int               hint     = 0;
  const bool                 at_end = facing.s_a < 1e-8 || facing.s_b < 1e-8 ||
                      facing.s_a > geometry.a.length() - 1e-8 ||
                      facing.s_b > geometry.b.length() - 1e-8;
  const Tensor<1, 3> tangents =
    geometry.a.evaluate(facing.s_a, hint).tangent +
    double(pair.orientation) * geometry.b.evaluate(facing.s_b, hint).tangent;
  if (!at_end)
    result.plane = std::max(result.plane,
                            std::abs(facing.connection * tangents) /
                              (facing.connection.norm() * tangents.norm()));

  const auto difference = [&](const double h) {
    double q_high = q, q_low = q;
    return std::abs((geometry.facing(p + h, q_high).squared_distance -
                     geometry.facing(p - h, q_low).squared_distance) /
                      (2. * h) -
                    facing.slope);
  };
  result.end_slope = std::max(result.end_slope, difference(1e-4));
  if (!at_end)
    {
      result.coarse_slope += difference(4e-2);
      result.fine_slope += difference(2e-2);
    }

  // With b first, p changes its sign if the fibers run opposite ways, and so
  // does q if they run the same way.
  const IntermediateGeometry exchanged(
    geometry.b, geometry.a, pair.orientation);
  double q_exchanged = pair.orientation > 0 ? -q : q;
  q_exchanged += 0.1;
  const FacingParticles other =
    exchanged.facing(pair.orientation * p, q_exchanged);
  result.exchange =
    std::max({result.exchange,
              std::abs(other.s_a - facing.s_b),
              std::abs(other.s_b - facing.s_a),
              (other.connection + facing.connection).norm(),
              std::abs(other.slope - pair.orientation * facing.slope)});

  const Tensor<2, 3> turn =
    rotation(random.direction(), random.between(0., 6.));
  Pair moved = pair;
  move_rigidly(moved.a, turn, Tensor<1, 3>({3., -4., 5.}));
  move_rigidly(moved.b, turn, Tensor<1, 3>({3., -4., 5.}));
  double                q_moved = q + 0.1;
  const FacingParticles same    = moved.geometry().facing(p, q_moved);
  result.motion                 = std::max({result.motion,
                                            std::abs(same.s_a - facing.s_a),
                                            (same.connection - turn * facing.connection).norm(),
                                            std::abs(same.slope - facing.slope)});
}



void
print(const std::string &place, const Deviations &result)
{
  deallog << place << ": out of plane "
          << (result.plane < 1e-10 ? "< 1e-10" : "NOT ZERO") << ", exchange "
          << (result.exchange < 1e-8 ? "< 1e-8" : "MATTERS")
          << ", rigid motion " << (result.motion < 1e-8 ? "< 1e-8" : "MATTERS");
}



int
main()
{
  initlog();
  deallog.precision(3);
  RandomNumbers random(1);
  for (const double degrees : {0., 10., 45., 89., 91., 150., 180.})
    {
      Deviations inside, at_end;
      for (unsigned int n = 0; n < 20; ++n)
        {
          Pair         pair(degrees * numbers::PI / 180., random);
          const double middle = pair.orientation > 0 ? 40. : 0.;
          for (unsigned int k = 0; k < 20; ++k)
            {
              examine(pair, middle + random.between(-8., 8.), random, inside);
              examine(pair, middle + random.between(36., 39.9), random, at_end);
            }
        }
      const std::string angle = "angle " + std::to_string(int(degrees));
      print(angle, inside);
      // The curvature jumps at knots: only the mean over many places is
      // of second order.
      const double order = std::log2(inside.coarse_slope / inside.fine_slope);
      deallog << ", slope of " << (order > 1.7 ? "second" : "LOWER")
              << " order, off by less than 1e-4: "
              << (inside.fine_slope / 400. < 1e-4 ? "yes" : "NO") << std::endl;
      print(angle + " at ends", at_end);
      deallog << ", slope "
              << (at_end.end_slope < 1e-3 ? "agrees" : "DISAGREES")
              << std::endl;
    }
}
