#include <heddle/base/exceptions.h>
#include <heddle/base/fiber_names.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <set>

namespace Heddle
{
  FiberNames::FiberNames(const std::vector<FiberName> &fibers)
    : number_of_fibers(fibers.size())
  {
    for (const FiberName &fiber : fibers)
      {
        auto &yarns = yarns_of_set[fiber.set];
        if (fiber.yarn != numbers::invalid_unsigned_int)
          yarns[fiber.yarn] = 0;
      }
    for (auto &set : yarns_of_set)
      {
        unsigned int place = 0;
        for (auto &yarn : set.second)
          yarn.second = place++;
      }

    for (unsigned int f = 0; f < number_of_fibers; ++f)
      {
        const auto &[set, yarn] = fibers[f];
        const auto add = [&](const std::string &word, const std::string &what) {
          meanings_of_word[word][what].push_back(f);
        };
        add("all", "all fibers");
        add(std::to_string(f), "fiber " + std::to_string(f));
        if (!set.empty())
          add(set, "the set \"" + set + '"');
        if (yarn == numbers::invalid_unsigned_int)
          continue;
        add("yarn " + std::to_string(yarn), "yarn " + std::to_string(yarn));
        if (set.empty())
          continue;
        const std::string place = std::to_string(yarns_of_set[set][yarn]);
        add(set + ' ' + place, "yarn " + place + " of the set \"" + set + '"');
      }
  }



  std::vector<unsigned int>
  FiberNames::find(const std::string &words, const std::string &where) const
  {
    std::set<unsigned int> found;
    for (const std::string &word : Utilities::split_string_list(words))
      {
        const auto meanings = meanings_of_word.find(word);
        if (meanings == meanings_of_word.end())
          complain(word, where);
        const auto &[what, fibers] = *meanings->second.begin();
        for (const auto &other : meanings->second)
          if (other.second != fibers)
            throw InputError(where + ": \"Fibers\" names \"" + word +
                             "\", which is " + what + " and " + other.first +
                             "; give the set another name in its file, or "
                             "name these fibers by other words.");
        found.insert(fibers.begin(), fibers.end());
      }
    require(!found.empty(),
            where + ": \"Fibers\" is empty; write \"all\", names of sets, or "
                    "numbers.");
    return {found.begin(), found.end()};
  }



  void
  FiberNames::complain(const std::string &word, const std::string &where) const
  {
    std::string sets, yarns;
    for (const auto &[set, numbers] : yarns_of_set)
      {
        if (!set.empty())
          sets += (sets.empty() ? " \"" : ", \"") + set + "\"";
        if (!numbers.empty())
          yarns = "; \"yarn " + std::to_string(numbers.begin()->first) + "\"" +
                  (set.empty() ? "" : ", or \"" + set + " 0\",") +
                  " is the name of a yarn";
      }
    throw InputError(
      where + ": \"Fibers\" names \"" + word +
      "\", which is no fiber; there are the numbers 0 to " +
      std::to_string(number_of_fibers - 1) +
      (sets.empty() ? ", and no sets" : ", and the sets" + sets) + yarns + ".");
  }
} // namespace Heddle
