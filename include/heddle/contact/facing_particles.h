#ifndef heddle_contact_facing_particles_h
#define heddle_contact_facing_particles_h

#include <deal.II/base/tensor.h>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    class IntermediateGeometry;

    /** Which fiber's end, if any, is one of two facing particles. */
    enum class FacingEnd
    {
      none,
      first_of_a,
      last_of_a,
      first_of_b,
      last_of_b
    };

    /** Two particles that face each other. */
    struct FacingParticles
    {
      double       s_a, s_b;         /**< arc lengths [mm] */
      Tensor<1, 3> connection;       /**< from b to a [mm] */
      double       squared_distance; /**< of the axes [mm^2] */
      double       slope; /**< of the squared distance along p [mm] */
      FacingEnd    end;
    };

    /**
     * Find the particles at p[i] in the intermediate geometry *between[i], from
     * the guess q[i] of $s_a - \sigma s_b$, which is set to what was found, for
     * i from 0 to @p n - 1. Four at once take about as long as one.
     */
    template <unsigned int n>
    void
    find_facing(const IntermediateGeometry *const *between,
                const double                      *p,
                double                            *q,
                FacingParticles                   *particles);
  } // namespace Contact
} // namespace Heddle

#endif
