#ifndef heddle_contact_geometric_stiffness_h
#define heddle_contact_geometric_stiffness_h

#include <heddle/contact/contact_element.h>
#include <heddle/contact/curve.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    /**
     * How the force of an element turns when its particles move relative to
     * each other by @f$\delta@f$: the geometric part of its tangent [N/mm],
     * @f[ -\frac{f}{D} \left( I - n n^T - \frac{c c^T}{h} \right), \quad
     *     c = t_a + \sigma t_b, \quad
     *     h = c \cdot c + D\, n \cdot (\kappa_a - \kappa_b), @f]
     * with the distance of the axes D, the tangents t and the curvatures
     * @f$\kappa@f$. The last term is of particles that give way to each other
     * along c, see IntermediateGeometry, as those at the end of a fiber do not.
     * That they do so too where fibers turn is left out: it is of the relative
     * size (D over the length of a wave)^2.
     *
     * The force is that of the element, D its @p distance [mm]. Nothing where
     * fibers bend around each other so sharply that hardly a distance is
     * stationary.
     */
    SymmetricTensor<2, 3>
    geometric_stiffness(const Curve          &a,
                        const Curve          &b,
                        const ContactElement &element,
                        const double          distance);
  } // namespace Contact
} // namespace Heddle

#endif
