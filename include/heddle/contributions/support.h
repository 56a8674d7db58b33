#ifndef heddle_contributions_support_h
#define heddle_contributions_support_h

#include <heddle/contributions/node_selection.h>

#include <array>
#include <memory>
#include <optional>
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



    /** The sides of a matrix, numbered as System::MatrixSpace has them. */
    enum class MatrixSide
    {
      lower_x,
      upper_x,
      lower_y,
      upper_y,
      lower_z,
      upper_z
    };

    /** How the user names them. */
    constexpr const char *
    word(const MatrixSide side)
    {
      switch (side)
        {
          case MatrixSide::lower_x:
            return "x-";
          case MatrixSide::upper_x:
            return "x+";
          case MatrixSide::lower_y:
            return "y-";
          case MatrixSide::upper_y:
            return "y+";
          case MatrixSide::lower_z:
            return "z-";
          case MatrixSide::upper_z:
            return "z+";
        }
      return nullptr;
    }



    /** What a support holds, and how that has to move. */
    struct Support
    {
      std::string where; /**< how messages call it: `Supports/Support 1` */

      NodeSelection              nodes;
      std::vector<MatrixSide>    matrix_sides;
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

      /**
       * Component along which fibers may slide, turned by the angle: of their
       * positions only what is normal to it is held.
       */
      std::optional<unsigned int> slides_along;

      /** Whether it leaves this component of positions alone. */
      bool
      is_free(const unsigned int component) const
      {
        return displacement[component] == "free";
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
