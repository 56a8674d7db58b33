#ifndef heddle_contact_contact_parameters_h
#define heddle_contact_contact_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <map>
#include <string>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    /**
     * What a user may say about contact. There is no penalty among it: that
     * follows from the penetration threshold, zone by zone.
     */
    class ContactParameters : public ParameterAcceptor
    {
    public:
      ContactParameters(const std::string &section = "/Contact");

      /** Choose what the user leaves to the scene. Throws InputError. */
      void
      choose_for(const bool fabric);

      /** Whether any two fibers rub. */
      bool
      has_friction() const;

      bool   enabled         = true;
      double threshold       = 0.02;
      double search_distance = 1.;
      double refinement      = 1.;
      double friction        = 0.;

      /** By "SET-SET", in place of the coefficient above. */
      std::multimap<std::string, double> friction_of_sets;

      /** Coefficient of crossed fibers over that of parallel ones. */
      double crossed_friction = 1.;

      /** Before slip, over the smaller radius. */
      double reversible_displacement = 0.05;

    private:
      double given_search_distance = 0.;
    };
  } // namespace Contact
} // namespace Heddle

#endif
