// What a parameter allows is said in words.
#include <heddle/base/pattern_in_words.h>

#include <deal.II/base/patterns.h>

#include "../tests.h"

void
say(const Patterns::PatternBase &pattern)
{
  deallog << Heddle::pattern_in_words(pattern.description()) << std::endl;
}



int
main()
{
  initlog();
  say(Patterns::Double());
  say(Patterns::Double(0.));
  say(Patterns::Double(-1., 1.));
  say(Patterns::Double(std::numeric_limits<double>::lowest(), 3.));
  say(Patterns::Integer());
  say(Patterns::Integer(1));
  say(Patterns::Integer(1, 3));
  say(*Patterns::Tools::Convert<unsigned int>::to_pattern());
  say(Patterns::Bool());
  say(Patterns::Selection("plain|twill 2/2|satin"));
  say(Patterns::MultipleSelection("warp|weft"));
  say(Patterns::List(Patterns::Double(0.)));
  say(Patterns::List(Patterns::Integer(), 2, 4, ";"));
  say(*Patterns::Tools::Convert<Tensor<1, 3>>::to_pattern());
  say(Patterns::FileName());
  say(Patterns::DirectoryName());
  say(Patterns::Anything());
  say(Patterns::Map(Patterns::Anything(), Patterns::Double(0., 2.)));
  say(Patterns::Map(Patterns::Integer(1), Patterns::Bool(), 1, 2, ";"));
  say(Patterns::Map(Patterns::Integer(), Patterns::Bool(), 1, 2, ",", "="));
}
