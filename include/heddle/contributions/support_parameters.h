#ifndef heddle_contributions_support_parameters_h
#define heddle_contributions_support_parameters_h

#include <heddle/base/parameter_file.h>
#include <heddle/contributions/support.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /** A support as a section of the parameter file describes it. */
    class SupportParameters : public ParameterAcceptor, public Support
    {
    public:
      SupportParameters(const std::string &section = "/Supports/Support 1");

      /** Throw InputError if the entries make no support. */
      void
      check() const;
    };

    /** As many supports as there are sections in the file. */
    SupportList
    declare_supports(const ParameterFile &file);
  } // namespace Contributions
} // namespace Heddle

#endif
