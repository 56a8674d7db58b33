// How the ends of yarns move in each test of a fabric, dry and in a matrix:
// each fiber as the sheet does, which shears and gets wider or narrower, all of
// a yarn as one body, or across their yarn as they like.
#include <heddle/simulation/fabric_loading_parameters.h>

#include "../tests.h"

using namespace Heddle;

std::string
describe(const Contributions::Support &support)
{
  return support.slides_along       ? "they slide"
         : support.yarns_are_bodies ? "as one body"
                                    : "each with the sheet";
}



int
main()
{
  initlog();
  const Simulation::FabricLoadingParameters parameters;
  for (const auto &entries :
       {"set Kind = held",
        "set Kind = uniaxial tension",
        "set Kind = biaxial tension",
        "set Kind = picture frame",
        "set Kind = simple shear\nset Yarn ends = gripped",
        "set Kind = bending\nset Grip = both sides"})
    {
      ParameterAcceptor::prm.parse_input_from_string(
        std::string("subsection Fabric loading\n") + entries + "\nend");
      ParameterAcceptor::parse_all_parameters();
      const auto cases = [&](const bool matrix) {
        return parameters.cases({{"0", "1", "2", "3"}}, matrix)[0];
      };
      const auto dry = cases(false), embedded = cases(true);
      deallog << dry.name << ": " << describe(*dry.supports[0])
              << ", in a matrix " << describe(*embedded.supports[0])
              << std::endl;
    }
}
