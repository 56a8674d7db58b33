#ifndef heddle_contributions_friction_coefficients_h
#define heddle_contributions_friction_coefficients_h

#include <heddle/contact/contact_parameters.h>
#include <heddle/system/fiber_space.h>

#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Coefficients of friction between the materials of a scene: fibers of one
     * set, "warp" for instance, are of one material.
     */
    class FrictionCoefficients
    {
    public:
      /** Throws InputError if @p parameters name sets that are not there. */
      FrictionCoefficients(const System::FiberSpace         &space,
                           const Contact::ContactParameters &parameters);

      /**
       * @return the coefficient for two fibers whose tangents enclose an angle
       * of this @p cosine [-].
       */
      double
      operator()(const unsigned int fiber_a,
                 const unsigned int fiber_b,
                 const double       cosine) const;

    private:
      const double              crossed; /**< over that of parallel fibers */
      std::vector<unsigned int> set_of_fiber;
      std::vector<std::vector<double>> parallel; /**< by both sets */
    };
  } // namespace Contributions
} // namespace Heddle

#endif
