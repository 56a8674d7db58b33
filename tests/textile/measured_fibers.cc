// Fibers from a file: how curves are drawn through their points, how they are
// read, the fabric that they make, and what is refused in one sentence.
#include <heddle/base/exceptions.h>
#include <heddle/textile/interpolation.h>
#include <heddle/textile/lost_fibers.h>
#include <heddle/textile/measured_fabric.h>
#include <heddle/textile/path_reader.h>
#include <heddle/textile/spun_yarns.h>

#include <deal.II/base/numbers.h>

#include "../tests.h"

#include <sstream>

using namespace Heddle::Textile;

/** Largest distance from the circle over the middle half of an arc. */
double
error(const Interpolation interpolation, const unsigned int n)
{
  std::vector<Tensor<1, 3>> points;
  for (unsigned int i = 0; i <= n; ++i)
    {
      const double angle = numbers::PI * i / n;
      points.push_back(Tensor<1, 3>({std::cos(angle), std::sin(angle), 0.}));
    }
  const InterpolatedCurve curve(points, interpolation);

  double error = 0.;
  for (unsigned int k = 0; k <= 1000; ++k)
    error = std::max(
      error, std::abs(curve(curve.end() * (0.25 + 0.0005 * k)).norm() - 1.));
  const double chord = curve.end() / n;
  for (unsigned int i = 0; i <= n; ++i)
    AssertThrow((curve(i * chord) - points[i]).norm() < 1e-12,
                ExcInternalError());
  return error;
}



/**
 * Between points of a circle, away from the free ends, both interpolations
 * leave it by a distance of fourth order; both meet every point.
 */
void
interpolations()
{
  for (const auto interpolation :
       {Interpolation::spline, Interpolation::catmull_rom})
    {
      deallog << (interpolation == Interpolation::spline ? "spline"
                                                         : "Catmull-Rom")
              << ", order of the error:";
      for (const unsigned int n : {32, 64, 128})
        deallog << " "
                << std::log2(error(interpolation, n) /
                             error(interpolation, 2 * n));
      deallog << std::endl;
    }
}



void
read(const std::string &text, const PathReading &settings)
{
  std::istringstream input(text);
  for (const FiberPath &fiber : read_paths(input, "fibers.csv", settings))
    {
      double smallest = 1e300, largest = 0.;
      for (unsigned int i = 1; i < fiber.points.size(); ++i)
        {
          const double h = (fiber.points[i] - fiber.points[i - 1]).norm();
          smallest       = std::min(smallest, h);
          largest        = std::max(largest, h);
        }
      deallog << "set '" << fiber.set << "', yarn "
              << static_cast<int>(fiber.yarn_id) << ", radius " << fiber.radius
              << ", length " << fiber.reference_length << ", "
              << fiber.points.size() - 1 << " elements, chords " << smallest
              << " to " << largest << ", from " << fiber.points.front()
              << " to " << fiber.points.back() << std::endl;
    }
}



/**
 * Fibers of a file are resampled to equal elements, whatever the order of the
 * columns, and scaled.
 */
void
reading()
{
  PathReading settings;
  settings.element_length = 0.5;
  settings.scale          = 0.1;
  read("# two fibers, points of which alternate\n"
       "z, y,x ,fiber,set,radius\n"
       "0,0,0,left,a,1\n"
       "\n"
       "0,0,0,right,b,2   # the second\n"
       "0,0,10,left,a,1\n"
       "5,0,0,right,b,4\n"
       "0,0,11,left,a,1\n",
       settings);

  // Yarns are numbered as they appear; nothing is no yarn.
  read("fiber,x,y,z,radius,yarn\n"
       "1,0,0,0,1,left\n1,9,0,0,1,left\n"
       "2,0,1,0,1,\n2,9,1,0,1,\n"
       "3,0,2,0,1,right\n3,9,2,0,1,right\n"
       "4,0,3,0,1,left\n4,9,3,0,1,left\n",
       settings);

  // A run leaves numbers, which are kept; others are names.
  for (const std::string last : {"0", "3"})
    read("fiber,x,y,z,radius,yarn\n"
         "1,0,0,0,1,2\n1,9,0,0,1,2\n"
         "2,0,1,0,1,\n2,9,1,0,1,\n"
         "3,0,2,0,1,1\n3,9,2,0,1,1\n"
         "4,0,3,0,1," +
           last + "\n4,9,3,0,1," + last + "\n",
         settings);

  settings.scale         = 1.;
  settings.radius        = 0.01;
  const std::string bend = "fiber,x,y,z\n1,0,0,0\n1,1,0,0\n1,2,1,0\n1,2,2,0\n";
  read(bend, settings);
  settings.interpolation = Interpolation::catmull_rom;
  read(bend, settings);
  settings.element_length = 100.;
  read(bend, settings);
}



/** The same points, as spreadsheets of all kinds write them. */
void
dialects()
{
  PathReading settings;
  settings.element_length = 1.;
  settings.radius         = 0.1;
  read("fiber;x;y;z;set\r\na;0;0;0;warp\r\na;2;0;0;warp\r\n", settings);
  read("fiber\tx\ty\tz\tset\na\t0\t0\t0\t\na\t2\t0\t0\t\n", settings);
  read("fiber,x,y,z\ra,0,0,0\ra,2,0,0\r", settings);
  read("\"fiber\",\"x\",\"y\",\"z\"\n\"a\",0,0,0\n\"a\",2,0,0", settings);
}



void
refuse_file(const std::string &text,
            const double       radius         = 0.1,
            const double       element_length = 1.,
            const double       scale          = 1.)
{
  PathReading reading;
  reading.element_length = element_length;
  reading.radius         = radius;
  reading.scale          = scale;
  std::istringstream input(text);
  try
    {
      read_paths(input, "fibers.csv", reading);
      deallog << "accepted" << std::endl;
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



/** Every fault of a file is told with its line, in one sentence. */
void
no_files_of_fibers()
{
  const std::string head = "fiber,x,y,z\n";
  refuse_file("");
  refuse_file("# nothing but a comment\n");
  refuse_file(head);
  refuse_file("fiber x y z\n1 0 0 0\n1 1 0 0\n");
  refuse_file("fiber;x;y;z\n1;0;0;0\n1;1,5;0;0\n");
  refuse_file(head + "1;0;0;0\n1;1;0;0\n");
  refuse_file(std::string("\xff\xfe"
                          "f\0i\0b\0",
                          8));
  refuse_file("fiber,x,z\n1,0,0\n");
  refuse_file("fiber,x,x,y,z\n");
  refuse_file("fiber,x,y,z,colour\n");
  refuse_file("fiber,x,y,z\n1,0,0,0\n1,1,0,0\n", 0.);
  refuse_file(head + "1,0,0,0\n1,1,0\n");
  refuse_file(head + "1,0,0,0\n1,1,zero,0\n");
  refuse_file(head + "1,0,0,0\n1,1,nan,0\n");
  refuse_file(head + "1,0,0,0\n1,1e999,0,0\n");
  refuse_file(head + "1,0,0,0\n,1,0,0\n");
  refuse_file(head + "1,0,0,0\n1,1,0,0\n2,5,5,5\n");
  refuse_file(head + "1,0,0,0\n1,1,0,0\n# again\n1,1,0,0\n");
  refuse_file(head + "1,0,0,0\n1,0.1,0.7,2.3\n1,0.1,0.7,2.3\n", 0.1, 1., 1e-3);
  refuse_file(head + "1,0,0,0\n1,1,0,0\n1,1,1,0\n1,0,0,0\n", 0.1, 100.);
  refuse_file("fiber,x,y,z,radius\n1,0,0,0,1\n1,1,0,0,-1\n", 0.);
  refuse_file("fiber,x,y,z,set\n1,0,0,0,a\n1,1,0,0,b\n");
  refuse_file("fiber,x,y,z,yarn\n1,0,0,0,a\n1,1,0,0,\n");
  refuse_file("fiber;x;y;z;set\n1;0;0;0;a,b\n1;1;0;0;a,b\n");
  refuse_file("fiber,x,y,z,set,yarn\n1,0,0,0,a,7\n1,1,0,0,a,7\n"
              "2,0,0,1,b,7\n2,1,0,1,b,7\n");
  refuse_file(head + "1,0,0,0\n1,1,0,0\n", 0.1, 0.);
  refuse_file(head + "1,0,0,0\n1,1,0,0\n", 0.1, 1e-9);
  refuse_file(head + "1,0,0,0\n1,1,0,0\n", -0.1);
  refuse_file(head + "1,0,0,0\n1,1,0,0\n", 0.1, 1., 0.);
  try
    {
      read_paths(
        "no such file.csv", PathReading{1., 1, 0.1, 1., {}}, MPI_COMM_WORLD);
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



/** A wave of @p n points, in an order that @p step times their number is. */
std::string
shuffled(const unsigned int n, const unsigned int step)
{
  std::ostringstream text;
  text << "fiber,x,y,z\n";
  for (unsigned int i = 0; i < n; ++i)
    {
      const double t = (i * step) % n;
      text << "f1," << 0.3 * t << ',' << std::sin(0.3 * t) << ",0\n";
    }
  return text.str();
}



/** Points that are not in their order along a fiber are told. */
void
orders()
{
  refuse_file(shuffled(40, 1));
  refuse_file(shuffled(40, 39));
  refuse_file(shuffled(41, 7));
  refuse_file(shuffled(41, 17));
  refuse_file(shuffled(7, 3));

  // Exchanged points of a straight fiber lie on it, those of others beside it.
  // A fold that is shorter than elements is none of theirs.
  refuse_file("fiber,x,y,z\n1,0,0,0\n1,1,0,0\n1,3,0,0\n1,2,0,0\n1,4,0,0\n");
  refuse_file("fiber,x,y,z\n1,0,0,0\n1,2,0,0\n1,1.9,0,0\n1,4,0,0\n");

  // A loop that closes, and a fiber of which two points are exchanged.
  for (const std::string more :
       {"1,1,1,0\n1,0,1,0\n1,0,0,0\n", "1,3,0.1,0\n1,2,0,0\n1,4,0,0\n"})
    {
      PathReading reading;
      reading.element_length = 1.;
      reading.radius         = 0.1;
      std::istringstream input("fiber,x,y,z\n1,0,0,0\n1,1,0,0\n" + more);
      deallog << read_paths(input, "fibers.csv", reading)[0].n_turns << " turns"
              << std::endl;
    }
}



/** A straight fiber in the middle of which is the place @p across. */
FiberPath
fiber(const std::string &set,
      const unsigned int yarn,
      const double       across,
      const bool         backward = false)
{
  const unsigned int along = set == "weft" ? 1 : 0;
  FiberPath          path;
  for (unsigned int i = 0; i < 3; ++i)
    {
      Tensor<1, 3> point;
      point[along]     = backward ? 2. - i : i;
      point[1 - along] = across;
      point[2]         = 0.1 * i;
      path.points.push_back(point);
    }
  path.set     = set;
  path.yarn_id = yarn;
  return path;
}



void
refuse_fabric(std::vector<FiberPath> paths)
{
  try
    {
      MeasuredFabric(paths, "fibers.csv").width();
      deallog << "accepted" << std::endl;
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



/**
 * Fibers of a measured fabric all run towards larger x or y, whichever end they
 * begin at; its yarns are counted, and side by side in its width. A file that
 * is no fabric is refused in one sentence.
 */
void
fabrics()
{
  std::vector<FiberPath> paths = {fiber("warp", 1, 4.),
                                  fiber("weft", 0, 1.),
                                  fiber("warp", 1, 6., /*backward=*/true),
                                  fiber("weft", 2, 0.75, true),
                                  fiber("warp", 3, 3.),
                                  fiber("warp", 4, 9.)};
  const MeasuredFabric   fabric(paths, "fibers.csv");
  for (const FiberPath &path : paths)
    deallog << path.set << " from " << path.points.front() << " to "
            << path.points.back() << std::endl;
  deallog << fabric.n_yarns()[0] << " warp yarns, " << fabric.width()[0]
          << " wide, " << fabric.n_yarns()[1] << " weft yarns, "
          << fabric.width()[1] << std::endl;

  // Lost while it was traced.
  deallog << "short: \"" << lost_fibers(paths, "fibers.csv") << '"'
          << std::endl;
  paths[2].points.pop_back();
  deallog << lost_fibers(paths, "fibers.csv") << std::endl;
  paths.push_back(paths[0]);
  paths.push_back(paths[0]);
  paths.back().points.erase(paths.back().points.begin());
  deallog << lost_fibers(paths, "fibers.csv") << std::endl;
  paths.resize(6);

  // None of the yarn runs from end to end: all are as good.
  paths[0].points.erase(paths[0].points.begin());
  deallog << "none whole: \"" << lost_fibers(paths, "fibers.csv") << '"'
          << std::endl;
  deallog << spun_yarns(paths, "fibers.csv") << std::endl;
  for (const std::array<bool, 2> &ends : ends_of_yarns(paths))
    deallog << ends[0] << ends[1] << ' ';
  deallog << std::endl;

  refuse_fabric({fiber("warp", 0, 1.), fiber("warp", no_id, 2.)});
  refuse_fabric({fiber("warp", 0, 1.), fiber("pile", 1, 2.)});
  refuse_fabric({fiber("warp", 0, 1.), fiber("warp", 1, 2.)});
  refuse_fabric(
    {fiber("warp", 0, 1.), fiber("warp", 1, 2.), fiber("weft", 2, 2.)});
  paths[1].set = "warp";
  refuse_fabric(paths);

  // Layers that lie over each other: three warp yarns 0.3 apart, two weft yarns
  // 0.5 apart. Of the latter the first column alone has no width.
  paths.clear();
  const auto stack = [&paths](const std::string &set, const double across) {
    paths.push_back(fiber(set, paths.size(), across));
    paths.back().radius = 0.1;
  };
  for (const double across : {0., 0.05, 0.3, 0.35, 0.6, 0.65})
    stack("warp", across);
  for (const double across : {1., 1.04, 1.5, 1.5, 1.54})
    stack("weft", across);
  const MeasuredFabric layered(paths, "fibers.csv");
  deallog << "layered: " << layered.n_yarns()[0] << " warp yarns, "
          << layered.width()[0] << " wide, " << layered.n_yarns()[1]
          << " weft yarns, " << layered.width()[1] << std::endl;
  paths.resize(8);
  refuse_fabric(paths);
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Interpolation", interpolations);
  run_part("Reading", reading);
  run_part("Dialects", dialects);
  run_part("Order of points", orders);
  run_part("What is no file of fibers", no_files_of_fibers);
  run_part("Measured fabrics", fabrics);
}
