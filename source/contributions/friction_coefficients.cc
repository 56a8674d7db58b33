#include <heddle/base/exceptions.h>
#include <heddle/contributions/friction_coefficients.h>

#include <algorithm>

namespace Heddle
{
  namespace Contributions
  {
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
      auto unknown = parameters.friction_of_sets;
      for (unsigned int i = 0; i < sets.size(); ++i)
        for (unsigned int j = 0; j < sets.size(); ++j)
          {
            const auto given =
              parameters.friction_of_sets.find(sets[i] + "-" + sets[j]);
            if (given == parameters.friction_of_sets.end())
              continue;
            const auto other =
              parameters.friction_of_sets.find(sets[j] + "-" + sets[i]);
            if (other != parameters.friction_of_sets.end() &&
                other->second != given->second)
              throw InputError("Contact: \"Friction of sets\" gives \"" +
                               given->first + "\" and \"" + other->first +
                               "\", which are the same pair, different "
                               "coefficients; leave one of them out.");
            parallel[i][j] = parallel[j][i] = given->second;
            unknown.erase(given->first);
          }
      if (unknown.empty())
        return;
      std::string names;
      for (const std::string &set : sets)
        names += (names.empty() ? "\"" : ", \"") + set + "\"";
      throw InputError("Contact: \"Friction of sets\" names \"" +
                       unknown.begin()->first +
                       "\", which is no pair of sets; give them as "
                       "\"SET-SET\", of the sets " +
                       names + ".");
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
