#include <heddle/base/exceptions.h>
#include <heddle/base/yarn_set.h>
#include <heddle/simulation/settle_parameters.h>

#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    SettleParameters::SettleParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_parameter("Axial tension",
                    axial_tension,
                    "Strain by which the force on both ends of every fiber, "
                    "along its yarn, would stretch it if it were straight. "
                    "Inactive if Run/Scene is 'centerlines', like all of this "
                    "section [-].",
                    prm,
                    Patterns::Double(0., 0.1));
      add_parameter("Axial tension of weft",
                    weft_tension,
                    "Likewise of the weft where it is pulled otherwise than "
                    "the warp: the one that is pulled less has more of the "
                    "crimp. 0: as the warp [-].",
                    prm,
                    Patterns::Double(0., 0.1));
      add_parameter("Guide stiffness",
                    guide_stiffness,
                    "Stiffness that holds every end of a fiber where it "
                    "starts, across its yarn but not along it, and the middle "
                    "of the fiber along the yarn; as a multiple of axial "
                    "modulus times radius [-].",
                    prm,
                    Patterns::Double(1e-9));
      add_parameter("Friction",
                    friction,
                    "Whether fibers rub already while they settle, or only "
                    "when they are loaded. Inactive without friction [-].");
      add_parameter(
        "Penetration thresholds",
        listed_thresholds,
        "Thresholds of penetration over radius, descending, each "
        "of which is settled before the next, as in '0.05, 0.02'; "
        "the last one holds in place of Contact/Penetration "
        "threshold, in what follows too. Empty: that one alone [-].",
        prm,
        Patterns::List(Patterns::Double(1e-4, 0.2)));
    }



    double
    SettleParameters::tension_of(const std::string &set) const
    {
      return set == word(YarnSet::weft) && weft_tension > 0. ? weft_tension
                                                             : axial_tension;
    }



    std::vector<double>
    SettleParameters::thresholds(const double contact_threshold) const
    {
      if (listed_thresholds.empty())
        return {contact_threshold};
      for (unsigned int i = 1; i < listed_thresholds.size(); ++i)
        if (listed_thresholds[i] >= listed_thresholds[i - 1])
          {
            std::ostringstream text;
            text << "Initial configuration: the penetration threshold "
                 << listed_thresholds[i] << " follows "
                 << listed_thresholds[i - 1]
                 << "; list the thresholds in descending order.";
            throw InputError(text.str());
          }
      return listed_thresholds;
    }
  } // namespace Simulation
} // namespace Heddle
