#ifndef heddle_contributions_load_parameters_h
#define heddle_contributions_load_parameters_h

#include <heddle/base/parameter_file.h>
#include <heddle/contributions/node_selection.h>

#include <deal.II/base/parameter_acceptor.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /** Whether all formulas are the default, 0. */
    bool
    is_nothing(const std::array<std::string, 3> &components);



    /** One load: on which nodes it acts, and its forces and moments. */
    class LoadParameters : public ParameterAcceptor
    {
    public:
      LoadParameters(const std::string &section = "/Loads/Load 1");

      NodeSelection              nodes;
      std::array<std::string, 3> force            = {{"0", "0", "0"}};
      std::array<std::string, 3> moment           = {{"0", "0", "0"}};
      std::array<std::string, 3> force_per_length = {{"0", "0", "0"}};

      bool
      has_moment() const
      {
        return !is_nothing(moment);
      }

      /** Throw InputError if an entry is no formula. */
      void
      check() const;

      /** How messages call an entry: `Loads/Load 1: "Force x"`. */
      std::string
      entry(const std::string &name, const unsigned int component) const;

    private:
      void
      add_vector(const std::string          &name,
                 std::array<std::string, 3> &components,
                 const std::string          &meaning);
    };

    using LoadList = std::vector<std::unique_ptr<LoadParameters>>;

    /** As many loads as there are sections in the file. */
    LoadList
    declare_loads(const ParameterFile &file);
  } // namespace Contributions
} // namespace Heddle

#endif
