// Particles of four pairs of fibers that are found at once are those that are
// found one by one: who is searched beside does not matter, though one guess
// may be much better than another.
#include <heddle/contact/intermediate_geometry.h>

#include "../tests.h"
#include "knots.h"

using Heddle::Contact::FacingParticles;
using Heddle::Contact::IntermediateGeometry;

constexpr unsigned int n_at_once = 4, n_intervals = 12;

Knots
fiber(const double angle, const double height, RandomNumbers &random)
{
  const Tensor<1, 3> along({std::cos(angle), std::sin(angle), 0.});
  return Knots(wavy_line(-20. * along + Tensor<1, 3>({0., 0., height}),
                         along,
                         /*length=*/40.,
                         /*height=*/1.,
                         random),
               n_intervals);
}



int
main()
{
  initlog();
  RandomNumbers random(1);
  double        largest = 0.;
  unsigned int  n_ends  = 0;
  for (unsigned int n = 0; n < 2000; ++n)
    {
      std::vector<Knots> knots;
      for (unsigned int i = 0; i < n_at_once; ++i)
        {
          knots.push_back(fiber(0., 0., random));
          knots.push_back(fiber(
            random.between(0., numbers::PI), random.between(1.5, 3.), random));
        }
      std::vector<IntermediateGeometry> geometries;
      const IntermediateGeometry       *between[n_at_once];
      double                            p[n_at_once], q[n_at_once];
      std::array<double, n_at_once>     alone_q;
      std::vector<FacingParticles>      alone;
      FacingParticles                   at_once[n_at_once];
      for (unsigned int i = 0; i < n_at_once; ++i)
        {
          const int orientation =
            knots[2 * i + 1].tangents.front()[0] > 0. ? 1 : -1;
          geometries.emplace_back(
            knots[2 * i].curve(1.), knots[2 * i + 1].curve(1.), orientation);
          const auto range = geometries.back().range();
          p[i]             = random.between(range.first, range.second);
          q[i] = alone_q[i] = random.between(-40., 40.);
        }
      for (unsigned int i = 0; i < n_at_once; ++i)
        {
          between[i] = &geometries[i];
          alone.push_back(geometries[i].facing(p[i], alone_q[i]));
        }
      Heddle::Contact::find_facing<n_at_once>(between, p, q, at_once);
      for (unsigned int i = 0; i < n_at_once; ++i)
        {
          n_ends += alone[i].end != Heddle::Contact::FacingEnd::none ? 1 : 0;
          AssertThrow(at_once[i].end == alone[i].end, ExcInternalError());
          largest =
            std::max({largest,
                      std::abs(q[i] - alone_q[i]),
                      std::abs(at_once[i].s_a - alone[i].s_a),
                      std::abs(at_once[i].s_b - alone[i].s_b),
                      std::abs(at_once[i].slope - alone[i].slope),
                      (at_once[i].connection - alone[i].connection).norm()});
        }
    }
  deallog << "more than 100 face an end: " << (n_ends > 100 ? "yes" : "NO")
          << ", largest difference "
          << (largest < 1e-10 ? "< 1e-10" : std::to_string(largest))
          << std::endl;
}
