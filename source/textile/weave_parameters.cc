#include <heddle/base/choice.h>
#include <heddle/textile/linear_density.h>
#include <heddle/textile/weave_parameters.h>

#include <deal.II/base/patterns.h>

namespace Heddle
{
  namespace Textile
  {
    WeaveParameters::WeaveParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_weave();
      add_family("Warp yarns", warp);
      enter_subsection("Weft yarns");
      add_parameter(
        "Same as warp yarns",
        weft_is_warp,
        "Whether the weft yarns are like the warp yarns, in number "
        "too. If true, no other entry of this section is active [-].");
      leave_subsection();
      add_family("Weft yarns", weft);
    }



    void
    WeaveParameters::add_weave()
    {
      add_parameter("Pattern",
                    weave.pattern,
                    "Which yarn lies on top at each crossing: 'plain', 'twill "
                    "m/n' (each warp yarn over m, under n weft yarns), 'satin "
                    "N/S' (warp on top but for one crossing in N, which moves "
                    "by S from weft yarn to weft yarn), 'basket m/n' (without "
                    "numbers: 2/2, satin 5/2), or a matrix like '0 1; 1 0', "
                    "rows being weft yarns and 1 "
                    "meaning warp on top. Repeated over the sample. "
                    "Inactive unless Run/Scene is 'weave', like all of this "
                    "section [-].");
      add_choice(*this,
                 "Start",
                 weave.start,
                 "Geometry from which the initial configuration is "
                 "computed: 'interpenetrating' (straight yarns in one "
                 "plane) or 'crimped' (yarns bent over and under each "
                 "other, every fiber on its side of those it crosses). Guides "
                 "keep the ends of yarns at the height at which these put "
                 "them, in that plane or as if the weave went on: in samples "
                 "of few yarns crimp and forces differ [-].");
      add_parameter("End length",
                    weave.end_length,
                    "Length of yarn beyond its last crossing, as a fraction of "
                    "the spacing of the yarns that it crosses, 0 to 10 [-].",
                    prm,
                    Patterns::Double(0., 10.));
      add_parameter(
        "Crimp factor",
        weave.crimp_factor,
        "Height of the yarn axes at the crossings over a quarter "
        "of the sum of a warp and a weft yarn's heights, 0 to 100. "
        "At 1 flat ribbons would just touch; wide yarns close to "
        "each other need about 2 to have every fiber on its side "
        "of every other, and 4 to be clear of each other. 0: the "
        "smallest at which no warp fiber touches a weft fiber or, "
        "if there is none up to 1.5, the smallest up to 6 at which "
        "all are on their side. Inactive unless Start is 'crimped' [-].",
        prm,
        Patterns::Double(0., 100.));
      add_parameter("Crimp transition",
                    weave.crimp_transition,
                    "Part of the spacing over which a yarn changes its side, "
                    "above 0 to 1. 1 is a cosine from crossing to crossing; "
                    "less gives a lower but sharper crimp. Inactive unless "
                    "Start is 'crimped' [-].",
                    prm,
                    Patterns::Double(0., 1.));
    }



    void
    WeaveParameters::add_family(const std::string &subsection, Entries &entries)
    {
      enter_subsection(subsection);
      add_parameter("Number of yarns",
                    entries.yarns.n_yarns,
                    "How many yarns lie side by side, at least 1 [-].",
                    prm,
                    Patterns::Integer(1));
      add_packing(entries);
      add_parameter("Twist",
                    entries.yarns.twist,
                    "Turns of the fibers about the axis of their yarn per "
                    "length of the fabric, right-handed (Z); negative: "
                    "left-handed (S). The packing spacing must leave room for "
                    "it [1/mm].",
                    prm,
                    Patterns::Double());
      add_parameter("Yarn spacing",
                    entries.yarns.spacing,
                    "Distance between the axes of neighbouring yarns. 0: the "
                    "width of the yarn plus 0.8 times the height of the yarns "
                    "that pass between [mm].",
                    prm,
                    Patterns::Double(0.));
      leave_subsection();
    }



    void
    WeaveParameters::add_packing(Entries &entries)
    {
      Packing &packing = entries.yarns.packing;
      add_parameter("Bundles",
                    packing.n_bundles,
                    "Number of bundles in a yarn, at least 1 [-].",
                    prm,
                    Patterns::Integer(1));
      add_parameter("Fibers per bundle",
                    packing.fibers_per_bundle,
                    "Number of fibers in a bundle, at least 1 [-].",
                    prm,
                    Patterns::Integer(1));
      add_parameter("Fiber radius",
                    packing.radius,
                    "Radius of the circular section of a fiber, above 0; with "
                    "a linear density, of a filament [mm].",
                    prm,
                    Patterns::Double(0.));
      add_parameter("Linear density",
                    entries.linear_density,
                    "What a yarn weighs, in grams per kilometer. Its fibers "
                    "then stand for all of its filaments: together they have "
                    "their area, and bend and twist as easily as they. 0: each "
                    "fiber is a filament [tex].",
                    prm,
                    Patterns::Double(0.));
      add_parameter("Density",
                    entries.yarns.density,
                    "Of the fibers, for what yarns and fabric weigh; 0: not "
                    "known [g/cm^3].",
                    prm,
                    Patterns::Double(0., 25.));
      add_choice(*this,
                 "Packing",
                 packing.layout,
                 "How the fibers lie in the section: 'rows' (bundles side "
                 "by side, each of staggered rows, 12 fibers being 4 x 3) "
                 "or 'hexagonal' (the whole yarn compact and round, its "
                 "bundles being sectors) [-].");
      add_parameter("Packing spacing",
                    packing.spacing,
                    "Distance between the axes of neighbouring fibers over the "
                    "fiber radius, at least 2 [-].",
                    prm,
                    Patterns::Double(2.));
      add_parameter("Packing perturbation",
                    packing.perturbation,
                    "Largest random shift of a fiber, as a fraction of the "
                    "shift at which it might touch a neighbour, 0 to 1 [-].",
                    prm,
                    Patterns::Double(0., 1.));
      add_parameter("Packing seed",
                    entries.seed,
                    "Seed of the random shifts, at least 0. The same seed "
                    "gives the same fibers on any number of ranks. Inactive if "
                    "the packing perturbation is 0 [-].",
                    prm,
                    Patterns::Integer(0));
    }



    WeaveDescription
    WeaveParameters::description() const
    {
      const auto family = [](const Entries &entries, const std::string &where) {
        YarnFamily yarns   = entries.yarns;
        yarns.packing.seed = entries.seed;
        if (entries.linear_density > 0.)
          lump_filaments(yarns, entries.linear_density, "Weave/" + where);
        return yarns;
      };
      WeaveDescription result = weave;
      result.warp             = family(warp, "Warp yarns");
      result.weft = weft_is_warp ? result.warp : family(weft, "Weft yarns");
      return result;
    }
  } // namespace Textile
} // namespace Heddle
