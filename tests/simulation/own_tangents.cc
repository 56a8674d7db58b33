// The tangent of a contribution that somebody adds to heddle's own is compared
// with differences of its residual: a right one agrees to round-off, one that
// is a tenth too stiff is a tenth off, and of one that is not symmetric the
// matrix keeps one half, while as sums of products it is right. Where forces
// are cubic the difference falls with the square of the motion.
#include <heddle/simulation/own_tangents.h>
#include <heddle/solver/tangent_error.h>

#include "../tests.h"

#include <cmath>
#include <fstream>
#include <sstream>

using namespace Heddle;

enum class Kind
{
  right,
  too_stiff,
  cubic,
  turning,
  turning_as_products
};



/** Forces on positions x: x, |x|^2 x, or e_z times x. */
class Field : public System::Contribution
{
public:
  Field(const Kind kind)
    : kind(kind)
  {
  }

  std::string
  name() const override
  {
    return "field";
  }

  void
  assemble(const System::State &state, System::BlockSystem &system) override
  {
    const SymmetricTensor<2, 3> one = unit_symmetric_tensor<3>();
    const Tensor<2, 3> turn({{0., -1., 0.}, {1., 0., 0.}, {0., 0., 0.}});
    for (unsigned int block = 0; block < state.n_owned_fiber_blocks();
         block += state.space.n_blocks_per_node())
      {
        const Tensor<1, 3> x        = state.current()[block];
        Tensor<1, 3>       residual = x;
        Tensor<2, 3>       tangent  = one;
        switch (kind)
          {
            case Kind::right:
              break;
            case Kind::too_stiff:
              tangent *= 1.1;
              break;
            case Kind::cubic:
              residual = (x * x) * x;
              tangent  = (x * x) * one + 2. * outer_product(x, x);
              break;
            case Kind::turning:
              residual = turn * x;
              tangent  = turn;
              break;
            case Kind::turning_as_products:
              residual = turn * x;
              tangent  = 0.;
              if (system.wants_tangent())
                add_products(block, turn, system.unsymmetric_terms());
          }
        system.add(1, &block, residual.begin_raw(), tangent[0].begin_raw());
      }
  }

private:
  static void
  add_products(const unsigned int        block,
               const Tensor<2, 3>       &tangent,
               System::UnsymmetricTerms &terms)
  {
    for (unsigned int d = 0; d < 3; ++d)
      {
        Tensor<1, 3> motion;
        motion[d] = 1.;
        terms.begin_term(motion);
        terms.add_motion(block, 1.);
        terms.begin_force(tangent * motion);
        terms.add_force(block, 1.);
      }
  }

  const Kind kind;
};



/** A fiber that is held at one end, and such a field. */
struct OneFiber
{
  OneFiber(const Kind kind)
    : file(fresh("one_fiber.prm"))
    , parameters(file)
    , scene(parameters,
            "one_fiber.prm",
            MPI_COMM_WORLD,
            [kind](const auto &, const auto &) {
              return Solver::Contributions{std::make_shared<Field>(kind)};
            })
  {
  }

  double
  tangent_error(const double motion) const
  {
    System::State state(scene.space());
    state.set(scene.initial());
    return Solver::tangent_error(
      scene.own_contributions().front(), state, motion);
  }

  /** Without what parameters of another scene have declared. */
  static const char *
  fresh(const char *name)
  {
    ParameterAcceptor::clear();
    return name;
  }

  ParameterFile                file;
  const Simulation::Parameters parameters;
  const Simulation::Scene      scene;
};



void
write_scene()
{
  std::ofstream("one_fiber.csv") << "fiber,x,y,z,radius\n0,0,0,0,0.1\n"
                                    "0,5,0,0,0.1\n0,10,2,0,0.1\n";
  std::ofstream("one_fiber.prm")
    << "subsection Run\n  set Scene = centerlines\nend\n"
       "subsection Centerlines\n  set File = one_fiber.csv\nend\n"
       "subsection Supports\n  subsection Support 1\n"
       "    set Section = held\n  end\nend\n";
}



/** The error, 0 if it is round-off, and how it is told. */
void
tell_of(const std::string &what, const Kind kind)
{
  const OneFiber     one(kind);
  std::ostringstream said;
  Log                log(MPI_COMM_WORLD, said);
  Simulation::print_own_tangents(log, one.scene);
  const double error = one.tangent_error(1e-4);
  deallog << what << ": " << (error < 1e-9 ? 0. : error) << ", "
          << said.str().substr(0, said.str().find('\'')) << std::endl;
}



void
linear_fields()
{
  deallog << std::setprecision(2);
  tell_of("right", Kind::right);
  tell_of("too stiff", Kind::too_stiff);
  tell_of("turning", Kind::turning);
  tell_of("turning, as products", Kind::turning_as_products);
}



void
cubic_field()
{
  const OneFiber one(Kind::cubic);
  double         last = 0.;
  for (const double motion : {40., 20., 10., 5.})
    {
      const double error = one.tangent_error(motion);
      if (last > 0.)
        deallog << "order " << std::round(10. * std::log2(last / error)) / 10.
                << std::endl;
      last = error;
    }
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  write_scene();
  run_part("Linear fields", linear_fields);
  run_part("Cubic field", cubic_field);
}
