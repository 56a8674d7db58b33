// What is to be said of a weave that is laid out as it was asked for.
#include <heddle/base/yarn_set.h>
#include <heddle/textile/weave.h>

#include <iomanip>
#include <sstream>

namespace Heddle
{
  namespace Textile
  {
    std::vector<std::string>
    Weave::notes() const
    {
      std::vector<std::string> result;
      for (const std::string &note : {short_ends(), wide_yarns(), loose_yarn()})
        if (!note.empty())
          result.push_back(note);
      return result;
    }



    std::string
    Weave::short_ends() const
    {
      // Yarns get wider as they settle: tutorial/small_weave.prm needs 1.33.
      constexpr double spread = 1.4;
      for (const Direction crossed : {warp, weft})
        {
          const double needed =
            0.5 * spread * sections[crossed].width / spacings[crossed];
          if (description.end_length >= needed)
            continue;
          std::ostringstream text;
          text << std::setprecision(3) << "Weave/End length is "
               << description.end_length << ": yarns end within the last "
               << word(YarnSet(crossed))
               << " yarns that they cross, and their fibers may slip off; "
                  "these need "
               << needed << ", better 1";
          return text.str();
        }
      return "";
    }



    std::string
    Weave::wide_yarns() const
    {
      constexpr double round_off = 1e-9;
      for (const Direction direction : {warp, weft})
        {
          const double width = sections[direction].width;
          if (family(direction).n_yarns == 1 ||
              width <= (1. + round_off) * spacings[direction])
            continue;
          std::ostringstream text;
          text << std::setprecision(3) << "Weave: " << word(YarnSet(direction))
               << " yarns are " << width << " mm wide and "
               << spacings[direction]
               << " mm apart, so that neighbours begin in each other; choose "
                  "a larger Yarn spacing, or fewer bundles side by side";
          return text.str();
        }
      return "";
    }



    std::string
    Weave::loose_yarn() const
    {
      const unsigned int n_yarns[] = {description.warp.n_yarns,
                                      description.weft.n_yarns};
      for (const Direction direction : {warp, weft})
        for (unsigned int i = 0; i < n_yarns[direction]; ++i)
          {
            unsigned int       n_on_top  = 0;
            const unsigned int n_crossed = n_yarns[other(direction)];
            for (unsigned int j = 0; j < n_crossed; ++j)
              n_on_top += direction == warp ? pattern.warp_on_top(i, j)
                                            : !pattern.warp_on_top(j, i);
            if (n_crossed > 1 && (n_on_top == 0 || n_on_top == n_crossed))
              return "Weave: " + std::string(word(YarnSet(direction))) +
                     " yarn " + std::to_string(i) +
                     " lies on the same side of all " +
                     word(YarnSet(other(direction))) +
                     " yarns, so that nothing holds it in the fabric; see "
                     "Pattern";
          }
      return "";
    }
  } // namespace Textile
} // namespace Heddle
