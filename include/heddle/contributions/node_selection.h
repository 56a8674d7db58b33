#ifndef heddle_contributions_node_selection_h
#define heddle_contributions_node_selection_h

#include <heddle/system/fiber_space.h>

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /** Which nodes of a fiber. */
    enum class ChosenNodes
    {
      first_end,
      last_end,
      both_ends,
      near_point,
      all
    };

    /** How the user names them. */
    constexpr const char *
    word(const ChosenNodes nodes)
    {
      switch (nodes)
        {
          case ChosenNodes::first_end:
            return "first end";
          case ChosenNodes::last_end:
            return "last end";
          case ChosenNodes::both_ends:
            return "both ends";
          case ChosenNodes::near_point:
            return "near point";
          case ChosenNodes::all:
            return "all";
        }
      return nullptr;
    }



    /** A node with its blocks in the reference configuration. */
    struct SelectedNode
    {
      unsigned int                fiber;
      unsigned int                node;
      std::array<Tensor<1, 3>, 3> reference;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &fiber &node &reference;
      }
    };

    /** Nodes that a user chooses, for a support or a load. */
    struct NodeSelection
    {
      std::string fibers = "all";
      ChosenNodes nodes  = ChosenNodes::both_ends;
      Point<3>    point;
      double      distance = 0.; /**< [mm] */

      /** Whether these are no fibers at all. */
      bool
      is_empty() const
      {
        return fibers == "none";
      }

      /** Declare the entries in the section of @p owner. */
      void
      add_parameters(ParameterAcceptor &owner);

      /**
       * Return the numbers of the chosen fibers, in ascending order. Throw
       * InputError if a word stands for none. @p where is the section.
       */
      std::vector<unsigned int>
      find_fibers(const System::FiberSpace &space,
                  const std::string        &where) const;

      /**
       * Return the chosen nodes of all ranks, fiber by fiber. @p reference are
       * the owned blocks in the reference configuration. Throw InputError if
       * there are none, but for those near a point if fibers @p will_settle
       * before.
       * @note Collective.
       */
      std::vector<SelectedNode>
      find_nodes(const System::FiberSpace        &space,
                 const std::vector<Tensor<1, 3>> &reference,
                 const std::string               &where,
                 const bool                       will_settle = false) const;

    private:
      bool
      chooses(const unsigned int  node,
              const unsigned int  n_nodes,
              const Tensor<1, 3> &position) const;
    };

    /** Return how messages name a section: without the first slash. */
    std::string
    section_in_words(const ParameterAcceptor &parameters);
  } // namespace Contributions
} // namespace Heddle

#endif
