// What a user can get wrong about the material is said in one sentence; the
// parameters arrive in the section of their owner; a cell that is turned inside
// out has an infinite energy with the laws of finite strain.
#include <heddle/base/exceptions.h>
#include <heddle/solid/material_parameters.h>

#include "test_cell.h"

using Heddle::Solid::MaterialParameters;

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
  parameters.law            = law;
  parameters.youngs_modulus = modulus;
  parameters.poisson_ratio  = ratio;
  report([&]() {
    const auto material = parameters.material();
    deallog << "accepted: " << material->name() << std::endl;
  });
}



int
main()
{
  initlog();
  make("linear", 1., .5);
  make("linear", 1., -1.);
  make("linear", 0., .3);
  make("neo-hookean", -2., .3);
  make("hookean", 1., .3);
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
  deallog << owner.material.law << ", E " << owner.material.youngs_modulus
          << ", nu " << owner.material.poisson_ratio << std::endl;
  for (const std::string remedy : {"automatic", "mean dilatation", "none"})
    for (const unsigned int degree : {1, 2})
      {
        owner.material.locking_remedy = remedy;
        report([&]() {
          const bool found = owner.material.has_mean_dilatation(degree);
          deallog << remedy << ", degree " << degree << ": mean dilatation "
                  << found << std::endl;
        });
      }

  for (const std::string &law : all_laws)
    {
      const auto material = Heddle::Solid::make_material(law, 1., .3);
      TestCell   cell(*material, 1, cube(1), /*mean_dilatation=*/true);
      Nodes      inside_out = cube(1);
      for (auto &node : inside_out)
        node[0] = -node[0];
      deallog << law << ", inside out: infinite energy "
              << std::isinf(cell.assemble(inside_out, nullptr, nullptr))
              << std::endl;
    }
}
