#include <heddle/base/exceptions.h>
#include <heddle/contributions/friction_coefficients.h>

#include <algorithm>
#include <utility>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** "warp", "weft". */
      std::string
      in_quotes(const std::vector<std::string> &names)
      {
        std::string text;
        for (const std::string &name : names)
          text += (text.empty() ? "\"" : ", \"") + name + "\"";
        return text;
      }



      /** Numbers of the sets that "SET-SET" names, or their number twice. */
      std::pair<unsigned int, unsigned int>
      find_pair(const std::string &name, const std::vector<std::string> &sets)
      {
        std::pair<unsigned int, unsigned int> found = {sets.size(),
                                                       sets.size()};
        for (unsigned int i = 0; i < sets.size(); ++i)
          for (unsigned int j = 0; j < sets.size(); ++j)
            if (name == sets[i] + "-" + sets[j] &&
                found != std::make_pair(j, i))
              {
                if (found.first < sets.size())
                  throw InputError(
                    "Contact: \"Friction of sets\" names \"" + name +
                    "\", which is the pair of " +
                    in_quotes({sets[found.first], sets[found.second]}) +
                    " and that of " + in_quotes({sets[i], sets[j]}) +
                    "; give the sets names without \"-\" in their file.");
                found = {i, j};
              }
        return found;
      }
    } // namespace



    FrictionCoefficients::FrictionCoefficients(
      const System::FiberSpace         &space,
      const Contact::ContactParameters &parameters)
      : crossed(parameters.crossed_friction)
    {
      std::vector<std::string> sets;
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        {
          const auto found =
            std::find(sets.begin(), sets.end(), space.fiber(f).set);
          set_of_fiber.push_back(found - sets.begin());
          if (found == sets.end())
            sets.push_back(space.fiber(f).set);
        }

      parallel.assign(sets.size(),
                      std::vector<double>(sets.size(), parameters.friction));
      std::vector<std::vector<std::string>> given(
        sets.size(), std::vector<std::string>(sets.size()));
      for (const auto &[pair, coefficient] : parameters.friction_of_sets)
        {
          const auto [i, j] = find_pair(pair, sets);
          if (i == sets.size())
            throw InputError("Contact: \"Friction of sets\" names \"" + pair +
                             "\", which is no pair of sets; give them as "
                             "\"SET-SET\", of the sets " +
                             in_quotes(sets) + ".");
          if (!given[i][j].empty())
            throw InputError("Contact: \"Friction of sets\" gives \"" +
                             given[i][j] + "\" and \"" + pair +
                             "\", which are the same pair; leave one of them "
                             "out.");
          given[i][j] = given[j][i] = pair;
          parallel[i][j] = parallel[j][i] = coefficient;
        }
    }



    double
    FrictionCoefficients::operator()(const unsigned int fiber_a,
                                     const unsigned int fiber_b,
                                     const double       cosine) const
    {
      const double part = cosine * cosine;
      return parallel[set_of_fiber[fiber_a]][set_of_fiber[fiber_b]] *
             (part + crossed * (1. - part));
    }
  } // namespace Contributions
} // namespace Heddle
