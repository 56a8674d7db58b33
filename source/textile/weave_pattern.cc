#include <heddle/base/exceptions.h>
#include <heddle/textile/weave_pattern.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <regex>
#include <sstream>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      using Rows = std::vector<std::vector<bool>>;

      /** Fill the repeat by asking @p on_top(warp, weft). */
      Rows
      fill(const unsigned int                                     n_warp,
           const unsigned int                                     n_weft,
           const std::function<bool(unsigned int, unsigned int)> &on_top)
      {
        Rows rows(n_weft, std::vector<bool>(n_warp));
        for (unsigned int j = 0; j < n_weft; ++j)
          for (unsigned int i = 0; i < n_warp; ++i)
            rows[j][i] = on_top(i, j);
        return rows;
      }



      Rows
      twill(const unsigned int over, const unsigned int under)
      {
        const unsigned int n = over + under;
        return fill(n, n, [=](const unsigned int i, const unsigned int j) {
          return (i + n - j) % n < over;
        });
      }



      Rows
      satin(const unsigned int n, const unsigned int move)
      {
        if (move < 2 || move + 2 > n || std::gcd(n, move) != 1)
          throw InputError(
            "Weave pattern 'satin " + std::to_string(n) + "/" +
            std::to_string(move) +
            "' does not exist: the second number must lie between 2 and the "
            "first one minus 2 and have no common divisor with it, as in "
            "'satin 5/2' or 'satin 8/3'.");
        return fill(n, n, [=](const unsigned int i, const unsigned int j) {
          return i != (j * move) % n;
        });
      }



      Rows
      basket(const unsigned int n_warp, const unsigned int n_weft)
      {
        return fill(2 * n_warp,
                    2 * n_weft,
                    [=](const unsigned int i, const unsigned int j) {
                      return (i / n_warp + j / n_weft) % 2 == 0;
                    });
      }



      /** A weave that has a name and two numbers, which may be left out. */
      struct Named
      {
        std::string  name;
        unsigned int usual_m, usual_n;
        Rows (*build)(const unsigned int m, const unsigned int n);
      };

      const std::array<Named, 3> all_named = {{{"twill", 2, 2, twill},
                                               {"satin", 5, 2, satin},
                                               {"basket", 2, 2, basket}}};



      Rows
      build(const Named &weave, const unsigned int m, const unsigned int n)
      {
        if (m == 0 || n == 0 || m > 64 || n > 64)
          throw InputError("Weave pattern '" + weave.name + " " +
                           std::to_string(m) + "/" + std::to_string(n) +
                           "': both numbers must lie between 1 and 64.");
        return weave.build(m, n);
      }



      Rows
      matrix(const std::string &text)
      {
        Rows               rows;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line, ';');)
          {
            rows.emplace_back();
            for (const char c : line)
              if (c == '0' || c == '1')
                rows.back().push_back(c == '1');
            if (rows.back().empty() || rows.back().size() != rows[0].size())
              throw InputError("Weave pattern '" + text + "': row " +
                               std::to_string(rows.size()) + " has " +
                               std::to_string(rows.back().size()) +
                               " entries, but every row needs the same number "
                               "of them, at least one, as in '0 1; 1 0'.");
          }
        return rows;
      }
    } // namespace



    WeavePattern::WeavePattern(const std::string &text)
    {
      static const std::regex plain_form("\\s*plain\\s*");
      static const std::regex named_form(
        "\\s*([a-z]+)(\\s+(\\d{1,4})\\s*/\\s*(\\d{1,4}))?\\s*");
      static const std::regex matrix_form("[01;\\s]*[01][01;\\s]*");

      std::smatch match;
      const bool  is_name = std::regex_match(text, match, named_form);
      const auto  weave =
        std::find_if(all_named.begin(), all_named.end(), [&](const Named &one) {
          return is_name && match[1] == one.name;
        });
      if (std::regex_match(text, plain_form))
        rows = basket(1, 1);
      else if (weave != all_named.end())
        rows = match[2].matched
                 ? build(*weave, std::stoul(match[3]), std::stoul(match[4]))
                 : build(*weave, weave->usual_m, weave->usual_n);
      else if (std::regex_match(text, matrix_form))
        rows = matrix(text);
      else
        throw InputError("Weave pattern '" + text +
                         "' is unknown: give 'plain', 'twill 2/2', 'satin "
                         "5/2', 'basket 2/2' (with numbers of your choice; "
                         "without them these are taken) or "
                         "a matrix like '0 1; 1 0' (rows are weft yarns, 1 "
                         "means warp on top).");
    }
  } // namespace Textile
} // namespace Heddle
