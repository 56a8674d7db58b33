#ifndef heddle_base_columns_h
#define heddle_base_columns_h

#include <vector>

namespace Heddle
{
  /** Where a yarn lies across its direction, and how wide it is [mm]. */
  struct YarnPlace
  {
    double middle = 0.;
    double width  = 0.;
  };



  /** Yarns side by side: those of several layers that lie over each other are
   * one column. */
  struct Columns
  {
    unsigned int n     = 0;
    double       first = 0.; /**< middle of the first one [mm] */
    double       last  = 0.; /**< of the last one [mm] */

    /** Mean distance of neighbours [mm]. @pre There are two or more. */
    double
    spacing() const
    {
      return (last - first) / (n - 1);
    }
  };

  /** Find the columns of @p yarns, which need not be in order. */
  Columns
  columns_of(std::vector<YarnPlace> yarns);
} // namespace Heddle

#endif
