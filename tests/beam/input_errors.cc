// What a user can get wrong about a fiber is said in one sentence.
#include <heddle/base/exceptions.h>

#include "random_element.h"



template <typename Function>
void
report(const Function &function)
{
  try
    {
      function();
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
  using namespace Heddle::Beam;
  initlog();
  report([]() { make_element("cubic", 3); });
  report([]() { make_element("director", 4); });
  report([]() { make_element("director", 2); });
  report([]() { make_element("hermite", 0); });
  report([]() { circular_section(-1., 1., 1., .3); });
  report([]() { circular_section(1., 0., 1., .3); });
  report([]() { circular_section(1., 1., -2., .3); });
  report([]() { circular_section(1., 1., 1., .5); });
  report([]() { circular_section(1., 1., 1., -.1); });
  report([]() { circular_section(1., 1., .02, .49); });
}
