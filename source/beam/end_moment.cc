#include <heddle/beam/end_moment.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Heddle
{
  namespace Beam
  {
    namespace
    {
      /**
       * Return A of the vectors. That of one tangent is singular along it; as
       * the result is only used in products m x t, |t|^2 I does the same.
       */
      Tensor<2, 3>
      spin_matrix(const unsigned int n_vectors, const Tensor<1, 3> *vectors)
      {
        Tensor<2, 3> matrix;
        for (unsigned int a = 0; a < n_vectors; ++a)
          {
            const double square = vectors[a] * vectors[a];
            for (unsigned int i = 0; i < 3; ++i)
              matrix[i][i] += square;
            if (n_vectors > 1)
              matrix -= outer_product(vectors[a], vectors[a]);
          }
        return matrix;
      }



      /** Return the derivative of A m in the vector @p g, with m held. */
      Tensor<2, 3>
      spin_matrix_derivative(const unsigned int  n_vectors,
                             const Tensor<1, 3> &m,
                             const Tensor<1, 3> &g)
      {
        Tensor<2, 3> derivative = 2. * outer_product(m, g);
        if (n_vectors > 1)
          {
            derivative -= outer_product(g, m);
            for (unsigned int i = 0; i < 3; ++i)
              derivative[i][i] -= g * m;
          }
        return derivative;
      }



      Tensor<1, 3>
      unit_vector(const unsigned int i)
      {
        Tensor<1, 3> e;
        e[i] = 1.;
        return e;
      }
    } // namespace



    Tensor<1, 3>
    predict_end_moment(const Tensor<1, 3> &moment,
                       const unsigned int  n_vectors,
                       const Tensor<1, 3> *vectors,
                       const Tensor<1, 3> *increment,
                       const Tensor<1, 3> *predicted)
    {
      const Tensor<2, 3> inverse = invert(spin_matrix(n_vectors, vectors));
      const Tensor<1, 3> m =
        predicted != nullptr ? *predicted : inverse * moment;
      Tensor<1, 3> rest = moment;
      for (unsigned int a = 0; a < n_vectors; ++a)
        rest -= spin_matrix_derivative(n_vectors, m, vectors[a]) * increment[a];
      return inverse * rest;
    }



    void
    end_moment(const Tensor<1, 3> &moment,
               const unsigned int  n_vectors,
               const Tensor<1, 3> *vectors,
               const Tensor<1, 3> *predicted,
               double             *forces,
               double             *tangent)
    {
      Assert(n_vectors == 1 || n_vectors == 2,
             ExcMessage("A node has one tangent or two section vectors."));

      const Tensor<2, 3> inverse = invert(spin_matrix(n_vectors, vectors));
      const Tensor<1, 3> m       = inverse * moment;
      for (unsigned int a = 0; a < n_vectors; ++a)
        {
          const Tensor<1, 3> force = cross_product_3d(m, vectors[a]);
          std::copy(force.begin_raw(), force.end_raw(), forces + 3 * a);
        }
      if (tangent == nullptr)
        return;

      // df_a = m x dg_a + dm x g_a, where dm = -A^{-1} (dA) m.
      const Tensor<1, 3> dual = predicted != nullptr ? *predicted : m;
      const unsigned int n    = 3 * n_vectors;
      for (unsigned int b = 0; b < n_vectors; ++b)
        {
          const Tensor<2, 3> dm =
            -1. * inverse * spin_matrix_derivative(n_vectors, dual, vectors[b]);
          for (unsigned int j = 0; j < 3; ++j)
            for (unsigned int a = 0; a < n_vectors; ++a)
              {
                Tensor<1, 3> df =
                  cross_product_3d(transpose(dm)[j], vectors[a]);
                if (a == b)
                  df += cross_product_3d(dual, unit_vector(j));
                for (unsigned int i = 0; i < 3; ++i)
                  tangent[(3 * a + i) * n + 3 * b + j] = df[i];
              }
        }
    }
  } // namespace Beam
} // namespace Heddle
