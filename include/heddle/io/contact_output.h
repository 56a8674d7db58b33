#ifndef heddle_io_contact_output_h
#define heddle_io_contact_output_h

#include <heddle/contact/contact_element.h>
#include <heddle/io/collection.h>
#include <heddle/io/patch_file.h>
#include <heddle/system/fiber_space.h>
#include <heddle/system/state.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace IO
  {
    using namespace dealii;

    /**
     * The contact elements as points halfway between their two particles.
     *
     * Gaps are those of the contact elements, computed in double precision, not
     * what one could measure between the points of the fibers' files.
     */
    class ContactOutput
    {
    public:
      ContactOutput(const System::FiberSpace &space,
                    const bool                with_friction,
                    const std::string        &directory,
                    const unsigned int        resume_at = 0);

      /**
       * Write @p elements as file @p number of the series. A rank holds all
       * elements that touch one of its fibers; an element is written by the
       * rank that owns its first fiber. With friction there are as many @p
       * friction as elements, else none.
       *
       * @note Collective.
       */
      void
      write(const std::vector<Contact::ContactElement>  &elements,
            const std::vector<Contact::TangentialForce> &friction,
            const System::State                         &state,
            const unsigned int                           number,
            const double                                 time,
            const std::string                           &stage);

      /**
       * Return the point of one element with its data. @p zone_id numbers the
       * proximity zones over all ranks; @p friction is null without friction.
       */
      PatchFile<0>::Patch
      patch(const Contact::ContactElement  &element,
            const Contact::TangentialForce *friction,
            const System::State            &state,
            const unsigned int              zone_id) const;

      /** Names of the data, vectors with the suffix "[3]", in their order. */
      static std::vector<std::string>
      fields(const bool with_friction);

    private:
      const System::FiberSpace &space;
      const bool                with_friction;
      Collection                collection;
    };
  } // namespace IO
} // namespace Heddle

#endif
