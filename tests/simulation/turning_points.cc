// Load steps hit the places at which the ramp of a fabric's test turns back,
// with a kink or without or after it has stayed, and none where it goes on;
// beside the points that were asked for.
#include <heddle/simulation/fabric_loading_parameters.h>
#include <heddle/solver/load_stepping.h>

#include "../tests.h"

void
test(const std::string &ramp)
{
  Heddle::Simulation::FabricLoadingParameters loading("/Of " + ramp);
  ParameterAcceptor::initialize();
  ParameterAcceptor::prm.enter_subsection("Of " + ramp);
  ParameterAcceptor::prm.set("Ramp", ramp);
  ParameterAcceptor::prm.leave_subsection();
  ParameterAcceptor::parse_all_parameters();
  Heddle::Solver::LoadPlan plan;
  plan.initial_step = 0.1;
  plan.points       = {0.25, 0.5};
  plan.reach(loading.turning_points());
  deallog << ramp << ": turns at";
  for (const double point : loading.turning_points())
    deallog << ' ' << point;
  deallog << "; steps hit";
  for (const double point : plan.points)
    deallog << ' ' << point;
  deallog << std::endl;
}



int
main()
{
  initlog();
  deallog << std::setprecision(7);
  test("t");
  test("1 - abs(2*t - 1)");
  test("1 - abs(t - 0.3337) - 0.6663");
  test("sin(3*pi*t)");
  test("min(2*t, 1)");
  test("min(2*t, 1) - max(0, 4*t - 3)");
  test("min(1, min(2.5*t, 2*(1-t)))");
  test("min(2*t, 1) + max(0, t - 0.75)");
  test("abs(abs(4*t - 2) - 1) - 1");
}
