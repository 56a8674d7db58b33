#include <heddle/base/settings.h>

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <locale>
#include <map>
#include <sstream>

namespace Heddle
{
  namespace internal
  {
    namespace Settings
    {
      bool
      same_number(const std::string &a, const std::string &b)
      {
        std::istringstream first(a), second(b);
        // Whatever the user's language, the decimal point is a point.
        first.imbue(std::locale::classic());
        second.imbue(std::locale::classic());
        double x, y;
        return first >> x && first.eof() && second >> y && second.eof() &&
               x == y;
      }



      /** The values of a text by name. */
      std::map<std::string, std::string>
      read(const std::string &text)
      {
        std::map<std::string, std::string> values;
        std::istringstream                 lines(text);
        for (std::string line; std::getline(lines, line);)
          {
            const auto equals = line.find('=');
            if (equals != std::string::npos)
              values[line.substr(0, equals)] = line.substr(equals + 1);
          }
        return values;
      }



      std::string
      in_words(const std::string &value)
      {
        return value.empty() ? "empty" : value;
      }
    } // namespace Settings
  }   // namespace internal



  bool
  same_value(const std::string &a, const std::string &b)
  {
    const auto first  = Utilities::split_string_list(a);
    const auto second = Utilities::split_string_list(b);
    return a == b || std::equal(first.begin(),
                                first.end(),
                                second.begin(),
                                second.end(),
                                internal::Settings::same_number);
  }



  std::string
  settings_text(const ParameterHandler &prm)
  {
    std::ostringstream json;
    prm.print_parameters(json, ParameterHandler::ShortJSON);
    const nlohmann::json values = nlohmann::json::parse(json.str()).flatten();

    std::string text;
    for (const auto &[path, value] : values.items())
      if (value.is_string())
        text += path.substr(1) + "=" + value.get<std::string>() + "\n";
    return text;
  }



  std::vector<std::string>
  changed_settings(const std::string &before, const std::string &now)
  {
    const auto then = internal::Settings::read(before);

    std::vector<std::string> changes;
    for (const auto &[name, value] : internal::Settings::read(now))
      {
        const auto other = then.find(name);
        if (other != then.end() && !same_value(other->second, value))
          changes.push_back(name + " is " +
                            internal::Settings::in_words(value) + ", and was " +
                            internal::Settings::in_words(other->second));
      }
    return changes;
  }
} // namespace Heddle
