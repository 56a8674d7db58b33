#include <heddle/contact/curve_list.h>

namespace Heddle
{
  namespace Contact
  {
    void
    CurveList::reset(const unsigned int n_fibers)
    {
      curves.clear();
      position.assign(n_fibers, 0);
    }



    void
    CurveList::add(const NumberedCurve &curve)
    {
      position[curve.fiber] = curves.size();
      curves.emplace_back(curve);
    }
  } // namespace Contact
} // namespace Heddle
