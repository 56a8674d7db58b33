// What a user chooses by a word reaches the object as a value of an enum; its
// table of words is also what the parameter allows.
#include <heddle/base/choice.h>

#include "../tests.h"

#include <exception>
#include <sstream>

enum class Color
{
  red,
  dark_blue,
  none
};

constexpr const char *
word(const Color color)
{
  switch (color)
    {
      case Color::red:
        return "red";
      case Color::dark_blue:
        return "dark blue";
      case Color::none:
        return "none";
    }
  return nullptr;
}



struct Paint : ParameterAcceptor
{
  Paint()
    : ParameterAcceptor("/Paint")
  {
    Heddle::add_choice(*this, "Color", color, "Its color [-].");
    enter_subsection("Border");
    Heddle::add_choice(*this, "Color", border, "Of its border [-].");
    leave_subsection();
    Heddle::add_choices(*this, "Stripes", stripes, "Of its stripes [-].");
  }

  Color              color   = Color::dark_blue;
  Color              border  = Color::none;
  std::vector<Color> stripes = {Color::none};
};



std::string
in_words(const std::vector<Color> &colors)
{
  std::string words;
  for (const Color color : colors)
    words += std::string(", stripe ") + word(color);
  return words;
}



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();

  deallog << "allowed: " << Heddle::words_of_choice<Color>() << std::endl;

  Paint             paint;
  ParameterHandler &prm = ParameterAcceptor::prm;
  ParameterAcceptor::declare_all_parameters();
  deallog << "by default: " << word(paint.color) << ", border "
          << word(paint.border) << in_words(paint.stripes) << std::endl;
  std::ostringstream text;
  prm.print_parameters(text, ParameterHandler::ShortText);
  deallog << text.str() << std::endl;

  prm.parse_input_from_string("subsection Paint\n set Color =  red \n"
                              " set Stripes = dark blue ,red\n"
                              " subsection Border\n set Color = dark blue\n"
                              " end\nend\n");
  ParameterAcceptor::parse_all_parameters();
  deallog << "as set: " << word(paint.color) << ", border "
          << word(paint.border) << in_words(paint.stripes) << std::endl;

  for (const std::string text : {"dark blue", " none ", "blue"})
    try
      {
        const Color color = Heddle::choice<Color>(text);
        deallog << "\"" << text << "\" is number " << static_cast<int>(color)
                << std::endl;
      }
    catch (const ExceptionBase &error)
      {
        std::ostringstream sentence;
        error.print_info(sentence);
        deallog << "refused: " << sentence.str() << std::flush;
      }
}
