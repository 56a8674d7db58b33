#ifndef heddle_post_fiber_orientation_h
#define heddle_post_fiber_orientation_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Heddle
{
  namespace Post
  {
    using namespace dealii;

    /**
     * How much of the fibers runs in which direction. A direction and its
     * opposite are the same.
     */
    class FiberOrientation
    {
    public:
      /** Width of the classes of both angles [degrees]. */
      static constexpr double step = 1.;

      /** Classes of the angle out of the plane of the fabric, 0 to 90 degrees,
       * and of the angle in it, from @p lowest to @p lowest + 180 degrees from
       * the x-axis towards y: warp and weft are then each in one piece, and
       * straight ones in the middle of a class. */
      static constexpr unsigned int n_out_of_plane = 90, n_in_plane = 180;
      static constexpr double       lowest = -45.5;

      FiberOrientation();

      /** Add a piece of fiber along @p piece, of the weight @p weight. */
      void
      add(const Tensor<1, 3> &piece, const double weight);

      /** Add another one, whose weights count @p factor times. */
      void
      add(const FiberOrientation &other, const double factor);

      /** Sum of all weights. */
      double
      weight() const
      {
        return sum;
      }

      /**
       * The orientation tensor of second order, of trace 1:
       * $a_{ij} = \sum w\, p_i p_j / \sum w$ with unit vectors $p$ (S. G.
       * Advani and C. L. Tucker, The use of tensors to describe and predict
       * fiber orientation in short fiber composites, J. Rheol. 31, 1987).
       * @pre Something was added.
       */
      SymmetricTensor<2, 3>
      tensor() const;

      /** Part of the weight in each class of the angle out of the plane [-]. */
      std::vector<double>
      out_of_plane() const;

      /** The same for the angle in the plane; pieces along z are in none. */
      std::vector<double>
      in_plane() const;

    private:
      std::vector<double>
      over_sum(const std::vector<double> &weights) const;

      SymmetricTensor<2, 3> moment;
      std::vector<double>   steep, turned; /**< weights by class */
      double                sum = 0.;
    };
  } // namespace Post
} // namespace Heddle

#endif
