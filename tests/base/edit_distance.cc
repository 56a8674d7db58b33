// The distance of two names counts letters inserted, deleted, replaced and
// exchanged with their neighbor.
#include <heddle/base/declared_parameters.h>

#include "../tests.h"

int
main()
{
  initlog();
  const std::vector<std::pair<std::string, std::string>> pairs = {
    {"Friction", "friction"},
    {"Friction", "Frictoin"},
    {"Cell", "Cells"},
    {"Gells", "Cells"},
    {"", "Cells"},
    {"Warp", "Weft"}};
  for (const auto &[a, b] : pairs)
    deallog << a << " - " << b << ": " << Heddle::edit_distance(a, b)
            << std::endl;
}
