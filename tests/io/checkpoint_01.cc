// What one rank writes, all ranks read, and what all ranks write, one reads:
// fibers, a table of the elements, and records found by their keys.
#include <heddle/io/checkpoint.h>

#include "../tests.h"
#include "wavy_fabric.h"

using Heddle::IO::Checkpoint;

/** A number that belongs to element @p e of fiber @p f. */
double
number(const unsigned int f, const unsigned int e)
{
  return f + 0.01 * e;
}



void
write(const MPI_Comm communicator, const std::string &directory)
{
  WavyFabric fabric(communicator);
  fabric.state.step        = 7;
  fabric.state.load_factor = 0.35;

  const auto          owned = fabric.space.owned_fibers();
  std::vector<double> strains;
  Heddle::Records     records;
  records.n_key_parts = 2;
  for (unsigned int f = owned.first; f < owned.second; ++f)
    for (unsigned int e = 0; e < WavyFabric::n_elements; ++e)
      {
        strains.push_back(number(f, e));
        if ((f + e) % 5 == 0)
          {
            records.keys.push_back(f);
            records.keys.push_back(WavyFabric::n_elements - e);
            records.values.push_back(number(f, e));
          }
      }

  Checkpoint::Position position;
  position.stage    = "settle";
  position.number   = 12;
  position.settings = "Contact/Threshold=0.02\n";
  Checkpoint(fabric.space, directory, /*n_kept=*/2)
    .write(position, fabric.state, [&](Heddle::ArchiveWriter &archive) {
      archive.write("fiber elasticity/strains",
                    owned.first * WavyFabric::n_elements,
                    fabric.space.n_fibers() * WavyFabric::n_elements,
                    strains);
      archive.write("fiber contact/zones", records);
    });
}



/** Return the number of numbers that are not as they were written. */
unsigned int
read(const MPI_Comm communicator, const std::string &directory)
{
  WavyFabric   fabric(communicator);
  const auto   written = fabric.state.current();
  unsigned int n_wrong = 0, n_records = 0;
  for (unsigned int b = 0; b < written.size(); ++b)
    fabric.state.fiber(fabric.space.owned_fibers().first)[b] = 0.;

  const auto position =
    Checkpoint(fabric.space, directory, /*n_kept=*/2)
      .read(
        Checkpoint::last(directory, communicator),
        fabric.state,
        [&](const Heddle::ArchiveReader &archive) {
          const auto owned = fabric.space.owned_fibers();
          const auto strains =
            archive.read("fiber elasticity/strains",
                         owned.first * WavyFabric::n_elements,
                         (owned.second - owned.first) * WavyFabric::n_elements);
          auto strain = strains.begin();
          for (unsigned int f = owned.first; f < owned.second; ++f)
            for (unsigned int e = 0; e < WavyFabric::n_elements; ++e)
              n_wrong += (*strain++ != number(f, e));

          const auto records = archive.read_records(
            "fiber contact/zones",
            [&](const std::int64_t *key) { return fabric.space.owns(key[0]); });
          n_records = records.size();
          for (unsigned int i = 0; i < n_records; ++i)
            n_wrong += (records.value(i)[0] !=
                        number(records.key(i)[0],
                               WavyFabric::n_elements - records.key(i)[1])) ||
                       (i > 0 && records.key(i - 1)[0] > records.key(i)[0]);
        });
  for (unsigned int b = 0; b < written.size(); ++b)
    n_wrong += (fabric.state.current()[b] != written[b]) ||
               (fabric.state.accepted()[b] != written[b]);

  deallog << "stage " << position.stage << ", number " << position.number
          << ", step " << fabric.state.step << ", load factor "
          << fabric.state.load_factor << ", " << position.settings.size()
          << " letters of settings, records "
          << Utilities::MPI::sum(n_records, communicator) << std::endl;
  return Utilities::MPI::sum(n_wrong, communicator);
}



int
main(int argc, char **argv)
{
  MPITest    test(argc, argv);
  const bool first_rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  if (first_rank)
    write(MPI_COMM_SELF, "checkpoint_01_one");
  MPI_Barrier(MPI_COMM_WORLD);
  unsigned int n_wrong = read(MPI_COMM_WORLD, "checkpoint_01_one");
  deallog << "wrong numbers " << n_wrong << std::endl;

  write(MPI_COMM_WORLD, "checkpoint_01_all");
  if (first_rank)
    n_wrong = read(MPI_COMM_SELF, "checkpoint_01_all");
  deallog << "wrong numbers " << n_wrong << std::endl;
}
