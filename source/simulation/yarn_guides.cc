#include <heddle/base/yarn_set.h>
#include <heddle/simulation/yarn_guides.h>
#include <heddle/textile/spun_yarns.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/symmetric_tensor.h>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    std::shared_ptr<Contributions::NodalSprings>
    yarn_guides(const System::FiberSpace              &space,
                const std::vector<Textile::FiberPath> &paths,
                const SettleParameters                &parameters)
    {
      const auto ends = Textile::ends_of_yarns(paths);
      std::vector<Contributions::NodalSprings::Spring> springs;
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        {
          const System::Fiber &fiber = space.fiber(f);
          const unsigned int   axis  = fiber.set == word(YarnSet::warp) ? 0 : 1;
          Tensor<1, 3>         along;
          along[axis]                = 1.;
          const Tensor<2, 3> on_axis = outer_product(along, along);
          const Tensor<2, 3> across =
            Tensor<2, 3>(unit_symmetric_tensor<3>()) - on_axis;

          const double stiffness = parameters.guide_stiffness *
                                   fiber.section.axial /
                                   (numbers::PI * fiber.radius);
          const Tensor<1, 3> tension =
            parameters.tension_of(fiber.set) * fiber.section.axial * along;
          const auto        &points = paths[f].points;
          const unsigned int last = fiber.n_nodes - 1, middle = last / 2;
          if (ends[f][0])
            springs.push_back(
              {f, 0, points.front(), stiffness * across, -tension});
          if (ends[f][1])
            springs.push_back(
              {f, last, points.back(), stiffness * across, tension});
          springs.push_back(
            {f, middle, points[middle], stiffness * on_axis, Tensor<1, 3>()});
        }
      return std::make_shared<Contributions::NodalSprings>("yarn guides",
                                                           springs);
    }
  } // namespace Simulation
} // namespace Heddle
