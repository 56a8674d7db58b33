#include <heddle/base/reduce.h>
#include <heddle/contact/elastic_approach.h>
#include <heddle/contributions/indentation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    namespace internal
    {
      namespace Indentation
      {
        using Element = Contact::ContactElement;
        using Range   = std::pair<std::vector<Element>::const_iterator,
                                std::vector<Element>::const_iterator>;



        Contact::PressedFiber
        pressed(const System::Fiber &fiber)
        {
          const double modulus = fiber.section.thickness /
                                 (numbers::PI * fiber.radius * fiber.radius);
          return {fiber.radius,
                  2. * modulus / (1. - fiber.section.poisson_ratio)};
        }



        /** Elements that follow each other, as one contact. */
        struct Stretch
        {
          double         force    = 0.; /**< [N] */
          double         length   = 0.; /**< [mm] */
          double         pressure = 0.; /**< largest of a cell [N/mm] */
          const Element *deepest  = nullptr;

          /** Of each cell, force [N], length [mm] and least gap [mm]. */
          std::vector<std::array<double, 3>> cells;
        };



        Stretch
        sum_up(const Range &elements)
        {
          Stretch stretch;
          for (auto e = elements.first; e != elements.second;)
            {
              double             force = 0., length = 0., gap = e->gap;
              const unsigned int cell = e->cell;
              for (; e != elements.second && e->cell == cell; ++e)
                {
                  force += e->force;
                  length += e->weight;
                  gap = std::min(gap, e->gap);
                  if (!stretch.deepest || e->gap < stretch.deepest->gap)
                    stretch.deepest = &*e;
                }
              stretch.force += force;
              stretch.length += length;
              stretch.pressure = std::max(stretch.pressure, force / length);
              stretch.cells.push_back({{force, length, gap}});
            }
          return stretch;
        }



        /** Forces of a line times what is missing to their depths [N mm]. */
        double
        work_of_line(const Stretch               &stretch,
                     const Contact::PressedFiber &a,
                     const Contact::PressedFiber &b)
        {
          double work = 0.;
          for (const auto &[force, length, gap] : stretch.cells)
            work +=
              force *
              std::max(0., Contact::line_approach(force / length, a, b) + gap);
          return work;
        }



        /** The elements from @p first on that are of one contact. */
        Range
        contact_from(const std::vector<Element>::const_iterator first,
                     const std::vector<Element>::const_iterator end)
        {
          auto last = first;
          for (auto next = first + 1;
               next != end && next->force > 0. && next->zone == last->zone &&
               next->cell <= last->cell + 1;
               ++next)
            last = next;
          return {first, last + 1};
        }



        /** As long as straight fibers of that angle touch at that depth? */
        bool
        is_crossing(const Stretch &stretch,
                    const double   cosine,
                    const double   sum_of_radii)
        {
          // Their surfaces part by (1 - cos) x^2 / (R_a + R_b).
          const double parted =
            (1. - cosine) / sum_of_radii * std::pow(0.5 * stretch.length, 2.);
          const double depth = -stretch.deepest->gap;
          return parted > 0.5 * depth && parted < 2. * depth;
        }
      } // namespace Indentation
    }   // namespace internal



    double
    Indentation::work_ratio() const
    {
      return work > 0. && energy > 0. ? work / (2. * energy) : 0.;
    }



    double
    Indentation::excess_of_force() const
    {
      // The part y of the force is left where y + r y^(2/3) = 1.
      double low = 0., high = 1.;
      for (unsigned int i = 0; i < 60; ++i)
        {
          const double y = 0.5 * (low + high);
          (y + work_ratio() * std::cbrt(y * y) < 1. ? low : high) = y;
        }
      return 1. / high;
    }



    bool
    Indentation::is_deep() const
    {
      constexpr double deep = 0.1, deeper = 2., large = 1.;
      return ratio > std::max(deep, deeper * allowed) && work_ratio() > large;
    }



    std::string
    Indentation::in_words() const
    {
      if (!is_deep())
        return "";
      const double       excess = excess_of_force();
      std::ostringstream text;
      text
        << std::setprecision(2) << "fibers " << fiber_a << " and " << fiber_b
        << " press each other with " << force << (is_line ? " N/mm" : " N")
        << " near (" << std::setprecision(3) << position[0] << ", "
        << position[1] << ", " << position[2]
        << "), which would press elastic ones into each other by "
        << std::setprecision(2) << ratio
        << " of their radius, and contact allows " << allowed
        << ": where supports prescribe how near fibers come forces are about "
        << std::setprecision(6)
        << (excess < 10. ? 0.1 * std::round(10. * excess) : std::round(excess))
        << " times too large, and where loads press them they come too "
           "little nearer; compress them less, or raise Contact/Penetration "
           "threshold (history.csv, max_indentation_ratio)";
      return text.str();
    }



    void
    Indentation::save(ArchiveWriter &archive, const std::string &name) const
    {
      archive.write_number(name + "/ratio", ratio);
      archive.write_number(name + "/fiber_a", fiber_a);
      archive.write_number(name + "/fiber_b", fiber_b);
      for (unsigned int d = 0; d < 3; ++d)
        archive.write_number(name + "/" + "xyz"[d], position[d]);
      archive.write_number(name + "/force", force);
      archive.write_number(name + "/is_line", is_line);
      archive.write_number(name + "/allowed", allowed);
      archive.write_number(name + "/work", work);
      archive.write_number(name + "/energy", energy);
    }



    void
    Indentation::load(const ArchiveReader &archive, const std::string &name)
    {
      ratio   = archive.read_number(name + "/ratio");
      fiber_a = archive.read_number(name + "/fiber_a");
      fiber_b = archive.read_number(name + "/fiber_b");
      for (unsigned int d = 0; d < 3; ++d)
        position[d] = archive.read_number(name + "/" + "xyz"[d]);
      force   = archive.read_number(name + "/force");
      is_line = archive.read_number(name + "/is_line") > 0.;
      allowed = archive.read_number(name + "/allowed");
      work    = archive.read_number(name + "/work");
      energy  = archive.read_number(name + "/energy");
    }



    Indentation
    find_indentation(const System::FiberSpace                   &space,
                     const Contact::CurveList                   &curves,
                     const std::vector<Contact::ContactElement> &elements,
                     const double                                threshold)
    {
      namespace helpers = internal::Indentation;
      Indentation worst;
      worst.allowed               = threshold;
      std::array<double, 1> works = {};
      for (auto e = elements.begin(); e != elements.end();)
        {
          if (e->force <= 0. || !space.owns(e->fiber_a))
            {
              ++e;
              continue;
            }
          const helpers::Range range = helpers::contact_from(e, elements.end());
          const helpers::Stretch stretch = helpers::sum_up(range);
          e                              = range.second;

          const Contact::ContactElement &at = *stretch.deepest;
          const System::Fiber           &a  = space.fiber(at.fiber_a),
                              &b            = space.fiber(at.fiber_b);
          unsigned int i = curves[at.fiber_a].interval(at.s_a),
                       j = curves[at.fiber_b].interval(at.s_b);
          const Contact::CurvePoint on_a =
                                      curves[at.fiber_a].evaluate(at.s_a, i),
                                    on_b =
                                      curves[at.fiber_b].evaluate(at.s_b, j);
          const double cosine =
            std::min(1.,
                     std::abs(on_a.tangent * on_b.tangent) /
                       (on_a.tangent.norm() * on_b.tangent.norm()));
          const bool crosses =
            helpers::is_crossing(stretch, cosine, a.radius + b.radius);
          const Contact::PressedFiber one = helpers::pressed(a),
                                      two = helpers::pressed(b);
          const double approach =
            crosses ? Contact::crossing_approach(
                        stretch.force, std::acos(cosine), one, two)
                    : Contact::line_approach(stretch.pressure, one, two);
          const double depth = approach / std::min(a.radius, b.radius);
          works[0] += crosses ? stretch.force * std::max(0., approach + at.gap)
                              : helpers::work_of_line(stretch, one, two);
          if (depth > worst.ratio)
            {
              worst.ratio    = depth;
              worst.fiber_a  = at.fiber_a;
              worst.fiber_b  = at.fiber_b;
              worst.position = Point<3>(0.5 * (on_a.position + on_b.position));
              worst.force    = crosses ? stretch.force : stretch.pressure;
              worst.is_line  = !crosses;
            }
        }
      sum_over_ranks(works, space.communicator());
      const auto deepest =
        Utilities::MPI::min_max_avg(worst.ratio, space.communicator());
      worst = Utilities::MPI::broadcast(
        space.communicator(), worst, deepest.max_index);
      worst.work = works[0];
      return worst;
    }
  } // namespace Contributions
} // namespace Heddle
