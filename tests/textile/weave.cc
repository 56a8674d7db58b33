// Weaves: their patterns, the parameters that describe them, their fibers in
// both starts, and what is refused in one sentence.
#include <heddle/base/exceptions.h>
#include <heddle/textile/weave.h>
#include <heddle/textile/weave_parameters.h>
#include <heddle/textile/weave_pattern.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_acceptor.h>

#include "../tests.h"

#include <functional>
#include <utility>

using namespace Heddle::Textile;

/** Every weave has the pattern of its textbook, and repeats itself. */
void
patterns()
{
  for (const std::string name : {"plain",
                                 "twill 2/2",
                                 "twill 3/1",
                                 "satin 5/2",
                                 "satin 8/3",
                                 "basket 2/2",
                                 "basket 2/1",
                                 "0 1; 1 1; 1 0"})
    {
      const Heddle::Textile::WeavePattern pattern(name);
      deallog << name << " repeats after " << pattern.n_warp() << " warp and "
              << pattern.n_weft() << " weft yarns" << std::endl;
      for (unsigned int j = 0; j < pattern.n_weft() + 1; ++j)
        {
          std::string row;
          for (unsigned int i = 0; i < pattern.n_warp() + 2; ++i)
            row += pattern.warp_on_top(i, j) ? '1' : '0';
          deallog << "  " << row << std::endl;
        }
    }

  // Names without numbers.
  for (const auto &names : std::vector<std::pair<std::string, std::string>>{
         {"twill", "twill 2/2"},
         {"satin", "satin 5/2"},
         {"basket", "basket 2/2"}})
    {
      const Heddle::Textile::WeavePattern bare(names.first), full(names.second);
      bool                                same =
        bare.n_warp() == full.n_warp() && bare.n_weft() == full.n_weft();
      for (unsigned int i = 0; i < full.n_warp(); ++i)
        for (unsigned int j = 0; j < full.n_weft(); ++j)
          same = same && bare.warp_on_top(i, j) == full.warp_on_top(i, j);
      deallog << names.first << " is " << names.second << ": " << same
              << std::endl;
    }
}



/** A pattern that is none is refused in one sentence. */
void
no_patterns()
{
  for (const std::string name : {"",
                                 "plane",
                                 "twill 2",
                                 "twill 0/2",
                                 "satin 6/2",
                                 "satin 5/4",
                                 "0 1; 1"})
    try
      {
        const Heddle::Textile::WeavePattern pattern(name);
        deallog << "accepted '" << name << "'" << std::endl;
      }
    catch (const Heddle::InputError &error)
      {
        deallog << error.what() << std::endl;
      }
}



void
print_yarns(const std::string &name, const YarnFamily &yarns)
{
  deallog << name << ": " << yarns.n_yarns << " yarns of "
          << yarns.packing.n_bundles << " x " << yarns.packing.fibers_per_bundle
          << (yarns.packing.layout == Layout::rows ? ", rows" : ", hexagonal")
          << ", radius " << yarns.packing.radius << ", seed "
          << yarns.packing.seed << ", spacing " << yarns.spacing << std::endl;
}



/**
 * The parameter section describes a weave; weft yarns follow the warp yarns
 * unless the user says otherwise.
 */
void
parameters()
{
  const WeaveParameters weave_parameters;
  for (const std::string weft :
       {"",
        "subsection Weft yarns\nset Same as warp yarns = false\n"
        "set Number of yarns = 3\nset Yarn spacing = 0.5\nend\n"})
    {
      ParameterAcceptor::prm.parse_input_from_string(
        "subsection Weave\nset Pattern = twill 2/2\n"
        "set Start = interpenetrating\nsubsection Warp yarns\n"
        "set Number of yarns = 5\nset Bundles = 3\nset Packing = hexagonal\n"
        "set Fiber radius = 0.25\nset Packing seed = 7\nend\n" +
        weft + "end\n");
      ParameterAcceptor::parse_all_parameters();

      const WeaveDescription weave = weave_parameters.description();
      deallog << weave.pattern
              << (weave.start == Start::crimped ? ", crimped"
                                                : ", interpenetrating")
              << std::endl;
      print_yarns("warp", weave.warp);
      print_yarns("weft", weave.weft);
    }
}



void
refuse(const std::function<void(WeaveDescription &)> &spoil)
{
  WeaveDescription description;
  spoil(description);
  try
    {
      const Weave weave(description);
      deallog << "accepted" << std::endl;
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



/** A weave that cannot be is refused in one sentence. */
void
no_weaves()
{
  refuse([](auto &weave) { weave.warp.n_yarns = 0; });
  refuse([](auto &weave) { weave.weft.spacing = -1.; });
  refuse([](auto &weave) { weave.warp.twist = 50.; });
  refuse([](auto &weave) { weave.warp.twist = 1e6; });
  refuse([](auto &weave) { weave.end_length = -0.5; });
  refuse([](auto &weave) { weave.crimp_transition = 0.; });
  refuse([](auto &weave) { weave.crimp_factor = -1.; });
  refuse([](auto &weave) { weave.weft.packing.n_bundles = 0; });
  refuse([](auto &weave) { weave.warp.packing.radius = 0.; });
  refuse([](auto &weave) { weave.warp.packing.spacing = 1.9; });
  refuse([](auto &weave) { weave.warp.packing.perturbation = 1.5; });
  refuse([](auto &weave) {
    weave.warp.n_yarns = weave.weft.n_yarns = 1;
    weave.end_length                        = 0.;
  });
  refuse([](auto &weave) {
    weave.warp.n_yarns = weave.weft.n_yarns = 2;
    weave.warp.spacing = weave.weft.spacing = 0.03;
  });
}



/** The spacing that a refused twist names is the least that is enough. */
void
named_spacing()
{
  const auto twisted = [](const double spacing) {
    WeaveDescription weave;
    weave.warp.twist           = 5.;
    weave.warp.packing.spacing = spacing;
    return weave;
  };
  try
    {
      const Weave weave(twisted(2.04));
      deallog << "accepted" << std::endl;
    }
  catch (const Heddle::InputError &error)
    {
      const std::string message = error.what();
      const std::string before  = "at least ";
      const double      named =
        std::stod(message.substr(message.find(before) + before.size()));
      refuse([&](auto &weave) { weave = twisted(named); });
      refuse([&](auto &weave) { weave = twisted(named - 0.002); });
    }
}



/** Largest minus smallest distance of neighbouring knots over their mean. */
double
unevenness(const FiberPath &fiber)
{
  double smallest = 1e300, largest = 0.;
  for (unsigned int i = 1; i < fiber.points.size(); ++i)
    {
      const double h = (fiber.points[i] - fiber.points[i - 1]).norm();
      smallest       = std::min(smallest, h);
      largest        = std::max(largest, h);
    }
  return (largest - smallest) / largest;
}



void
print_fibers(const std::string &name, const WeaveDescription &description)
{
  const Weave weave(description);
  const auto  fibers = weave.paths(400);
  double      uneven = 0.;
  for (const FiberPath &fiber : fibers)
    uneven = std::max(uneven, unevenness(fiber));

  deallog << name << ": " << fibers.size() << " fibers of "
          << fibers[0].points.size() << " knots, uneven by less than "
          << (uneven < 1e-3 ? "1e-3" : "1") << std::endl;
  for (const unsigned int f : {0u, 23u, 24u, 59u})
    deallog << "  fiber " << f << ": yarn " << fibers[f].yarn_id << ", bundle "
            << fibers[f].bundle_id << ", set " << fibers[f].set << ", length "
            << fibers[f].reference_length << ", from " << fibers[f].points[0]
            << std::endl;
}



/**
 * Fibers come warp first, yarn by yarn, with knots equally spaced in arc
 * length; straight ones have their own length, twisted ones that of a helix,
 * and crimped ones that of a cosine.
 */
void
paths()
{
  WeaveDescription description;
  description.start                          = Start::interpenetrating;
  description.warp.n_yarns                   = 2;
  description.warp.packing.n_bundles         = 2;
  description.warp.packing.fibers_per_bundle = 6;
  description.warp.packing.radius            = 1.;
  description.warp.packing.spacing           = 2.2;
  description.warp.spacing                   = 30.;
  description.weft                           = description.warp;
  description.weft.n_yarns                   = 3;
  description.weft.spacing                   = 40.;
  print_fibers("straight", description);

  description.warp.twist = 0.01;
  print_fibers("twisted warp", description);
  const double across =
    pack_yarn(description.warp.packing, 0).positions[0].norm();
  const double rate = 2. * numbers::PI * description.warp.twist * across;
  deallog << "  helix of fiber 0: " << 120. * std::sqrt(1. + rate * rate)
          << std::endl;

  description.warp.twist   = 0.;
  description.start        = Start::crimped;
  description.crimp_factor = 1.5;
  print_fibers("crimped", description);
}



/** Smallest distance between the points of two lists of fibers, to a pitch. */
double
smallest_distance(const std::vector<FiberPath> &fibers, const bool same_yarn)
{
  double smallest = 1e300;
  for (const FiberPath &a : fibers)
    for (const FiberPath &b : fibers)
      if (same_yarn ? (&a < &b && a.yarn_id == 0 && b.yarn_id == 0)
                    : (a.set == "warp" && b.set == "weft"))
        for (const auto &p : a.points)
          for (const auto &q : b.points)
            smallest = std::min(smallest, (p - q).norm_square());
  return std::sqrt(smallest);
}



void
print_distances(const std::string &pattern,
                const Layout       layout,
                const unsigned int n_bundles)
{
  WeaveDescription description;
  description.pattern                = pattern;
  description.warp.n_yarns           = 2;
  description.warp.packing.layout    = layout;
  description.warp.packing.n_bundles = n_bundles;
  description.warp.packing.radius    = 0.0045;
  description.weft                   = description.warp;

  const Weave  weave(description);
  const auto   fibers = weave.paths(150);
  const double scale  = 1. / description.warp.packing.radius;
  deallog << pattern << (layout == Layout::rows ? ", rows, " : ", hexagonal, ")
          << n_bundles << " x 12: amplitude " << scale * weave.amplitude()
          << " R at a pitch of " << scale * weave.warp_spacing()
          << " R, warp touches weft "
          << (scale * smallest_distance(fibers, false) < 2.)
          << ", fibers of a yarn "
          << std::floor(10. * scale * smallest_distance(fibers, true)) / 10.
          << " R apart or more" << std::endl;
}



/**
 * In the crimped start no warp fiber touches a weft fiber, unless that takes
 * more than half as much crimp again as flat ribbons need: then it is in order
 * only (see post/yarns). Within a yarn fibers keep their distance.
 */
void
distances()
{
  for (const std::string pattern : {"plain", "twill 2/2"})
    for (const Layout layout : {Layout::rows, Layout::hexagonal})
      for (const unsigned int n_bundles : {1, 3})
        print_distances(pattern, layout, n_bundles);
}



/** What is said of weaves that are laid out, but may not be what was meant. */
void
notes()
{
  const auto print = [](const std::string                             &name,
                        const std::function<void(WeaveDescription &)> &change) {
    WeaveDescription description;
    change(description);
    const auto notes = Weave(description).notes();
    deallog << name << ": " << notes.size() << " notes" << std::endl;
    for (const std::string &note : notes)
      deallog << note << std::endl;
  };
  print("default", [](WeaveDescription &) {});
  print("short ends", [](WeaveDescription &weave) { weave.end_length = 0.25; });
  print("narrow", [](WeaveDescription &weave) {
    weave.weft.spacing = 0.5 * Weave(weave).weft_spacing();
  });
  print("warp on top", [](WeaveDescription &weave) { weave.pattern = "1"; });
  print("one warp yarn over all",
        [](WeaveDescription &weave) { weave.pattern = "1 0; 1 1"; });
}



int
main()
{
  initlog();
  run_part("Patterns", patterns);
  run_part("What is no pattern", no_patterns);
  run_part("Parameters", parameters);
  run_part("What is no weave", no_weaves);
  run_part("Spacing that a refused twist names", named_spacing);
  run_part("Notes", notes);
  run_part("Paths of fibers", paths);
  run_part("Distances of fibers in the crimped start", distances);
}
