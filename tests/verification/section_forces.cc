// Forces and moments in sections, as they are written for pictures, against
// statics: a cantilever under a force and a moment at its end, far bent, has
// the force F and the moment M + (r(L) - r) x F everywhere, whatever its shape.
// The slender element knows the force as exactly as it balances its nodes; its
// moment is that of bending. The straight fiber is
// bent in space, an arc that is free of stress is opened in its plane. Errors
// are relative to F and to the largest moment.
#include <heddle/base/choice.h>

#include "../contributions/scene.h"

#include <algorithm>

/** Slender, so that stretches count little; E I = 1. */
const double radius = 0.002;

/** Largest errors over all middles: of the whole force, along the axis, and of
 * the moment. */
struct Errors
{
  double force = 0., axial = 0., moment = 0.;
};



Errors
errors(const std::string &element,
       const unsigned int degree,
       const unsigned int n_elements,
       const bool         curved)
{
  const bool         slender = element == "hermite";
  const Tensor<1, 3> force({0.6, 2., curved || slender ? 0. : -1.});
  const Tensor<1, 3> moment({curved || slender ? 0. : 0.8, 0., 0.5});
  Scene              scene;
  scene.fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  scene.fibers.degree                 = degree;
  scene.fibers.material.axial_modulus = 4. / M_PI / std::pow(radius, 4);
  scene.fibers.material.poisson_ratio = 0.3;
  scene.newton.residual_tolerance     = 1e-11;
  scene.newton.increment_tolerance    = 1e-11;
  scene.clamp("first end");
  auto &load = scene.add_load();
  for (unsigned int d = 0; d < 3; ++d)
    {
      load.force[d]  = std::to_string(force[d]) + "*t";
      load.moment[d] = std::to_string(moment[d]) + "*t";
    }
  const unsigned int n_knots = (slender ? 1 : degree) * n_elements + 1;
  auto               path =
    straight_path(Tensor<1, 3>(), Tensor<1, 3>({1., 0., 0.}), n_knots, radius);
  if (curved)
    for (unsigned int i = 0; i < n_knots; ++i)
      {
        const double s = double(i) / (n_knots - 1);
        path.points[i] = Tensor<1, 3>({std::sin(s), std::cos(s) - 1., 0.});
      }
  scene.build({path});
  for (const auto &contribution : scene.contributions)
    contribution->begin_stage(*scene.state);
  for (const double t : {0.25, 0.5, 0.75, 1.})
    AssertThrow(scene.step(t).converged, ExcMessage("No equilibrium."));

  const auto &elasticity = dynamic_cast<const Contributions::FiberElasticity &>(
    *scene.contributions.front());
  const Tensor<1, 3> tip     = scene.block(0, scene.last_node());
  double             largest = 0.;
  Errors             worst;
  for (unsigned int e = 0; e < n_elements; ++e)
    {
      const unsigned int  first  = scene.space->first_block_of_element(e);
      const Tensor<1, 3> *blocks = scene.state->fiber(0) + first;
      const double        length = scene.space->element_length(0, e);
      const auto          found  = scene.space->element().section_state(
        scene.space->fiber(0).section,
        blocks,
        length,
        elasticity.reference_strains(0, e));
      const auto at = [&](const double part) {
        return scene.space->locate(0, (e + part) * length)
          .position(scene.state->fiber(0));
      };
      const Tensor<1, 3> place   = at(0.5);
      Tensor<1, 3>       tangent = at(0.501) - at(0.499);
      tangent /= tangent.norm();

      const Tensor<1, 3> turning =
        moment + cross_product_3d(tip - place, force);
      const double size  = std::sqrt(found.torque * found.torque +
                                    found.bending_moment.norm_square());
      const double whole = std::abs(
        std::hypot(found.axial_force, found.shear_force.norm()) - force.norm());
      largest     = std::max(largest, turning.norm());
      worst.force = std::max(worst.force, whole / force.norm());
      worst.axial =
        std::max(worst.axial,
                 std::abs(found.axial_force - force * tangent) / force.norm());
      worst.moment = std::max(worst.moment, std::abs(size - turning.norm()));
    }
  worst.moment /= largest;
  return worst;
}



void
converge(const std::string &element,
         const unsigned int degree,
         const bool         curved,
         const unsigned int coarsest)
{
  const std::string name =
    element + ' ' + std::to_string(degree) + (curved ? ", arc" : ", rod");
  const auto order = [](const double coarse, const double fine) {
    return std::round(10. * std::log2(coarse / fine)) / 10.;
  };
  Errors coarse, before, now;
  for (unsigned int n = coarsest; n <= 4 * coarsest; n *= 2)
    {
      now = errors(element, degree, n, curved);
      std::cout << name << ", " << n << " elements: force " << now.force
                << ", along the axis " << now.axial << ", moment "
                << now.moment;
      if (n == coarsest)
        coarse = now;
      else
        std::cout << ", orders " << order(before.force, now.force) << ' '
                  << order(before.axial, now.axial) << ' '
                  << order(before.moment, now.moment);
      std::cout << std::endl;
      before = now;
    }
  const bool exact = element == "hermite";
  deallog << name << ": to " << (exact ? "1e-7 " : "2e-4 ")
          << (now.force < (exact ? 1e-7 : 2e-4)) << ", along the axis "
          << (now.axial < (exact ? 1e-7 : 1e-4));
  if (!exact)
    deallog << ", with order 1.5 and more "
            << (order(coarse.axial, now.axial) > 3.);
  deallog << ", moment to 1e-3 " << (now.moment < 1e-3) << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  converge("hermite", 3, /*curved=*/false, 16);
  for (const bool curved : {false, true})
    {
      converge("director", 1, curved, 16);
      converge("director", 2, curved, 8);
      converge("director", 3, curved, 8);
    }
}
