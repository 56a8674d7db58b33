// The parameter section describes a weave; weft yarns follow the warp yarns
// unless the user says otherwise.
#include <heddle/textile/weave_parameters.h>

#include <deal.II/base/parameter_acceptor.h>

#include "../tests.h"

using namespace Heddle::Textile;



void
print(const std::string &name, const YarnFamily &yarns)
{
  deallog << name << ": " << yarns.n_yarns << " yarns of "
          << yarns.packing.n_bundles << " x " << yarns.packing.fibers_per_bundle
          << (yarns.packing.layout == Layout::rows ? ", rows" : ", hexagonal")
          << ", radius " << yarns.packing.radius << ", seed "
          << yarns.packing.seed << ", spacing " << yarns.spacing << std::endl;
}



int
main()
{
  initlog();
  const WeaveParameters parameters;
  for (const std::string weft :
       {"",
        "subsection Weft yarns\nset Same as warp yarns = false\n"
        "set Number of yarns = 3\nset Yarn spacing = 0.5\nend\n"})
    {
      ParameterAcceptor::prm.parse_input_from_string(
        "subsection Weave\nset Pattern = twill 2/2\n"
        "set Start = interpenetrating\nsubsection Warp yarns\n"
        "set Number of yarns = 5\nset Bundles = 3\nset Packing = hexagonal\n"
        "set Fiber radius = 0.25\nset Packing seed = 7\nend\n" +
        weft + "end\n");
      ParameterAcceptor::parse_all_parameters();

      const WeaveDescription weave = parameters.description();
      deallog << weave.pattern
              << (weave.start == Start::crimped ? ", crimped"
                                                : ", interpenetrating")
              << std::endl;
      print("warp", weave.warp);
      print("weft", weave.weft);
    }
}
