#ifndef heddle_tests_io_wavy_fabric_h
#define heddle_tests_io_wavy_fabric_h

#include <heddle/system/fiber_space.h>
#include <heddle/system/state.h>

#include <cmath>
#include <memory>
#include <vector>

/**
 * A plain weave of 2 x 2 yarns of 7 fibers, drawn by cosines: no equilibrium,
 * but something to write and to look at.
 */
struct WavyFabric
{
  static constexpr unsigned int n_yarns      = 4;
  static constexpr unsigned int n_in_yarn    = 7;
  static constexpr unsigned int n_elements   = 24;
  static constexpr double       radius       = 0.05;
  static constexpr double       yarn_spacing = 0.6;
  static constexpr double       amplitude    = 0.155;
  static constexpr double       length       = 2. * yarn_spacing;
  static constexpr double       strain       = 0.01;

  static double
  wave(const unsigned int yarn)
  {
    return ((yarn % 2 == 0) == (yarn < 2)) ? amplitude : -amplitude;
  }

  /** Axis of fiber @p f at the place @p t in [0, 1] along its yarn. */
  static dealii::Tensor<1, 3>
  position(const unsigned int f, const double t)
  {
    const unsigned int yarn  = f / n_in_yarn;
    const unsigned int k     = f % n_in_yarn;
    const double       turn  = dealii::numbers::PI / 3. * k;
    const double       out   = (k == 0) ? 0. : 2.02 * radius;
    const double       along = length * t;
    const double       across =
      yarn_spacing * (yarn % 2 + 0.5) + out * std::cos(turn);
    const double phase = dealii::numbers::PI * along / yarn_spacing;
    const double up    = wave(yarn) * std::sin(phase) + out * std::sin(turn);
    return (yarn < 2) ? dealii::Tensor<1, 3>({along, across, up})
                      : dealii::Tensor<1, 3>({across, along, up});
  }

  static dealii::Tensor<1, 3>
  direction(const unsigned int f, const double t)
  {
    const auto chord = position(f, t + 1e-5) - position(f, t - 1e-5);
    return chord / chord.norm();
  }

  static double
  arc_length(const unsigned int f, const double begin, const double end)
  {
    constexpr unsigned int n_chords = 20;
    double                 sum      = 0.;
    for (unsigned int i = 0; i < n_chords; ++i)
      sum += (position(f, begin + (end - begin) * (i + 1) / n_chords) -
              position(f, begin + (end - begin) * i / n_chords))
               .norm();
    return sum;
  }

  static std::vector<Heddle::System::FiberSpace::Description>
  fibers()
  {
    std::vector<Heddle::System::FiberSpace::Description> list;
    for (unsigned int f = 0; f < n_yarns * n_in_yarn; ++f)
      {
        Heddle::System::FiberSpace::Description fiber;
        for (unsigned int e = 0; e < n_elements; ++e)
          fiber.element_lengths.push_back(
            arc_length(f, double(e) / n_elements, (e + 1.) / n_elements) /
            (1. + strain));
        fiber.radius    = radius;
        fiber.yarn_id   = f / n_in_yarn;
        fiber.bundle_id = (f % n_in_yarn) % 3;
        fiber.set       = (fiber.yarn_id < 2) ? "warp" : "weft";
        fiber.section   = Heddle::Beam::circular_section(radius,
                                                       /*axial_modulus=*/1000.,
                                                       /*shear_modulus=*/400.,
                                                       /*poisson_ratio=*/0.25);
        list.push_back(fiber);
      }
    return list;
  }

  WavyFabric(const MPI_Comm communicator)
    : space(communicator,
            Heddle::Beam::make_element(Heddle::Beam::ElementKind::hermite,
                                       /*degree=*/3),
            fibers())
    , state(space)
  {
    const auto owned = space.owned_fibers();
    for (unsigned int f = owned.first; f < owned.second; ++f)
      for (unsigned int node = 0; node <= n_elements; ++node)
        {
          const double t               = double(node) / n_elements;
          state.fiber(f)[2 * node]     = position(f, t);
          state.fiber(f)[2 * node + 1] = (1. + strain) * direction(f, t);
        }
    state.accept();
  }

  Heddle::System::FiberSpace space;
  Heddle::System::State      state;
};

#endif
