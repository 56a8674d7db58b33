// What is told of yarns: their sections and crimp, and the order in which they
// cross.
#include <heddle/base/mean_line.h>
#include <heddle/post/crossing_order.h>
#include <heddle/post/yarn_section.h>
#include <heddle/textile/weave.h>

#include <deal.II/base/numbers.h>

#include "../tests.h"

using namespace Heddle;

void
cut(const Textile::Weave &weave,
    const unsigned int    yarn,
    const bool            upright   = false,
    const bool            turn_some = false)
{
  std::vector<Polyline> lines;
  std::vector<double>   radii;
  for (const auto &fiber : weave.paths(20))
    if (fiber.yarn_id == yarn)
      {
        lines.push_back(fiber.points);
        radii.push_back(fiber.radius);
        if (upright)
          for (Tensor<1, 3> &point : lines.back())
            point = Tensor<1, 3>({point[1], point[2], point[0]});
        if (turn_some && lines.size() % 3 == 2)
          std::reverse(lines.back().begin(), lines.back().end());
      }
  const auto mean    = mean_line(lines, 41);
  const auto section = Post::cut_yarn(lines, radii, plane_at(mean, 0.3));
  deallog << "yarn " << yarn << ": " << section.points.size() << " fibers, "
          << section.n_missing << " missing, center " << section.center
          << ", width " << section.width << ", height " << section.height
          << ", aspect ratio " << section.aspect_ratio() << ", area over pi "
          << section.fiber_area / numbers::PI << ", hull " << section.hull_area
          << ", volume fraction " << section.volume_fraction() << ", 1 + crimp "
          << 1. + crimp(mean) << std::endl;
}



/**
 * Sections of a straight yarn have the width, height and areas of its packing,
 * along x, along y and along z, and if some of its fibers run the other way; a
 * cosine has the crimp of the elliptic integral.
 */
void
sections()
{
  Textile::WeaveDescription description;
  description.start               = Textile::Start::interpenetrating;
  description.warp.n_yarns        = 2;
  description.warp.packing.radius = 1.;
  description.weft                = description.warp;
  cut(Textile::Weave(description), 0);
  cut(Textile::Weave(description), 3);
  cut(Textile::Weave(description), 3, /*upright=*/false, /*turn_some=*/true);
  cut(Textile::Weave(description), 0, /*upright=*/true);

  description.warp.packing.fibers_per_bundle = 1;
  cut(Textile::Weave(description), 0);

  Polyline cosine;
  for (unsigned int k = 0; k <= 2000; ++k)
    {
      const double x = 4. * numbers::PI * k / 2000;
      cosine.push_back(Tensor<1, 3>({x, 0., std::cos(x)}));
    }
  deallog << "1 + crimp of cos x: " << 1. + crimp(cosine) << std::endl;
}



/** Six fibers around cos x, two waves long. */
std::vector<Polyline>
wavy_yarn()
{
  std::vector<Polyline> fibers(6);
  for (unsigned int f = 0; f < 6; ++f)
    for (unsigned int k = 0; k <= 840; ++k)
      {
        const double x = 4. * numbers::PI * k / 840;
        const double y = std::cos(f * numbers::PI / 3.);
        const double z = std::sin(f * numbers::PI / 3.);
        fibers[f].push_back(Tensor<1, 3>({x, y, z + std::cos(x)}));
      }
  return fibers;
}



void
print(const std::string &name, const std::vector<Polyline> &fibers)
{
  const Polyline mean = mean_line(fibers, 1001);
  deallog << name << ": 1 + crimp " << 1. + crimp(mean)
          << ", from x + 1 = " << 1. + mean.front()[0]
          << ", z = " << mean.front()[2]
          << " to x over pi = " << mean.back()[0] / numbers::PI << std::endl;
}



/**
 * The mean line of a yarn, and its crimp, whether its fibers run from end to
 * end, or some were lost, or it is spun of staple fibers, which begin and end
 * where they do and are given from either end.
 */
void
short_fibers()
{
  const std::vector<Polyline> whole = wavy_yarn();
  print("whole", whole);

  std::vector<Polyline> lost = whole;
  lost[1].resize(400);
  lost[4].erase(lost[4].begin(), lost[4].begin() + 500);
  print("two lost", lost);

  std::vector<Polyline> spun;
  for (unsigned int f = 0; f < 6; ++f)
    {
      const auto cut = whole[f].begin() + 120 * (f + 1);
      spun.emplace_back(whole[f].begin(), cut + 1);
      spun.emplace_back(cut, whole[f].end());
      std::reverse(spun.back().begin(), spun.back().end());
    }
  print("spun", spun);
}



void
print(const std::string &name, const Post::CrossingCount &count)
{
  deallog << name << ": " << count.total << " pairs, " << count.wrong
          << " wrong, " << count.apart << " apart" << std::endl;
}



void
count(const std::string   &pattern,
      const Textile::Start start,
      const double         spacing)
{
  Textile::WeaveDescription description;
  description.pattern                = pattern;
  description.start                  = start;
  description.warp.packing.n_bundles = 3;
  description.warp.packing.radius    = 1.;
  description.warp.spacing           = spacing;
  description.weft                   = description.warp;
  const Textile::Weave weave(description);

  std::vector<Polyline>                  lines;
  std::vector<std::vector<unsigned int>> yarns(8);
  for (const auto &fiber : weave.paths(36))
    {
      yarns[fiber.yarn_id].push_back(lines.size());
      lines.push_back(fiber.points);
    }

  std::vector<Post::OrderedFibers> crossings, inverted;
  for (const auto &crossing : weave.crossings())
    {
      const auto &warp = yarns[crossing.warp_yarn];
      const auto &weft = yarns[crossing.weft_yarn];
      crossings.push_back(crossing.warp_on_top
                            ? Post::OrderedFibers{warp, weft}
                            : Post::OrderedFibers{weft, warp});
      inverted.push_back({crossings.back().lower, crossings.back().upper});
    }
  deallog << "clear at a spacing of " << spacing << " R: " << weave.is_clear()
          << std::endl;
  print(pattern, count_crossing_order(lines, crossings));
  print(pattern + " inverted", count_crossing_order(lines, inverted));
}



/**
 * All pairs of a crimped weave lie in the order of the pattern, all lie wrong
 * if the pattern is inverted, and fibers that do not cross are told apart.
 */
void
order_of_crossings()
{
  count("plain", Textile::Start::crimped, 30.);
  count("twill 2/2", Textile::Start::crimped, 30.);
  count("plain", Textile::Start::interpenetrating, 30.);
  // The closer the yarns the steeper they cross.
  count("plain", Textile::Start::crimped, 27.);

  const std::vector<Polyline> three = {
    {Tensor<1, 3>({-1., 0., 0.}), Tensor<1, 3>({1., 0., 0.})},
    {Tensor<1, 3>({0., -1., 1.}), Tensor<1, 3>({0., 1., -3.})},
    {Tensor<1, 3>({2., -1., 1.}), Tensor<1, 3>({2., 1., 1.})}};
  print("three fibers", Post::count_crossing_order(three, {{{0}, {1, 2}}}));
  print("three fibers", Post::count_crossing_order(three, {{{1, 2}, {0}}}));
}



int
main()
{
  initlog();
  run_part("Sections", sections);
  run_part("Short fibers", short_fibers);
  run_part("Order of crossings", order_of_crossings);
}
