#ifndef heddle_system_fiber_space_h
#define heddle_system_fiber_space_h

#include <heddle/base/fiber_names.h>
#include <heddle/beam/element.h>

#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Heddle
{
  namespace System
  {
    using namespace dealii;

    /**
     * Shape values of the smooth centerline of a fiber at one material point:
     * $x = \sum_{i<4} N_i\, q_{b_i}$, where $q_b$ is the block (a position or
     * a tangent) number b of this fiber.
     */
    struct MaterialPoint
    {
      std::array<unsigned int, 4> blocks;
      std::array<double, 4>       values; /**< [-], or [mm] of a tangent */

      /** Return x [mm]; @p q are the blocks of the fiber. */
      Tensor<1, 3>
      position(const Tensor<1, 3> *q) const
      {
        Tensor<1, 3> x;
        for (unsigned int i = 0; i < blocks.size(); ++i)
          x += values[i] * q[blocks[i]];
        return x;
      }
    };

    /**
     * How the section vectors at one material point follow from those of the
     * nodes: $g_\alpha = \sum_{i<2} L_i\, q_{b_i + \alpha - 1}$.
     */
    struct SectionPoint
    {
      std::array<unsigned int, 2> blocks; /**< of g_1; g_2 follows */
      std::array<double, 2>       values;
    };

    /** Nodes begin <= i < end of a fiber. */
    struct NodeRange
    {
      unsigned int begin = 0, end = 0;

      bool
      empty() const
      {
        return begin == end;
      }

      bool
      contains(const NodeRange &other) const
      {
        return other.empty() || (begin <= other.begin && other.end <= end);
      }

      bool
      operator==(const NodeRange &other) const
      {
        return begin == other.begin && end == other.end;
      }
    };

    /** What the space keeps of one fiber, on every rank. */
    struct Fiber
    {
      unsigned int  first_node; /**< global number of its first node */
      unsigned int  n_nodes;
      unsigned int  n_elements;
      double        length;    /**< reference length [mm] */
      double        radius;    /**< [mm] */
      unsigned int  yarn_id;   /**< invalid_unsigned_int: of none */
      unsigned int  bundle_id; /**< the same */
      std::string   set;
      Beam::Section section;
    };

    /**
     * The discrete fibers: which nodes and elements there are, how they are
     * numbered, which rank owns which fiber, and the smooth centerline that
     * contact, coupling and output see.
     *
     * Unknowns come in *blocks* of three numbers; a node has two (Hermite:
     * position, tangent) or three (director: position, two section vectors).
     * Blocks are numbered fiber by fiber, node by node, so that a fiber is a
     * band of the system, and ranks own consecutive whole fibers. Within one
     * fiber a block is addressed by its number counted from the fiber's first.
     *
     * The centerline is piecewise cubic and C1 for every element: the Hermite
     * element's own, and, through the nodes of the director element, the cubic
     * with tangents from the parabola through three neighbouring nodes.
     */
    class FiberSpace
    {
    public:
      /** Description of a fiber to be added: all but the numbering. */
      struct Description
      {
        std::vector<double> element_lengths; /**< reference lengths [mm] */
        double              radius;
        unsigned int        yarn_id;
        unsigned int        bundle_id;
        std::string         set;
        Beam::Section       section;
      };

      FiberSpace(const MPI_Comm                  communicator,
                 std::unique_ptr<Beam::Element>  element,
                 const std::vector<Description> &fibers);

      MPI_Comm
      communicator() const
      {
        return mpi_communicator;
      }

      const Beam::Element &
      element() const
      {
        return *beam_element;
      }

      unsigned int
      n_fibers() const
      {
        return fibers.size();
      }

      /** Yarns to which fibers belong; they are numbered from 0. */
      unsigned int
      n_yarns() const
      {
        return yarns;
      }

      /** Of all fibers [mm]. */
      double
      smallest_radius() const
      {
        return least_radius;
      }

      const Fiber &
      fiber(const unsigned int f) const
      {
        return fibers[f];
      }

      /** Fibers [first, second) belong to this rank. */
      std::pair<unsigned int, unsigned int>
      owned_fibers() const
      {
        return {rank_begin[this_rank], rank_begin[this_rank + 1]};
      }

      bool
      owns(const unsigned int f) const
      {
        return f >= rank_begin[this_rank] && f < rank_begin[this_rank + 1];
      }

      /** Rank that owns fiber @p f. */
      unsigned int
      owner(const unsigned int f) const
      {
        return std::upper_bound(rank_begin.begin(), rank_begin.end(), f) -
               rank_begin.begin() - 1;
      }

      /** Numbers of the whole scene, over all ranks. */
      unsigned int
      n_nodes() const
      {
        return total_nodes;
      }

      unsigned int
      n_blocks() const
      {
        return total_nodes * blocks_per_node;
      }

      unsigned int
      n_dofs() const
      {
        return 3 * n_blocks();
      }

      unsigned int
      n_blocks_per_node() const
      {
        return blocks_per_node;
      }

      unsigned int
      n_blocks(const unsigned int f) const
      {
        return fibers[f].n_nodes * blocks_per_node;
      }

      /** Global number of the first block of fiber @p f. */
      unsigned int
      first_block(const unsigned int f) const
      {
        return fibers[f].first_node * blocks_per_node;
      }

      /** Blocks [first, second) belong to this rank. */
      std::pair<unsigned int, unsigned int>
      owned_blocks() const;

      /** The end of the blocks of @p rank. */
      unsigned int
      end_of_blocks(const unsigned int rank) const
      {
        const unsigned int f = rank_begin[rank + 1];
        return f < fibers.size() ? first_block(f) : n_blocks();
      }

      /** Block of the fiber at which its element @p e begins. */
      unsigned int
      first_block_of_element(const unsigned int e) const
      {
        return e * (beam_element->n_nodes() - 1) * blocks_per_node;
      }

      /** The words by which fibers are chosen, made when they are asked for. */
      const FiberNames &
      names() const;

      /** Reference arc lengths of the nodes of fiber @p f, from 0 [mm]. */
      const double *
      node_positions(const unsigned int f) const
      {
        return arc_lengths.data() + fibers[f].first_node;
      }

      /** Reference length of element @p e of fiber @p f [mm]. */
      double
      element_length(const unsigned int f, const unsigned int e) const;

      /**
       * Return which blocks of fiber @p f make up the position of its particle
       * at arc length @p s [mm], 0 <= s <= length.
       */
      MaterialPoint
      locate(const unsigned int f, const double s) const;

      /**
       * The same; the derivative of the position in arc length is the sum of
       * the same blocks with the weights @p slopes [1/mm].
       */
      MaterialPoint
      locate(const unsigned int     f,
             const double           s,
             std::array<double, 4> &slopes) const;

      /** Return what the section at @p s is made of: three blocks per node. */
      SectionPoint
      locate_section(const unsigned int f, const double s) const;

      NodeRange
      all_nodes(const unsigned int f) const
      {
        return {0, fibers[f].n_nodes};
      }

      /** @p nodes of fiber @p f and up to @p more on both sides of them. */
      NodeRange
      lengthened(const unsigned int f,
                 const NodeRange   &nodes,
                 const unsigned int more) const
      {
        return {nodes.begin - std::min(more, nodes.begin),
                std::min(nodes.end + more, fibers[f].n_nodes)};
      }

      /**
       * Nodes of fiber @p f whose blocks the centerline from the first to the
       * last of @p nodes is made of, and the sections there.
       */
      NodeRange
      nodes_below(const unsigned int f, const NodeRange &nodes) const;

      /** Knots that follow if the blocks of the nodes @p held are known. */
      NodeRange
      knots_from(const unsigned int f, const NodeRange &held) const;

      /**
       * Write positions and arc-length derivatives of the centerline at the
       * nodes knots_from(@p f, @p held): knots of its piecewise cubic.
       * @p blocks are those of the nodes @p held.
       */
      void
      centerline_knots(const unsigned int  f,
                       const NodeRange    &held,
                       const Tensor<1, 3> *blocks,
                       Tensor<1, 3>       *positions,
                       Tensor<1, 3>       *tangents) const;

      /** Return the i with node i <= s < node i + 1 of fiber @p f. */
      unsigned int
      interval(const unsigned int f, const double s) const;

      /** Arc length of the middle between nodes @p i and i + 1 [mm]. */
      double
      middle(const unsigned int f, const unsigned int i) const
      {
        const double *s = node_positions(f);
        return 0.5 * (s[i] + s[i + 1]);
      }

      /** Weights by which the positions of three nodes give the tangent of @p
       * node [1/mm]. */
      std::array<std::pair<unsigned int, double>, 3>
      tangent_weights(const unsigned int f, const unsigned int node) const;

    private:
      /** Set the interval_slopes of a fiber that is added. */
      void
      add_interval_slopes(const unsigned int f);

      /** First of the three nodes whose parabola gives the slope of a node. */
      unsigned int
      first_of_parabola(const unsigned int f, const unsigned int node) const
      {
        return std::min(std::max(node, 1u),
                        std::max(fibers[f].n_nodes, 3u) - 2) -
               1;
      }

      /** First of the four nodes below the centerline from node @p i to the
       * next one, where their slopes follow from their positions. */
      unsigned int
      first_of_interval(const unsigned int f, const unsigned int i) const
      {
        return std::min(std::max(i, 1u), std::max(fibers[f].n_nodes, 4u) - 3) -
               1;
      }

      /** The particle at the part @p t of the way from node @p i to the next
       * one, which is @p length. */
      MaterialPoint
      particle(const unsigned int f,
               const unsigned int i,
               const double       t,
               const double       length) const;

      /**
       * Weights of the blocks below the centerline from node @p i to the next
       * one, where position and slope at both have the weights @p hermite.
       */
      std::array<double, 4>
      combine(const unsigned int           f,
              const unsigned int           i,
              const std::array<double, 4> &hermite) const;

      const MPI_Comm                       mpi_communicator;
      const std::unique_ptr<Beam::Element> beam_element;
      const unsigned int                   blocks_per_node;
      unsigned int                         this_rank;
      unsigned int                         total_nodes;
      unsigned int                         yarns = 0;
      double              least_radius = std::numeric_limits<double>::max();
      std::vector<Fiber>  fibers;
      std::vector<double> arc_lengths;

      /** Weights of the nodes of a parabola in the slope of each node. */
      std::vector<std::array<double, 3>> parabola_slopes;

      /** The same of the four nodes below each interval, for both its ends. */
      using IntervalSlopes = std::array<std::array<double, 4>, 2>;
      std::vector<IntervalSlopes> interval_slopes;
      std::vector<unsigned int>   rank_begin;

      mutable std::unique_ptr<const FiberNames> fiber_names;
    };
  } // namespace System
} // namespace Heddle

#endif
