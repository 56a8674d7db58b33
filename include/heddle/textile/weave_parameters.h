#ifndef heddle_textile_weave_parameters_h
#define heddle_textile_weave_parameters_h

#include <heddle/textile/weave_description.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /**
     * The parameter section that describes a woven sample, with one subsection
     * for the warp yarns and one for the weft yarns.
     */
    class WeaveParameters : public ParameterAcceptor
    {
    public:
      explicit WeaveParameters(const std::string &section = "/Weave");

      /**
       * What the user asked for. Weft yarns are like warp yarns if the user
       * said so, or said nothing. Throws InputError if a linear density does
       * not fit to the fibers.
       */
      WeaveDescription
      description() const;

    private:
      /** One family as it is written in the file. */
      struct Entries
      {
        YarnFamily yarns;
        int        seed           = 1;
        double     linear_density = 0.; /**< [tex]; 0: of the fibers */
      };

      void
      add_weave();

      void
      add_family(const std::string &subsection, Entries &entries);

      void
      add_packing(Entries &entries);

      WeaveDescription weave;
      bool             weft_is_warp = true;
      Entries          warp;
      Entries          weft;
    };
  } // namespace Textile
} // namespace Heddle

#endif
