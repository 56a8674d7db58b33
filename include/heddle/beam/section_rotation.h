#ifndef heddle_beam_section_rotation_h
#define heddle_beam_section_rotation_h

#include <deal.II/base/tensor.h>

namespace Heddle
{
  namespace Beam
  {
    using namespace dealii;

    /**
     * The rotation vector [rad] that takes a section from @p before to
     * @p after, by less than half a turn: that of the frames along two section
     * vectors, or the least one that takes one tangent to the other.
     * @p n_vectors is 2 or 1.
     */
    Tensor<1, 3>
    section_rotation(const unsigned int  n_vectors,
                     const Tensor<1, 3> *before,
                     const Tensor<1, 3> *after);
  } // namespace Beam
} // namespace Heddle

#endif
