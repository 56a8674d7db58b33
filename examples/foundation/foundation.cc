// heddle with a contribution that it does not have: fibers on an elastic
// foundation, springs between them and where they start.
#include <heddle/simulation/program.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_acceptor.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace dealii;
using namespace Heddle;

/** A section of the parameter file. */
struct FoundationParameters : public ParameterAcceptor
{
  FoundationParameters()
    : ParameterAcceptor("/Foundation")
  {
    add_parameter("Stiffness",
                  stiffness,
                  "Force per length of fiber and per displacement [N/mm^2].",
                  prm,
                  Patterns::Double(0.));
  }

  double stiffness = 1.;
};



/** Springs at the nodes, each of its share of the fiber's length. */
class Foundation : public System::Contribution
{
public:
  /** @p initial are the owned blocks where the springs are free. */
  Foundation(const std::vector<Tensor<1, 3>> &initial, const double stiffness)
    : initial(initial)
    , stiffness(stiffness)
  {
  }

  std::string
  name() const override
  {
    return "foundation";
  }

  void
  assemble(const System::State &state, System::BlockSystem &system) override
  {
    for_all_springs(
      state,
      [&system](const unsigned int  block,
                const double        spring,
                const Tensor<1, 3> &displacement) {
        const Tensor<1, 3> residual = spring * displacement;
        const Tensor<2, 3> tangent =
          spring * Tensor<2, 3>(unit_symmetric_tensor<3>());
        system.add(1, &block, residual.begin_raw(), tangent[0].begin_raw());
      });
  }

  void
  report(const System::State           &state,
         std::map<std::string, double> &values) const override
  {
    double       energy = 0.;
    Tensor<1, 3> force;
    for_all_springs(
      state,
      [&](const unsigned int, const double spring, const Tensor<1, 3> &way) {
        energy += 0.5 * spring * way.norm_square();
        force += spring * way;
      });
    const MPI_Comm communicator = state.space.communicator();
    values["foundation_energy[N*mm]"] =
      Utilities::MPI::sum(energy, communicator);
    values["foundation_force_z[N]"] =
      Utilities::MPI::sum(force, communicator)[2];
  }

private:
  /** Call @p visit (block, stiffness [N/mm], displacement [mm]) for the owned
   * nodes. The first block of a node is its position. */
  template <typename Visit>
  void
  for_all_springs(const System::State &state, const Visit &visit) const
  {
    const System::FiberSpace &space = state.space;
    const auto                owned = space.owned_fibers();
    for (unsigned int f = owned.first; f < owned.second; ++f)
      {
        const double      *places  = space.node_positions(f);
        const unsigned int n_nodes = space.fiber(f).n_nodes;
        for (unsigned int i = 0; i < n_nodes; ++i)
          {
            const double share = 0.5 * (places[std::min(i + 1, n_nodes - 1)] -
                                        places[std::max(i, 1u) - 1]);
            const unsigned int block =
              state.local_block(f) + i * space.n_blocks_per_node();
            visit(block,
                  stiffness * share,
                  state.current()[block] - initial[block]);
          }
      }
  }

  const std::vector<Tensor<1, 3>> initial;
  const double                    stiffness;
};



int
main(int argc, char *argv[])
{
  const FoundationParameters parameters;
  return Simulation::program(
    argc,
    argv,
    [&parameters](const System::FiberSpace &,
                  const std::vector<Tensor<1, 3>> &initial) {
      return Solver::Contributions{
        std::make_shared<Foundation>(initial, parameters.stiffness)};
    });
}
