#ifndef heddle_base_yarn_reach_h
#define heddle_base_yarn_reach_h

#include <heddle/base/polyline.h>

#include <array>
#include <vector>

namespace Heddle
{
  /** The same fibers, which all run as the first one does. */
  std::vector<Polyline>
  run_one_way(std::vector<Polyline> fibers);



  /**
   * How far the fibers of a yarn reach along it.
   *
   * A yarn reaches as far as a quarter of its fibers do. Those that end before
   * it does, by more than a tenth of its length, are short, as if they were
   * lost while they were traced. If all are, the yarn is spun of staple fibers:
   * it reaches as far as any of them does, and none of them is short.
   */
  class YarnReach
  {
  public:
    explicit YarnReach(const std::vector<Polyline> &fibers);

    /** Whether no fiber runs from end to end. */
    bool
    is_spun() const
    {
      return spun;
    }

    /** Numbers of the fibers that are short. A yarn that ends near where it
     * begins has none. */
    std::vector<unsigned int>
    short_fibers() const;

    /** Whether the first and the last point of @p fiber are at an end of the
     * yarn. */
    const std::array<bool, 2> &
    ends_with_yarn(const unsigned int fiber) const
    {
      return at_end[fiber];
    }

    /** Unit vector from end to end, as the first fiber runs. */
    const Tensor<1, 3> &
    direction() const
    {
      return along;
    }

    /** Where the yarn begins and ends in this direction, from the origin [mm].
     */
    const std::array<double, 2> &
    extent() const
    {
      return reach;
    }

  private:
    bool                             spun = false;
    Tensor<1, 3>                     along;
    std::array<double, 2>            reach = {{0., 0.}};
    std::vector<std::array<bool, 2>> at_end;
  };
} // namespace Heddle

#endif
