// Times of a section add up over its visits, and the inner section counts for
// the outer one as well.
#include <heddle/base/timer.h>

#include "../tests.h"

#include <chrono>
#include <thread>

int
main()
{
  initlog();
  Heddle::SectionTimer timer;
  for (unsigned int i = 0; i < 3; ++i)
    {
      const Heddle::SectionTimer::Scope outer(timer, "contact");
      const Heddle::SectionTimer::Scope inner(timer, "broad phase");
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  for (const auto &section : timer.all_sections())
    deallog << section.name << ": visits " << section.visits
            << ", at least 60 ms " << (section.seconds >= 0.06) << std::endl;
  deallog << "outer not less than inner "
          << (timer.seconds("contact") >= timer.seconds("broad phase"))
          << ", total not less than outer "
          << (timer.total() >= timer.seconds("contact")) << ", never visited "
          << timer.seconds("friction") << std::endl;

  const std::string table = timer.table();
  deallog << "lines " << std::count(table.begin(), table.end(), '\n')
          << ", names the inner one "
          << (table.find("  broad phase") != std::string::npos) << std::endl;
}
