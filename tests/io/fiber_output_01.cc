// The lines of a stretched wavy fabric lie on its centerlines, carry their
// strains and displacements, and are the same on any number of ranks.
#include <heddle/base/file.h>
#include <heddle/io/fiber_output.h>

#include "../tests.h"
#include "wavy_fabric.h"

int
main(int argc, char **argv)
{
  MPITest    test(argc, argv);
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
                                 "fiber_output_01_files");

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
  deallog << "fields " << Heddle::IO::FiberOutput::fields().size()
          << ", total length " << Utilities::MPI::sum(total, MPI_COMM_WORLD)
          << std::endl
          << "on the wave within 1e-3: " << (maximum(off_the_wave) < 1e-3)
          << ", lifted within 1e-6: " << (maximum(lift_error) < 1e-6)
          << ", strained within 1e-4: " << (maximum(strain_error) < 1e-4)
          << std::endl;

  for (const unsigned int number : {0, 1})
    output.write(
      fabric.state, initial, no_strain, number, 0.5 * number, "settle");
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    deallog << Heddle::read_file("fiber_output_01_files/fibers.pvd", "series")
            << std::endl;
}
