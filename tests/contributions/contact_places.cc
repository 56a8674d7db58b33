// Where there is contact: wherever fibers overlap, also with themselves, and
// nowhere else.
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



/**
 * Wherever fibers of a random heap overlap, by dense sampling, there are
 * contact elements, and of one proximity zone only.
 */
void
coverage()
{
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



void
examine(const std::string               &name,
        const Path                      &path,
        const std::vector<unsigned int> &meshes)
{
  for (const unsigned int n : meshes)
    {
      ContactScene scene({path}, {n});
      const auto  &forces = scene.forces();
      Tensor<1, 3> resultant;
      double       sum = 0., along = 0.;
      for (unsigned int b = 0; b < forces.size(); b += 2)
        {
          resultant += forces[b];
          sum += forces[b].norm();
        }
      for (const auto &element : scene.contact->elements())
        along += element.force > 0. ? element.weight : 0.;
      deallog << name << ", intervals " << n << ": length of contact " << along
              << ", penetration " << scene.reported("max_penetration_ratio[-]")
              << ", balance "
              << (resultant.norm() <= 1e-12 * sum ? "yes" : "NO") << std::endl;
    }
}



/**
 * One fiber touches itself where it crosses itself, in a hairpin and in a coil;
 * forces balance. Straight, gently bent and helical fibers do not, however fine
 * or coarse their elements are.
 */
void
with_itself()
{
  deallog << std::setprecision(3);
  const double pi = numbers::PI;

  examine("overhand crossing",
          [](const double t) {
            const double angle = 8. * t - 4.;
            return Tensor<1, 3>({3. * angle - 8. * std::sin(angle),
                                 -8. * std::cos(angle),
                                 0.44 * angle});
          },
          {12, 24, 96});
  examine("hairpin",
          [=](const double t) {
            const double angle = pi * (t - 0.5), s = std::sin(angle);
            return Tensor<1, 3>({20. * (1. - std::cos(angle)),
                                 8. * s * (1. - 0.878 * s * s),
                                 0.});
          },
          {12, 24, 96});
  examine("coil of pitch 1.98",
          [=](const double t) {
            return Tensor<1, 3>({5. * std::cos(6. * pi * t),
                                 5. * std::sin(6. * pi * t),
                                 3. * 1.98 * t});
          },
          {36, 72});

  const std::vector<unsigned int> meshes = {2, 6, 20, 100};
  examine("straight",
          line(Tensor<1, 3>(), Tensor<1, 3>({0.6, 0., 0.8}), 40.),
          meshes);
  for (const double radius : {40., 8., 4.})
    examine("arc of radius " + std::to_string(int(radius)),
            [=](const double t) {
              const double angle = std::min(40. / radius, 5.) * t;
              return Tensor<1, 3>(
                {radius * std::cos(angle), radius * std::sin(angle), 0.});
            },
            {12, 40, 100});
  examine("helix of pitch 4",
          [=](const double t) {
            return Tensor<1, 3>({4. * std::cos(6. * pi * t),
                                 4. * std::sin(6. * pi * t),
                                 12. * t});
          },
          {36, 100});
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Heaps of fibers", coverage);
  run_part("One fiber and itself", with_itself);
}
