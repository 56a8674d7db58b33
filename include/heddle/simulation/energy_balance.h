#ifndef heddle_simulation_energy_balance_h
#define heddle_simulation_energy_balance_h

#include <heddle/base/archive.h>

#include <map>
#include <string>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * What the energies of a scene grow by beyond the work that supports and
     * loads do on it, over the steps of a stage. It falls with the steps where
     * motion is smooth, and stays where fibers snap: what they lose between two
     * equilibria is in no energy.
     */
    class EnergyBalance
    {
    public:
      /** By name and unit, as Scene::report() returns them. */
      using Report = std::map<std::string, double>;

      /** What all that do work on the scene report together. */
      static constexpr const char *external_work = "external_work[N*mm]";

      /** Whether anything can do work. */
      static bool
      is_in(const Report &report);

      /** What fibers, contacts, matrix and links have stored [N mm]. */
      static double
      elastic_energy(const Report &report);

      /** Count from a state on, that of load factor 0. */
      void
      begin(const Report &report);

      /** A step has led to this state. */
      void
      add(const Report &report);

      /** Growth of all energies less the work, since begin() [N mm]. */
      double
      imbalance() const
      {
        return sum;
      }

      /**
       * A sentence, if that is a large part of the work, and more than the
       * work @p round_off of forces that are last digits [N mm]; empty
       * otherwise.
       */
      std::string
      in_words(const double round_off) const;

      void
      save(ArchiveWriter &archive) const;

      void
      load(const ArchiveReader &archive);

    private:
      /** Whether the last step is known: see load(). */
      bool begun = true;

      double energy = 0.; /**< at the last step [N mm] */
      double work   = 0.; /**< until then [N mm] */
      double sum    = 0.; /**< of the imbalances of steps [N mm] */
      double path   = 0.; /**< sum of the absolute work of steps [N mm] */
    };
  } // namespace Simulation
} // namespace Heddle

#endif
