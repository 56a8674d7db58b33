// Contributions that somebody adds to heddle's own share its names with them:
// those of two terms, and of two columns of the history, that are the same are
// refused in one sentence, and so is a column without a unit. External work
// alone is the sum of what all report.
#include <heddle/base/exceptions.h>
#include <heddle/simulation/recorder.h>

#include "../tests.h"

#include <fstream>

using namespace Heddle;

/** A term without forces, which reports 1. */
class Mute : public System::Contribution
{
public:
  Mute(const std::string &called, const std::string &reported)
    : called(called)
    , reported(reported)
  {
  }

  std::string
  name() const override
  {
    return called;
  }

  void
  assemble(const System::State &, System::BlockSystem &) override
  {
  }

  void
  report(const System::State &,
         std::map<std::string, double> &values) const override
  {
    values[reported] = 1.;
  }

private:
  const std::string called, reported;
};



/** A fiber that is held at one end. */
const std::string file_name = "one_fiber.prm";

void
write_scene()
{
  std::ofstream("one_fiber.csv") << "fiber,x,y,z,radius\n0,0,0,0,0.1\n"
                                    "0,5,0,0,0.1\n0,10,0,0,0.1\n";
  std::ofstream(file_name) << "subsection Run\n  set Scene = centerlines\nend\n"
                              "subsection Centerlines\n"
                              "  set File = one_fiber.csv\nend\n"
                              "subsection Supports\n  subsection Support 1\n"
                              "    set Section = held\n  end\nend\n";
}



void
try_two(const Mute &first, const Mute &second)
{
  ParameterAcceptor::clear();
  ParameterFile                file(file_name);
  const Simulation::Parameters parameters(file);
  try
    {
      Simulation::Scene scene(
        parameters, file_name, MPI_COMM_WORLD, [&](const auto &, const auto &) {
          return Solver::Contributions{std::make_shared<Mute>(first),
                                       std::make_shared<Mute>(second)};
        });
      SectionTimer               timer;
      const Simulation::Recorder recorder(
        scene, parameters, file, "results", timer);
      deallog << "external work " << scene.report()["external_work[N*mm]"]
              << std::endl;
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
  write_scene();
  try_two({"wind", "external_work[N*mm]"}, {"rain", "external_work[N*mm]"});
  try_two({"wind", "gusts[-]"}, {"wind", "drops[-]"});
  try_two({"wind", "gusts[-]"}, {"supports", "drops[-]"});
  try_two({"wind", "gusts[-]"}, {"rain", "gusts[-]"});
  try_two({"wind", "gusts[-]"}, {"rain", "bending_energy[N*mm]"});
  try_two({"wind", "gusts[-]"}, {"rain", "drops"});
  try_two({"wind", "gusts[-]"}, {"rain", "step[-]"});
}
