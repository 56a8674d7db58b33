// Sections of a straight yarn have the width, height and areas of its packing,
// along x, along y and along z, and if some of its fibers run the other way; a
// cosine has the crimp of the elliptic integral.
#include <heddle/base/mean_line.h>
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



int
main()
{
  initlog();
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
