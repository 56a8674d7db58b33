#ifndef heddle_contributions_support_h
#define heddle_contributions_support_h

#include <heddle/contributions/node_selection.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /** What a support does to sections. */
    enum class SupportedSection
    {
      free,
      held,
      turned /**< by an angle */
    };

    /** How the user names them. */
    constexpr const char *
    word(const SupportedSection section)
    {
      switch (section)
        {
          case SupportedSection::free:
            return "free";
          case SupportedSection::held:
            return "held";
          case SupportedSection::turned:
            return "turned";
        }
      return nullptr;
    }



    /** What a support holds, and how that has to move. */
    struct Support
    {
      std::string where; /**< how messages call it: `Supports/Support 1` */

      NodeSelection              nodes;
      std::vector<std::string>   matrix_sides;
      std::array<std::string, 3> displacement = {{"free", "free", "free"}};
      SupportedSection           section      = SupportedSection::free;
      std::string                angle        = "0";
      Tensor<1, 3>               axis         = Tensor<1, 3>({0., 0., 1.});
      std::vector<std::string>   held_tangent;

      /**
       * The ends of a yarn move as one body: as their middle is displaced, and
       * turned about it by the angle. Fibers that touch keep their distance.
       */
      bool yarns_are_bodies = false;

      /** Whether it leaves this component of positions alone. */
      bool
      is_free(const unsigned int component) const
      {
        return displacement[component] == "free";
      }

      /** Numbers of the sides of the matrix, x-, x+, y-, y+, z-, z+. */
      std::vector<unsigned int>
      sides() const
      {
        std::vector<unsigned int> numbers;
        for (const std::string &side : matrix_sides)
          numbers.push_back(2 * (side[0] - 'x') + (side[1] == '+' ? 1 : 0));
        return numbers;
      }

      /** How messages call an entry: `Supports/Support 1: "Turn angle"`. */
      std::string
      entry(const std::string &name) const
      {
        return where + ": \"" + name + "\"";
      }
    };

    using SupportList = std::vector<std::shared_ptr<Support>>;
  } // namespace Contributions
} // namespace Heddle

#endif
