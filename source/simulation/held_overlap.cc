#include <heddle/base/exceptions.h>
#include <heddle/base/reduce.h>
#include <heddle/base/throw_together.h>
#include <heddle/simulation/held_overlap.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iomanip>
#include <set>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    namespace internal
    {
      namespace HeldOverlap
      {
        /** Two nodes that are held in each other. */
        struct Pair
        {
          double       depth   = 0.; /**< penetration [mm] */
          double       radius  = 1.; /**< the smaller one [mm] */
          unsigned int fiber_a = 0;
          unsigned int fiber_b = 0;
          Point<3>     position; /**< [mm] */

          double
          ratio() const
          {
            return depth / radius;
          }
        };



        /** Pairs that are so for good, and others: those of this rank. */
        struct Pairs
        {
          Pair                                            deepest;
          std::set<std::pair<unsigned int, unsigned int>> fibers;

          void
          add(const Pair &pair)
          {
            if (pair.ratio() > deepest.ratio())
              deepest = pair;
            fibers.insert({pair.fiber_a, pair.fiber_b});
          }
        };



        /** Beside each other, not one behind the end of the other. */
        bool
        is_beside(const Tensor<1, 3> &connection, const Tensor<1, 3> &tangent)
        {
          constexpr double largest_cosine = 0.5;
          return std::abs(connection * tangent) <=
                 largest_cosine * connection.norm() * tangent.norm();
        }



        class Search
        {
        public:
          Search(const System::FiberSpace          &space,
                 const Contributions::FiberContact &contact,
                 const Contributions::Supports     &supports,
                 const double                       threshold)
            : space(space)
            , contact(contact)
            , supports(supports)
            , threshold(threshold)
          {
          }

          /** Look at the nodes next to the particles of an element. */
          void
          look_at(const Contact::ContactElement &element)
          {
            const unsigned int a = element.fiber_a, b = element.fiber_b;
            const unsigned int i = space.interval(a, element.s_a),
                               j = space.interval(b, element.s_b);
            for (unsigned int m = i; m < i + 2; ++m)
              for (unsigned int n = j; n < j + 2; ++n)
                look_at(a, m, b, n);
          }

          Pairs for_good, others;

        private:
          void
          look_at(const unsigned int a,
                  const unsigned int m,
                  const unsigned int b,
                  const unsigned int n)
          {
            const auto x =
                         supports.prescribed_position(a, m, /*load_factor=*/0.),
                       y = supports.prescribed_position(b, n, 0.);
            if (!x || !y)
              return;
            const double sum = space.fiber(a).radius + space.fiber(b).radius;
            Pair         pair;
            pair.depth = sum - (*x - *y).norm();
            pair.radius =
              std::min(space.fiber(a).radius, space.fiber(b).radius);
            pair.fiber_a  = a;
            pair.fiber_b  = b;
            pair.position = Point<3>(0.5 * (*x + *y));
            if (pair.ratio() <= threshold ||
                !is_beside(*x - *y, contact.curves()[a].tangent(m)) ||
                !is_beside(*x - *y, contact.curves()[b].tangent(n)))
              return;
            const auto x_1 = supports.prescribed_position(a, m, 1.),
                       y_1 = supports.prescribed_position(b, n, 1.);
            const double depth_in_the_end = sum - (*x_1 - *y_1).norm();
            const bool   stays = depth_in_the_end > threshold * pair.radius;
            (stays && is_end(a, m) && is_end(b, n) ? for_good : others)
              .add(pair);
          }

          bool
          is_end(const unsigned int f, const unsigned int node) const
          {
            return node == 0 || node + 1 == space.fiber(f).n_nodes;
          }

          const System::FiberSpace          &space;
          const Contributions::FiberContact &contact;
          const Contributions::Supports     &supports;
          const double                       threshold;
        };



        /**
         * "by 0.005 mm, 0.05 of the radius, near (0, 0, 0), and
         * Contact/Penetration threshold allows 0.02, 0.002 mm"; behind the
         * fibers' numbers, and nothing if there are none.
         * @note Collective.
         */
        std::string
        in_words(const Pairs   &pairs,
                 const double   threshold,
                 const char    *begin,
                 const char    *what,
                 const MPI_Comm communicator)
        {
          const auto deepest =
            Utilities::MPI::min_max_avg(pairs.deepest.ratio(), communicator);
          std::array<double, 1> n = {
            {static_cast<double>(pairs.fibers.size())}};
          sum_over_ranks(n, communicator);
          if (n[0] == 0.)
            return "";
          const Pair pair = Utilities::MPI::broadcast(
            communicator, pairs.deepest, deepest.max_index);
          std::ostringstream text;
          text << std::setprecision(3) << begin << pair.fiber_a << " and "
               << pair.fiber_b << what << pair.depth << " mm, " << pair.ratio()
               << " of the radius, near (" << pair.position[0] << ", "
               << pair.position[1] << ", " << pair.position[2]
               << "), and Contact/Penetration threshold allows " << threshold
               << " of it, " << threshold * pair.radius << " mm";
          if (n[0] > 1.)
            text << ", the deepest of " << n[0] << " pairs of fibers";
          text << ": ";
          return text.str();
        }
      } // namespace HeldOverlap
    }   // namespace internal



    std::string
    held_overlap(const System::FiberSpace          &space,
                 const Contributions::FiberContact &contact,
                 const Contributions::Supports     &supports,
                 const double                       threshold)
    {
      namespace helpers = internal::HeldOverlap;
      helpers::Search search(space, contact, supports, threshold);
      throw_together(
        [&]() {
          for (const Contact::ContactElement &element : contact.elements())
            if (element.force > 0. && space.owns(element.fiber_a) &&
                element.fiber_a != element.fiber_b)
              search.look_at(element);
        },
        space.communicator());
      const std::string refusal =
        helpers::in_words(search.for_good,
                          threshold,
                          "Supports hold ends of fibers ",
                          " that lie in each other, at load factor 0 and still "
                          "at 1, by ",
                          space.communicator());
      require(refusal.empty(),
              refusal +
                "no contact force parts them; let them begin further apart "
                "(Centerlines/File), let supports leave one of them free in a "
                "direction, or raise the threshold (at most 0.2).");
      const std::string note =
        helpers::in_words(search.others,
                          threshold,
                          "at the start supports hold nodes of fibers ",
                          " in each other, by ",
                          space.communicator());
      return note.empty()
               ? ""
               : note +
                   "no contact force parts them, and if supports do not, no "
                   "equilibrium may be found; let them begin further apart";
    }
  } // namespace Simulation
} // namespace Heddle
