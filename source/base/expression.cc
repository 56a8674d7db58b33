#include <heddle/base/exceptions.h>
#include <heddle/base/expression.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <cmath>
#include <iostream>
#include <sstream>

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
