// One fiber touches itself where it crosses itself, in a hairpin and in a coil;
// forces balance. Straight, gently bent and helical fibers do not, however fine
// or coarse their elements are.
#include "../contact/contact_scene.h"
#include "../tests.h"

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



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
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
