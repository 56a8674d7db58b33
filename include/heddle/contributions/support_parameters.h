#ifndef heddle_contributions_support_parameters_h
#define heddle_contributions_support_parameters_h

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

    /** One support: which nodes it holds, and how they have to move. */
    class SupportParameters : public ParameterAcceptor
    {
    public:
      SupportParameters(const std::string &section = "/Supports/Support 1");

      NodeSelection              nodes;
      std::vector<std::string>   matrix_sides;
      std::array<std::string, 3> displacement = {{"free", "free", "free"}};
      std::string                section      = "free";
      std::string                angle        = "0";
      Tensor<1, 3>               axis         = Tensor<1, 3>({0., 0., 1.});
      std::vector<std::string>   held_tangent;

      /** Throw InputError if the entries make no support. */
      void
      check() const;

      /** Numbers of the sides of the matrix, x-, x+, y-, y+, z-, z+. */
      std::vector<unsigned int>
      sides() const;

      /** How messages call an entry: `Supports/Support 1: "Turn angle"`. */
      std::string
      entry(const std::string &name) const;
    };

    using SupportList = std::vector<std::unique_ptr<SupportParameters>>;

    /** As many supports as there are sections in the file. */
    SupportList
    declare_supports(const ParameterFile &file);
  } // namespace Contributions
} // namespace Heddle

#endif
