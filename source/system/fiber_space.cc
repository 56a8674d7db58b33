#include <heddle/system/fiber_space.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Heddle
{
  namespace System
  {
    namespace internal
    {
      namespace FiberSpaceImplementation
      {
        /**
         * Cut the fibers into one consecutive piece for each rank, with nodes
         * spread as evenly as whole fibers allow.
         */
        std::vector<unsigned int>
        partition(const std::vector<Fiber> &fibers,
                  const unsigned int        n_nodes,
                  const unsigned int        n_ranks)
        {
          std::vector<unsigned int> begin(n_ranks + 1, fibers.size());
          begin[0]            = 0;
          unsigned int rank   = 1;
          double       so_far = 0.;
          for (unsigned int f = 0; f < fibers.size(); ++f)
            {
              // A fiber goes to the rank in whose share its middle lies.
              const double middle = so_far + 0.5 * fibers[f].n_nodes;
              while (rank < n_ranks &&
                     middle * n_ranks >= double(n_nodes) * rank)
                begin[rank++] = f;
              so_far += fibers[f].n_nodes;
            }
          return begin;
        }

        /**
         * Weights of three of @p n nodes at arc lengths @p s, in the derivative
         * at @p node of the parabola through them; at the ends of a fiber these
         * are the first or last three. Two nodes are joined by a line.
         */
        std::array<double, 3>
        parabola_slope(const unsigned int node,
                       const unsigned int n,
                       const double      *s)
        {
          if (n == 2)
            return {{-1. / s[1], 1. / s[1], 0.}};
          const unsigned int i = std::min(std::max(node, 1u), n - 2);
          const double       a = s[i - 1], b = s[i], c = s[i + 1], x = s[node];
          return {{(2. * x - b - c) / ((a - b) * (a - c)),
                   (2. * x - a - c) / ((b - a) * (b - c)),
                   (2. * x - a - b) / ((c - a) * (c - b))}};
        }
      } // namespace FiberSpaceImplementation
    }   // namespace internal



    FiberSpace::FiberSpace(const MPI_Comm                  communicator,
                           std::unique_ptr<Beam::Element>  element,
                           const std::vector<Description> &descriptions)
      : mpi_communicator(communicator)
      , beam_element(std::move(element))
      , blocks_per_node(beam_element->n_blocks_per_node())
      , this_rank(Utilities::MPI::this_mpi_process(communicator))
      , total_nodes(0)
    {
      const unsigned int nodes_per_element = beam_element->n_nodes() - 1;
      for (const Description &description : descriptions)
        {
          Fiber fiber;
          fiber.first_node = total_nodes;
          fiber.n_elements = description.element_lengths.size();
          fiber.n_nodes    = fiber.n_elements * nodes_per_element + 1;
          fiber.radius     = description.radius;
          fiber.yarn_id    = description.yarn_id;
          fiber.bundle_id  = description.bundle_id;
          fiber.set        = description.set;
          fiber.section    = description.section;
          if (fiber.yarn_id != numbers::invalid_unsigned_int)
            yarns = std::max(yarns, fiber.yarn_id + 1);
          least_radius = std::min(least_radius, fiber.radius);

          arc_lengths.push_back(0.);
          double begin = 0.;
          for (const double length : description.element_lengths)
            {
              for (unsigned int i = 1; i <= nodes_per_element; ++i)
                arc_lengths.push_back(begin + i * length / nodes_per_element);
              begin += length;
            }
          fiber.length = begin;
          total_nodes += fiber.n_nodes;
          fibers.push_back(fiber);
          for (unsigned int i = 0; i < fiber.n_nodes; ++i)
            parabola_slopes.push_back(
              internal::FiberSpaceImplementation::parabola_slope(
                i, fiber.n_nodes, arc_lengths.data() + fiber.first_node));
          add_interval_slopes(fibers.size() - 1);
        }
      rank_begin = internal::FiberSpaceImplementation::partition(
        fibers, total_nodes, Utilities::MPI::n_mpi_processes(communicator));
    }



    const FiberNames &
    FiberSpace::names() const
    {
      if (!fiber_names)
        {
          std::vector<FiberName> names;
          for (const Fiber &fiber : fibers)
            names.push_back({fiber.set, fiber.yarn_id});
          fiber_names = std::make_unique<const FiberNames>(names);
        }
      return *fiber_names;
    }



    void
    FiberSpace::add_interval_slopes(const unsigned int f)
    {
      // A last one, of no interval, for the last node.
      interval_slopes.resize(interval_slopes.size() + fibers[f].n_nodes);
      for (unsigned int i = 0; i + 1 < fibers[f].n_nodes; ++i)
        for (unsigned int end = 0; end < 2; ++end)
          {
            const unsigned int node = fibers[f].first_node + i;
            const unsigned int shift =
              first_of_parabola(f, i + end) - first_of_interval(f, i);
            std::copy_n(parabola_slopes[node + end].begin(),
                        3,
                        interval_slopes[node][end].begin() + shift);
          }
    }



    std::pair<unsigned int, unsigned int>
    FiberSpace::owned_blocks() const
    {
      return {this_rank == 0 ? 0 : end_of_blocks(this_rank - 1),
              end_of_blocks(this_rank)};
    }



    double
    FiberSpace::element_length(const unsigned int f, const unsigned int e) const
    {
      const unsigned int per_element = beam_element->n_nodes() - 1;
      const double      *s           = node_positions(f);
      return s[(e + 1) * per_element] - s[e * per_element];
    }



    unsigned int
    FiberSpace::interval(const unsigned int f, const double s) const
    {
      const double      *knots = node_positions(f);
      const unsigned int last  = fibers[f].n_nodes - 2;

      // Nearly all fibers have equal elements: this guess is then right.
      unsigned int i = std::min<unsigned int>(
        last, static_cast<unsigned int>(s / fibers[f].length * (last + 1)));
      while (i > 0 && s < knots[i])
        --i;
      while (i < last && s >= knots[i + 1])
        ++i;
      return i;
    }



    std::array<std::pair<unsigned int, double>, 3>
    FiberSpace::tangent_weights(const unsigned int f,
                                const unsigned int node) const
    {
      const auto        &slopes = parabola_slopes[fibers[f].first_node + node];
      const unsigned int first  = first_of_parabola(f, node);

      // Two nodes have none but a line: the third weight is zero.
      return {{{first, slopes[0]},
               {first + 1, slopes[1]},
               {std::min(first + 2, fibers[f].n_nodes - 1), slopes[2]}}};
    }



    MaterialPoint
    FiberSpace::locate(const unsigned int f, const double s) const
    {
      const double      *knots  = node_positions(f);
      const unsigned int i      = interval(f, s);
      const double       length = knots[i + 1] - knots[i];
      return particle(f, i, (s - knots[i]) / length, length);
    }



    MaterialPoint
    FiberSpace::locate(const unsigned int     f,
                       const double           s,
                       std::array<double, 4> &slopes) const
    {
      const double      *knots  = node_positions(f);
      const unsigned int i      = interval(f, s);
      const double       length = knots[i + 1] - knots[i];
      const double       t      = (s - knots[i]) / length;
      const double       steep  = 6. * t * (1. - t) / length;
      slopes                    = combine(
        f, i, {{-steep, (1. - t) * (1. - 3. * t), steep, -t * (2. - 3. * t)}});
      return particle(f, i, t, length);
    }



    MaterialPoint
    FiberSpace::particle(const unsigned int f,
                         const unsigned int i,
                         const double       t,
                         const double       length) const
    {
      MaterialPoint point;
      point.values = combine(f,
                             i,
                             {{(1. + 2. * t) * (1. - t) * (1. - t),
                               length * t * (1. - t) * (1. - t),
                               t * t * (3. - 2. * t),
                               -length * t * t * (1. - t)}});
      if (blocks_per_node == 2)
        point.blocks = {{2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 3}};
      else
        // A fiber of two or three nodes repeats its last one, weight zero.
        for (unsigned int k = 0; k < 4; ++k)
          point.blocks[k] =
            3 * std::min(first_of_interval(f, i) + k, fibers[f].n_nodes - 1);
      return point;
    }



    SectionPoint
    FiberSpace::locate_section(const unsigned int f, const double s) const
    {
      AssertDimension(blocks_per_node, 3);
      const double      *knots = node_positions(f);
      const unsigned int i     = interval(f, s);
      const double       t     = (s - knots[i]) / (knots[i + 1] - knots[i]);
      return {{{3 * i + 1, 3 * i + 4}}, {{1. - t, t}}};
    }



    std::array<double, 4>
    FiberSpace::combine(const unsigned int           f,
                        const unsigned int           i,
                        const std::array<double, 4> &hermite) const
    {
      if (blocks_per_node == 2)
        return hermite;
      const IntervalSlopes &slopes = interval_slopes[fibers[f].first_node + i];
      const unsigned int    begin  = i - first_of_interval(f, i);
      std::array<double, 4> values;
      for (unsigned int k = 0; k < 4; ++k)
        values[k] = (k == begin ? hermite[0] : 0.) +
                    (k == begin + 1 ? hermite[2] : 0.) +
                    hermite[1] * slopes[0][k] + hermite[3] * slopes[1][k];
      return values;
    }



    NodeRange
    FiberSpace::nodes_below(const unsigned int f, const NodeRange &nodes) const
    {
      // See first_of_interval(): at the ends of a fiber the four nodes begin
      // further in.
      return lengthened(f, nodes, 2);
    }



    NodeRange
    FiberSpace::knots_from(const unsigned int f, const NodeRange &held) const
    {
      // The tangent of a node takes its neighbours, and that of an end the two
      // next ones, see first_of_parabola(): of nodes that are held for the
      // matrix alone there may be fewer.
      const unsigned int n       = fibers[f].n_nodes;
      const unsigned int begin   = held.begin > 0 ? held.begin + 1 : 0;
      const unsigned int end     = held.end < n ? held.end - 1 : n;
      const bool         has_end = begin == 0 || end == n;
      const bool         too_few = has_end && blocks_per_node == 3 &&
                           held.end - held.begin < std::min(n, 3u);
      return {begin, too_few ? begin : std::max(begin, end)};
    }



    void
    FiberSpace::centerline_knots(const unsigned int  f,
                                 const NodeRange    &held,
                                 const Tensor<1, 3> *blocks,
                                 Tensor<1, 3>       *positions,
                                 Tensor<1, 3>       *tangents) const
    {
      const NodeRange knots = knots_from(f, held);
      const auto      block = [&](const unsigned int node) {
        return blocks + blocks_per_node * (node - held.begin);
      };
      for (unsigned int i = knots.begin; i < knots.end; ++i)
        {
          positions[i - knots.begin] = block(i)[0];
          Tensor<1, 3> &tangent      = tangents[i - knots.begin];
          if (blocks_per_node == 2)
            {
              tangent = block(i)[1];
              continue;
            }
          tangent = 0.;
          for (const auto &weight : tangent_weights(f, i))
            tangent += weight.second * block(weight.first)[0];
        }
    }
  } // namespace System
} // namespace Heddle
