// The summary of a run that did not converge, and a history that goes on after
// a restart.
#include <heddle/base/file.h>
#include <heddle/io/history.h>
#include <heddle/io/summary.h>

#include "../tests.h"

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();

  Heddle::IO::Summary summary;
  summary.status        = Heddle::IO::Summary::Status::not_converged;
  summary.reason        = "The step fell below 1e-4 in the stage \"settle\".";
  summary.n_fibers      = 28;
  summary.n_fiber_nodes = 700;
  summary.n_dofs        = 4200;
  summary.contributions = {"fiber elasticity", "fiber contact"};
  summary.results       = {{"crimp_warp[-]", 0.125}};

  Heddle::IO::StageSummary stage;
  stage.name                  = "settle";
  stage.status                = "not converged";
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
                    /*doubled_volume=*/0.125};
  deallog << summary.json() << std::endl;

  Heddle::create_folder("summary_01_files");
  summary.write("summary_01_files");

  const std::vector<Heddle::IO::History::Column> measured = {{"force", "N"}};
  Heddle::IO::History history("summary_01_files", MPI_COMM_WORLD, measured);
  history.add({{"step", 1}, {"load_factor", 0.5}, {"force", 2.5}});
  const std::string saved = history.csv();
  history.add({{"step", 2}, {"load_factor", 1.}, {"force", 77.}});

  Heddle::IO::History resumed("summary_01_files", MPI_COMM_WORLD, measured);
  resumed.resume(saved);
  resumed.add({{"step", 2}, {"load_factor", 1.}, {"force", 5.}});
  deallog << Heddle::read_file("summary_01_files/history.csv", "history")
          << std::endl;
}
