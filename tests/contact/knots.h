#ifndef heddle_tests_contact_knots_h
#define heddle_tests_contact_knots_h

#include <heddle/contact/curve.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

using dealii::Tensor;

/** A place in space as a function of a parameter from 0 to 1. */
using Path = std::function<Tensor<1, 3>(double)>;

/** Numbers that are the same on all machines. */
class RandomNumbers
{
public:
  RandomNumbers(const unsigned int seed)
    : generator(seed)
  {
  }

  double
  between(const double low, const double high)
  {
    return low + (high - low) * (generator() / 4294967296.);
  }

  Tensor<1, 3>
  direction()
  {
    Tensor<1, 3> d;
    do
      for (unsigned int k = 0; k < 3; ++k)
        d[k] = between(-1., 1.);
    while (d.norm() > 1. || d.norm() < 0.1);
    return d / d.norm();
  }

private:
  std::mt19937 generator;
};



/** A straight line from @p begin along the unit vector @p direction. */
inline Path
line(const Tensor<1, 3> &begin,
     const Tensor<1, 3> &direction,
     const double        length)
{
  return [=](const double t) { return begin + t * length * direction; };
}



/** A line with waves of random amplitudes up to @p height. */
inline Path
wavy_line(const Tensor<1, 3> &begin,
          const Tensor<1, 3> &direction,
          const double        length,
          const double        height,
          RandomNumbers      &random)
{
  std::vector<Tensor<1, 3>> waves;
  for (unsigned int k = 0; k < 3; ++k)
    waves.push_back(random.between(0., height) / (1. + k) * random.direction());
  const double shift = random.between(0., 6.);
  return [=](const double t) {
    Tensor<1, 3> x = begin + t * length * direction;
    for (unsigned int k = 0; k < waves.size(); ++k)
      x += std::sin(shift + (k + 1.) * 6.283185307 * t) * waves[k];
    return x;
  };
}



/** Knots of a fiber on a path: where they are, and which way it goes. */
struct Knots
{
  Knots(const Path &path, const unsigned int n_intervals)
  {
    const auto slope = [&path](const double t) {
      return (path(t + 1e-5) - path(t - 1e-5)) / 2e-5;
    };
    arc_lengths.push_back(0.);
    for (unsigned int i = 0; i <= n_intervals; ++i)
      {
        const double t = double(i) / n_intervals;
        positions.push_back(path(t));
        tangents.push_back(slope(t) / slope(t).norm());
        if (i > 0)
          {
            double length = 0.;
            for (unsigned int q = 0; q < 20; ++q)
              length += slope(t - (q + 0.5) / 20. / n_intervals).norm();
            arc_lengths.push_back(arc_lengths.back() +
                                  length / 20. / n_intervals);
          }
      }
  }

  /** Good until the next one of these knots. */
  Heddle::Contact::Curve
  curve(const double radius) const
  {
    const unsigned int n = positions.size();
    cubics.resize(n);
    Heddle::Contact::set_cubics(
      n, arc_lengths.data(), positions.data(), tangents.data(), cubics.data());
    return {n,
            {0, n},
            arc_lengths.data(),
            positions.data(),
            tangents.data(),
            cubics.data(),
            radius};
  }

  std::vector<double>       arc_lengths;
  std::vector<Tensor<1, 3>> positions, tangents;

private:
  mutable std::vector<Heddle::Contact::CurveCubic> cubics;
};



/** The rotation by @p angle about the unit vector @p axis. */
inline Tensor<2, 3>
rotation(const Tensor<1, 3> &axis, const double angle)
{
  Tensor<2, 3> result;
  const double c = std::cos(angle), s = std::sin(angle);
  for (unsigned int i = 0; i < 3; ++i)
    {
      result[i][i] += c;
      for (unsigned int j = 0; j < 3; ++j)
        result[i][j] += (1. - c) * axis[i] * axis[j];
      result[i][(i + 1) % 3] -= s * axis[(i + 2) % 3];
      result[i][(i + 2) % 3] += s * axis[(i + 1) % 3];
    }
  return result;
}

#endif
