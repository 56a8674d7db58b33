// Laws of the matrix: forces and tangents are derivatives of the energy, and
// what a user can get wrong is told.
#include <heddle/base/choice.h>
#include <heddle/base/exceptions.h>
#include <heddle/solid/material_parameters.h>

#include "test_cell.h"

using Heddle::Solid::MaterialParameters;

Nodes
moved(const Nodes &nodes, const Nodes &direction, const double step)
{
  Nodes result = nodes;
  for (unsigned int a = 0; a < nodes.size(); ++a)
    result[a] += step * direction[a];
  return result;
}



/** Errors of the differences of energy and residual, relative. */
std::pair<double, double>
errors(TestCell    &cell,
       const Nodes &state,
       const Nodes &direction,
       const double step)
{
  const unsigned int  n = cell.n_unknowns();
  std::vector<double> residual, tangent, plus, minus;
  cell.assemble(state, &residual, &tangent);
  const double difference =
    cell.assemble(moved(state, direction, step), &plus, nullptr) -
    cell.assemble(moved(state, direction, -step), &minus, nullptr);

  double slope = 0., error = 0., size = 0.;
  for (unsigned int i = 0; i < n; ++i)
    {
      double row = 0.;
      for (unsigned int j = 0; j < n; ++j)
        row += tangent[i * n + j] * direction[j / 3][j % 3];
      slope += residual[i] * direction[i / 3][i % 3];
      error += std::pow((plus[i] - minus[i]) / (2. * step) - row, 2);
      size += row * row;
    }
  return {std::abs(difference / (2. * step) - slope) / std::abs(slope),
          std::sqrt(error / size)};
}



/** The observed order, or that there is no error to observe. */
std::string
order(const double coarse, const double fine)
{
  return fine < 1e-10 ? "exact"
                      : std::to_string(std::lround(std::log2(coarse / fine)));
}



double
asymmetry(TestCell &cell, const Nodes &state)
{
  const unsigned int  n = cell.n_unknowns();
  std::vector<double> tangent;
  cell.assemble(state, nullptr, &tangent);
  double largest = 0.;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      largest =
        std::max(largest, std::abs(tangent[i * n + j] - tangent[j * n + i]));
  return largest;
}



/**
 * The residual is the gradient of the energy and the tangent is the gradient of
 * the residual: central differences approach both with the order two, on
 * distorted cells in random states. Where the energy is at most quadratic and
 * differences are exact, round-off is all that is left.
 */
void
derivatives()
{
  for (const std::string &law : all_laws)
    for (const unsigned int degree : {1, 2})
      for (const bool mean_dilatation : {false, true})
        for (unsigned int seed = 1; seed <= 3; ++seed)
          {
            const auto material = Heddle::Solid::make_material(
              Heddle::choice<Heddle::Solid::MaterialLaw>(law), 2.5, .35);
            Random random(seed);
            Nodes  reference = cube(degree);
            random.disturb(reference, .12 / degree);
            Nodes state = reference;
            random.disturb(state, .06 / degree);
            Nodes direction(state.size());
            random.disturb(direction, 1.);

            TestCell   cell(*material, degree, reference, mean_dilatation);
            const auto coarse = errors(cell, state, direction, 2e-3);
            const auto fine   = errors(cell, state, direction, 1e-3);
            deallog << law << ", " << reference.size() << " nodes"
                    << (mean_dilatation ? ", mean dilatation" : "")
                    << ", state " << seed << ": order of the residual "
                    << order(coarse.first, fine.first) << ", of the tangent "
                    << order(coarse.second, fine.second) << ", small "
                    << (fine.first < 1e-2 && fine.second < 1e-2)
                    << ", symmetric " << (asymmetry(cell, state) < 1e-12)
                    << std::endl;
          }
}



/** Somebody else's section. */
class Owner : public ParameterAcceptor
{
public:
  Owner()
    : ParameterAcceptor("/Matrix")
  {
    material.add_parameters(*this);
  }

  MaterialParameters material;
};



template <typename Function>
void
report(const Function &function)
{
  try
    {
      function();
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



void
make(const std::string &law, const double modulus, const double ratio)
{
  MaterialParameters parameters;
  parameters.law            = Heddle::choice<Heddle::Solid::MaterialLaw>(law);
  parameters.youngs_modulus = modulus;
  parameters.poisson_ratio  = ratio;
  report([&]() {
    const auto material = parameters.material();
    deallog << "accepted: " << Heddle::Solid::word(material->law())
            << std::endl;
  });
}



/**
 * What a user can get wrong about the material is said in one sentence; the
 * parameters arrive in the section of their owner; a cell that is turned inside
 * out has an infinite energy with the laws of finite strain.
 */
void
input_errors()
{
  make("linear", 1., .5);
  make("linear", 1., -1.);
  make("linear", 0., .3);
  make("neo-hookean", -2., .3);
  make("st venant-kirchhoff", 1., .499);
  make("linear", 1e-3, -.9);

  Owner             owner;
  ParameterHandler &handler = ParameterAcceptor::prm;
  ParameterAcceptor::declare_all_parameters(handler);
  handler.parse_input_from_string("subsection Matrix\n"
                                  "set Law = neo-hookean\n"
                                  "set Youngs modulus = 7.5\n"
                                  "set Poisson ratio = 0.45\n"
                                  "end\n");
  ParameterAcceptor::parse_all_parameters(handler);
  deallog << word(owner.material.law) << ", E " << owner.material.youngs_modulus
          << ", nu " << owner.material.poisson_ratio << std::endl;
  for (const std::string remedy : {"automatic", "mean dilatation", "none"})
    for (const unsigned int degree : {1, 2})
      {
        owner.material.locking_remedy =
          Heddle::choice<Heddle::Solid::LockingRemedy>(remedy);
        report([&]() {
          const bool found = owner.material.has_mean_dilatation(degree);
          deallog << remedy << ", degree " << degree << ": mean dilatation "
                  << found << std::endl;
        });
      }

  for (const std::string &law : all_laws)
    {
      const auto material = Heddle::Solid::make_material(
        Heddle::choice<Heddle::Solid::MaterialLaw>(law), 1., .3);
      TestCell cell(*material, 1, cube(1), /*mean_dilatation=*/true);
      Nodes    inside_out = cube(1);
      for (auto &node : inside_out)
        node[0] = -node[0];
      deallog << law << ", inside out: infinite energy "
              << std::isinf(cell.assemble(inside_out, nullptr, nullptr))
              << std::endl;
    }
}



int
main()
{
  initlog();
  run_part("Derivatives", derivatives);
  run_part("Input errors", input_errors);
}
