// Fibers of a file are resampled to equal elements, whatever the order of the
// columns, and scaled.
#include <heddle/textile/path_reader.h>

#include "../tests.h"

#include <sstream>

using namespace Heddle::Textile;



void
read(const std::string &text, const PathReading &reading)
{
  std::istringstream input(text);
  for (const FiberPath &fiber : read_paths(input, "fibers.csv", reading))
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



int
main()
{
  initlog();
  PathReading reading;
  reading.element_length = 0.5;
  reading.scale          = 0.1;
  read("# two fibers, points of which alternate\n"
       "z, y,x ,fiber,set,radius\n"
       "0,0,0,left,a,1\n"
       "\n"
       "0,0,0,right,b,2   # the second\n"
       "0,0,10,left,a,1\n"
       "5,0,0,right,b,4\n"
       "0,0,11,left,a,1\n",
       reading);

  // Yarns are numbered as they appear; nothing is no yarn.
  read("fiber,x,y,z,radius,yarn\n"
       "1,0,0,0,1,left\n1,9,0,0,1,left\n"
       "2,0,1,0,1,\n2,9,1,0,1,\n"
       "3,0,2,0,1,right\n3,9,2,0,1,right\n"
       "4,0,3,0,1,left\n4,9,3,0,1,left\n",
       reading);

  reading.scale          = 1.;
  reading.radius         = 0.01;
  const std::string bend = "fiber,x,y,z\n1,0,0,0\n1,1,0,0\n1,2,1,0\n1,2,2,0\n";
  read(bend, reading);
  reading.interpolation = Interpolation::catmull_rom;
  read(bend, reading);
  reading.element_length = 100.;
  read(bend, reading);
}
