#ifndef heddle_contact_contact_element_h
#define heddle_contact_contact_element_h

#include <deal.II/base/tensor.h>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    /**
     * Two material particles that face each other, anywhere on two fibers, in
     * the plane normal to the intermediate geometry between them.
     */
    struct ContactElement
    {
      unsigned int fiber_a;
      unsigned int fiber_b;
      unsigned int zone;  /**< number of its proximity zone on this rank */
      unsigned int cell;  /**< number of its cell on this rank */
      int    orientation; /**< +1: the fibers run the same way there, else -1 */
      double s_a;         /**< arc length of the particle on a [mm] */
      double s_b;         /**< arc length of the particle on b [mm] */
      double weight;   /**< tributary length of the intermediate curve [mm] */
      double gap;      /**< distance of the surfaces, negative inside [mm] */
      double forgiven; /**< penetration that counts as none [mm] */
      double force;    /**< normal force, not negative [N] */
      double penalty;  /**< force per length per penetration [N/mm^2] */
      Tensor<1, 3> normal; /**< unit vector from b to a */
    };

    /** What friction does where two particles touch. */
    struct TangentialForce
    {
      Tensor<1, 3> on_a;       /**< its opposite acts on b [N] */
      double       ratio = 0.; /**< of the limit: 1 where they slip [-] */
    };
  } // namespace Contact
} // namespace Heddle

#endif
