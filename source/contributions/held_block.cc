#include <heddle/base/exceptions.h>
#include <heddle/contributions/held_block.h>

#include <map>
#include <utility>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Collects blocks and sees to it that supports agree on each. */
      class Collector
      {
      public:
        Collector(const SupportList &supports)
          : supports(supports)
        {
        }

        /** Support number @p holder holds component @p d of this block. */
        void
        hold(const HeldBlock   &wanted,
             const unsigned int node,
             const unsigned int d,
             const unsigned int holder)
        {
          const auto         key  = std::make_pair(wanted.fiber, wanted.block);
          HeldBlock         &held = blocks.emplace(key, wanted).first->second;
          const unsigned int before = held.holder[d];
          const bool         agree =
            held.kind == wanted.kind &&
            (before == HeldBlock::nobody ||
             same_motion(*supports[before], *supports[holder], held.kind, d));
          if (!agree)
            complain(held, node, holder);
          if (before == HeldBlock::nobody)
            held.holder[d] = holder;
        }

        std::vector<HeldBlock>
        list() const
        {
          std::vector<HeldBlock> all;
          for (const auto &entry : blocks)
            all.push_back(entry.second);
          return all;
        }

      private:
        static bool
        same_motion(const Support        &a,
                    const Support        &b,
                    const HeldBlock::Kind kind,
                    const unsigned int    d)
        {
          if (kind == HeldBlock::Kind::position)
            return a.displacement[d] == b.displacement[d];
          if (kind == HeldBlock::Kind::tangent)
            return true;
          return a.section == b.section &&
                 (a.section == SupportedSection::held ||
                  (a.angle == b.angle && a.axis == b.axis));
        }

        [[noreturn]] void
        complain(const HeldBlock   &held,
                 const unsigned int node,
                 const unsigned int holder) const
        {
          unsigned int other = HeldBlock::nobody;
          for (const unsigned int support : held.holder)
            other = std::min(other, support);
          const std::string what =
            held.is_in_matrix()
              ? "an edge of the matrix"
              : std::string(held.kind == HeldBlock::Kind::position
                              ? "the position"
                              : "the section") +
                  " of node " + std::to_string(node) + " of fiber " +
                  std::to_string(held.fiber);
          throw InputError(
            supports[holder]->where + " and " + supports[other]->where +
            " hold " + what +
            " in different ways; leave it free in one of them, or choose "
            "other nodes.");
        }

        const SupportList                                         &supports;
        std::map<std::pair<unsigned int, unsigned int>, HeldBlock> blocks;
      };



      /** The middles of the nodes of each yarn, by its number [mm]. */
      std::map<unsigned int, Tensor<1, 3>>
      middles_of_yarns(const System::FiberSpace        &space,
                       const std::vector<SelectedNode> &nodes)
      {
        std::map<unsigned int, Tensor<1, 3>> middles;
        std::map<unsigned int, double>       counts;
        for (const SelectedNode &node : nodes)
          {
            const unsigned int yarn = space.fiber(node.fiber).yarn_id;
            middles[yarn] += node.reference[0];
            counts[yarn] += 1.;
          }
        for (auto &middle : middles)
          middle.second /= counts[middle.first];
        return middles;
      }



      /**
       * Let @p collector know what support @p number holds of @p node, which
       * moves as what is at @p position.
       */
      void
      hold_node(const Support      &support,
                const unsigned int  number,
                const SelectedNode &node,
                const Tensor<1, 3> &position,
                const unsigned int  n_blocks_per_node,
                Collector          &collector)
      {
        const auto hold = [&](const unsigned int    block,
                              const HeldBlock::Kind kind,
                              const unsigned int    d) {
          HeldBlock held;
          held.fiber     = node.fiber;
          held.block     = node.node * n_blocks_per_node + block;
          held.kind      = kind;
          held.position  = position;
          held.reference = node.reference[block];
          collector.hold(held, node.node, d, number);
        };

        for (unsigned int d = 0; d < 3; ++d)
          if (!support.is_free(d))
            hold(0, HeldBlock::Kind::position, d);
        if (support.section != SupportedSection::free)
          for (unsigned int block = 1; block < n_blocks_per_node; ++block)
            for (unsigned int d = 0; d < 3; ++d)
              hold(block,
                   n_blocks_per_node == 2 ? HeldBlock::Kind::direction
                                          : HeldBlock::Kind::section,
                   d);
        for (const std::string &component : support.held_tangent)
          hold(1, HeldBlock::Kind::tangent, component[0] - 'x');
      }



      /** Let @p collector know what support @p number holds of the matrix. */
      void
      hold_sides(const Support             &support,
                 const unsigned int         number,
                 const System::MatrixSpace &matrix,
                 Collector                 &collector)
      {
        for (const MatrixSide side : support.matrix_sides)
          for (const unsigned int node :
               matrix.nodes_on_side(static_cast<unsigned int>(side)))
            for (unsigned int d = 0; d < 3; ++d)
              if (!support.is_free(d))
                {
                  HeldBlock held;
                  held.fiber     = HeldBlock::nobody;
                  held.block     = node;
                  held.kind      = HeldBlock::Kind::position;
                  held.position  = matrix.reference(node);
                  held.reference = held.position;
                  collector.hold(held, node, d, number);
                }
      }
    } // namespace



    unsigned int
    HeldBlock::local_block(const System::State &state) const
    {
      if (is_in_matrix())
        return state.has_matrix_node(block) ? state.matrix_block(block)
                                            : nobody;
      return state.has(fiber, block) ? state.local_block(fiber) + block
                                     : nobody;
    }



    std::vector<HeldBlock>
    find_held_blocks(const System::FiberSpace        &space,
                     const std::vector<Tensor<1, 3>> &reference,
                     const SupportList               &supports,
                     const System::MatrixSpace       *matrix,
                     const bool                       will_settle)
    {
      Collector collector(supports);
      for (unsigned int i = 0; i < supports.size(); ++i)
        {
          const Support &support = *supports[i];
          require(support.held_tangent.empty() ||
                    space.n_blocks_per_node() == 2,
                  support.entry("Held tangent components") +
                    " needs the element \"hermite\"; with \"" +
                    space.element().name() + "\" hold the section instead.");
          const std::vector<SelectedNode> nodes = support.nodes.find_nodes(
            space, reference, support.where, will_settle);
          const auto middles = middles_of_yarns(space, nodes);
          for (const SelectedNode &node : nodes)
            hold_node(support,
                      i,
                      node,
                      support.yarns_are_bodies
                        ? middles.at(space.fiber(node.fiber).yarn_id)
                        : node.reference[0],
                      space.n_blocks_per_node(),
                      collector);
          if (matrix)
            hold_sides(support, i, *matrix, collector);
        }
      return collector.list();
    }
  } // namespace Contributions
} // namespace Heddle
