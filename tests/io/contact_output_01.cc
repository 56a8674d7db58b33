// A contact element becomes one point with its data, also if two ranks hold it.
#include <heddle/base/file.h>
#include <heddle/io/contact_output.h>

#include "../tests.h"
#include "wavy_fabric.h"

#include <regex>

/** Number of points in all pieces of a VTU file. */
unsigned int
count_points(const std::string &file)
{
  const std::string text = Heddle::read_file(file, "VTU file");
  const std::regex  number("NumberOfPoints=\"([0-9]+)\"");
  unsigned int      n = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end;
       ++i)
    n += std::stoi((*i)[1]);
  return n;
}



int
main(int argc, char **argv)
{
  MPITest    test(argc, argv);
  WavyFabric fabric(MPI_COMM_WORLD);

  // A warp fiber over a weft fiber: on two ranks, both hold the element.
  const unsigned int                      a = 7, b = 14;
  std::vector<Heddle::System::GhostFiber> ghosts;
  for (const unsigned int f : {a, b})
    if (!fabric.space.owns(f))
      ghosts.push_back({f, fabric.space.all_nodes(f)});
  fabric.state.set_ghost_fibers(ghosts);

  Heddle::Contact::ContactElement element;
  element.fiber_a = a;
  element.fiber_b = b;
  element.zone    = 3;
  element.s_a     = 0.25 * fabric.space.fiber(a).length;
  element.s_b     = 0.75 * fabric.space.fiber(b).length;
  element.weight  = 0.02;
  element.gap     = -0.0004;
  element.force   = 1.5;
  element.penalty = 40.;
  element.normal  = Tensor<1, 3>({0., 0., 1.});

  Heddle::IO::ContactOutput output(fabric.space, "contact_output_01_files");
  const auto  patch = output.patch(element, fabric.state, /*zone_id=*/3);
  const auto &names = Heddle::IO::ContactOutput::fields();
  deallog << "at " << patch.vertices[0] << std::endl;
  for (unsigned int i = 1; i < names.size(); ++i)
    deallog << names[i] << " " << patch.data(i + 2, 0) << std::endl;

  output.write({element}, fabric.state, 0, 0., "settle");
  output.write({}, fabric.state, 1, 1., "settle");
  for (const std::string number : {"0", "1"})
    deallog << "points in file " << number << ": "
            << count_points("contact_output_01_files/contacts/contacts-0000" +
                            number + ".vtu")
            << std::endl;
}
