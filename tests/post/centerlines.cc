// What is told of the centerlines of fibers is the same on any number of ranks:
// their points, their sharpest bend, that at a contact, how they cross, and
// their table, which the first rank reads for all.
#include <heddle/base/choice.h>
#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/contributions/fiber_contact.h>
#include <heddle/post/bend.h>
#include <heddle/post/centerline.h>
#include <heddle/post/crossing_order.h>
#include <heddle/simulation/fiber_placement.h>
#include <heddle/textile/csv_table.h>
#include <heddle/textile/path_reader.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include "../tests.h"

#include <algorithm>
#include <sstream>

using namespace Heddle;

/** Fibers where their paths are. */
struct PlacedFibers
{
  PlacedFibers(const std::vector<Textile::FiberPath> &paths,
               const Simulation::FiberParameters     &parameters)
    : space(Simulation::make_space(paths, parameters, MPI_COMM_WORLD))
    , state(*space)
  {
    const auto blocks = Simulation::place_on_paths(*space, paths);
    std::copy(
      blocks.begin(), blocks.end(), state.fiber(space->owned_fibers().first));
  }

  std::unique_ptr<System::FiberSpace> space;
  System::State                       state;
};



/** A quarter of a circle of radius @p radius about the z-axis. */
Textile::FiberPath
quarter(const double radius, const unsigned int n_elements)
{
  Textile::FiberPath path;
  for (unsigned int i = 0; i <= n_elements; ++i)
    {
      const double angle = 0.5 * numbers::PI * i / n_elements;
      path.points.push_back(
        Tensor<1, 3>({radius * std::cos(angle), radius * std::sin(angle), 0.}));
    }
  path.reference_length = 0.5 * numbers::PI * radius;
  path.radius           = 0.1;
  return path;
}



void
print_points(const std::string &element)
{
  Simulation::FiberParameters parameters("/Fiber " + element);
  parameters.element_kind       = choice<Beam::ElementKind>(element);
  parameters.elements_per_fiber = 16;
  const std::vector<Textile::FiberPath> paths = {
    quarter(1., 16), quarter(2., 16), quarter(3., 16)};
  const PlacedFibers fibers(paths, parameters);

  for (const Polyline &line : Post::gather_centerlines(fibers.state, 5))
    {
      double off = 0., uneven = 0.;
      for (unsigned int i = 1; i < line.size(); ++i)
        {
          const double radius = line[0].norm();
          const double chord  = 0.5 * numbers::PI * radius / (line.size() - 1);
          off    = std::max(off, std::abs(line[i].norm() / radius - 1.));
          uneven = std::max(
            uneven, std::abs((line[i] - line[i - 1]).norm() / chord - 1.));
        }
      deallog << element << ": " << line.size() << " points, from "
              << line.front().norm() << ", off the circle by "
              << (off < 1e-3 ? "less than 1e-3" : "more") << ", uneven by "
              << (uneven < 2e-2 ? "less than 2e-2" : "more") << std::endl;
    }
}



/**
 * Sampled between its nodes, the centerline of a fiber that lies on a circle
 * stays on the circle and its points equally far from each other, for both
 * elements, and rank 0 gets those of all ranks in their order.
 */
void
points()
{
  print_points("hermite");
  print_points("director");
}



/** One wave of a cosine, with @p radius in the vertex. */
Textile::FiberPath
wave(const double       radius,
     const unsigned int n_elements,
     const double       radius_of_fiber)
{
  Textile::FiberPath path;
  for (unsigned int i = 0; i <= n_elements; ++i)
    {
      const double x = (2. * i / n_elements - 1.) * radius;
      path.points.push_back(
        Tensor<1, 3>({x, -radius * std::cos(x / radius), radius}));
    }
  path.reference_length = 2. * radius;
  path.radius           = radius_of_fiber;
  return path;
}



Post::Bend
sharpest(const std::string &element,
         const unsigned int n_elements,
         const double       radius_of_fiber)
{
  Simulation::FiberParameters parameters("/Fiber " + element);
  parameters.element_kind       = choice<Beam::ElementKind>(element);
  parameters.elements_per_fiber = n_elements;
  const std::vector<Textile::FiberPath> paths = {
    wave(1., n_elements, radius_of_fiber),
    wave(2., n_elements, radius_of_fiber),
    wave(0.5, n_elements, radius_of_fiber)};
  const PlacedFibers fibers(paths, parameters);
  return Post::sharpest_bend(fibers.state);
}



void
print_bends(const std::string &element)
{
  std::vector<double> errors;
  for (const unsigned int n_elements : {8, 16, 32, 64})
    {
      const Post::Bend bend = sharpest(element, n_elements, 0.1);
      errors.push_back(std::abs(bend.ratio / 0.2 - 1.));
      deallog << element << ", " << n_elements << " elements: fiber "
              << bend.fiber << ", error " << errors.back();
      if (errors.size() > 1)
        deallog << ", order "
                << std::log2(errors[errors.size() - 2] / errors.back());
      deallog << ", a kink: " << bend.is_a_kink() << std::endl;
    }
  const Post::Bend bend = sharpest(element, 64, 0.55);
  deallog << "Thicker: " << bend.in_words() << ", a kink: " << bend.is_a_kink()
          << std::endl;
}



/**
 * The sharpest bend of three fibers on waves, in whose vertices are radii of 1,
 * 2 and 0.5 mm: radius of the fiber over 0.5 mm, found in the vertex of the
 * last one, with the order that the slopes in the nodes have. Bent to its own
 * radius a fiber has a kink.
 */
void
bends()
{
  print_bends("hermite");
  print_bends("director");
}



/** Half a circle about the origin, opened downwards, in a plane with x. */
Textile::FiberPath
half_circle(const double       radius,
            const unsigned int across,
            const double       side,
            const double       top)
{
  constexpr unsigned int n_elements = 32;
  Textile::FiberPath     path;
  for (unsigned int i = 0; i <= n_elements; ++i)
    {
      const double angle = numbers::PI * i / n_elements;
      Tensor<1, 3> point;
      point[0]      = top + side * radius * (std::sin(angle) - 1.);
      point[across] = radius * std::cos(angle);
      path.points.push_back(point);
    }
  path.reference_length = numbers::PI * radius;
  path.radius           = 0.1;
  return path;
}



/**
 * Two halves of circles that hang in each other at a right angle, their tops
 * 0.199 apart: what their bends take of the derivative that makes particles
 * unique is that over the radius of the circles. With one of them straight it
 * is half of that, and the one that is bent is named.
 */
void
bent_contacts()
{
  Simulation::FiberParameters parameters("/Fiber around");
  parameters.element_kind       = Beam::ElementKind::hermite;
  parameters.elements_per_fiber = 32;
  const Contact::ContactParameters contact_parameters("/Contact around");
  for (const double radius : {0.5, 0.3, 0.25, 0.205})
    for (const double other : {radius, 100.})
      {
        PlacedFibers                fibers({half_circle(radius, 1, 1., 0.0995),
                                            half_circle(other, 2, -1., -0.0995)},
                            parameters);
        Contributions::FiberContact contact(*fibers.space, contact_parameters);
        contact.update(fibers.state);
        const Post::BentContact found = Post::tightest_contact(
          *fibers.space, contact.curves(), contact.elements());
        deallog << "radii " << radius << " and " << other
                << std::setprecision(2) << ": taken over what is expected "
                << found.taken / (0.0995 / radius + 0.0995 / other)
                << ", bend over that of the circle "
                << found.bend.ratio * radius / 0.1
                << ", tight: " << found.is_tight() << std::setprecision(6);
        // Which one of two that are alike is named is a matter of round-off.
        if (other > radius)
          deallog << ", fiber " << found.bend.fiber << " at " << found.other;
        deallog << std::endl;
      }
  deallog << "as near, but bent gently: "
          << Post::BentContact{0.9, {0.1, 0, Point<3>()}, 1}.is_tight()
          << std::endl;
}



/** A straight fiber in four elements, of lengths that no decimals hold. */
Textile::FiberPath
fiber(const unsigned int number,
      const std::string &set,
      const unsigned int yarn)
{
  Textile::FiberPath path;
  path.yarn_id = yarn;
  for (unsigned int i = 0; i <= 4; ++i)
    path.points.push_back(Tensor<1, 3>({i / 3., number / 7., -1e-5 / 3.}));
  path.reference_length = 4. / 3.;
  path.radius           = 0.1 / (number + 3.);
  path.set              = set;
  return path;
}



/**
 * Written as a table and read again, the nodes of all fibers are the same to
 * the last digit, in their order, with radius, set and yarn.
 */
void
table()
{
  Simulation::FiberParameters           parameters;
  const std::vector<Textile::FiberPath> paths = {
    fiber(0, "warp", 0), fiber(1, "", Textile::no_id), fiber(2, "weft", 1)};
  const PlacedFibers fibers(paths, parameters);

  const std::string text = Post::centerlines_csv(fibers.state);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    {
      AssertThrow(text == "fiber,x,y,z,radius,set,yarn\n", ExcInternalError());
      return;
    }
  std::istringstream input(text);
  Textile::CsvTable  csv(input,
                        "centerlines.csv",
                        {"fiber", "x", "y", "z", "radius", "set", "yarn"},
                        {});
  unsigned int       n_same = 0;
  for (unsigned int f = 0; f < paths.size(); ++f)
    for (const Tensor<1, 3> &point : paths[f].points)
      {
        csv.next();
        n_same += csv.number("fiber") == f && csv.number("x") == point[0] &&
                  csv.number("y") == point[1] && csv.number("z") == point[2] &&
                  csv.number("radius") == paths[f].radius &&
                  csv.text("set") == paths[f].set &&
                  csv.text("yarn") == std::vector<std::string>{"0", "", "1"}[f];
      }
  deallog << n_same << " nodes are the same, more follow: " << csv.next()
          << std::endl;

  std::istringstream   again(text);
  Textile::PathReading reading;
  reading.element_length = 1. / 3.;
  for (const Textile::FiberPath &path :
       Textile::read_paths(again, "centerlines.csv", reading))
    deallog << "set '" << path.set << "', yarn "
            << static_cast<int>(path.yarn_id) << ", radius " << path.radius
            << ", " << path.points.size() << " knots, to " << path.points.back()
            << std::endl;
}



/**
 * Four fibers along x cross four along y, which are owned by turns: all lie as
 * they should but for one that is on the wrong side of its neighbours, and one
 * that ends before it meets the last two. Where ranks own fibers their pairs
 * are those that a rank finds which has all lines.
 */
void
crossings()
{
  const auto straight = [](const Tensor<1, 3> &begin, const Tensor<1, 3> &way) {
    Textile::FiberPath path;
    for (unsigned int i = 0; i <= 6; ++i)
      path.points.push_back(begin + i / 6. * way);
    path.reference_length = way.norm();
    path.radius           = 0.01;
    return path;
  };
  std::vector<Textile::FiberPath> paths;
  Post::OrderedFibers             pairs;
  for (unsigned int i = 0; i < 4; ++i)
    {
      const double height = i == 1 ? -0.2 : 0.1, length = i == 2 ? 2. : 4.;
      pairs.upper.push_back(paths.size());
      paths.push_back(straight(Tensor<1, 3>({0., i + 0.5, height}),
                               Tensor<1, 3>({length, 0., 0.})));
      pairs.lower.push_back(paths.size());
      paths.push_back(straight(Tensor<1, 3>({i + 0.5, 0., 0.}),
                               Tensor<1, 3>({0., 4., -0.05})));
    }
  const PlacedFibers fibers(paths, Simulation::FiberParameters("/Fiber cross"));
  const auto         print = [](const std::string         &by,
                        const Post::CrossingCount &count) {
    deallog << by << ": " << count.total << " pairs, " << count.wrong
            << " wrong, " << count.apart << " apart" << std::endl;
  };
  const Post::CrossingCount together =
    Post::count_crossing_order(fibers.state, {pairs});
  print("by all ranks", together);
  deallog << together.wrong_in_words() << std::endl
          << together.apart_in_words() << std::endl;
  const auto lines = Post::gather_centerlines(fibers.state, 4);
  if (!lines.empty())
    print("by one", Post::count_crossing_order(lines, {pairs}));
}



/**
 * A file that only the first rank finds reaches all of them, with all that is
 * said of a fiber; one that it does not find is refused by all.
 */
void
one_reads_for_all()
{
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const bool first = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const std::string there = "fibers.csv", not_there = "not there.csv";
  if (first)
    Heddle::write_file(there,
                       "fiber,x,y,z,radius,set,yarn\n"
                       "a,0,0,0,0.1,warp,5\na,1,0,0,0.1,warp,5\n");
  Textile::PathReading reading;
  reading.element_length = 0.5;
  reading.axial_strain   = 0.25;
  const auto paths =
    Textile::read_paths(first ? there : not_there, reading, MPI_COMM_WORLD);
  const bool is_right = paths.size() == 1 && paths[0].points.size() == 3 &&
                        paths[0].points[2][0] == 1. &&
                        std::abs(paths[0].reference_length - 0.8) < 1e-12 &&
                        paths[0].radius == 0.1 && paths[0].set == "warp" &&
                        paths[0].yarn_id == 0;
  std::string said;
  try
    {
      Textile::read_paths(first ? not_there : there, reading, MPI_COMM_WORLD);
    }
  catch (const InputError &error)
    {
      said = error.what();
    }
  const bool is_refused = said.rfind(not_there, 0) == 0;
  deallog << "all have the fiber: "
          << (Utilities::MPI::sum(is_right ? 1u : 0u, MPI_COMM_WORLD) ==
              n_ranks)
          << ", all refuse: "
          << (Utilities::MPI::sum(is_refused ? 1u : 0u, MPI_COMM_WORLD) ==
              n_ranks)
          << std::endl;
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Points", points);
  run_part("Bends", bends);
  run_part("Bent contacts", bent_contacts);
  run_part("Crossings", crossings);
  run_part("Table", table);
  run_part("One reads for all", one_reads_for_all);
}
