// What a data sheet says of a fabric, thickness, areal weight, volume fraction
// and how fibers run, has the values of closed forms, whatever sticks out of
// it, however it lies, and if a fiber was lost.
#include <heddle/post/fabric_sheet.h>
#include <heddle/simulation/fabric_report.h>
#include <heddle/simulation/fiber_placement.h>
#include <heddle/textile/parametric_curve.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include "../tests.h"

#include <cmath>
#include <sstream>

using namespace Heddle;

/** Waves of a plain weave of single fibers, 1 mm apart. */
constexpr double amplitude = 0.2, radius = 0.1, density = 2.5, stretch = 1e-3;

/** Of fibers that stick out, at both ends of a yarn [mm]. */
constexpr double tail_before = 0.6, tail_behind = 0.75;

/** A place in the plane of the fabric: warp and weft need not be at right
 * angles. */
struct Plane
{
  double turned  = 0.; /**< warp from the x-axis [degrees] */
  double between = 90.;

  Tensor<1, 3>
  point(const double along_warp, const double along_weft, const double z) const
  {
    const double a = turned * numbers::PI / 180.;
    const double b = a + between * numbers::PI / 180.;
    return Tensor<1, 3>({along_warp * std::cos(a) + along_weft * std::cos(b),
                         along_warp * std::sin(a) + along_weft * std::sin(b),
                         z});
  }
};



/** One fiber of yarn number @p i of @p n, which cross @p n_crossed others; of
 * those that stick out the fabric bends away. */
Textile::FiberPath
wave(const bool         is_warp,
     const unsigned int i,
     const unsigned int n,
     const unsigned int n_crossed,
     const unsigned int n_elements,
     const Plane       &plane)
{
  const double last = 0.5 * (n_crossed - 1);
  const double sign = i % 2 == 0 ? 1. : -1.;
  const auto   axis = [&](const double t) {
    const double beyond = std::max(0., std::abs(t) - last);
    const double z = sign * amplitude * std::cos(numbers::PI * (t + last)) +
                     2. * beyond * beyond * beyond;
    const double across = i - 0.5 * (n - 1) + 0.5 * beyond * beyond * beyond;
    return is_warp ? plane.point(t, across, z) : plane.point(across, t, -z);
  };
  const Textile::Knots knots = Textile::equally_spaced(axis,
                                                       -last - tail_before,
                                                       last + tail_behind,
                                                       n_elements + 1,
                                                       64 * n_elements);
  Textile::FiberPath   path;
  path.points           = knots.points;
  path.reference_length = knots.length / (1. + stretch);
  path.radius           = radius;
  path.set              = is_warp ? "warp" : "weft";
  path.yarn_id          = is_warp ? i : 4 + i;
  return path;
}



/** Four warp yarns and three weft yarns. */
std::vector<Textile::FiberPath>
weave(const unsigned int n_elements, const Plane &plane = {})
{
  std::vector<Textile::FiberPath> paths;
  for (unsigned int i = 0; i < 4; ++i)
    paths.push_back(wave(true, i, 4, 3, n_elements, plane));
  for (unsigned int i = 0; i < 3; ++i)
    paths.push_back(wave(false, i, 3, 4, n_elements, plane));
  return paths;
}



/** Fibers where their paths are, and the report on them. */
struct Placed
{
  explicit Placed(const std::vector<Textile::FiberPath> &paths)
    : space(Simulation::make_space(paths, parameters(), MPI_COMM_WORLD))
    , state(*space)
  {
    const auto blocks = Simulation::place_on_paths(*space, paths);
    std::copy(
      blocks.begin(), blocks.end(), state.fiber(space->owned_fibers().first));
    report = std::make_unique<Simulation::FabricReport>(state);
  }

  static const Simulation::FiberParameters &
  parameters()
  {
    static const Simulation::FiberParameters fiber;
    return fiber;
  }

  std::map<std::string, double>
  results() const
  {
    return report->results(
      /*n_stations=*/5, std::vector<double>(space->n_fibers(), density));
  }

  std::unique_ptr<System::FiberSpace>       space;
  System::State                             state;
  std::unique_ptr<Simulation::FabricReport> report;
};



/** Of z = A cos(pi x): length over that of x, and the part that runs along x of
 * the orientation tensor. */
struct ClosedForm
{
  const double slope   = numbers::PI * amplitude;
  const double square  = 1. + slope * slope;
  const double modulus = slope / std::sqrt(square);
  const double length =
    2. / numbers::PI * std::sqrt(square) * std::comp_ellint_2(modulus);
  const double along =
    std::comp_ellint_1(modulus) / (square * std::comp_ellint_2(modulus));
  const double volume    = 2. * numbers::PI * radius * radius * length;
  const double weight    = 1000. * density * volume / (1. + stretch);
  const double thickness = 2. * (amplitude + radius);

  /** Part of the length that is less than @p angle [degrees] out of the plane.
   */
  double
  below(const double angle) const
  {
    const double sine = std::tan(angle * numbers::PI / 180.) / slope;
    return sine >= 1. ? 1.
                      : 1. - std::ellint_2(modulus, std::acos(sine)) /
                               std::comp_ellint_2(modulus);
  }
};



/**
 * The error falls with the square of the length of elements, or faster; that of
 * the thickness depends on where the crests lie between points as well. Fibers
 * that stick out, bent away from the fabric, do not count.
 */
void
waves()
{
  const ClosedForm                    exact;
  const std::map<std::string, double> wanted = {
    {"thickness[mm]", exact.thickness},
    {"areal_weight[g/m^2]", exact.weight},
    {"fiber_volume_fraction[-]", exact.volume / exact.thickness},
    {"warp_spacing[mm]", 1.},
    {"warp_inner_crimp[-]", exact.length - 1.},
    {"warp_orientation_xx[-]", exact.along},
    {"warp_orientation_zz[-]", 1. - exact.along},
    {"weft_orientation_yy[-]", exact.along},
    {"orientation_xx[-]", 0.5 * exact.along},
    {"orientation_yy[-]", 0.5 * exact.along},
    {"orientation_zz[-]", 1. - exact.along}};
  std::map<std::string, double> before;
  for (const unsigned int n_elements : {16, 32, 64, 128})
    {
      auto found = Placed(weave(n_elements)).results();
      deallog << n_elements << " elements:" << std::endl;
      for (const auto &one : wanted)
        {
          const double error = std::abs(found[one.first] / one.second - 1.);
          deallog << "  " << one.first << ": ";
          if (error < 1e-6)
            deallog << "exact";
          else
            deallog << "error " << error;
          if (error >= 1e-6 && before.count(one.first) > 0)
            deallog << ", order " << std::log2(before[one.first] / error);
          deallog << std::endl;
          before[one.first] = error;
        }
    }
  auto found = Placed(weave(128)).results();
  deallog << "g/m^2: " << found["areal_weight[g/m^2]"]
          << ", without a density: "
          << Placed(weave(16))
               .report->results(5, std::vector<double>(7, 0.))
               .count("areal_weight[g/m^2]")
          << std::endl;
}



/** The part of a column of the table of orientations in rows of one angle, up
 * to @p to degrees. */
double
part(const std::string &table,
     const std::string &angle,
     const unsigned int column,
     const double       from,
     const double       to)
{
  std::istringstream lines(table);
  std::string        line;
  double             sum = 0.;
  while (std::getline(lines, line))
    {
      std::istringstream       words(line);
      std::vector<std::string> values;
      for (std::string word; std::getline(words, word, ',');)
        values.push_back(word);
      if (values[0] == angle && std::stod(values[1]) >= from &&
          std::stod(values[2]) <= to)
        sum += std::stod(values[column]);
    }
  return sum;
}



/** The largest error of the part of fibers below an angle falls with the length
 * of the pieces. */
void
histogram()
{
  const ClosedForm exact;
  deallog << Placed(weave(16)).report->orientation_csv().substr(0, 50)
          << std::endl;
  for (const unsigned int n_elements : {16, 64, 256})
    {
      const std::string table =
        Placed(weave(n_elements)).report->orientation_csv();
      double error = 0.;
      for (unsigned int angle = 1; angle <= 90; ++angle)
        for (unsigned int column = 3; column < 6; ++column)
          error =
            std::max(error,
                     std::abs(part(table, "out of plane", column, 0., angle) -
                              exact.below(angle)));
      deallog << n_elements << " elements: error " << error
              << ", in the plane along x "
              << part(table, "in plane", 3, -0.5, 0.5) << " of the warp, "
              << part(table, "in plane", 5, -0.5, 0.5) << " of all, along y "
              << part(table, "in plane", 4, 89.5, 90.5) << " of the weft"
              << std::endl;
    }
}



/** A fabric that is turned by 25 degrees and sheared by 20. */
void
sheared()
{
  const ClosedForm exact;
  Plane            plane;
  plane.turned  = 25.;
  plane.between = 70.;
  const Placed fabric(weave(128, plane));
  auto         found = fabric.results();
  const double sine  = std::sin(70. * numbers::PI / 180.);
  deallog << "over the closed form: thickness "
          << found["thickness[mm]"] / exact.thickness << ", areal weight "
          << found["areal_weight[g/m^2]"] / (exact.weight / sine)
          << ", volume fraction "
          << found["fiber_volume_fraction[-]"] /
               (exact.volume / exact.thickness / sine)
          << ", spacings " << found["warp_spacing[mm]"] / sine << " and "
          << found["weft_spacing[mm]"] / sine << std::endl;
  const double a = 25. * numbers::PI / 180.;
  deallog << "orientation xy of the warp "
          << found["warp_orientation_xy[-]"] /
               (exact.along * std::sin(a) * std::cos(a))
          << std::endl;
  const std::string table = fabric.report->orientation_csv();
  deallog << "in the plane at 25 degrees "
          << part(table, "in plane", 3, 23.5, 26.5)
          << " of the warp, at 95 degrees "
          << part(table, "in plane", 4, 93.5, 96.5) << " of the weft"
          << std::endl;
}



/** Three fibers beside each other in a yarn, one of which was lost half way,
 * or is in the place of another one. */
void
lost_and_doubled()
{
  auto paths = weave(64);
  for (const double shift : {-0.25, 0.25})
    {
      paths.push_back(paths[1]);
      for (Tensor<1, 3> &point : paths.back().points)
        point[1] += shift;
    }
  const Placed fabric(paths);
  auto        &lost = paths.back();
  lost.points.resize(33);
  lost.reference_length *= 0.5;
  const Placed short_of_one(paths);
  for (const std::string name : {"warp_crimp[-]", "warp_inner_crimp[-]"})
    deallog << name << " without half of a fiber, over the one with it: "
            << short_of_one.results()[name] / fabric.results()[name]
            << std::endl;

  deallog << "overfull: '" << fabric.report->overfull(5) << "'" << std::endl;
  // Where a fiber lies in another one there are two of them.
  lost = paths[0];
  deallog << Placed(paths).report->overfull(5) << std::endl;
  // Ten times as thick, there is no room for them.
  for (auto &path : paths)
    path.radius *= 10.;
  deallog << Placed(paths).report->overfull(5) << std::endl;
}



/** A fabric is the same wherever it lies, though its yarns have ends that do
 * not go along them. */
void
moved()
{
  auto paths = weave(64);
  for (auto &path : paths)
    path.points.front() += Tensor<1, 3>({0.1, 0.2, 0.});
  const auto here = Placed(paths).results();
  for (auto &path : paths)
    for (Tensor<1, 3> &point : path.points)
      point += Tensor<1, 3>({100., -200., 0.});
  auto   there     = Placed(paths).results();
  double different = 0.;
  for (const auto &entry : here)
    different =
      std::max(different, std::abs(there[entry.first] - entry.second));
  deallog << here.size() << " and " << there.size()
          << " entries, the same to 1e-9: " << (different < 1e-9) << std::endl;
}



/** Yarns that make no fabric: all that there is counts. */
void
no_fabric()
{
  std::vector<Textile::FiberPath> paths = {wave(true, 0, 2, 3, 64, {}),
                                           wave(true, 1, 2, 3, 64, {})};
  for (const auto &one : Placed(paths).results())
    deallog << one.first << ' ';
  deallog << std::endl;
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Waves", waves);
  run_part("Histogram", histogram);
  run_part("Turned and sheared", sheared);
  run_part("Lost and doubled", lost_and_doubled);
  run_part("Moved", moved);
  run_part("No fabric", no_fabric);
}
