// What a parameter file sets reaches the objects, and what is wrong in it is
// told with words for what is allowed and with the name that was meant.
#include <heddle/base/declared_parameters.h>
#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/parameter_file.h>
#include <heddle/base/pattern_in_words.h>
#include <heddle/base/settings.h>

#include <deal.II/base/patterns.h>

#include "../tests.h"

#include <memory>

struct Support : ParameterAcceptor
{
  Support(const unsigned int number)
    : ParameterAcceptor("/Supports/Support " + std::to_string(number))
  {
    add_parameter("Fibers", fibers, "[-]");
    add_parameter("Value", value, "[mm]");
  }

  std::string fibers = "all";
  double      value  = 0.;
};



/**
 * The values of a file, of what it includes from another folder, and of the
 * command line reach the objects, the last one wins; numbered sections are
 * counted before anything is declared.
 */
void
values()
{
  Heddle::create_folder("parts/more");
  Heddle::write_file("parts/one.prm",
                     "subsection Supports\n"
                     "  subsection Support 1\n"
                     "    set Fibers = 0, 1 # the first two\n"
                     "    include more/value.prm\n"
                     "  end\n"
                     "end\n");
  Heddle::write_file("parts/more/value.prm", "set Value = 1.5");
  Heddle::write_file("scene.prm",
                     "include parts/one.prm\n"
                     "subsection Supports\n"
                     "  subsection Support 2\n"
                     "    set Fibers = 3,\\\n"
                     "                 4\n"
                     "    set Value = 7\n"
                     "  end\n"
                     "end\n");

  Heddle::ParameterFile file("scene.prm");
  file.set("Supports/Support 3/Fibers=a = b");
  file.set("Supports/Support 2/Value = 8");

  const unsigned int n_supports = file.count_sections("/Supports", "Support");
  deallog << n_supports << " supports, "
          << file.count_sections("/Supports", "Load") << " loads, "
          << file.count_sections("/", "Support") << " elsewhere" << std::endl;
  deallog << "mentions supports " << file.mentions("/Supports") << ", value 1 "
          << file.mentions("Supports/Support 1/Value") << ", value 3 "
          << file.mentions("Supports/Support 3/Value") << std::endl;

  std::vector<std::unique_ptr<Support>> supports;
  for (unsigned int n = 1; n <= n_supports; ++n)
    supports.push_back(std::make_unique<Support>(n));
  file.apply();
  for (const auto &support : supports)
    deallog << "fibers " << support->fibers << " value " << support->value
            << std::endl;

  file.set("Supports/Support 5/Value=1");
  try
    {
      file.count_sections("Supports", "Support");
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



void
compare_values(const std::string &a, const std::string &b)
{
  deallog << '\'' << a << "' and '" << b
          << "': " << (Heddle::same_value(a, b) ? "the same" : "not the same")
          << std::endl;
}



/**
 * Values are compared as numbers where they are numbers, and else as texts.
 */
void
equal_values()
{
  compare_values("0", "0.0");
  compare_values("1e-3", "0.001");
  compare_values("0.1", "0.10000000001");
  compare_values("0, 0, 0", "0.0,0,-0");
  compare_values("0, 0, 0", "0, 0");
  compare_values("0, 0", "0, 1");
  compare_values("", "0");
  compare_values("", "");
  compare_values("true", "true");
  compare_values("true", "false");
  compare_values("1*t", "1.0*t");
  compare_values("warp: 0.1", "warp: 0.10");
}



/**
 * The distance of two names counts letters inserted, deleted, replaced and
 * exchanged with their neighbor.
 */
void
distance_of_names()
{
  const std::vector<std::pair<std::string, std::string>> pairs = {
    {"Friction", "friction"},
    {"Friction", "Frictoin"},
    {"Cell", "Cells"},
    {"Gells", "Cells"},
    {"", "Cells"},
    {"Warp", "Weft"}};
  for (const auto &[a, b] : pairs)
    deallog << a << " - " << b << ": " << Heddle::edit_distance(a, b)
            << std::endl;
}



void
say(const Patterns::PatternBase &pattern)
{
  deallog << Heddle::pattern_in_words(pattern.description()) << std::endl;
}



/** What a parameter allows is said in words. */
void
allowed_values()
{
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



struct Friction : ParameterAcceptor
{
  Friction()
    : ParameterAcceptor("/Contact/Friction")
  {
    add_parameter("Coefficient", coefficient, "[-]", prm, Patterns::Double(0.));
    add_parameter(
      "Law", law, "[-]", prm, Patterns::Selection("none|coulomb|stick"));
    add_parameter("Slip length", slip, "[mm]");
    add_parameter("Sections", n_sections, "[-]");
    add_parameter("Direction", direction, "[-]");
    parse_parameters_call_back.connect([this]() {
      AssertThrow(coefficient > 0. || law == "none",
                  ExcMessage("Contact/Friction: the law \"" + law +
                             "\" needs a positive Coefficient."));
    });
  }

  double       coefficient = 0.3;
  double       slip        = 1.;
  unsigned int n_sections  = 1;
  std::string  law         = "coulomb";
  Tensor<1, 3> direction;
};

struct Mesh : ParameterAcceptor
{
  Mesh()
    : ParameterAcceptor("/Mesh")
  {
    add_parameter("Cells", cells, "[-]", prm, Patterns::Integer(1, 50));
  }

  int cells = 2;
};



void
answer(const std::string &text, const std::string &assignment = "")
{
  ParameterAcceptor::clear();
  const Friction friction;
  const Mesh     mesh;
  Heddle::write_file("scene.prm", text);
  try
    {
      Heddle::ParameterFile file("scene.prm");
      if (!assignment.empty())
        file.set(assignment);
      file.apply();
      deallog << "no error" << std::endl;
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



/** Put one statement into the section Contact/Friction, on line 3. */
void
answer_to_friction(const std::string &statement)
{
  answer("subsection Contact\n subsection Friction\n  " + statement +
         "\n end\nend\n");
}



/**
 * Each mistake in a parameter file is answered by one sentence that says where
 * it is, what was found, and what is allowed or was meant.
 */
void
errors()
{
  deallog.push("names");
  answer_to_friction("set Coeficient = 0.1");
  answer_to_friction("set cells = 4");
  answer_to_friction("set Length = 4");
  answer_to_friction("set Temperature = 4");
  answer("set Coefficient = 0.1");
  answer("subsection Contcat\nend");
  answer("subsection Friction\nend");
  answer("subsection Weather\nend");
  deallog.pop();

  deallog.push("values");
  answer_to_friction("set Coefficient = -1");
  answer_to_friction("set Coefficient = nan");
  answer_to_friction("set Coefficient = # none");
  answer_to_friction("set Law = viscous");
  answer_to_friction("set Sections = -1");
  answer_to_friction("set Direction = 1, 0");
  answer("subsection Mesh\nset Cells = 51\nend");
  answer("subsection Mesh\nset Cells = 2.5\nend");
  deallog.pop();

  deallog.push("statements");
  answer("subsection Mesh\n");
  answer("end\n");
  answer("subsection\n");
  answer("# a comment\nsett Cells = 3\n");
  answer("set Cells\n");
  answer("subsection Mesh\nset Cells \\\n  = 3\nend now\n");
  answer("\n\ninclude none.prm");
  answer("include scene.prm");
  answer("subsection Mesh\nset Cells = 3\nend\nsubsection Mesh\n"
         "set Cells = 4\nend\n");
  deallog.pop();

  deallog.push("text");
  answer("subsection Mesh\rset Cells = 51\rend\r");
  answer("subsection Mesh\r\nset Cells = 51\r\nend\r\n");
  answer(std::string("s\0e\0t\0", 6));
  answer(std::string("\xFF\xFE"
                     "#\0",
                     4));
  deallog.pop();

  deallog.push("command line");
  answer("", "Mesh/Cells=0");
  answer("", "Mesh/Cell=1");
  answer("", "Mash/Cells=1");
  answer("", "Mesh/Cells");
  answer("", "=3");
  answer("", "/Mesh/Cells = 3");
  deallog.pop();

  deallog.push("file");
  for (const std::string name : {"missing.prm", "."})
    try
      {
        const Heddle::ParameterFile file(name);
      }
    catch (const Heddle::InputError &error)
      {
        deallog << error.what() << std::endl;
      }
  deallog.pop();

  // Last, because deal.II's handler is left inside the section that complained.
  deallog.push("combination");
  answer_to_friction("set Coefficient = 0");
  deallog.pop();
}



int
main()
{
  initlog();
  run_part("Values of files and of the command line", values);
  run_part("Values that are the same", equal_values);
  run_part("Distance of names", distance_of_names);
  run_part("What is allowed, in words", allowed_values);
  run_part("Errors", errors);
}
