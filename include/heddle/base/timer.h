#ifndef heddle_base_timer_h
#define heddle_base_timer_h

#include <chrono>
#include <string>
#include <vector>

namespace Heddle
{
  /**
   * Wall-clock time by named section, accumulated over all visits. Sections may
   * be nested; the time of an inner one then counts for both. Each rank keeps
   * its own time.
   */
  class SectionTimer
  {
  public:
    /** What is known of one section. */
    struct Section
    {
      std::string  name;
      double       seconds = 0.;
      unsigned int visits  = 0;
    };

    /** The time between construction and destruction counts for a section. */
    class Scope
    {
    public:
      Scope(SectionTimer &timer, const std::string &name);
      ~Scope();

      Scope(const Scope &) = delete;
      Scope &
      operator=(const Scope &) = delete;

    private:
      SectionTimer                               &timer;
      const std::size_t                           section;
      const std::chrono::steady_clock::time_point start;
    };

    SectionTimer();

    /** Return the seconds since this object was constructed. */
    double
    total() const;

    /** Return the seconds spent in section @p name so far; 0 if never. */
    double
    seconds(const std::string &name) const;

    /** Return all sections, in the order of their first visit. */
    const std::vector<Section> &
    all_sections() const;

    /** Return a table of all sections with their share of the total. */
    std::string
    table() const;

  private:
    std::size_t
    find_or_add(const std::string &name);

    const std::chrono::steady_clock::time_point start;
    std::vector<Section>                        sections;
  };
} // namespace Heddle

#endif
