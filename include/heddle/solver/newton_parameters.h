#ifndef heddle_solver_newton_parameters_h
#define heddle_solver_newton_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /** When an equilibrium is found, and when the search is given up. */
    struct NewtonLimits
    {
      double       residual_tolerance  = 1e-5;
      double       increment_tolerance = 1e-3;
      unsigned int max_iterations      = 60;

      /** Of those, as long as forces fall, and at load factor 0. */
      unsigned int most_iterations = 60;

      double damping = 3e-4;
    };



    /** As a parameter file sets them. */
    class NewtonParameters : public ParameterAcceptor, public NewtonLimits
    {
    public:
      NewtonParameters(const std::string &section = "/Newton");

      /**
       * Set what was not given. A @p fabric is settled when what its contacts
       * carry is balanced to a hundredth: its last fibers find their places
       * slowly, and change little. Fibers that are @p straight_when_free come
       * from as far, and so do those that have to settle before loads begin,
       * in a step that cannot be halved.
       */
      void
      choose_for(const bool fabric, const bool straight_when_free);

    private:
      /** As given; 0: it was not. */
      double       given_residual   = 0.;
      double       given_increment  = 0.;
      unsigned int given_iterations = 0;
    };
  } // namespace Solver
} // namespace Heddle

#endif
