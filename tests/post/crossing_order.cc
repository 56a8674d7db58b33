// All pairs of a crimped weave lie in the order of the pattern, all lie wrong
// if the pattern is inverted, and fibers that do not cross are told apart.
#include <heddle/post/crossing_order.h>
#include <heddle/textile/weave.h>

#include "../tests.h"

using namespace Heddle;



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



int
main()
{
  initlog();
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
