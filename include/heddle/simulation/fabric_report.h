#ifndef heddle_simulation_fabric_report_h
#define heddle_simulation_fabric_report_h

#include <heddle/post/fabric_window.h>
#include <heddle/simulation/scene.h>

#include <map>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * What the yarns look like in the current configuration, of a weave or of
     * centerlines from a file that says to which yarn fibers belong.
     */
    class FabricReport
    {
    public:
      /**
       * Collect the fibers on rank 0: only there the members below have
       * something to say. A fabric that is bent is measured @p flattened.
       * @note Collective.
       */
      FabricReport(const System::State &state, const PointMap &flattened = {});

      /**
       * The sections of all yarns at @p n_stations equal fractions of their
       * lengths, one line each, as CSV.
       */
      std::string
      yarns_csv(const unsigned int n_stations) const;

      /**
       * Means over the yarns of each set, and what a data sheet says of the
       * fabric, by name with unit. @p densities are those of all fibers when
       * they are free; 0: not known [g/cm^3].
       */
      std::map<std::string, double>
      results(const unsigned int         n_stations,
              const std::vector<double> &densities) const;

      /** How the fibers of yarns run, one line for each class of angles. */
      std::string
      orientation_csv() const;

      /**
       * A sentence about yarns, or a fabric, of which fibers take more than
       * there is; empty if there are none.
       */
      std::string
      overfull(const unsigned int n_stations) const;

      /** The fibers of a yarn, as polylines in their current place. */
      struct Yarn
      {
        std::string               set;
        std::vector<unsigned int> fibers;
        std::vector<Polyline>     lines;
        std::vector<double>       radii;

        /** As fine as the fibers. */
        Polyline
        mean_line() const;
      };

      /** Of all yarns, by their numbers; none on other ranks than 0. */
      const std::vector<Yarn> &
      yarns() const
      {
        return all_yarns;
      }

      /** Of all fibers, by their numbers; none on other ranks than 0. */
      const std::vector<Polyline> &
      centerlines() const
      {
        return lines;
      }

    private:
      /** The yarns with their mean lines and, of known @p densities, those of
       * the fibers as they are, stretched. */
      std::vector<Post::YarnBody>
      bodies(const std::vector<double> &densities) const;

      const System::FiberSpace &space;
      std::vector<Polyline>     lines;
      std::vector<Yarn>         all_yarns;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
