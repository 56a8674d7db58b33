// A pattern that is none is refused in one sentence.
#include <heddle/base/exceptions.h>
#include <heddle/textile/weave_pattern.h>

#include "../tests.h"

int
main()
{
  initlog();
  for (const std::string name : {"",
                                 "plane",
                                 "twill 2",
                                 "twill 0/2",
                                 "satin 6/2",
                                 "satin 5/4",
                                 "0 1; 1"})
    try
      {
        const Heddle::Textile::WeavePattern pattern(name);
        deallog << "accepted '" << name << "'" << std::endl;
      }
    catch (const Heddle::InputError &error)
      {
        deallog << error.what() << std::endl;
      }
}
