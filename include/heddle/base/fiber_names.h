#ifndef heddle_base_fiber_names_h
#define heddle_base_fiber_names_h

#include <deal.II/base/types.h>

#include <map>
#include <string>
#include <vector>

namespace Heddle
{
  using namespace dealii;

  /** What a fiber is part of. */
  struct FiberName
  {
    std::string  set;  /**< "warp"; empty: of none */
    unsigned int yarn; /**< invalid_unsigned_int: of none */
  };

  /**
   * The words by which a parameter file chooses fibers: "all", their numbers,
   * their sets, "yarn 3", and "warp 0", which is the first yarn of this set.
   * Sets may have any name, as labels of a tomogram, which are numbers: what a
   * word chooses is in doubt only if it is used and stands for other fibers as
   * the name of a set than otherwise.
   */
  class FiberNames
  {
  public:
    FiberNames(const std::vector<FiberName> &fibers);

    unsigned int
    n_fibers() const
    {
      return number_of_fibers;
    }

    /**
     * Return the numbers of the fibers that the list @p words stands for, in
     * ascending order. Throw InputError if a word stands for none, or for
     * several things that are not the same fibers, or if there is no word;
     * @p where is the section whose "Fibers" they are.
     */
    std::vector<unsigned int>
    find(const std::string &words, const std::string &where) const;

  private:
    /** Say which words would have been understood. */
    [[noreturn]] void
    complain(const std::string &word, const std::string &where) const;

    /** What a word stands for, as in `fiber 1`, and which fibers these are. */
    using Meanings = std::map<std::string, std::vector<unsigned int>>;

    const unsigned int              number_of_fibers;
    std::map<std::string, Meanings> meanings_of_word;

    /** Numbers of the yarns of each set, those of fibers without one empty. */
    std::map<std::string, std::map<unsigned int, unsigned int>> yarns_of_set;
  };
} // namespace Heddle

#endif
