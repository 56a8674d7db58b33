// Fibers that stand for the filaments of a yarn weigh what it weighs, and
// stretch, bend and twist together as all of its filaments do.
#include <heddle/base/exceptions.h>
#include <heddle/simulation/fiber_placement.h>
#include <heddle/textile/linear_density.h>
#include <heddle/textile/weave.h>
#include <heddle/textile/weave_parameters.h>

#include <deal.II/base/numbers.h>

#include "../tests.h"

using namespace Heddle;



/** A glass yarn of @p tex in fibers for filaments of 9 micrometers across. */
std::string
glass(const std::string &tex, const std::string &more)
{
  return "subsection Weave\nsubsection Warp yarns\nset Fiber radius = 0.0045\n"
         "set Linear density = " +
         tex + "\nset Number of yarns = 1\nset Yarn spacing = 0.5\n" + more +
         "end\nend\n";
}



void
check(const unsigned int n_fibers)
{
  Textile::WeaveParameters    weave_parameters;
  Simulation::FiberParameters fiber_parameters;
  ParameterAcceptor::prm.parse_input_from_string(glass(
    "68",
    "set Density = 2.6\nset Fibers per bundle = " + std::to_string(n_fibers) +
      "\n"));
  ParameterAcceptor::parse_all_parameters();
  const auto           description = weave_parameters.description();
  const Textile::Weave weave(description);
  const auto           space =
    Simulation::make_space(weave.paths(4), fiber_parameters, MPI_COMM_WORLD);

  Beam::Section yarn;
  for (unsigned int f = 0; f < space->n_fibers(); ++f)
    if (space->fiber(f).yarn_id == 0)
      {
        const Beam::Section &section = space->fiber(f).section;
        yarn.axial += section.axial;
        yarn.bending += section.bending;
        yarn.torsion += section.torsion;
        yarn.gradient += section.gradient;
      }
  const Beam::Section filament = fiber_parameters.material.section(0.0045);
  const double        n =
    68. / (1000. * 2.6 * numbers::PI * 0.0045 * 0.0045); // filaments
  deallog << n_fibers << " fibers: "
          << Textile::yarns_in_words(description.warp, weave.warp_spacing())
          << "; over " << n << " filaments: tex "
          << Textile::linear_density(description.warp) << ", stretch "
          << yarn.axial / filament.axial / n << ", bending "
          << yarn.bending / filament.bending / n << ", torsion "
          << yarn.torsion / filament.torsion / n << ", section "
          << yarn.gradient / filament.gradient / n << std::endl;
}



void
refuse(const std::string &text)
{
  const Textile::WeaveParameters parameters;
  ParameterAcceptor::prm.parse_input_from_string(text);
  ParameterAcceptor::parse_all_parameters();
  try
    {
      parameters.description();
      deallog << "accepted" << std::endl;
    }
  catch (const InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  check(3);
  check(36);
  check(400);
  refuse(glass("68", "set Density = 2.6\nset Fibers per bundle = 500\n"));
  refuse(glass("68", "set Density = 0\nset Fibers per bundle = 12\n"));
  refuse(glass("68", "set Density = 2.6\nset Fiber radius = 0\n"));
}
