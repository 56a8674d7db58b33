#ifndef heddle_contributions_centerlines_h
#define heddle_contributions_centerlines_h

#include <heddle/contact/curve.h>
#include <heddle/system/state.h>

#include <utility>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * The smooth centerlines of all fibers that a rank has, its own and what it
     * holds of others: what contact and crossings see. Of a vector other than
     * the configuration, its interpolation along the fibers.
     */
    class Centerlines
    {
    public:
      explicit Centerlines(const System::FiberSpace &space);

      /** Take the fibers that @p state has from @p blocks of all of them. */
      void
      set(const System::State &state, const std::vector<Tensor<1, 3>> &blocks);

      /** The centerline of fiber @p f, as long as none is set anew. */
      Contact::Curve
      curve(const unsigned int f) const;

      /** Numbers [first, second) of the knots of fiber @p f in what follows. */
      std::pair<unsigned int, unsigned int>
      knots(const unsigned int f) const
      {
        return {first_knots[f],
                first_knots[f] + ranges[f].end - ranges[f].begin};
      }

      const std::vector<Tensor<1, 3>> &
      positions() const
      {
        return knot_positions;
      }

      /** Derivatives in arc length. */
      const std::vector<Tensor<1, 3>> &
      tangents() const
      {
        return knot_tangents;
      }

    private:
      const System::FiberSpace        &space;
      std::vector<System::NodeRange>   ranges;
      std::vector<unsigned int>        first_knots;
      std::vector<Tensor<1, 3>>        knot_positions, knot_tangents;
      std::vector<Contact::CurveCubic> cubics;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
