// Wherever fibers of a random heap overlap, by dense sampling, there are
// contact elements, and of one proximity zone only.
#include "../contact/contact_scene.h"
#include "../tests.h"

#include <set>

constexpr unsigned int n_fibers = 14;

std::vector<Path>
heap(const unsigned int seed, const double waves)
{
  RandomNumbers     random(seed);
  std::vector<Path> paths;
  for (unsigned int f = 0; f < n_fibers; ++f)
    {
      const Tensor<1, 3> along = random.direction();
      const Tensor<1, 3> middle({random.between(-8., 8.),
                                 random.between(-8., 8.),
                                 random.between(-8., 8.)});
      paths.push_back(
        wavy_line(middle - 15. * along, along, 30., waves, random));
    }
  return paths;
}



/** Places (s_a, s_b) of least distance below 2 R - @p depth of two fibers. */
std::vector<std::pair<double, double>>
overlaps(const ContactScene &scene,
         const unsigned int  a,
         const unsigned int  b,
         const double        depth)
{
  constexpr unsigned int    n = 240;
  std::vector<Tensor<1, 3>> x[2];
  for (unsigned int side = 0; side < 2; ++side)
    for (unsigned int k = 0; k <= n; ++k)
      {
        const unsigned int f = side == 0 ? a : b;
        const auto         point =
          scene.space.locate(f, scene.space.fiber(f).length * k / n);
        Tensor<1, 3> position;
        for (unsigned int i = 0; i < 4; ++i)
          position += point.values[i] * scene.state.fiber(f)[point.blocks[i]];
        x[side].push_back(position);
      }
  std::vector<std::pair<double, double>> result;
  const auto distance = [&](const int i, const int j) {
    return i < 0 || j < 0 || i > int(n) || j > int(n)
             ? 1e300
             : (x[0][i] - x[1][j]).norm();
  };
  for (int i = 0; i <= int(n); ++i)
    for (int j = 0; j <= int(n); ++j)
      if (distance(i, j) < 2. - depth)
        {
          bool least = true;
          for (int k = -1; k <= 1; ++k)
            for (int l = -1; l <= 1; ++l)
              least = least && distance(i + k, j + l) >= distance(i, j);
          if (least)
            result.emplace_back(scene.space.fiber(a).length * i / n,
                                scene.space.fiber(b).length * j / n);
        }
  return result;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  for (const double waves : {0., 3.})
    for (const unsigned int n_intervals : {6, 15, 40})
      {
        unsigned int n_overlaps = 0, n_missed = 0, n_twice = 0, n_itself = 0;
        for (unsigned int seed = 0; seed < 6; ++seed)
          {
            ContactScene scene(
              heap(seed, waves),
              std::vector<unsigned int>(n_fibers, n_intervals));
            scene.contact->update(scene.state);
            const auto &elements = scene.contact->elements();
            for (unsigned int a = 0; a < n_fibers; ++a)
              for (unsigned int b = a; b < n_fibers; ++b)
                for (const auto &place : overlaps(scene, a, b, 0.01))
                  {
                    // A fiber does not touch its own neighbourhood, and its
                    // pairs of places come twice.
                    if (a == b && place.second < place.first + 6.3)
                      continue;
                    ++n_overlaps;
                    n_itself += a == b ? 1 : 0;
                    bool found = false;
                    for (const auto &element : elements)
                      found =
                        found || (element.fiber_a == a &&
                                  element.fiber_b == b && element.force > 0. &&
                                  std::abs(element.s_a - place.first) +
                                      std::abs(element.s_b - place.second) <
                                    5.);
                    n_missed += found ? 0 : 1;
                  }
            std::set<std::pair<unsigned int, unsigned int>> zones;
            for (const auto &element : elements)
              {
                for (const auto &other : elements)
                  if (element.force > 0. && other.force > 0. &&
                      other.zone > element.zone &&
                      other.fiber_a == element.fiber_a &&
                      other.fiber_b == element.fiber_b &&
                      std::abs(other.s_a - element.s_a) < 0.3 &&
                      std::abs(other.s_b - element.s_b) < 0.3)
                    zones.insert({element.zone, other.zone});
              }
            n_twice += zones.size();
          }
        deallog << "waves " << waves << ", intervals " << n_intervals
                << ": overlaps " << n_overlaps << ", missed " << n_missed
                << ", covered twice " << n_twice << ", with itself " << n_itself
                << std::endl;
      }
}
