#ifndef heddle_contact_curve_list_h
#define heddle_contact_curve_list_h

#include <heddle/contact/broad_phase.h>

#include <vector>

namespace Heddle
{
  namespace Contact
  {
    /** The curves of all fibers that a rank knows, found by fiber number. */
    class CurveList
    {
    public:
      /** Begin a list for fibers 0 to @p n_fibers - 1. */
      void
      reset(const unsigned int n_fibers);

      void
      add(const NumberedCurve &curve);

      const Curve &
      operator[](const unsigned int fiber) const
      {
        return curves[position[fiber]].curve;
      }

      void
      set_stale(const unsigned int fiber)
      {
        curves[position[fiber]].stale = true;
      }

      bool
      is_stale(const unsigned int fiber) const
      {
        return curves[position[fiber]].stale;
      }

      const std::vector<NumberedCurve> &
      all() const
      {
        return curves;
      }

    private:
      std::vector<NumberedCurve> curves;
      std::vector<unsigned int>  position;
    };
  } // namespace Contact
} // namespace Heddle

#endif
