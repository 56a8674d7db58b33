#ifndef heddle_io_output_parameters_h
#define heddle_io_output_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace Heddle
{
  namespace IO
  {
    using namespace dealii;

    /** What a run writes for the eye, and what it keeps to be resumed. */
    class OutputParameters : public ParameterAcceptor
    {
    public:
      OutputParameters(const std::string &section = "/Output");

      /**
       * Whether fibers and contacts are written after load step @p step of a
       * stage. The last step of a stage always is, unless the interval is 0;
       * that to load factor 0, number 0, is not: it would be shown at the time
       * of the end of the stage before.
       */
      bool
      due(const unsigned int step, const bool last_of_stage) const;

      /** Whether a checkpoint is written after load step @p step. */
      bool
      checkpoint_due(const unsigned int step, const bool last_of_stage) const;

      bool         fibers              = true;
      bool         contacts            = true;
      bool         matrix              = true;
      bool         centerlines         = true;
      unsigned int interval            = 1;
      unsigned int subdivisions        = 2;
      unsigned int checkpoint_interval = 1;
      unsigned int n_checkpoints       = 2;
      unsigned int yarn_stations       = 21;
    };
  } // namespace IO
} // namespace Heddle

#endif
