#include <heddle/base/choice.h>
#include <heddle/base/exceptions.h>
#include <heddle/simulation/fiber_parameters.h>

namespace Heddle
{
  namespace Simulation
  {
    FiberParameters::FiberParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_choice(*this,
                 "Element",
                 element_kind,
                 "'hermite': slender, torsion-free, smooth, six unknowns per "
                 "node. 'director': nine unknowns per node, with torsion, "
                 "shear and strains of the section; where fibers are curved "
                 "and free to turn it takes fewer iterations. Without torsion "
                 "fibers roll on each other for nothing, and rub less: 19 of "
                 "them, squeezed between two rods with a friction of 0.2, "
                 "resisted a third as much [-].");
      add_parameter("Degree",
                    degree,
                    "Polynomial degree of 'director'. Linear elements are too "
                    "stiff where a fiber is bent between contacts that are "
                    "few elements apart: five of degree 1 were by 60 %, of "
                    "degree 2 by 2 %. Inactive for 'hermite', which is cubic "
                    "[-].",
                    prm,
                    Patterns::Integer(1, 3));
      add_parameter(
        "Elements per fiber",
        elements_per_fiber,
        "Number of elements of every fiber of a weave. Inactive for "
        "centerlines from a file, which have an element length [-].",
        prm,
        Patterns::Integer(1));
      material.add_parameters(*this);
    }



    std::unique_ptr<Beam::Element>
    FiberParameters::element() const
    {
      return Beam::make_element(element_kind, degree);
    }



    std::vector<unsigned int>
    FiberParameters::materials_of(const FiberNames &fibers) const
    {
      std::vector<unsigned int> numbers(fibers.n_fibers(), 0);
      for (unsigned int i = 0; i < materials.size(); ++i)
        {
          const std::string where = "Fiber/Material " + std::to_string(i + 1);
          for (const unsigned int f : fibers.find(materials[i]->fibers, where))
            {
              require(numbers[f] == 0,
                      where + ": \"Fibers\" has fiber " + std::to_string(f) +
                        ", and so has Material " + std::to_string(numbers[f]) +
                        "; a fiber is of one material.");
              numbers[f] = i + 1;
            }
        }
      return numbers;
    }



    const FiberMaterial &
    FiberParameters::material_number(const unsigned int number) const
    {
      return number == 0 ? material : materials[number - 1]->material;
    }
  } // namespace Simulation
} // namespace Heddle
