#ifndef heddle_textile_weave_description_h
#define heddle_textile_weave_description_h

#include <heddle/textile/packing.h>

#include <string>

namespace Heddle
{
  namespace Textile
  {
    /** From which geometry the initial configuration is computed. */
    enum class Start
    {
      /** Straight yarns, all in one plane, running through each other. */
      interpenetrating,
      /** Yarns bent over and under each other, clear of each other. */
      crimped
    };

    /** How the user names them. */
    constexpr const char *
    word(const Start start)
    {
      switch (start)
        {
          case Start::interpenetrating:
            return "interpenetrating";
          case Start::crimped:
            return "crimped";
        }
      return nullptr;
    }



    /** All the warp yarns, or all the weft yarns. */
    struct YarnFamily
    {
      unsigned int n_yarns = 4;
      Packing      packing;

      /** Density of the fibers [g/cm^3]; 0: not known. */
      double density = 0.;

      /** Turns of the fibers about the yarn per length of the fabric [1/mm]. */
      double twist = 0.;

      /**
       * Distance between the axes of neighbouring yarns [mm]; 0: the width of
       * the yarn and 0.8 times the height of the yarns that pass between.
       */
      double spacing = 0.;
    };



    /** A woven sample, as the user describes it. */
    struct WeaveDescription
    {
      std::string pattern = "plain";
      YarnFamily  warp;
      YarnFamily  weft;

      /** Yarn beyond its last crossing, in spacings of those it crosses [-]. */
      double end_length = 1.;

      Start start = Start::crimped;

      /**
       * Height of the yarn axes at the crossings of the crimped start, over a
       * quarter of the sum of both yarns' heights; 0: the smallest at which the
       * yarns are clear of each other or, if there is none, in order [-].
       */
      double crimp_factor = 0.;

      /** Part of the spacing over which a yarn changes its side, (0,1] [-]. */
      double crimp_transition = 1.;
    };



    /**
     * Throw an InputError if a number is out of its range or the packing leaves
     * no room for the twist. What only the whole geometry can tell, Weave does.
     */
    void
    check_weave(const WeaveDescription &description);
  } // namespace Textile
} // namespace Heddle

#endif
