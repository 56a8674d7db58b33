#include <heddle/base/declared_parameters.h>
#include <heddle/base/exceptions.h>
#include <heddle/contributions/node_selection.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** The words that stand for each fiber alone or with others of its yarn
       * or set. */
      std::vector<std::set<std::string>>
      names_of_fibers(const System::FiberSpace &space)
      {
        std::map<std::string, std::set<unsigned int>> yarns_of_set;
        for (unsigned int f = 0; f < space.n_fibers(); ++f)
          if (space.fiber(f).yarn_id != numbers::invalid_unsigned_int)
            yarns_of_set[space.fiber(f).set].insert(space.fiber(f).yarn_id);

        std::vector<std::set<std::string>> names;
        for (unsigned int f = 0; f < space.n_fibers(); ++f)
          {
            const System::Fiber &fiber = space.fiber(f);
            names.push_back({"all", fiber.set, std::to_string(f)});
            if (fiber.yarn_id == numbers::invalid_unsigned_int)
              continue;
            names[f].insert("yarn " + std::to_string(fiber.yarn_id));
            const auto &yarns = yarns_of_set[fiber.set];
            names[f].insert(fiber.set + ' ' +
                            std::to_string(std::distance(
                              yarns.begin(), yarns.find(fiber.yarn_id))));
          }
        return names;
      }



      /** Say which words would have been understood as fibers. */
      [[noreturn]] void
      complain_about_fibers(const System::FiberSpace &space,
                            const std::string        &word,
                            const std::string        &where)
      {
        std::set<std::string> sets;
        bool                  has_yarns = false;
        for (unsigned int f = 0; f < space.n_fibers(); ++f)
          {
            sets.insert(space.fiber(f).set);
            has_yarns = has_yarns ||
                        space.fiber(f).yarn_id != numbers::invalid_unsigned_int;
          }
        std::string names;
        for (const std::string &set : sets)
          if (!set.empty())
            names += (names.empty() ? " \"" : ", \"") + set + "\"";
        throw InputError(
          where + ": \"Fibers\" names \"" + word +
          "\", which is no fiber; there are the numbers 0 to " +
          std::to_string(space.n_fibers() - 1) +
          (names.empty() ? ", and no sets" : ", and the sets" + names) +
          (has_yarns ? "; \"yarn 0\", or \"" + *sets.rbegin() +
                         " 0\", are names of yarns."
                     : "."));
      }
    } // namespace



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
        "weft yarns take turns: fibers of the first warp yarn, "
        "of the first weft yarn, of the second warp yarn... "
        "[-].");
      owner.add_parameter(
        "Nodes",
        nodes,
        "Which nodes of these fibers: an end, both ends, all, or those 'near "
        "point' in the reference configuration [-].",
        ParameterAcceptor::prm,
        Patterns::Selection("first end|last end|both ends|near point|all"));
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
      std::set<unsigned int> found;
      if (fibers == "none")
        return {};
      const auto names = names_of_fibers(space);
      for (const std::string &word : Utilities::split_string_list(fibers))
        {
          bool known = false;
          for (unsigned int f = 0; f < space.n_fibers(); ++f)
            if (names[f].count(word) > 0)
              {
                found.insert(f);
                known = true;
              }
          if (!known)
            complain_about_fibers(space, word, where);
        }
      require(!found.empty(),
              where + ": \"Fibers\" is empty; write \"all\", names of sets, or "
                      "numbers.");
      return {found.begin(), found.end()};
    }



    bool
    NodeSelection::chooses(const unsigned int  node,
                           const unsigned int  n_nodes,
                           const Tensor<1, 3> &position) const
    {
      if (nodes == "near point")
        return (position - point).norm() <= distance;
      const bool is_first = node == 0, is_last = node == n_nodes - 1;
      return nodes == "all" || (is_first && nodes != "last end") ||
             (is_last && nodes != "first end");
    }



    std::vector<SelectedNode>
    NodeSelection::find_nodes(const System::FiberSpace        &space,
                              const std::vector<Tensor<1, 3>> &reference,
                              const std::string               &where) const
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
      if (all.empty() && fibers != "none")
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
