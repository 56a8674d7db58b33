#include <heddle/system/state.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace Heddle
{
  namespace System
  {
    namespace
    {
      /** Of each fiber what is in any of both, both in ascending order. */
      std::vector<GhostFiber>
      union_of(const std::vector<GhostFiber> &some,
               const std::vector<GhostFiber> &others)
      {
        std::vector<GhostFiber> all;
        std::merge(some.begin(),
                   some.end(),
                   others.begin(),
                   others.end(),
                   std::back_inserter(all),
                   [](const GhostFiber &left, const GhostFiber &right) {
                     return left.fiber < right.fiber;
                   });
        std::vector<GhostFiber> result;
        for (const GhostFiber &ghost : all)
          if (result.empty() || result.back().fiber != ghost.fiber)
            result.push_back(ghost);
          else
            {
              NodeRange &nodes = result.back().nodes;
              nodes.begin      = std::min(nodes.begin, ghost.nodes.begin);
              nodes.end        = std::max(nodes.end, ghost.nodes.end);
            }
        return result;
      }
    } // namespace



    State::State(const FiberSpace &space)
      : space(space)
      , owned_fiber_blocks(space.owned_blocks().second -
                           space.owned_blocks().first)
      , owned_blocks(owned_fiber_blocks)
      , blocks(owned_blocks)
      , accepted_blocks(owned_blocks)
      , held(space.n_fibers())
      , local_begin(space.n_fibers(), 0)
      , fiber_exchange(space.communicator())
      , node_exchange(space.communicator())
    {
      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          held[f]        = space.all_nodes(f);
          local_begin[f] = space.first_block(f) - space.owned_blocks().first;
        }
    }



    void
    State::set_matrix(const MatrixSpace               *matrix,
                      const std::vector<unsigned int> &foreign_nodes,
                      const std::vector<GhostFiber>   &foreign_fibers)
    {
      matrix_space     = matrix;
      ghost_nodes      = foreign_nodes;
      linked_fibers    = foreign_fibers;
      const auto owned = matrix->owned_nodes();
      owned_blocks     = owned_fiber_blocks + owned.second - owned.first;
      ++fields;

      blocks.resize(n_fixed_blocks());
      for (unsigned int node = owned.first; node < owned.second; ++node)
        blocks[matrix_block(node)] = matrix->reference(node);
      for (const unsigned int node : ghost_nodes)
        blocks[matrix_block(node)] = matrix->reference(node);
      accepted_blocks.resize(owned_fiber_blocks);
      accepted_blocks.insert(accepted_blocks.end(),
                             blocks.begin() + owned_fiber_blocks,
                             blocks.end());

      std::map<unsigned int, std::vector<unsigned int>> wanted;
      for (const unsigned int node : ghost_nodes)
        wanted[matrix->owner(node)].push_back(node);
      node_exchange.received.clear();
      node_exchange.sent.clear();
      for (const auto &request : wanted)
        node_exchange.received[request.first] = {
          matrix_block(request.second.front()),
          static_cast<unsigned int>(request.second.size())};
      for (const auto &request :
           Utilities::MPI::some_to_some(space.communicator(), wanted))
        for (const unsigned int node : request.second)
          node_exchange.sent[request.first].push_back({matrix_block(node), 1});

      set_ghost_fibers(ghosts);
    }



    bool
    State::has_matrix_node(const unsigned int node) const
    {
      return matrix_space->owns(node) ||
             std::binary_search(ghost_nodes.begin(), ghost_nodes.end(), node);
    }



    unsigned int
    State::matrix_block(const unsigned int node) const
    {
      if (matrix_space->owns(node))
        return owned_fiber_blocks + node - matrix_space->owned_nodes().first;
      const auto ghost =
        std::lower_bound(ghost_nodes.begin(), ghost_nodes.end(), node);
      Assert(ghost != ghost_nodes.end() && *ghost == node,
             ExcMessage("This node of the matrix is not held here."));
      return owned_blocks + (ghost - ghost_nodes.begin());
    }



    std::vector<int>
    State::global_blocks() const
    {
      // Before the fibers of a rank lie the nodes of lower ranks, before its
      // nodes the fibers of those and its own.
      std::vector<int> numbers(blocks.size());
      const auto       number_fiber = [&](const unsigned int f) {
        const unsigned int nodes_before =
          matrix_space ? matrix_space->first_node(space.owner(f)) : 0;
        const auto local = held_blocks(f);
        for (unsigned int k = local.first; k < local.second; ++k)
          numbers[k] =
            int(space.first_block(f) + nodes_before + k) - local_begin[f];
      };
      const auto number_node = [&](const unsigned int node) {
        numbers[matrix_block(node)] =
          space.end_of_blocks(matrix_space->owner(node)) + node;
      };

      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        number_fiber(f);
      for (const GhostFiber &ghost : ghosts)
        number_fiber(ghost.fiber);
      if (matrix_space)
        {
          const auto nodes = matrix_space->owned_nodes();
          for (unsigned int node = nodes.first; node < nodes.second; ++node)
            number_node(node);
          for (const unsigned int node : ghost_nodes)
            number_node(node);
        }
      return numbers;
    }



    void
    State::set_ghost_fibers(const std::vector<GhostFiber> &fibers)
    {
      for (const GhostFiber &ghost : ghosts)
        held[ghost.fiber] = {};
      ghosts = union_of(fibers, linked_fibers);
      ++version;

      std::map<unsigned int, std::vector<GhostFiber>> wanted;
      const int    n_per_node = space.n_blocks_per_node();
      unsigned int end        = n_fixed_blocks();
      fiber_exchange.received.clear();
      fiber_exchange.sent.clear();
      for (const GhostFiber &ghost : ghosts)
        {
          const unsigned int f = ghost.fiber, owner = space.owner(f);
          Assert(!space.owns(f), ExcMessage("An owned fiber is no ghost."));
          held[f]           = ghost.nodes;
          local_begin[f]    = int(end) - n_per_node * int(ghost.nodes.begin);
          const auto blocks = held_blocks(f);
          end               = blocks.second;
          wanted[owner].push_back(ghost);
          fiber_exchange.received.insert({owner, {blocks.first, 0}})
            .first->second.n += blocks.second - blocks.first;
        }
      blocks.resize(end);
      accepted_blocks.resize(end);
      for (const auto &request :
           Utilities::MPI::some_to_some(space.communicator(), wanted))
        for (const GhostFiber &ghost : request.second)
          {
            const unsigned int n = ghost.nodes.end - ghost.nodes.begin;
            fiber_exchange.sent[request.first].push_back(
              {static_cast<unsigned int>(local_begin[ghost.fiber] +
                                         n_per_node * int(ghost.nodes.begin)),
               n_per_node * n});
          }

      update_ghosts();
      update_ghosts(accepted_blocks);
    }



    void
    State::set_owned(const std::vector<Tensor<1, 3>> &values)
    {
      Assert(values.size() >= owned_blocks, ExcInternalError());
      std::copy_n(values.begin(), owned_blocks, blocks.begin());
      update_ghosts();
    }



    void
    State::update_ghosts()
    {
      update_ghosts(blocks);
    }



    void
    State::update_ghosts(std::vector<Tensor<1, 3>> &values) const
    {
      AssertDimension(values.size(), blocks.size());
      fiber_exchange.update(values);
      node_exchange.update(values);
    }



    void
    State::move(const double factor, const std::vector<Tensor<1, 3>> &increment)
    {
      AssertDimension(increment.size(), blocks.size());
      for (unsigned int i = 0; i < blocks.size(); ++i)
        blocks[i] += factor * increment[i];
    }



    void
    State::accept()
    {
      accepted_blocks = blocks;
    }



    void
    State::reject()
    {
      blocks = accepted_blocks;
    }
  } // namespace System
} // namespace Heddle
