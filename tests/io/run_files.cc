// What a run leaves to read and to go on from: its summary, its history, and
// checkpoints, of which the last complete one counts.
#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/io/checkpoint.h>
#include <heddle/io/collection.h>
#include <heddle/io/hdf5_archive.h>
#include <heddle/io/history.h>
#include <heddle/io/summary.h>

#include "../tests.h"
#include "wavy_fabric.h"

#include <filesystem>
#include <fstream>
#include <functional>

using Heddle::IO::Checkpoint;

/**
 * The summary of a run that did not converge, and a history that goes on after
 * a restart.
 */
void
summary_and_history()
{
  Heddle::IO::Summary summary;
  summary.status        = Heddle::IO::Status::not_converged;
  summary.reason        = "The step fell below 1e-4 in the stage \"settle\".";
  summary.n_fibers      = 28;
  summary.n_fiber_nodes = 700;
  summary.n_dofs        = 4200;
  summary.contributions = {"fiber elasticity", "fiber contact"};
  summary.results       = {{"crimp_warp[-]", 0.125}};

  Heddle::IO::StageSummary stage;
  stage.name                  = "settle";
  stage.status                = Heddle::IO::Status::not_converged;
  stage.steps                 = 3;
  stage.newton_iterations     = 21;
  stage.contact_elements      = 900;
  stage.n_dofs_per_rank       = 2400;
  stage.max_penetration_ratio = 0.0175;
  stage.wall_time.total       = 2.5;
  summary.stages.push_back(stage);
  deallog << summary.json() << std::endl;

  // Of a composite it says how large the matrix is.
  summary.stages.clear();
  summary.matrix = {/*n_cells=*/400,
                    /*n_nodes=*/605,
                    /*n_links=*/96,
                    /*n_assemblies=*/1,
                    /*volume=*/0.5,
                    /*doubled_volume=*/0.125,
                    /*ply_thickness=*/0.375,
                    /*ply_volume_fraction=*/0.4375};
  deallog << summary.json() << std::endl;

  Heddle::create_folder("summary_files");
  summary.write("summary_files");

  const std::vector<Heddle::IO::History::Column> measured = {{"force", "N"}};
  Heddle::IO::History history("summary_files", MPI_COMM_WORLD, measured);
  history.add({{"step", 1}, {"load_factor", 0.5}, {"force", 2.5}});
  const std::string saved = history.csv();
  history.add({{"step", 2}, {"load_factor", 1.}, {"force", 77.}});

  Heddle::IO::History resumed("summary_files", MPI_COMM_WORLD, measured);
  resumed.resume(saved);
  resumed.add({{"step", 2}, {"load_factor", 1.}, {"force", 5.}});
  deallog << Heddle::read_file("summary_files/history.csv", "history")
          << std::endl;
}



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



/**
 * A write that is cut short leaves the last checkpoint; old ones go; files of
 * other fibers, of another layout, or none at all are refused in one sentence.
 */
void
checkpoints()
{
  WavyFabric        fabric(MPI_COMM_WORLD);
  const std::string directory     = "checkpoint_files";
  const auto        nothing_saved = [](Heddle::ArchiveWriter &) {};
  const auto        nothing_read  = [](const Heddle::ArchiveReader &) {};
  std::filesystem::remove_all(directory);

  report([&]() { Checkpoint::last(directory, MPI_COMM_WORLD); });

  const Checkpoint     checkpoint(fabric.space, directory, /*n_kept=*/2);
  Checkpoint::Position position;
  for (position.number = 1; position.number <= 5; ++position.number)
    checkpoint.write(position, fabric.state, nothing_saved);
  deallog << "last " << Checkpoint::last(directory, MPI_COMM_WORLD)
          << ", step 3 is there: "
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
      deallog << error.what() << ", last "
              << Checkpoint::last(directory, MPI_COMM_WORLD) << ", part left: "
              << std::filesystem::exists(directory +
                                         "/checkpoint/step-00006.h5.part")
              << std::endl;
    }

  const std::string last = Checkpoint::last(directory, MPI_COMM_WORLD);
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
        MPI_COMM_WORLD,
        Heddle::Beam::make_element(Heddle::Beam::ElementKind::hermite, 3),
        fibers);
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



/** Numbers of more digits than others follow these, when a run goes on too. */
void
list_of_pictures()
{
  Heddle::create_folder("pictures_files");
  Heddle::IO::Collection before("pictures_files", "fibers", MPI_COMM_WORLD, 0);
  for (const unsigned int number : {2, 99999, 100000, 100001})
    before.add(number, number, "load");
  const Heddle::IO::Collection after(
    "pictures_files", "fibers", MPI_COMM_WORLD, 100001);
  std::ifstream file("pictures_files/fibers.pvd");
  for (std::string line; std::getline(file, line);)
    deallog << line << std::endl;
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Summary and history", summary_and_history);
  run_part("Checkpoints", checkpoints);
  run_part("List of pictures", list_of_pictures);
}
