#ifndef heddle_base_expression_h
#define heddle_base_expression_h

#include <deal.II/base/tensor.h>

#include <memory>
#include <string>

namespace dealii
{
  template <int dim>
  class FunctionParser;
}

namespace Heddle
{
  using namespace dealii;

  /**
   * A number that a user gives as a formula of a position x, y, z [mm] and the
   * load factor t, as in "0.5*t*sin(pi*x/10)".
   */
  class Expression
  {
  public:
    /**
     * Throw InputError if @p text is no formula. @p where says in messages
     * which parameter this is, as in `Loads/Load 1: "Force x"`.
     */
    Expression(const std::string &text, const std::string &where);

    /**
     * Return the value at the position @p x and the load factor @p t. Throw
     * InputError if that is not a finite number.
     */
    double
    value(const Tensor<1, 3> &x, const double t) const;

  private:
    std::string                        text;
    std::string                        where;
    std::shared_ptr<FunctionParser<3>> parser;
  };
} // namespace Heddle

#endif
