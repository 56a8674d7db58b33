// Each fiber is solved for exactly, whatever it is coupled to; also when
// contact couples more or less of its nodes than before. A fiber that is
// unstable on its own is made stable, and no other one changes; how does not
// depend on the unit of length. Fibers of different lengths are factorized side
// by side. Products are those of the bands, without shifts, and that there is
// nothing else is said where it is so.
#include <heddle/base/choice.h>
#include <heddle/base/petsc.h>
#include <heddle/simulation/fiber_placement.h>
#include <heddle/solver/fiber_blocks.h>

#include "../contributions/scene.h"
#include "../eigenmodes.h"

#include <numeric>
#include <random>

/** Of the shortest fibers; others have one or two more. */
constexpr unsigned int n_elements = 6;



class Tangent : public Scene
{
public:
  Tangent(const std::string &element,
          const unsigned int degree,
          const unsigned int n_fibers,
          const double       mm = 1.)
    : n_fibers(n_fibers)
    , unstable(n_fibers / 2)
    , mm(mm)
  {
    fibers.element_kind = Heddle::choice<Heddle::Beam::ElementKind>(element);
    fibers.degree       = degree;
    std::vector<Textile::FiberPath> paths;
    for (unsigned int f = 0; f < n_fibers; ++f)
      {
        const Tensor<1, 3> begin({0., mm * f, 0.});
        paths.push_back(
          straight_path(begin,
                        begin + Tensor<1, 3>({6. * mm, 0., 0.}),
                        (n_elements + f % 3) *
                            (degree == 3 && element == "director" ? 3 : 1) +
                          1,
                        0.1 * mm));
      }
    build(paths);
    system = std::make_unique<System::BlockSystem>(*state);
  }

  /**
   * Elements and neighbouring fibers and, if there is @p contact, the positions
   * of four nodes in a row or, as with tangents, the blocks of two; of one
   * fiber @p less is taken off the diagonal.
   */
  void
  assemble(const bool contact, const double less)
  {
    System::BlockPattern pattern(state->n_owned_blocks());
    for_each_group(contact, [&](const std::vector<unsigned int> &blocks) {
      pattern.couple(blocks.size(), blocks.data());
    });
    system->set_pattern(pattern);
    system->set_constraints({});
    system->begin(System::BlockSystem::Want::residual_and_tangent);
    std::uniform_real_distribution<double> random(-1., 1.);
    for_each_group(contact, [&](const std::vector<unsigned int> &blocks) {
      const unsigned int  n = 3 * blocks.size();
      std::vector<double> v(n), tangent(n * n), residual(n, 0.);
      for (unsigned int i = 0; i < n; ++i)
        v[i] = scale(blocks[i / 3]) * random(generator);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          tangent[n * i + j] = v[i] * v[j];
      system->add(
        blocks.size(), blocks.data(), residual.data(), tangent.data());
    });
    for (unsigned int f = 0; f < n_fibers; ++f)
      for (unsigned int b = 0; b < space->n_blocks(f); ++b)
        system->add_diagonal(state->local_block(f) + b,
                             Utilities::fixed_power<2>(scale(b)) *
                               (0.1 - (f == unstable ? less : 0.)));
    system->end();
  }

  /**
   * Stiffnesses are of the unit of stress times the product of this of their
   * blocks: length of positions, cubed of others.
   */
  double
  scale(const unsigned int block) const
  {
    return std::sqrt(mm) * (block % space->n_blocks_per_node() == 0 ? 1. : mm);
  }

  /** Rows and columns of one fiber. */
  LAPACKFullMatrix<double>
  part(const unsigned int f) const
  {
    const unsigned int n     = 3 * space->n_blocks(f),
                       begin = 3 * state->local_block(f);
    LAPACKFullMatrix<double> matrix(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        Vec unit = system->solution(), column = system->right_hand_side();
        petsc(VecSet(unit, 0.));
        petsc(VecSetValue(unit, begin + j, 1., INSERT_VALUES));
        petsc(VecAssemblyBegin(unit));
        petsc(VecAssemblyEnd(unit));
        petsc(MatMult(system->tangent(), unit, column));
        const double *entries;
        petsc(VecGetArrayRead(column, &entries));
        std::copy_n(entries + begin, n, &matrix(0, j));
        petsc(VecRestoreArrayRead(column, &entries));
      }
    return matrix;
  }

  const unsigned int                   n_fibers, unstable;
  const double                         mm; /**< in units of length */
  std::unique_ptr<System::BlockSystem> system;
  std::mt19937                         generator{1};

private:
  template <typename Action>
  void
  for_each_group(const bool contact, const Action &action) const
  {
    const unsigned int n = space->n_blocks_per_node();
    for (unsigned int f = 0; f < n_fibers; ++f)
      {
        const unsigned int        first = state->local_block(f);
        std::vector<unsigned int> element(space->element().n_blocks());
        for (unsigned int e = 0; e < space->fiber(f).n_elements; ++e)
          {
            std::iota(element.begin(),
                      element.end(),
                      first + space->first_block_of_element(e));
            // As many terms of rank one as there are unknowns.
            for (unsigned int i = 0; i < 3 * element.size(); ++i)
              action(element);
          }
        for (unsigned int i = 0; i + 3 < space->fiber(f).n_nodes && contact;
             ++i)
          {
            const unsigned int next = n == 2 ? 1 : n, begin = first + n * i;
            action(std::vector<unsigned int>{
              begin, begin + next, begin + 2 * next, begin + 3 * next});
          }
        if (f + 1 < n_fibers)
          for (unsigned int i = 0; i < std::min(space->fiber(f).n_nodes,
                                                space->fiber(f + 1).n_nodes);
               ++i)
            action(std::vector<unsigned int>{
              first + n * i, first + space->n_blocks(f) + n * i});
      }
  }
};



Vector<double>
random_vector(const unsigned int n, std::mt19937 &generator)
{
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Vector<double>                         vector(n);
  for (double &component : vector)
    component = uniform(generator);
  return vector;
}



/** What fiber @p f answers to @p right, on it alone. */
Vector<double>
solve(const Solver::FiberBlocks &fibers,
      const System::State       &state,
      const unsigned int         f,
      const Vector<double>      &right)
{
  const unsigned int  begin = 3 * state.local_block(f);
  std::vector<double> whole(3 * state.n_owned_blocks()), found(whole.size());
  std::copy(right.begin(), right.end(), whole.begin() + begin);
  fibers.apply(whole.data(), found.data());
  Vector<double> answer(right.size());
  std::copy_n(found.begin() + begin, right.size(), answer.begin());
  return answer;
}



/** Largest error of the solution of a fiber for a random right-hand side. */
double
error(Tangent &tangent, const Solver::FiberBlocks &fibers, const unsigned int f)
{
  const auto           matrix = tangent.part(f);
  const Vector<double> exact  = random_vector(matrix.m(), tangent.generator);
  Vector<double>       right(exact.size());
  matrix.vmult(right, exact);
  Vector<double> found = solve(fibers, *tangent.state, f, right);
  found -= exact;
  return found.linfty_norm();
}



/** Largest error of the products of fibers with a random vector. */
double
product_error(Tangent &tangent, const Solver::FiberBlocks &fibers)
{
  const System::State &state = *tangent.state;
  const Vector<double> vector =
    random_vector(3 * state.n_owned_blocks(), tangent.generator);
  std::vector<double> found(vector.size());
  fibers.multiply(vector.begin(), found.data());
  double largest = 0.;
  for (unsigned int f = 0; f < tangent.n_fibers; ++f)
    {
      const auto         matrix = tangent.part(f);
      const unsigned int begin  = 3 * state.local_block(f);
      Vector<double>     input(matrix.m()), exact(matrix.m());
      std::copy_n(vector.begin() + begin, matrix.m(), input.begin());
      matrix.vmult(exact, input);
      for (unsigned int i = 0; i < matrix.m(); ++i)
        largest = std::max(largest, std::abs(found[begin + i] - exact(i)));
    }
  return largest;
}



void
check(const std::string &element,
      const unsigned int degree,
      const unsigned int n_fibers)
{
  Tangent             tangent(element, degree, n_fibers);
  const unsigned int  unstable = tangent.unstable;
  Solver::FiberBlocks fibers(*tangent.state);
  for (const auto &[contact, less] : {std::make_pair(false, 0.),
                                      {true, 0.},
                                      {true, 5.},
                                      {true, 0.},
                                      {false, 0.}})
    {
      tangent.assemble(contact, less);
      fibers.set_up(System::LocalBlocks(tangent.system->tangent()));
      double largest = 0.;
      for (unsigned int f = 0; f < n_fibers; ++f)
        if (f != unstable || less == 0.)
          largest = std::max(largest, error(tangent, fibers, f));
      deallog << n_fibers << " of " << element << " " << degree
              << (contact ? ", contact" : "")
              << ": exact to 1e-9: " << (largest < 1e-9)
              << ", product to 1e-12: "
              << (product_error(tangent, fibers) < 1e-12)
              << ", nothing but bands: " << fibers.are_all();
      if (less > 0.)
        {
          const auto [stiffnesses, modes] = eigenmodes(tangent.part(unstable));
          const unsigned int n            = stiffnesses.size();
          bool               stable       = true;
          for (unsigned int i = 0; i < 200; ++i)
            {
              if (i == 100)
                fibers.set_up(System::LocalBlocks(tangent.system->tangent()),
                              /*gentle=*/true);
              Vector<double> right = random_vector(n, tangent.generator);
              if (i % 100 < n)
                for (unsigned int j = 0; j < n; ++j)
                  right(j) = modes(j, i % 100);
              stable =
                stable &&
                right * solve(fibers, *tangent.state, unstable, right) > 0.;
            }
          deallog << ", one fiber has modes of negative stiffness: "
                  << (stiffnesses(0) < 0.) << ", is made stable: " << stable;
        }
      deallog << std::endl;
    }
}



/** The answer of an unstable fiber and its neighbours, over what it is to be
 * multiplied by in other units. */
std::vector<double>
answer(const std::string &element, const unsigned int degree, const double mm)
{
  Tangent tangent(element, degree, /*n_fibers=*/3, mm);
  tangent.assemble(/*contact=*/true, /*less=*/5.);
  Solver::FiberBlocks fibers(*tangent.state);
  fibers.set_up(System::LocalBlocks(tangent.system->tangent()));
  std::vector<double> right, found(3 * tangent.state->n_owned_blocks());
  for (unsigned int i = 0; i < found.size(); ++i)
    right.push_back(tangent.scale(i / 3));
  fibers.apply(right.data(), found.data());
  for (unsigned int i = 0; i < found.size(); ++i)
    found[i] *= tangent.scale(i / 3);
  return found;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  check("hermite", 3, 1);
  check("hermite", 3, 3);
  check("director", 1, 3);
  check("director", 1, 60);
  check("director", 3, 3);
  // Powers of four, whose roots are exact, change no digit.
  for (const auto &[element, degree] :
       {std::make_pair("hermite", 3u), {"director", 1u}, {"director", 3u}})
    deallog << element << " " << degree << ", other units, same digits: "
            << (answer(element, degree, 1.) ==
                answer(element, degree, std::pow(2., -20)))
            << (answer(element, degree, 1.) ==
                answer(element, degree, std::pow(2., 20)))
            << std::endl;
}
