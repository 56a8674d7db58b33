// Values are compared as numbers where they are numbers, and else as texts.
#include <heddle/base/settings.h>

#include "../tests.h"

void
compare(const std::string &a, const std::string &b)
{
  deallog << '\'' << a << "' and '" << b
          << "': " << (Heddle::same_value(a, b) ? "the same" : "not the same")
          << std::endl;
}



int
main()
{
  initlog();
  compare("0", "0.0");
  compare("1e-3", "0.001");
  compare("0.1", "0.10000000001");
  compare("0, 0, 0", "0.0,0,-0");
  compare("0, 0, 0", "0, 0");
  compare("0, 0", "0, 1");
  compare("", "0");
  compare("", "");
  compare("true", "true");
  compare("true", "false");
  compare("1*t", "1.0*t");
  compare("warp: 0.1", "warp: 0.10");
}
