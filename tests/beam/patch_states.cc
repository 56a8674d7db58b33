// Uniform extension with the contraction of the section, constant curvature and
// constant twist on elements of uneven length: the strains are the same
// everywhere, no node within is out of balance, and the energy is exactly that
// of EA, EI and GJ, whatever moduli and Poisson's ratio.
#include <heddle/base/choice.h>

#include "random_element.h"

#include <functional>

using State = std::vector<Tensor<1, 3>>;

/** Position and the two section vectors at s. */
using Motion = std::function<std::array<Tensor<1, 3>, 3>(const double s)>;

const std::array<double, 3> lengths = {{1., .4, .7}};

/** Amplitude of bending and twist: these are patch states for small turns. */
constexpr double small = 1e-7;

/** Room for the terms of second order in small turns, at nu = 0.49. */
constexpr double tolerance = 1000. * small;



/** The nodal blocks of an element from @p start to @p end. */
State
interpolate(const Heddle::Beam::Element &element,
            const Motion                &motion,
            const double                 start,
            const double                 end)
{
  State state;
  for (unsigned int a = 0; a < element.n_nodes(); ++a)
    {
      const double s   = start + a * (end - start) / (element.n_nodes() - 1.);
      const auto   now = motion(s);
      state.push_back(now[0]);
      if (element.n_blocks_per_node() == 3)
        {
          state.push_back(now[1]);
          state.push_back(now[2]);
        }
      else
        state.push_back((motion(s + .5)[0] - motion(s - .5)[0]));
    }
  return state;
}



struct Result
{
  double energy    = 0.;
  double imbalance = 0.;
  double spread    = 0.;
};



/** Largest number, within the fiber, that is out of balance. */
double
imbalance(const std::vector<double> &residual, const unsigned int n_end)
{
  double largest = 0.;
  for (unsigned int i = n_end; i + n_end < residual.size(); ++i)
    largest = std::max(largest, std::abs(residual[i]));
  return largest;
}



Result
evaluate(const Heddle::Beam::Element &element,
         const Heddle::Beam::Section &section,
         const Motion                &motion)
{
  const unsigned int n       = 3 * element.n_blocks();
  const unsigned int per_end = 3 * element.n_blocks_per_node();

  const std::vector<double> reference(element.n_strains(), 0.);
  std::vector<double>       strains(reference), first;
  std::vector<double>       residual(n), all(per_end, 0.);
  Result                    result;
  double                    start = 0.;
  for (const double length : lengths)
    {
      const State state = interpolate(element, motion, start, start + length);
      element.strains(state.data(), length, strains.data());
      if (first.empty())
        first = strains;
      for (unsigned int i = 0; i < strains.size(); ++i)
        result.spread =
          std::max(result.spread, std::abs(strains[i] - first[i]));

      result.energy += element.assemble(section,
                                        state.data(),
                                        length,
                                        reference.data(),
                                        /*predicted_stresses=*/nullptr,
                                        residual.data(),
                                        /*tangent=*/nullptr);
      const unsigned int offset = all.size() - per_end;
      all.resize(offset + n, 0.);
      for (unsigned int i = 0; i < n; ++i)
        all[offset + i] += residual[i];
      start += length;
    }
  result.imbalance = imbalance(all, per_end);
  return result;
}



/** Print energy over its exact value, and the errors in units of @p size. */
void
print(const std::string &name,
      const Result      &result,
      const double       stiffness,
      const double       size)
{
  const double length = lengths[0] + lengths[1] + lengths[2];
  deallog << "  " << name << ": energy / exact "
          << rounded(result.energy / (.5 * stiffness * size * size * length), 5)
          << ", constant " << (result.spread < tolerance * size)
          << ", balanced " << (result.imbalance < tolerance * stiffness * size)
          << std::endl;
}



void
test(const Kind &kind, const double shear_modulus, const double poisson_ratio)
{
  const auto element = Heddle::Beam::make_element(
    Heddle::choice<Heddle::Beam::ElementKind>(kind.name), kind.degree);
  const auto section = Heddle::Beam::circular_section(/*radius=*/1.,
                                                      /*axial_modulus=*/1.,
                                                      shear_modulus,
                                                      poisson_ratio);
  deallog << kind.name << ' ' << kind.degree << ", G/E " << shear_modulus
          << ", nu " << poisson_ratio << std::endl;

  const double strain          = .1;
  const double stretch         = std::sqrt(1. + 2. * strain);
  const double section_stretch = std::sqrt(1. - 2. * poisson_ratio * strain);
  print("extension",
        evaluate(*element,
                 section,
                 [&](const double s) {
                   return std::array<Tensor<1, 3>, 3>{
                     {Tensor<1, 3>({stretch * s, 0., 0.}),
                      Tensor<1, 3>({0., section_stretch, 0.}),
                      Tensor<1, 3>({0., 0., section_stretch})}};
                 }),
        section.axial,
        strain);

  print("bending",
        evaluate(*element,
                 section,
                 [](const double s) {
                   return std::array<Tensor<1, 3>, 3>{
                     {Tensor<1, 3>({s, .5 * small * s * s, 0.}),
                      Tensor<1, 3>({-small * s, 1., 0.}),
                      Tensor<1, 3>({0., 0., 1.})}};
                 }),
        section.bending,
        small);

  if (kind.name == "director")
    print("twist",
          evaluate(*element,
                   section,
                   [](const double s) {
                     return std::array<Tensor<1, 3>, 3>{
                       {Tensor<1, 3>({s, 0., 0.}),
                        Tensor<1, 3>({0., 1., small * s}),
                        Tensor<1, 3>({0., -small * s, 1.})}};
                   }),
          section.torsion,
          small);
}



int
main()
{
  initlog();
  for (const Kind &kind : all_elements)
    {
      test(kind, /*shear_modulus=*/1. / 2.6, /*poisson_ratio=*/.3);
      test(kind, /*shear_modulus=*/1. / 2.98, /*poisson_ratio=*/.49);
      test(kind, /*shear_modulus=*/.02, /*poisson_ratio=*/.35);
      test(kind, /*shear_modulus=*/.06, /*poisson_ratio=*/0.);
    }
}
