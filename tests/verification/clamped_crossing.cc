// Two clamped beams cross in their middles and are pressed together until they
// carry by their axial forces as much as by bending. Each is a clamped rod
// under a force in its middle, which an independent method solves to ten
// digits: the ordinary differential equations of the rod with the strains of
// the elements, shooting from its clamped end. The force is compared with that
// of the rod for the deflection that is left beside the penetration.
//
// Friction does nothing here, by symmetry, and must not be in the way.
#include <heddle/base/choice.h>
#include <heddle/contributions/fiber_contact.h>
#include <heddle/contributions/fiber_friction.h>

#include "../contributions/scene.h"

#include <iomanip>
#include <iostream>

const double radius = 0.5, length = 40., modulus = 1000., poisson_ratio = 0.3,
             approach = 2., gap = 0.02;

/** x, z, angle and moment at a place of the rod. */
using RodState = std::array<double, 4>;



/** A plane rod with the axial, bending and perhaps shear strains of section 1.
 */
class Rod
{
public:
  explicit Rod(const bool shears)
    : shears(shears)
    , section(Beam::circular_section(radius,
                                     modulus,
                                     0.5 * modulus / (1. + poisson_ratio),
                                     poisson_ratio))
  {
  }

  /** Force in the middle that moves it by @p deflection. */
  double
  force(const double deflection) const
  {
    // Horizontal and vertical force and moment at the clamped end, such that
    // the middle is where it is to be, and level.
    RodState begin = {{1.1, 0.14, 0., 0.83}};
    for (unsigned int iteration = 0; iteration < 20; ++iteration)
      {
        const std::array<unsigned int, 3> unknown = {{0, 1, 3}};
        const auto                        end     = [&](const RodState &s) {
          const RodState y = shoot(s);
          return Tensor<1, 3>({y[0] - 0.5 * length, y[1] - deflection, y[2]});
        };
        const Tensor<1, 3> miss = end(begin);
        Tensor<2, 3>       slope;
        for (unsigned int j = 0; j < 3; ++j)
          {
            RodState near = begin;
            near[unknown[j]] += 1e-6;
            const Tensor<1, 3> change = end(near) - miss;
            for (unsigned int i = 0; i < 3; ++i)
              slope[i][j] = change[i] / 1e-6;
          }
        const Tensor<1, 3> step = invert(slope) * miss;
        for (unsigned int j = 0; j < 3; ++j)
          begin[unknown[j]] -= step[j];
      }
    return 2. * begin[1];
  }

private:
  bool          shears;
  Beam::Section section;

  /** From the clamped end to the middle, with Runge and Kutta's method. */
  RodState
  shoot(const RodState &begin) const
  {
    const unsigned int n = 100;
    const double       h = 0.5 * length / n;
    RodState           y = {{0., 0., 0., begin[3]}};
    const auto         moved =
      [](const RodState &a, const double f, const RodState &b) {
        RodState sum = a;
        for (unsigned int i = 0; i < 4; ++i)
          sum[i] += f * b[i];
        return sum;
      };
    for (unsigned int k = 0; k < n; ++k)
      {
        const RodState a = derivative(y, begin),
                       b = derivative(moved(y, h / 2., a), begin),
                       c = derivative(moved(y, h / 2., b), begin),
                       d = derivative(moved(y, h, c), begin);
        for (unsigned int i = 0; i < 4; ++i)
          y[i] += h / 6. * (a[i] + 2. * b[i] + 2. * c[i] + d[i]);
      }
    return y;
  }

  /**
   * With r' = a d + b g, along the section's normal d and in its plane, the
   * energy per length is EA (a^2 + b^2 - 1)^2 / 8 + EI a^2 k^2 / 2 + kGA b^2 /
   * 2 for the turning k of the section; its derivatives are the forces and the
   * moment.
   */
  RodState
  derivative(const RodState &y, const RodState &begin) const
  {
    const double c = std::cos(y[2]), s = std::sin(y[2]);
    const double along  = begin[0] * c + begin[1] * s,
                 across = -begin[0] * s + begin[1] * c;
    double a = 1., b = 0., turning = 0.;
    for (unsigned int iteration = 0; iteration < 12; ++iteration)
      {
        const double axial = section.axial * 0.5 * (a * a + b * b - 1.);
        turning            = y[3] / (section.bending * a * a);
        b                  = shears ? across / (section.shear + axial) : 0.;
        a += (along - section.bending * a * turning * turning - axial * a) /
             section.axial;
      }
    const double x = a * c - b * s, z = a * s + b * c;
    return {{x, z, turning, x * -begin[1] + z * begin[0]}};
  }
};



/** Both beams; the ends of the upper one come down. */
double
computed_force(const std::string &element,
               const unsigned int n_elements,
               double            &penetration,
               bool              &converged)
{
  Scene scene;
  scene.fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  scene.fibers.material.axial_modulus = modulus;
  scene.fibers.material.poisson_ratio = poisson_ratio;
  for (const std::string fiber : {"0", "1"})
    for (const std::string end : {"first end", "last end"})
      {
        auto &support = scene.clamp(end, fiber);
        if (fiber == "1")
          support.displacement[2] = "-" + std::to_string(approach) + "*t";
      }
  std::vector<Textile::FiberPath> paths;
  for (unsigned int direction = 0; direction < 2; ++direction)
    {
      Tensor<1, 3> half, middle;
      half[direction] = 0.5 * length;
      middle[2]       = (2. * radius + gap) * direction;
      paths.push_back(
        straight_path(middle - half, middle + half, n_elements + 1, radius));
    }
  scene.build(paths);
  Contact::ContactParameters contact;
  contact.threshold = 0.002;
  contact.friction  = 0.1;
  const auto touch =
    std::make_shared<Contributions::FiberContact>(*scene.space, contact);
  scene.contributions.push_back(touch);
  scene.contributions.push_back(std::make_shared<Contributions::FiberFriction>(
    *scene.space, contact, *touch));
  const unsigned int n_steps = 4;
  converged                  = true;
  for (unsigned int step = 1; step <= n_steps; ++step)
    converged = scene.step(double(step) / n_steps).converged && converged;
  auto values = scene.report();
  penetration = radius * values["max_penetration_ratio[-]"];
  return values["support_1_force_z[N]"] + values["support_2_force_z[N]"];
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);

  // Of a rod whose strains are small: without the terms in the square of radius
  // times curvature that those of the elements have.
  const double small_strains = 0.27829;
  for (const std::string element : {"hermite", "director"})
    {
      const Rod                   rod(/*shears=*/element == "director");
      const std::array<double, 3> bounds =
        element == "hermite" ? std::array<double, 3>{{1e-4, 1e-5, 5e-6}}
                             : std::array<double, 3>{{2e-3, 5e-4, 1e-4}};
      deallog << element << ": force on the rod " << std::setprecision(5)
              << rod.force(0.5 * (approach - gap)) << std::endl;
      double before = 0.;
      for (unsigned int k = 0; k < 3; ++k)
        {
          const unsigned int n_elements = 20 << k;
          double             penetration;
          bool               converged;
          const double       force =
            computed_force(element, n_elements, penetration, converged);
          const double error =
            force / rod.force(0.5 * (approach - gap - penetration)) - 1.;
          const bool close = std::abs(force / small_strains - 1.) < 5e-3,
                     good  = std::abs(error) < bounds[k];
          std::cout << element << ", " << n_elements << " elements: force "
                    << std::setprecision(6) << force << ", error "
                    << std::setprecision(2) << error;
          if (k > 0)
            std::cout << ", order " << std::log2(std::abs(before / error));
          std::cout << std::endl;
          before = error;
          deallog << element << ", " << n_elements << " elements: converged "
                  << converged << ", within 0.5 % of small strains " << close
                  << ", error below " << bounds[k] << " " << good
                  << verdict(converged && close && good) << std::endl;
        }
    }
}
