#ifndef heddle_io_fiber_output_h
#define heddle_io_fiber_output_h

#include <heddle/io/collection.h>
#include <heddle/io/patch_file.h>
#include <heddle/system/fiber_space.h>
#include <heddle/system/state.h>

#include <functional>
#include <string>
#include <vector>

namespace Heddle
{
  namespace IO
  {
    using namespace dealii;

    /**
     * The fibers as lines: points on the smooth centerline, with the strains
     * and section forces of the fibers.
     *
     * Elements know strains and forces best at their middles. In between they
     * vary linearly along the fiber, and these lines go on to its ends.
     */
    class FiberOutput
    {
    public:
      /** Reference strains of element @p e of the owned fiber @p f. */
      using ReferenceStrains =
        std::function<const double *(const unsigned int f,
                                     const unsigned int e)>;

      /** Each element is drawn by @p n_subdivisions straight pieces. */
      FiberOutput(const System::FiberSpace &space,
                  const unsigned int        n_subdivisions,
                  const std::string        &directory,
                  const unsigned int        resume_at = 0);

      /**
       * Write the current configuration of @p state as file @p number of the
       * series. Displacements are counted from the configuration @p initial,
       * an array like State::current().
       *
       * @note Collective.
       */
      void
      write(const System::State             &state,
            const std::vector<Tensor<1, 3>> &initial,
            const ReferenceStrains          &reference_strains,
            const unsigned int               number,
            const double                     time,
            const std::string               &stage);

      /** Return the line of the owned fiber @p f with its data. */
      PatchFile<1>::Patch
      patch(const System::State             &state,
            const std::vector<Tensor<1, 3>> &initial,
            const ReferenceStrains          &reference_strains,
            const unsigned int               f) const;

      /** Names of the data, vectors with the suffix "[3]", in their order. */
      std::vector<std::string>
      fields() const;

    private:
      /** Fibers have sections, whose directions are written. */
      bool
      has_sections() const;

      const System::FiberSpace &space;
      const unsigned int        n_subdivisions;
      Collection                collection;
    };
  } // namespace IO
} // namespace Heddle

#endif
