#include <heddle/base/choice.h>
#include <heddle/base/exceptions.h>
#include <heddle/base/expression.h>
#include <heddle/contributions/support_parameters.h>

namespace Heddle
{
  namespace Contributions
  {
    SupportParameters::SupportParameters(const std::string &section_name)
      : ParameterAcceptor(section_name)
    {
      where = section_in_words(*this);
      nodes.add_parameters(*this);
      add_choices(*this,
                  "Matrix sides",
                  matrix_sides,
                  "Sides of the matrix that move as 'Displacement' says, as "
                  "in 'x-, x+'. Refused without a matrix [-].");
      for (unsigned int d = 0; d < 3; ++d)
        add_parameter(std::string("Displacement ") + "xyz"[d],
                      displacement[d],
                      "'free', or a formula of the reference position x, y, z "
                      "[mm] and the load factor t: the displacement from the "
                      "reference position, which in a weave is where the "
                      "fibers have settled [mm].");
      add_choice(
        *this,
        "Section",
        section,
        "'held' keeps the section (with the element 'hermite' the direction of "
        "the axis, which may stretch), 'turned' turns it by 'Turn angle', "
        "'free' leaves it free: held at its two ends a fiber that is curved "
        "when free spins about the line through them for nothing [-].");
      add_parameter("Turn angle",
                    angle,
                    "Formula of x, y, z [mm] and t: angle by which sections "
                    "are turned from the reference configuration. Elements "
                    "that are twisted by more than 0.2 each resist too much: "
                    "give shorter ones. Inactive unless 'Section' is 'turned' "
                    "[rad].");
      add_parameter("Turn axis",
                    axis,
                    "Direction, of any length, about which sections are "
                    "turned, through each node. Inactive unless 'Section' is "
                    "'turned' [-].");
      add_parameter("Held tangent components",
                    held_tangent,
                    "Components x, y, z of the tangent dx/ds that keep their "
                    "reference values; the others are free. For the element "
                    "'hermite', with the 'Section' 'free' [-].",
                    prm,
                    Patterns::List(Patterns::Selection("x|y|z"), 0, 3));
      parse_parameters_call_back.connect([this]() { check(); });
    }



    void
    SupportParameters::check() const
    {
      for (unsigned int d = 0; d < 3; ++d)
        if (!is_free(d))
          Expression(displacement[d],
                     entry(std::string("Displacement ") + "xyz"[d]));
      Expression(angle, entry("Turn angle"));
      require(section != SupportedSection::turned || axis.norm() > 0.,
              entry("Turn axis") + " is 0, 0, 0, which is no direction.");
      require(section == SupportedSection::free || held_tangent.empty(),
              entry("Held tangent components") +
                " needs a free section, but \"Section\" is \"" + word(section) +
                "\".");
      require(!nodes.is_empty() || !matrix_sides.empty(),
              entry("Fibers") +
                " is \"none\", and \"Matrix sides\" is empty: this support "
                "holds nothing; name fibers or sides.");
      const bool all_free = is_free(0) && is_free(1) && is_free(2);
      require(
        !all_free || section != SupportedSection::free || !held_tangent.empty(),
        where + ": this support holds nothing; give a displacement, set the "
                "section to \"held\" or \"turned\", or leave the support out.");
    }



    SupportList
    declare_supports(const ParameterFile &file)
    {
      SupportList        supports;
      const unsigned int n = file.count_sections("/Supports", "Support");
      for (unsigned int i = 1; i <= n; ++i)
        supports.push_back(std::make_shared<SupportParameters>(
          "/Supports/Support " + std::to_string(i)));
      return supports;
    }
  } // namespace Contributions
} // namespace Heddle
