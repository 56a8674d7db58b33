#include <heddle/post/fiber_orientation.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Post
  {
    namespace
    {
      constexpr double degrees = 180. / numbers::PI;
    }



    FiberOrientation::FiberOrientation()
      : steep(n_out_of_plane, 0.)
      , turned(n_in_plane, 0.)
    {
    }



    void
    FiberOrientation::add(const Tensor<1, 3> &piece, const double weight)
    {
      const double length = piece.norm();
      if (length == 0.)
        return;
      sum += weight;
      moment +=
        weight / (length * length) * symmetrize(outer_product(piece, piece));

      const double flat = std::hypot(piece[0], piece[1]);
      const double up   = degrees * std::atan2(std::abs(piece[2]), flat);
      steep[std::min<unsigned int>(up / step, n_out_of_plane - 1)] += weight;
      if (flat == 0.)
        return;
      double angle = degrees * std::atan2(piece[1], piece[0]) - lowest;
      angle -= 180. * std::floor(angle / 180.);
      turned[std::min<unsigned int>(angle / step, n_in_plane - 1)] += weight;
    }



    void
    FiberOrientation::add(const FiberOrientation &other, const double factor)
    {
      sum += factor * other.sum;
      moment += factor * other.moment;
      for (unsigned int i = 0; i < n_out_of_plane; ++i)
        steep[i] += factor * other.steep[i];
      for (unsigned int i = 0; i < n_in_plane; ++i)
        turned[i] += factor * other.turned[i];
    }



    SymmetricTensor<2, 3>
    FiberOrientation::tensor() const
    {
      return moment / sum;
    }



    std::vector<double>
    FiberOrientation::out_of_plane() const
    {
      return over_sum(steep);
    }



    std::vector<double>
    FiberOrientation::in_plane() const
    {
      return over_sum(turned);
    }



    std::vector<double>
    FiberOrientation::over_sum(const std::vector<double> &weights) const
    {
      std::vector<double> parts = weights;
      for (double &part : parts)
        part /= sum;
      return parts;
    }
  } // namespace Post
} // namespace Heddle
