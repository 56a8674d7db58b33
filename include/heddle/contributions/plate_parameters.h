#ifndef heddle_contributions_plate_parameters_h
#define heddle_contributions_plate_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /** Plates that press on fibers from below and above. */
    class PlateParameters : public ParameterAcceptor
    {
    public:
      PlateParameters(const std::string &section = "/Plates");

      std::string compression = "0";

      /** Whether there are plates. */
      bool
      are_there() const
      {
        return compression != "0";
      }

      /** Throw InputError unless the compression is a formula of t alone, 0 at
       * first and always less than 1. */
      void
      check() const;

      /** Load factors at which the compression turns back. */
      std::vector<double>
      turning_points() const;

      /** How messages call it. */
      static const char *const entry;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
