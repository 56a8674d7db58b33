#include <heddle/base/timer.h>

#include <iomanip>
#include <sstream>

namespace Heddle
{
  namespace internal
  {
    namespace SectionTimer
    {
      double
      seconds_since(const std::chrono::steady_clock::time_point start)
      {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - start).count();
      }
    } // namespace SectionTimer
  }   // namespace internal



  SectionTimer::Scope::Scope(SectionTimer &timer, const std::string &name)
    : timer(timer)
    , section(timer.find_or_add(name))
    , start(std::chrono::steady_clock::now())
  {
  }



  SectionTimer::Scope::~Scope()
  {
    Section &here = timer.sections[section];
    here.seconds += internal::SectionTimer::seconds_since(start);
    ++here.visits;
  }



  SectionTimer::SectionTimer()
    : start(std::chrono::steady_clock::now())
  {
  }



  double
  SectionTimer::total() const
  {
    return internal::SectionTimer::seconds_since(start);
  }



  double
  SectionTimer::seconds(const std::string &name) const
  {
    for (const Section &section : sections)
      if (section.name == name)
        return section.seconds;
    return 0.;
  }



  const std::vector<SectionTimer::Section> &
  SectionTimer::all_sections() const
  {
    return sections;
  }



  std::string
  SectionTimer::table() const
  {
    const double       whole = total();
    std::ostringstream out;
    const auto         row = [&out](const std::string &name,
                            const std::string &visits,
                            const std::string &seconds,
                            const std::string &percent) {
      out << "  " << std::left << std::setw(36) << name << std::right
          << std::setw(8) << visits << std::setw(12) << seconds << std::setw(9)
          << percent << '\n';
    };
    const auto fixed = [](const double value, const int digits) {
      std::ostringstream text;
      text << std::fixed << std::setprecision(digits) << value;
      return text.str();
    };

    row("Wall time by section", "visits", "s", "%");
    for (const Section &section : sections)
      row(section.name,
          std::to_string(section.visits),
          fixed(section.seconds, 2),
          fixed(100. * section.seconds / whole, 1));
    row("total", "", fixed(whole, 2), "");
    return out.str();
  }



  std::size_t
  SectionTimer::find_or_add(const std::string &name)
  {
    for (std::size_t i = 0; i < sections.size(); ++i)
      if (sections[i].name == name)
        return i;
    sections.push_back({name, 0., 0});
    return sections.size() - 1;
  }
} // namespace Heddle
