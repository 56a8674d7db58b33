// A write that is cut short leaves the last checkpoint; old ones go; files of
// other fibers, of another layout, or none at all are refused in one sentence.
#include <heddle/base/exceptions.h>
#include <heddle/io/checkpoint.h>
#include <heddle/io/hdf5_archive.h>

#include "../tests.h"
#include "wavy_fabric.h"

#include <filesystem>
#include <fstream>
#include <functional>

using Heddle::IO::Checkpoint;

void
report(const std::function<void()> &action)
{
  try
    {
      action();
      deallog << "no error" << std::endl;
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



int
main(int argc, char **argv)
{
  MPITest           test(argc, argv);
  WavyFabric        fabric(MPI_COMM_WORLD);
  const std::string directory     = "checkpoint_02_files";
  const auto        nothing_saved = [](Heddle::ArchiveWriter &) {};
  const auto        nothing_read  = [](const Heddle::ArchiveReader &) {};
  std::filesystem::remove_all(directory);

  report([&]() { Checkpoint::last(directory); });

  const Checkpoint     checkpoint(fabric.space, directory, /*n_kept=*/2);
  Checkpoint::Position position;
  for (position.number = 1; position.number <= 5; ++position.number)
    checkpoint.write(position, fabric.state, nothing_saved);
  deallog << "last " << Checkpoint::last(directory) << ", step 3 is there: "
          << std::filesystem::exists(directory + "/checkpoint/step-00003.h5")
          << std::endl;

  try
    {
      checkpoint.write(position, fabric.state, [](Heddle::ArchiveWriter &) {
        throw std::runtime_error("a fault while saving");
      });
    }
  catch (const std::runtime_error &error)
    {
      deallog << error.what() << ", last " << Checkpoint::last(directory)
              << ", part left: "
              << std::filesystem::exists(directory +
                                         "/checkpoint/step-00006.h5.part")
              << std::endl;
    }

  const std::string last = Checkpoint::last(directory);
  report([&]() { checkpoint.read(last, fabric.state, nothing_read); });
  report([&]() {
    checkpoint.read(last, fabric.state, [](const Heddle::ArchiveReader &file) {
      file.read_number("fiber contact/slip");
    });
  });

  auto others = WavyFabric::fibers();
  others[9].element_lengths[4] *= 1.1;
  const auto read_as =
    [&](const std::vector<Heddle::System::FiberSpace::Description> &fibers) {
      const Heddle::System::FiberSpace space(
        MPI_COMM_WORLD, Heddle::Beam::make_element("hermite", 3), fibers);
      Heddle::System::State state(space);
      Checkpoint(space, directory, 2).read(last, state, nothing_read);
    };
  report([&]() { read_as(others); });
  others.pop_back();
  report([&]() { read_as(others); });

  const std::string text_file = directory + "/checkpoint/step-00008.h5";
  std::ofstream(text_file) << "not HDF5";
  report([&]() { checkpoint.read(text_file, fabric.state, nothing_read); });

  {
    Heddle::IO::Hdf5Writer other_layout(text_file, MPI_COMM_WORLD);
    other_layout.write_number("schema", 99);
    other_layout.commit();
  }
  report([&]() { checkpoint.read(text_file, fabric.state, nothing_read); });
}
