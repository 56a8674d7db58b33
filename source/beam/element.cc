#include <heddle/base/exceptions.h>
#include <heddle/beam/director_element.h>
#include <heddle/beam/element.h>
#include <heddle/beam/hermite_element.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <sstream>

namespace Heddle
{
  namespace Beam
  {
    namespace
    {
      void
      check(const bool condition, const std::string &what, const double value)
      {
        if (condition && std::isfinite(value))
          return;
        std::ostringstream sentence;
        sentence << what << ", but it is " << value << '.';
        throw InputError(sentence.str());
      }



      std::unique_ptr<Element>
      make_director_element(const unsigned int degree)
      {
        switch (degree)
          {
            case 1:
              return std::make_unique<DirectorElement<1>>();
            case 2:
              return std::make_unique<DirectorElement<2>>();
            case 3:
              return std::make_unique<DirectorElement<3>>();
            default:
              throw InputError("The fiber element \"director\" has the degree "
                               "1, 2 or 3, not " +
                               std::to_string(degree) + ".");
          }
      }
    } // namespace



    Section
    circular_section(const double radius,
                     const double axial_modulus,
                     const double shear_modulus,
                     const double poisson_ratio)
    {
      check(radius > 0., "The radius of a fiber must be positive", radius);
      check(axial_modulus > 0.,
            "The axial modulus of a fiber must be positive",
            axial_modulus);
      check(shear_modulus > 0.,
            "The shear modulus of a fiber must be positive",
            shear_modulus);
      check(poisson_ratio >= 0. && poisson_ratio < .5,
            "Poisson's ratio of a fiber must be from 0 to below 0.5",
            poisson_ratio);

      const double area    = numbers::PI * radius * radius;
      const double inertia = .25 * area * radius * radius;

      // Contact takes sections for circles: they are to remain some. Were they
      // as soft as G, bending would flatten them, and the fiber would kink.
      const double isotropic = axial_modulus / (2. * (1. + poisson_ratio));

      Section section;
      section.axial         = axial_modulus * area;
      section.bending       = axial_modulus * inertia;
      section.torsion       = shear_modulus * 2. * inertia;
      section.shear         = shear_modulus * area;
      section.thickness     = isotropic * area;
      section.gradient      = isotropic * inertia;
      section.poisson_ratio = poisson_ratio;
      return section;
    }



    std::unique_ptr<Element>
    make_element(const ElementKind kind, const unsigned int degree)
    {
      switch (kind)
        {
          case ElementKind::hermite:
            return std::make_unique<HermiteElement>();
          case ElementKind::director:
            return make_director_element(degree);
        }
      Assert(false, ExcInternalError());
      return nullptr;
    }
  } // namespace Beam
} // namespace Heddle
