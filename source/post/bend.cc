#include <heddle/post/bend.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

namespace Heddle
{
  namespace Post
  {
    std::string
    Bend::in_words() const
    {
      std::ostringstream text;
      text << std::setprecision(2) << "fiber " << fiber << " is bent to "
           << 1. / ratio << " times its own radius near ("
           << std::setprecision(3) << position[0] << ", " << position[1] << ", "
           << position[2] << ")";
      return text.str();
    }



    Bend
    sharpest_bend(const System::State &state)
    {
      const System::FiberSpace &space = state.space;
      Bend                      bend;
      std::vector<Tensor<1, 3>> positions, tangents;
      const auto                range = space.owned_fibers();
      for (unsigned int f = range.first; f < range.second; ++f)
        {
          const System::Fiber &fiber = space.fiber(f);
          positions.resize(fiber.n_nodes);
          tangents.resize(fiber.n_nodes);
          space.centerline_knots(f,
                                 space.all_nodes(f),
                                 state.fiber(f),
                                 positions.data(),
                                 tangents.data());
          // The second derivative of a cubic is largest at one of its ends.
          const double *nodes = space.node_positions(f);
          for (unsigned int i = 0; i + 1 < fiber.n_nodes; ++i)
            {
              const double       h    = nodes[i + 1] - nodes[i];
              const Tensor<1, 3> mean = (positions[i + 1] - positions[i]) / h;
              const auto         take = [&](const unsigned int  node,
                                    const Tensor<1, 3> &second) {
                const Tensor<1, 3> &t     = tangents[node];
                const double        ratio = fiber.radius *
                                     cross_product_3d(t, second).norm() /
                                     std::pow(t.norm(), 3);
                if (ratio > bend.ratio)
                  bend = {ratio, f, Point<3>(positions[node])};
              };
              take(i,
                   (6. * mean - 4. * tangents[i] - 2. * tangents[i + 1]) / h);
              take(i + 1,
                   (2. * tangents[i] + 4. * tangents[i + 1] - 6. * mean) / h);
            }
        }
      const auto sharpest =
        Utilities::MPI::min_max_avg(bend.ratio, space.communicator());
      return Utilities::MPI::broadcast(
        space.communicator(), bend, sharpest.max_index);
    }



    bool
    BentContact::is_tight() const
    {
      // A thin fiber around a thick drum takes half, however gently it is bent.
      constexpr double much = 0.75, sharp = 1. / 3.;
      return taken > much && bend.ratio > sharp;
    }



    std::string
    BentContact::in_words() const
    {
      return bend.in_words() + ", where it touches fiber " +
             std::to_string(other);
    }



    BentContact
    tightest_contact(const System::FiberSpace                   &space,
                     const Contact::CurveList                   &curves,
                     const std::vector<Contact::ContactElement> &elements)
    {
      BentContact tightest;
      const auto  particle = [&](const unsigned int f, const double s) {
        unsigned int interval = curves[f].interval(s);
        return curves[f].evaluate(s, interval);
      };
      const auto bend = [&](const unsigned int         f,
                            const Contact::CurvePoint &at) {
        const double ratio = space.fiber(f).radius *
                             cross_product_3d(at.tangent, at.curvature).norm() /
                             std::pow(at.tangent.norm(), 3);
        return Bend{ratio, f, Point<3>(at.position)};
      };
      for (const Contact::ContactElement &element : elements)
        if (element.force > 0. && space.owns(element.fiber_a))
          {
            const auto a = particle(element.fiber_a, element.s_a),
                       b = particle(element.fiber_b, element.s_b);
            const Tensor<1, 3> sum =
              a.tangent + static_cast<double>(element.orientation) * b.tangent;
            const double taken = (a.position - b.position) *
                                 (b.curvature - a.curvature) /
                                 sum.norm_square();
            if (taken > tightest.taken)
              {
                const Bend of_a = bend(element.fiber_a, a),
                           of_b = bend(element.fiber_b, b);
                tightest        = of_a.ratio >= of_b.ratio
                                    ? BentContact{taken, of_a, element.fiber_b}
                                    : BentContact{taken, of_b, element.fiber_a};
              }
          }
      const auto worst =
        Utilities::MPI::min_max_avg(tightest.taken, space.communicator());
      return Utilities::MPI::broadcast(
        space.communicator(), tightest, worst.max_index);
    }
  } // namespace Post
} // namespace Heddle
