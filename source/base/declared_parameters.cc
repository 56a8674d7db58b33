#include <heddle/base/declared_parameters.h>
#include <heddle/base/number_range.h>
#include <heddle/base/pattern_in_words.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <functional>
#include <sstream>

namespace Heddle
{
  namespace internal
  {
    namespace DeclaredParameters
    {
      /** deal.II's description of an unsigned integer without a range. */
      const std::string count = "[Integer]";



      std::string
      lower_case(std::string text)
      {
        std::transform(
          text.begin(), text.end(), text.begin(), [](const char c) {
            return static_cast<char>(
              std::tolower(static_cast<unsigned char>(c)));
          });
        return text;
      }



      /** How unlike two names are; a name inside the other is quite like it. */
      unsigned int
      unlikeness(const std::string &a, const std::string &b)
      {
        const std::string first    = lower_case(a);
        const std::string second   = lower_case(b);
        const unsigned    distance = edit_distance(first, second);
        const bool        inside   = std::min(a.size(), b.size()) >= 4 &&
                            (first.find(second) != std::string::npos ||
                             second.find(first) != std::string::npos);
        return inside ? std::min(distance, 2u) : distance;
      }



      /** Names that differ by more than this are not mistaken for another. */
      unsigned int
      tolerated(const std::string &name)
      {
        return std::max<std::size_t>(2, name.size() / 3);
      }
    } // namespace DeclaredParameters
  }   // namespace internal



  DeclaredParameters::DeclaredParameters(const ParameterHandler &prm)
  {
    std::ostringstream text;
    prm.print_parameters(text, ParameterHandler::JSON);

    const std::function<void(const nlohmann::json &, const std::string &)>
      visit = [&](const nlohmann::json &section, const std::string &path) {
        sections.insert(path);
        for (const auto &item : section.items())
          if (item.value().contains("pattern_description"))
            parameters[path].push_back({item.key(),
                                        item.value()["pattern_description"],
                                        item.value()["default_value"]});
          else if (item.value().is_object())
            visit(item.value(),
                  path.empty() ? item.key() : path + "/" + item.key());
      };
    visit(nlohmann::json::parse(text.str()), "");
  }



  bool
  DeclaredParameters::has_section(const std::vector<std::string> &path) const
  {
    return sections.count(join_path(path)) > 0;
  }



  bool
  DeclaredParameters::has_parameter(const std::vector<std::string> &path,
                                    const std::string              &name) const
  {
    return find(path, name) != nullptr;
  }



  bool
  DeclaredParameters::admits(const std::vector<std::string> &path,
                             const std::string              &name,
                             const std::string              &value) const
  {
    const std::string &pattern = find(path, name)->pattern;
    // deal.II would let a negative number wrap around.
    if (pattern == internal::DeclaredParameters::count &&
        value.find('-') != std::string::npos)
      return false;
    return Patterns::pattern_factory(pattern)->match(value);
  }



  bool
  DeclaredParameters::is_in_range(const std::vector<std::string> &path,
                                  const std::string              &name,
                                  const std::string              &value) const
  {
    if (find(path, name)->pattern.find("[Double") == std::string::npos)
      return true;
    // Of lists, and of maps, whose names are no numbers.
    for (const std::string &entry : Utilities::split_string_list(value))
      {
        const std::string word = entry.substr(entry.rfind(':') + 1);
        if (!Heddle::is_in_range(std::strtod(word.c_str(), nullptr)))
          return false;
      }
    return true;
  }



  std::string
  DeclaredParameters::allowed(const std::vector<std::string> &path,
                              const std::string              &name) const
  {
    return pattern_in_words(find(path, name)->pattern);
  }



  const std::string &
  DeclaredParameters::usual_value(const std::vector<std::string> &path,
                                  const std::string              &name) const
  {
    return find(path, name)->usual_value;
  }



  std::string
  DeclaredParameters::suggest_section(
    const std::vector<std::string> &path) const
  {
    const std::string &name = path.back();
    const std::string  parent =
      join_path(std::vector<std::string>(path.begin(), path.end() - 1));

    std::string  best;
    unsigned int least = 2 * internal::DeclaredParameters::tolerated(name) + 1;
    for (const std::string &section : sections)
      {
        const auto        slash     = section.rfind('/');
        const bool        is_nested = slash != std::string::npos;
        const std::string last =
          is_nested ? section.substr(slash + 1) : section;
        const bool is_here =
          (is_nested ? section.substr(0, slash) : std::string()) == parent;
        const unsigned int measure =
          2 * internal::DeclaredParameters::unlikeness(name, last) +
          (is_here ? 0 : 1);
        if (!section.empty() && measure < least)
          {
            least = measure;
            best  = section;
          }
      }
    return best.empty() ? "." : "; did you mean \"" + best + "\"?";
  }



  std::string
  DeclaredParameters::suggest_parameter(const std::vector<std::string> &path,
                                        const std::string &name) const
  {
    const std::string here = join_path(path);

    std::string  best;
    unsigned int least = 2 * internal::DeclaredParameters::tolerated(name) + 1;
    for (const auto &[section, members] : parameters)
      for (const Parameter &parameter : members)
        {
          const unsigned int measure =
            2 * internal::DeclaredParameters::unlikeness(name, parameter.name) +
            (section == here ? 0 : 1);
          if (measure < least)
            {
              least = measure;
              best  = "\"" + parameter.name + "\"";
              if (section != here)
                best += section.empty() ? " outside of all sections"
                                        : " in section \"" + section + "\"";
            }
        }
    return best.empty() ? "." : "; did you mean " + best + "?";
  }



  const DeclaredParameters::Parameter *
  DeclaredParameters::find(const std::vector<std::string> &path,
                           const std::string              &name) const
  {
    const auto section = parameters.find(join_path(path));
    if (section == parameters.end())
      return nullptr;
    for (const Parameter &parameter : section->second)
      if (parameter.name == name)
        return &parameter;
    return nullptr;
  }



  std::string
  join_path(const std::vector<std::string> &path)
  {
    std::string text;
    for (const std::string &section : path)
      text += (text.empty() ? "" : "/") + section;
    return text;
  }



  unsigned int
  edit_distance(const std::string &a, const std::string &b)
  {
    const std::string s = internal::DeclaredParameters::lower_case(a);
    const std::string t = internal::DeclaredParameters::lower_case(b);

    // d[i][j] is the distance of the first i letters of s to the first j of t.
    std::vector<std::vector<unsigned int>> d(
      s.size() + 1, std::vector<unsigned int>(t.size() + 1));
    for (unsigned int i = 0; i <= s.size(); ++i)
      for (unsigned int j = 0; j <= t.size(); ++j)
        if (i == 0 || j == 0)
          d[i][j] = i + j;
        else
          {
            const unsigned int cost = s[i - 1] == t[j - 1] ? 0 : 1;
            d[i][j]                 = std::min(
              {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + cost});
            if (i > 1 && j > 1 && s[i - 1] == t[j - 2] && s[i - 2] == t[j - 1])
              d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
          }
    return d[s.size()][t.size()];
  }
} // namespace Heddle
