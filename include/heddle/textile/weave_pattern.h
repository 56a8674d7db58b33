#ifndef heddle_textile_weave_pattern_h
#define heddle_textile_weave_pattern_h

#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /**
     * Which yarn lies on top at each crossing: a matrix of zeros and ones that
     * is repeated over the fabric. Rows are weft yarns, columns warp yarns, and
     * 1 means that the warp yarn is on top.
     *
     * Understood are
     * - `plain`;
     * - `twill m/n`: each warp yarn goes over m weft yarns and under n, and the
     *   diagonal moves by one yarn per weft yarn;
     * - `satin N/S`: the warp yarns lie on top but for one crossing in N, which
     *   moves by S warp yarns from one weft yarn to the next; N and S have no
     *   common divisor and 1 < S < N-1;
     * - `basket m/n`: plain weave of groups of m warp and n weft yarns;
     * - the matrix itself, rows separated by semicolons: `0 1; 1 0`.
     *
     * Without numbers these are `twill 2/2`, `satin 5/2` and `basket 2/2`.
     *
     * Throws InputError for anything else.
     */
    class WeavePattern
    {
    public:
      explicit WeavePattern(const std::string &text);

      /** Whether warp yarn @p warp lies on top of weft yarn @p weft. */
      bool
      warp_on_top(const unsigned int warp, const unsigned int weft) const
      {
        return rows[weft % rows.size()][warp % rows[0].size()];
      }

      /** Number of warp yarns after which the pattern repeats itself. */
      unsigned int
      n_warp() const
      {
        return rows[0].size();
      }

      /** Number of weft yarns after which the pattern repeats itself. */
      unsigned int
      n_weft() const
      {
        return rows.size();
      }

    private:
      std::vector<std::vector<bool>> rows;
    };
  } // namespace Textile
} // namespace Heddle

#endif
