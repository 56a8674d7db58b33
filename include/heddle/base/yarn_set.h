#ifndef heddle_base_yarn_set_h
#define heddle_base_yarn_set_h

namespace Heddle
{
  /** The two sets of yarns of a fabric; their numbers are those of the axes. */
  enum class YarnSet
  {
    warp, /**< along x */
    weft  /**< along y */
  };

  /** The name of a set, for users and in files. */
  constexpr const char *
  word(const YarnSet set)
  {
    switch (set)
      {
        case YarnSet::warp:
          return "warp";
        case YarnSet::weft:
          return "weft";
      }
    return nullptr;
  }
} // namespace Heddle

#endif
