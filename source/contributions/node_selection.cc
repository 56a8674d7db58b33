#include <heddle/base/choice.h>
#include <heddle/base/declared_parameters.h>
#include <heddle/base/exceptions.h>
#include <heddle/contributions/node_selection.h>

#include <deal.II/base/mpi.h>

#include <limits>
#include <sstream>

namespace Heddle
{
  namespace Contributions
  {
    void
    NodeSelection::add_parameters(ParameterAcceptor &owner)
    {
      owner.add_parameter(
        "Fibers",
        fibers,
        "'all', 'none', or a list of names of sets ('warp', "
        "or those of the file of centerlines), of their yarns "
        "('warp 0' is the first one), of yarns by their number "
        "in 'yarns.csv' ('yarn 3'), and of numbers of fibers, "
        "from 0, in the order of the file. In a weave warp and "
        "weft yarns take turns by their places, number i of n, from 0, at "
        "(i + 1/2) / n: fibers of the first warp yarn, of the first weft "
        "yarn, of the second warp yarn... if there are as many of both. "
        "The name of a set that stands for other fibers too, "
        "as '1' for fiber 1, is refused; so is a load on 'none' [-].");
      add_choice(
        owner,
        "Nodes",
        nodes,
        "Which nodes of these fibers: an end, both ends, all, or those 'near "
        "point' in the reference configuration [-].");
      owner.add_parameter("Point",
                          point,
                          "Nodes within 'Distance' of this point are chosen. "
                          "Inactive unless 'Nodes' is 'near point' [mm].");
      owner.add_parameter("Distance",
                          distance,
                          "How far nodes may be from 'Point'. Inactive unless "
                          "'Nodes' is 'near point' [mm].",
                          ParameterAcceptor::prm,
                          Patterns::Double(0.));
    }



    std::vector<unsigned int>
    NodeSelection::find_fibers(const System::FiberSpace &space,
                               const std::string        &where) const
    {
      if (is_empty())
        return {};
      return space.names().find(fibers, where);
    }



    bool
    NodeSelection::chooses(const unsigned int  node,
                           const unsigned int  n_nodes,
                           const Tensor<1, 3> &position) const
    {
      const bool is_first = node == 0, is_last = node == n_nodes - 1;
      switch (nodes)
        {
          case ChosenNodes::first_end:
            return is_first;
          case ChosenNodes::last_end:
            return is_last;
          case ChosenNodes::both_ends:
            return is_first || is_last;
          case ChosenNodes::near_point:
            return (position - point).norm() <= distance;
          case ChosenNodes::all:
            return true;
        }
      Assert(false, ExcInternalError());
      return false;
    }



    std::vector<SelectedNode>
    NodeSelection::find_nodes(const System::FiberSpace        &space,
                              const std::vector<Tensor<1, 3>> &reference,
                              const std::string               &where,
                              const bool will_settle) const
    {
      std::vector<SelectedNode> owned;
      double                    nearest  = std::numeric_limits<double>::max();
      const unsigned int        per_node = space.n_blocks_per_node();
      for (const unsigned int f : find_fibers(space, where))
        for (unsigned int i = 0; i < space.fiber(f).n_nodes; ++i)
          if (space.owns(f))
            {
              const Tensor<1, 3> *blocks =
                reference.data() + space.first_block(f) -
                space.owned_blocks().first + i * per_node;
              nearest = std::min(nearest, (blocks[0] - point).norm());
              if (!chooses(i, space.fiber(f).n_nodes, blocks[0]))
                continue;
              owned.push_back({f, i, {}});
              std::copy(
                blocks, blocks + per_node, owned.back().reference.begin());
            }
      std::vector<SelectedNode> all;
      for (const auto &part :
           Utilities::MPI::all_gather(space.communicator(), owned))
        all.insert(all.end(), part.begin(), part.end());
      nearest = Utilities::MPI::min(nearest, space.communicator());
      if (all.empty() && !is_empty() &&
          !(will_settle && nodes == ChosenNodes::near_point))
        {
          std::ostringstream sentence;
          sentence << where << ": no node lies within " << distance
                   << " mm of the point " << point[0] << ", " << point[1]
                   << ", " << point[2] << "; the nearest of these fibers is "
                   << nearest << " mm away.";
          throw InputError(sentence.str());
        }
      return all;
    }



    std::string
    section_in_words(const ParameterAcceptor &parameters)
    {
      return join_path(parameters.get_section_path());
    }
  } // namespace Contributions
} // namespace Heddle
