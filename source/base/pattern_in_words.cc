#include <heddle/base/pattern_in_words.h>

#include <deal.II/base/utilities.h>

#include <regex>

namespace Heddle
{
  using namespace dealii;

  namespace internal
  {
    namespace PatternInWords
    {
      /** Bounds that deal.II prints where it has none. */
      bool
      is_no_bound(const std::string &bound)
      {
        return bound == "MAX_DOUBLE" || bound == "-MAX_DOUBLE" ||
               bound == "2147483647" || bound == "-2147483648" ||
               bound == "4294967295";
      }



      std::string
      range(const std::string &lower, const std::string &upper)
      {
        const bool open_below = is_no_bound(lower);
        const bool open_above = is_no_bound(upper);
        if (open_below && open_above)
          return "";
        if (open_above)
          return " of at least " + lower;
        if (open_below)
          return " of at most " + upper;
        return " from " + lower + " to " + upper;
      }



      /** Return `"a", "b" or "c"` for "a|b|c ". */
      std::string
      choice(const std::string &alternatives)
      {
        std::string text;
        const auto  names = Utilities::split_string_list(alternatives, '|');
        for (unsigned int i = 0; i < names.size(); ++i)
          text += (i == 0                 ? ""
                   : i + 1 < names.size() ? ", "
                                          : " or ") +
                  ("\"" + names[i] + "\"");
        return text;
      }



      /** Of entries of any kind. */
      std::string
      list(const std::string &shortest,
           const std::string &longest,
           const std::string &separator)
      {
        const std::string length =
          shortest == longest                       ? " of length " + shortest
          : shortest == "0" && is_no_bound(longest) ? ""
          : shortest == "1" && is_no_bound(longest)
            ? " of one or more"
            : " of length" + range(shortest, longest);
        return "a list" + length + ", separated by \"" +
               (separator.empty() ? "," : separator) + "\"";
      }
    } // namespace PatternInWords
  }   // namespace internal



  std::string
  pattern_in_words(const std::string &description)
  {
    const auto is = [&description](const std::string &form,
                                   std::smatch       &parts) {
      return std::regex_match(description, parts, std::regex(form));
    };

    std::smatch parts;
    if (is("\\[Double (.*)\\.\\.\\.(.*) \\(inclusive\\)\\]", parts))
      return "a number" + internal::PatternInWords::range(parts[1], parts[2]);
    if (is("\\[Integer range (.*)\\.\\.\\.(.*) \\(inclusive\\)\\]", parts))
      return "an integer" + internal::PatternInWords::range(parts[1], parts[2]);
    if (description == "[Integer]")
      return "an integer of at least 0";
    if (description == "[Bool]")
      return "true or false";
    if (is("\\[Selection (.*)\\]", parts))
      return internal::PatternInWords::choice(parts[1]);
    if (is("\\[MultipleSelection (.*)\\]", parts))
      return "a list, separated by \",\", of " +
             internal::PatternInWords::choice(parts[1]);
    if (is("\\[List of <(.*)> of length (\\d+)\\.\\.\\.(\\d+) \\(inclusive\\)"
           "(?: separated by <(.*)>)?\\]",
           parts))
      return internal::PatternInWords::list(parts[2], parts[3], parts[4]) +
             ", each " + pattern_in_words(parts[1]);
    if (is("\\[Map of <(.*)>:<(.*)> of length (\\d+)\\.\\.\\.(\\d+) "
           "\\(inclusive\\)(?: separated by <(.*)>)?\\]",
           parts))
      return internal::PatternInWords::list(parts[3], parts[4], parts[5]) +
             ", of pairs \"A: B\", where A is " + pattern_in_words(parts[1]) +
             " and B is " + pattern_in_words(parts[2]);
    if (is("\\[FileName.*\\]", parts))
      return "the name of a file";
    if (description == "[DirectoryName]")
      return "the name of a folder";
    if (description == "[Anything]")
      return "any text";
    return "what matches " + description;
  }
} // namespace Heddle
