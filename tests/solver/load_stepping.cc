// Load steps hit the points that are asked for, grow after easy steps, are
// halved after failures, and are given up when they would get too short.
#include <heddle/solver/load_stepping.h>

#include "../tests.h"

/** Newton iterations of each attempt; 0: it failed. */
void
attempt(Heddle::Solver::LoadStepping    &stepping,
        const std::vector<unsigned int> &attempts)
{
  for (const unsigned int iterations : attempts)
    {
      deallog << stepping.reached() << " -> " << stepping.next();
      if (iterations > 0)
        stepping.accept(iterations);
      else
        deallog << " failed, shorter " << stepping.cut_back();
      deallog << std::endl;
    }
}



int
main()
{
  initlog();
  Heddle::Solver::LoadPlan plan;
  plan.initial_step  = 0.1;
  plan.largest_step  = 0.3;
  plan.smallest_step = 0.02;
  plan.points        = {0.25};
  Heddle::Solver::LoadStepping stepping(plan);

  attempt(stepping, {5, 5, 20, 5, 0, 0, 5, 5, 5});
  while (!stepping.finished())
    stepping.accept(5);
  deallog << "finished at " << stepping.reached() << std::endl;

  // After a cut hard steps grow again, but less soon if they fail again.
  plan.points = {};
  Heddle::Solver::LoadStepping hard(plan);
  attempt(hard, {20, 0, 20, 20, 20, 20, 0, 20, 20, 20, 20, 20, 20, 20});

  // A step to 0 comes first, is not halved, and leaves the others as they were.
  Heddle::Solver::LoadStepping from_zero(plan);
  from_zero.begin_at_zero();
  deallog << "has begun " << from_zero.has_begun() << std::endl;
  attempt(from_zero, {0, 5});
  deallog << "has begun " << from_zero.has_begun() << std::endl;
  attempt(from_zero, {5, 5});

  Heddle::Solver::LoadStepping stubborn(plan);
  while (stubborn.cut_back())
    deallog << "halved to " << stubborn.next() << std::endl;
  deallog << "given up at " << stubborn.reached() << std::endl;
}
