#ifndef heddle_simulation_fiber_parameters_h
#define heddle_simulation_fiber_parameters_h

#include <heddle/base/fiber_names.h>
#include <heddle/beam/element.h>
#include <heddle/simulation/fiber_material.h>

#include <deal.II/base/parameter_acceptor.h>

#include <memory>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** Finite element and materials of the fibers. */
    class FiberParameters : public ParameterAcceptor
    {
    public:
      FiberParameters(const std::string &section = "/Fiber");

      std::unique_ptr<Beam::Element>
      element() const;

      /**
       * Return the number of the material of each fiber: 0 of this section, i
       * of section *Material i* in it. Throw InputError if one of these names
       * what is no fiber, or a fiber of another one.
       */
      std::vector<unsigned int>
      materials_of(const FiberNames &fibers) const;

      /** Return the material of this number. */
      const FiberMaterial &
      material_number(const unsigned int number) const;

      Beam::ElementKind element_kind       = Beam::ElementKind::hermite;
      unsigned int      degree             = 1;
      unsigned int      elements_per_fiber = 36;

      FiberMaterial material;
      MaterialList  materials; /**< of fibers that differ; may be empty */
    };
  } // namespace Simulation
} // namespace Heddle

#endif
