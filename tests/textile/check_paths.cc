// Fibers whose axes are the same, or partly so, are refused, whichever way they
// run and wherever their points are; those that cross, touch, follow each other
// or lie side by side are not.
#include <heddle/base/exceptions.h>
#include <heddle/textile/check_paths.h>

#include "../tests.h"

using Heddle::Polyline;

const double radius = 0.1;



/** Points at equal distances on a line from @p begin to @p end. */
Polyline
straight(const Tensor<1, 3> &begin,
         const Tensor<1, 3> &end,
         const unsigned int  n)
{
  Polyline points;
  for (unsigned int i = 0; i <= n; ++i)
    points.push_back(begin + double(i) / n * (end - begin));
  return points;
}



Tensor<1, 3>
at(const double x, const double y = 0., const double z = 0.)
{
  return Tensor<1, 3>({x, y, z});
}



void
check(const std::string &what, const Polyline &first, const Polyline &second)
{
  deallog << what << ": ";
  try
    {
      std::vector<Heddle::Textile::FiberPath> paths(3);
      paths[0].points = straight(at(0., 9.), at(1., 9.), 3);
      paths[1].points = first;
      paths[2].points = second;
      for (auto &path : paths)
        path.radius = radius;
      Heddle::Textile::check_paths(paths);
      deallog << "accepted" << std::endl;
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



int
main(int argc, char **argv)
{
  const MPITest  mpi(argc, argv);
  const Polyline fiber = straight(at(0.), at(3., 1.5, -0.6), 7);
  check("the same", fiber, fiber);
  check("reversed", fiber, Polyline(fiber.rbegin(), fiber.rend()));
  check("other points", fiber, straight(fiber.front(), fiber.back(), 11));
  check("a part",
        fiber,
        straight(fiber[3] + 0.3 * (fiber[4] - fiber[3]), fiber[5], 1));
  check(
    "begins at its end", fiber, straight(fiber.back(), at(5., 2.5, -1.), 4));
  check("a hundredth of its end",
        straight(at(0.), at(1.), 1),
        straight(at(0.98), at(2.), 1));
  check("beside by a thousandth of the radius",
        straight(at(0.), at(1.), 4),
        straight(at(0., 0.99e-3 * radius), at(1., 0.99e-3 * radius), 5));
  check("beside by two thousandths",
        straight(at(0.), at(1.), 4),
        straight(at(0., 2e-3 * radius), at(1., 2e-3 * radius), 5));
  check("beside by two radii",
        straight(at(0.), at(1.), 4),
        straight(at(0., 2. * radius), at(1., 2. * radius), 5));
  check("axes that cross",
        straight(at(-1.), at(1.), 3),
        straight(at(0., -1.), at(0., 1.), 5));
  check("axes that cross by two degrees",
        straight(at(-1.), at(1.), 3),
        straight(at(-1., -0.035), at(1., 0.035), 5));
}
