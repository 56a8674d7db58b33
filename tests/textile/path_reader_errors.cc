// Every fault of a file is told with its line, in one sentence.
#include <heddle/base/exceptions.h>
#include <heddle/textile/path_reader.h>

#include "../tests.h"

#include <sstream>

using namespace Heddle::Textile;



void
refuse(const std::string &text,
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



int
main()
{
  initlog();
  const std::string head = "fiber,x,y,z\n";
  refuse("");
  refuse("# nothing but a comment\n");
  refuse(head);
  refuse("fiber,x,z\n1,0,0\n");
  refuse("fiber,x,x,y,z\n");
  refuse("fiber,x,y,z,colour\n");
  refuse("fiber,x,y,z\n1,0,0,0\n1,1,0,0\n", 0.);
  refuse(head + "1,0,0,0\n1,1,0\n");
  refuse(head + "1,0,0,0\n1,1,zero,0\n");
  refuse(head + "1,0,0,0\n1,1,nan,0\n");
  refuse(head + "1,0,0,0\n1,1e999,0,0\n");
  refuse(head + "1,0,0,0\n,1,0,0\n");
  refuse(head + "1,0,0,0\n1,1,0,0\n2,5,5,5\n");
  refuse(head + "1,0,0,0\n1,1,0,0\n# again\n1,1,0,0\n");
  refuse("fiber,x,y,z,radius\n1,0,0,0,1\n1,1,0,0,-1\n", 0.);
  refuse("fiber,x,y,z,set\n1,0,0,0,a\n1,1,0,0,b\n");
  refuse("fiber,x,y,z,yarn\n1,0,0,0,a\n1,1,0,0,\n");
  refuse("fiber,x,y,z,set,yarn\n1,0,0,0,a,7\n1,1,0,0,a,7\n"
         "2,0,0,1,b,7\n2,1,0,1,b,7\n");
  refuse(head + "1,0,0,0\n1,1,0,0\n", 0.1, 0.);
  refuse(head + "1,0,0,0\n1,1,0,0\n", 0.1, 1e-9);
  refuse(head + "1,0,0,0\n1,1,0,0\n", -0.1);
  refuse(head + "1,0,0,0\n1,1,0,0\n", 0.1, 1., 0.);
  try
    {
      read_paths("no such file.csv", PathReading{1., 1, 0.1, 1., {}});
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}
