#include <heddle/contributions/centerlines.h>

namespace Heddle
{
  namespace Contributions
  {
    Centerlines::Centerlines(const System::FiberSpace &space)
      : space(space)
    {
    }



    void
    Centerlines::set(const System::State             &state,
                     const std::vector<Tensor<1, 3>> &blocks)
    {
      ranges.assign(space.n_fibers(), {});
      first_knots.assign(space.n_fibers(), 0);
      unsigned int n_knots = 0;
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        if (state.has(f))
          {
            ranges[f]      = space.knots_from(f, state.held_nodes(f));
            first_knots[f] = n_knots;
            n_knots += ranges[f].end - ranges[f].begin;
          }
      knot_positions.resize(n_knots);
      knot_tangents.resize(n_knots);
      cubics.resize(n_knots);
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        if (state.has(f))
          {
            const unsigned int first = first_knots[f];
            space.centerline_knots(f,
                                   state.held_nodes(f),
                                   blocks.data() + state.held_blocks(f).first,
                                   knot_positions.data() + first,
                                   knot_tangents.data() + first);
            Contact::set_cubics(ranges[f].end - ranges[f].begin,
                                space.node_positions(f) + ranges[f].begin,
                                knot_positions.data() + first,
                                knot_tangents.data() + first,
                                cubics.data() + first);
          }
    }



    Contact::Curve
    Centerlines::curve(const unsigned int f) const
    {
      const unsigned int first = first_knots[f];
      return Contact::Curve(space.fiber(f).n_nodes,
                            {ranges[f].begin, ranges[f].end},
                            space.node_positions(f),
                            knot_positions.data() + first,
                            knot_tangents.data() + first,
                            cubics.data() + first,
                            space.fiber(f).radius);
    }
  } // namespace Contributions
} // namespace Heddle
