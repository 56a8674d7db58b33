// What is drawn of fibers and of their contact, the same on any number of
// ranks.
#include <heddle/base/file.h>
#include <heddle/io/contact_output.h>
#include <heddle/io/fiber_output.h>

#include "../tests.h"
#include "wavy_fabric.h"

#include <regex>

/**
 * The lines of a stretched wavy fabric lie on its centerlines, carry their
 * strains and displacements, and are the same on any number of ranks.
 */
void
fibers()
{
  WavyFabric fabric(MPI_COMM_WORLD);

  const auto                      initial = fabric.state.current();
  const std::vector<Tensor<1, 3>> lift(initial.size(),
                                       Tensor<1, 3>({0., 0., 0.25}));
  for (unsigned int b = 0; b < initial.size(); b += 2)
    fabric.state.fiber(fabric.space.owned_fibers().first)[b] += lift[b];

  std::vector<double> zero(Heddle::Beam::Element::max_strains);
  const auto          no_strain = [&](const unsigned int, const unsigned int) {
    return zero.data();
  };

  Heddle::IO::FiberOutput output(fabric.space,
                                 /*n_subdivisions=*/3,
                                 "fiber_files");

  double     off_the_wave = 0., strain_error = 0., lift_error = 0., total = 0.;
  const auto owned = fabric.space.owned_fibers();
  for (unsigned int f = owned.first; f < owned.second; ++f)
    {
      const auto patch     = output.patch(fabric.state, initial, no_strain, f);
      const unsigned int n = patch.data.n_rows();
      for (unsigned int i = 0; i <= patch.n_subdivisions; ++i)
        {
          // Lift undone, the height is that of the wave at this place.
          const bool   warp  = patch.data(7, i) > 0.5;
          const double along = patch.data(n - (warp ? 3 : 2), i);
          const auto wave = WavyFabric::position(f, along / WavyFabric::length);
          off_the_wave    = std::max<double>(
            off_the_wave, std::abs(patch.data(n - 1, i) - 0.25 - wave[2]));
          lift_error =
            std::max<double>(lift_error, std::abs(patch.data(2, i) - 0.25));
          strain_error = std::max<double>(
            strain_error, std::abs(patch.data(9, i) - WavyFabric::strain));
        }
      total += patch.data(8, patch.n_subdivisions);
    }
  const auto maximum = [](const double value) {
    return Utilities::MPI::max(value, MPI_COMM_WORLD);
  };
  deallog << "fields " << output.fields().size() << ", total length "
          << Utilities::MPI::sum(total, MPI_COMM_WORLD) << std::endl
          << "on the wave within 1e-3: " << (maximum(off_the_wave) < 1e-3)
          << ", lifted within 1e-6: " << (maximum(lift_error) < 1e-6)
          << ", strained within 1e-4: " << (maximum(strain_error) < 1e-4)
          << std::endl;

  for (const unsigned int number : {0, 1})
    output.write(
      fabric.state, initial, no_strain, number, 0.5 * number, "settle");
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    deallog << Heddle::read_file("fiber_files/fibers.pvd", "series")
            << std::endl;
}



/** Number of points in all pieces of a VTU file, each of which must say so. */
unsigned int
count_points(const std::string &file)
{
  const std::string text      = Heddle::read_file(file, "VTU file");
  const auto        number_of = [&text](const std::string &words) {
    const std::regex pattern(words);
    return std::distance(
      std::sregex_iterator(text.begin(), text.end(), pattern),
      std::sregex_iterator());
  };
  deallog << "pieces " << number_of("<Piece") << ", with points "
          << number_of("<Points") << ": ";
  const std::regex number("NumberOfPoints=\"([0-9]+)\"");
  unsigned int     n = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end;
       ++i)
    n += std::stoi((*i)[1]);
  return n;
}



/**
 * A contact element becomes one point with its data, also if two ranks hold it.
 */
void
contacts()
{
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

  const Heddle::Contact::TangentialForce friction = {
    Tensor<1, 3>({0.1, -0.2, 0.}), 0.75};

  Heddle::IO::ContactOutput output(fabric.space,
                                   /*with_friction=*/true,
                                   "contact_files");
  const auto                patch =
    output.patch(element, &friction, fabric.state, /*zone_id=*/3);
  const auto names = Heddle::IO::ContactOutput::fields(true);
  deallog << "at " << patch.vertices[0] << std::endl;
  unsigned int row = 0;
  for (const std::string &name : names)
    for (unsigned int d = 0; d < (name.back() == ']' ? 3 : 1); ++d)
      deallog << name << " " << patch.data(row++, 0) << std::endl;

  output.write({element}, {friction}, fabric.state, 0, 0., "settle");
  output.write({}, {}, fabric.state, 1, 1., "settle");
  for (const std::string number : {"0", "1"})
    deallog << "points in file " << number << ": "
            << count_points("contact_files/contacts/contacts-0000" + number +
                            ".vtu")
            << std::endl;
}



/** Sections point where the first of their vectors does, whatever its size. */
void
sections()
{
  Heddle::System::FiberSpace::Description fiber;
  fiber.element_lengths = {0.5, 0.5};
  fiber.radius          = 0.1;
  fiber.section = Heddle::Beam::circular_section(0.1, 1000., 400., 0.25);
  const Heddle::System::FiberSpace space(
    MPI_COMM_WORLD,
    Heddle::Beam::make_element(Heddle::Beam::ElementKind::director,
                               /*degree=*/1),
    {fiber});
  Heddle::System::State state(space);
  const auto            owned   = space.owned_fibers();
  const auto            turning = [](const unsigned int node) {
    return Tensor<1, 3>({0., std::cos(0.4 * node), std::sin(0.4 * node)});
  };
  for (unsigned int f = owned.first; f < owned.second; ++f)
    for (unsigned int node = 0; node < 3; ++node)
      {
        Tensor<1, 3> *blocks = state.fiber(f) + 3 * node;
        blocks[0]            = Tensor<1, 3>({0.5 * node, 0., 0.});
        blocks[1]            = 0.9 * turning(node);
        blocks[2] =
          1.2 * cross_product_3d(Tensor<1, 3>({1., 0., 0.}), blocks[1]);
      }

  // Its three numbers are the last ones before the position.
  const Heddle::IO::FiberOutput output(space, /*n_subdivisions=*/1, "sections");
  std::vector<double>           zero(Heddle::Beam::Element::max_strains);
  double                        error = 0.;
  for (unsigned int f = owned.first; f < owned.second; ++f)
    {
      const auto patch = output.patch(
        state,
        state.current(),
        [&](const unsigned int, const unsigned int) { return zero.data(); },
        f);
      const unsigned int row = patch.data.n_rows() - 6;
      for (unsigned int node = 0; node < 3; ++node)
        for (unsigned int d = 0; d < 3; ++d)
          error = std::max<double>(
            error, std::abs(patch.data(row + d, node) - turning(node)[d]));
    }
  deallog << "fields " << output.fields().size() << ", last "
          << output.fields().back() << ", right within 1e-6: "
          << (Utilities::MPI::max(error, MPI_COMM_WORLD) < 1e-6) << std::endl;
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Fibers", fibers);
  run_part("Sections", sections);
  run_part("Contact elements", contacts);
}
