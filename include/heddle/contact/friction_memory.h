#ifndef heddle_contact_friction_memory_h
#define heddle_contact_friction_memory_h

#include <heddle/base/archive.h>
#include <heddle/contact/contact_element.h>

#include <deal.II/base/array_view.h>

#include <functional>
#include <vector>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    /**
     * The reversible displacements of touching fibers, by the material
     * particles that carry them: it survives the elements it was taken from.
     */
    class FrictionMemory
    {
    public:
      struct Record
      {
        unsigned int fiber_a, fiber_b;
        double       s_a, s_b; /**< [mm] */
        double       weight;   /**< length of contact that it stands for [mm] */

        /** In the frame of the pair for this orientation [mm]. */
        int          orientation;
        Tensor<1, 3> displacement;

        double limit; /**< of the friction force [N] */
      };

      /** Replace everything that is known. */
      void
      set(std::vector<Record> &records);

      /**
       * Return displacement and limit at an element: those of a record at the
       * same particles, or what lies between the two next to it, the limit as
       * it is for the length of the element. They fade with their distance,
       * and are gone beyond @p reach [mm] or their own lengths: a contact that
       * slides or grows keeps what it has, and what touches for the first time
       * has none. They are continuous functions of the particles.
       */
      Record
      at(const ContactElement &element, const double reach) const;

      /**
       * Return 1 if both fibers touched within @p reach [mm] of the particles
       * or their own lengths, 0 if they did not, and what lies between near the
       * end of that: a continuous function of the particles and of the reach.
       */
      double
      touched(const ContactElement &element, const double reach) const;

      /** @return the sum of the limits of the friction of two fibers, [N]. */
      double
      limit(const unsigned int fiber_a, const unsigned int fiber_b) const;

      const std::vector<Record> &
      all() const
      {
        return records;
      }

      /** Write those records for which @p owned says so of their fiber a. */
      void
      save(ArchiveWriter                           &archive,
           const std::string                       &name,
           const std::function<bool(unsigned int)> &owned) const;

      /** Read the records of which @p wanted says so of one of the fibers. */
      void
      load(const ArchiveReader                     &archive,
           const std::string                       &name,
           const std::function<bool(unsigned int)> &wanted);

    private:
      /** Records of two fibers with @p first <= s_a <= @p last [mm]. */
      ArrayView<const Record>
      between(const unsigned int fiber_a,
              const unsigned int fiber_b,
              const double       first,
              const double       last) const;

      /** Those of its fibers up to @p distance from an element along a. */
      ArrayView<const Record>
      around(const ContactElement &element, const double distance) const;

      std::vector<Record> records;      /**< by fiber a, fiber b, s_a, s_b */
      double              longest = 0.; /**< largest weight of a record */
    };
  } // namespace Contact
} // namespace Heddle

#endif
