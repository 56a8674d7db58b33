#ifndef heddle_contributions_section_damping_h
#define heddle_contributions_section_damping_h

#include <heddle/system/contribution.h>

#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Holds the section vectors of fibers back in each iteration, without a
     * force: a term of the tangent alone. Nothing resists the spin of a fiber
     * about its axis where no moment acts on it, and the tangent is singular;
     * an arbitrary spin, taken as the linear step that it is, would stretch the
     * sections beyond repair. Sections that hardly turn any more are let go,
     * fiber by fiber: what little resists their spin, friction of contacts with
     * small forces for instance, would else come to bear very slowly. Where
     * friction resists it they are let go sooner.
     */
    class SectionDamping : public System::Contribution
    {
    public:
      explicit SectionDamping(const bool with_friction);

      std::string
      name() const override
      {
        return "section damping";
      }

      void
      begin_step(System::State &state) override;

      void
      predict(const System::State     &state,
              const System::Increment &increment) override;

      void
      assemble(const System::State &state,
               System::BlockSystem &system) override;

    private:
      /** Sections that turn less in an iteration are let go [rad]. */
      const double still;

      /** What is left of the stiffness, from 1 down, by owned fiber. */
      std::vector<double> parts;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
