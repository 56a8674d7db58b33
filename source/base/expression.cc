#include <heddle/base/exceptions.h>
#include <heddle/base/expression.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <cctype>
#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

namespace Heddle
{
  namespace
  {
    /** What the parser complains about, without what deal.II puts around it. */
    std::string
    complaint(const ExceptionBase &exception)
    {
      std::ostringstream message;
      exception.print_info(message);
      std::string       words  = message.str();
      const std::string before = "said: ";
      if (words.find(before) != std::string::npos)
        words.erase(0, words.find(before) + before.size());
      words.erase(words.find_last_not_of(" .\n") + 1);
      return words;
    }



    /** Whether the parenthesis at @p position belongs to a function, as in
     * "min (". */
    bool
    is_call(const std::string &text, const std::size_t position)
    {
      const auto is_of_name = [](const unsigned char letter) {
        return std::isalnum(letter) || letter == '_';
      };
      std::size_t end = position;
      while (end > 0 && std::isspace(static_cast<unsigned char>(text[end - 1])))
        --end;
      std::size_t begin = end;
      while (begin > 0 && is_of_name(text[begin - 1]))
        --begin;
      return begin < end &&
             !std::isdigit(static_cast<unsigned char>(text[begin]));
    }



    /** Whether a comma stands elsewhere than between the arguments of a
     * function: the parser takes the last of such a list, 2 of "0,2". */
    bool
    has_stray_comma(const std::string &text)
    {
      std::vector<bool> calls = {false};
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '(')
          calls.push_back(is_call(text, i));
        else if (text[i] == ')' && calls.size() > 1)
          calls.pop_back();
        else if (text[i] == ',' && !calls.back())
          return true;
      return false;
    }



    /** While it lives nothing is printed: deal.II shows errors by itself. */
    class SilentErrors
    {
    public:
      SilentErrors()
        : screen(std::cerr.rdbuf(nullptr))
      {
      }

      ~SilentErrors()
      {
        std::cerr.rdbuf(screen);
      }

    private:
      std::streambuf *const screen;
    };
  } // namespace



  Expression::Expression(const std::string &text, const std::string &where)
    : text(text)
    , where(where)
    , parser(std::make_shared<FunctionParser<3>>(1))
  {
    require(!has_stray_comma(text),
            where + " is \"" + text +
              "\", with a comma outside of functions like min(x, y); give "
              "numbers with a decimal point.");
    try
      {
        const SilentErrors silent;
        parser->initialize("x,y,z,t",
                           text,
                           {{"pi", numbers::PI}},
                           /*time_dependent=*/true);
        parser->value(Point<3>());
      }
    catch (const ExceptionBase &exception)
      {
        throw InputError(
          where + " is \"" + text +
          "\", which cannot be evaluated: " + complaint(exception) +
          "; use numbers, the reference position x, y, z [mm], "
          "the load factor t, pi, and functions like sin(x).");
      }
  }



  double
  Expression::value(const Tensor<1, 3> &x, const double t) const
  {
    parser->set_time(t);
    const double result = parser->value(Point<3>(x));
    if (!std::isfinite(result))
      {
        std::ostringstream sentence;
        sentence << where << " is \"" << text << "\", which is no finite number"
                 << " at x = " << x[0] << ", y = " << x[1] << ", z = " << x[2]
                 << ", t = " << t << '.';
        throw InputError(sentence.str());
      }
    return result;
  }
} // namespace Heddle
