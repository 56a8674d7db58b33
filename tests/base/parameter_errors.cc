// Each mistake in a parameter file is answered by one sentence that says where
// it is, what was found, and what is allowed or was meant.
#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/parameter_file.h>

#include "../tests.h"

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



int
main()
{
  initlog();

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
