#include <heddle/solver/cholesky_lanes.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <iterator>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    namespace
    {
      /** Eliminating a row couples all that it is coupled to. */
      BlockStructure
      eliminated_structure(const BlockStructure &matrix)
      {
        std::vector<std::vector<unsigned int>> columns(matrix.n_rows());
        for (unsigned int row = 0; row < matrix.n_rows(); ++row)
          columns[row].assign(matrix.columns.begin() + matrix.row_begin[row],
                              matrix.columns.begin() +
                                matrix.row_begin[row + 1]);
        for (const std::vector<unsigned int> &row : columns)
          for (auto a = row.begin() + 1; a < row.end(); ++a)
            {
              std::vector<unsigned int> more, &of_a = columns[*a];
              std::set_union(of_a.begin(),
                             of_a.end(),
                             a,
                             row.end(),
                             std::back_inserter(more));
              of_a = more;
            }
        return columns;
      }
    } // namespace



    FactorStructure::FactorStructure(const BlockStructure &matrix)
      : factors(eliminated_structure(matrix))
    {
      for (unsigned int row = 0; row < matrix.n_rows(); ++row)
        for (unsigned int k = matrix.row_begin[row];
             k < matrix.row_begin[row + 1];
             ++k)
          of_matrix.push_back(factors.position(row, matrix.columns[k]));
      for (unsigned int row = 0; row < factors.n_rows(); ++row)
        for (unsigned int a = factors.row_begin[row] + 1;
             a < factors.row_begin[row + 1];
             ++a)
          for (unsigned int b = a; b < factors.row_begin[row + 1]; ++b)
            changed.push_back(
              factors.position(factors.columns[a], factors.columns[b]));
    }



    CholeskyLanes::CholeskyLanes(
      const std::shared_ptr<const FactorStructure> &structure)
      : shared_structure(structure)
      , blocks(structure->factors.n_blocks())
      , solution(structure->factors.n_rows())
    {
    }



    void
    CholeskyLanes::take(const MatrixLanes &matrices)
    {
      std::fill(blocks.begin(), blocks.end(), Block());
      const std::vector<Block> &taken = matrices.all_blocks();
      for (unsigned int k = 0; k < taken.size(); ++k)
        blocks[shared_structure->of_matrix[k]] = taken[k];
    }



    void
    CholeskyLanes::add(const unsigned int lane,
                       const unsigned int row,
                       const unsigned int d,
                       const double       value)
    {
      blocks[shared_structure->factors.row_begin[row]].values[4 * d][lane] +=
        value;
    }



    void
    CholeskyLanes::invert(Block &block)
    {
      // L diag(d) L^T, and the inverse M of L.
      Numbers *const a   = block.values;
      const Numbers  l10 = a[1] / a[0], l20 = a[2] / a[0];
      const Numbers  d1 = a[4] - l10 * a[1], e = a[5] - l10 * a[2];
      const Numbers  l21 = e / d1, d2 = a[8] - l20 * a[2] - l21 * e;
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        positive[lane] =
          positive[lane] && a[0][lane] > 0. && d1[lane] > 0. && d2[lane] > 0.;

      const Numbers m20 = l10 * l21 - l20;
      const Numbers i0 = 1. / a[0], i1 = 1. / d1, i2 = 1. / d2;
      a[0] = i0 + l10 * l10 * i1 + m20 * m20 * i2;
      a[1] = a[3] = -l10 * i1 - m20 * l21 * i2;
      a[2] = a[6] = m20 * i2;
      a[4]        = i1 + l21 * l21 * i2;
      a[5] = a[7] = -l21 * i2;
      a[8]        = i2;
    }



    void
    CholeskyLanes::factorize()
    {
      positive.fill(true);
      const unsigned int   *changed = shared_structure->changed.data();
      const BlockStructure &factors = shared_structure->factors;
      for (unsigned int row = 0; row < factors.n_rows(); ++row)
        {
          const unsigned int begin = factors.row_begin[row],
                             n     = factors.row_begin[row + 1] - begin - 1;
          invert(blocks[begin]);
          const Numbers *const inverse = blocks[begin].values;
          Block *const         in_row  = blocks.data() + begin + 1;
          eliminated.assign(in_row, in_row + n);
          for (unsigned int b = 0; b < n; ++b)
            for (unsigned int j = 0; j < 3; ++j)
              for (unsigned int i = 0; i < 3; ++i)
                in_row[b].values[3 * j + i] =
                  inverse[i] * eliminated[b].values[3 * j] +
                  inverse[3 + i] * eliminated[b].values[3 * j + 1] +
                  inverse[6 + i] * eliminated[b].values[3 * j + 2];
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = a; b < n; ++b, ++changed)
              {
                const Numbers *const left  = eliminated[a].values;
                const Numbers *const right = in_row[b].values;
                Numbers *const       block = blocks[*changed].values;
                for (unsigned int j = 0; j < 3; ++j)
                  for (unsigned int i = 0; i < 3; ++i)
                    block[3 * j + i] -= left[3 * i] * right[3 * j] +
                                        left[3 * i + 1] * right[3 * j + 1] +
                                        left[3 * i + 2] * right[3 * j + 2];
              }
        }
    }



    void
    CholeskyLanes::solve(const MatrixLanes::Vectors          &residuals,
                         const std::array<double *, n_lanes> &results) const
    {
      MatrixLanes::gather(residuals, solution);
      const unsigned int        n         = solution.size();
      const BlockStructure     &factors   = shared_structure->factors;
      const unsigned int *const columns   = factors.columns.data();
      const unsigned int *const row_begin = factors.row_begin.data();
      for (unsigned int row = 0; row < n; ++row)
        {
          const Numbers *const here = solution[row].values;
          const Numbers        x = here[0], y = here[1], z = here[2];
          for (unsigned int k = row_begin[row] + 1; k < row_begin[row + 1]; ++k)
            {
              const Numbers *const block = blocks[k].values;
              Numbers *const       there = solution[columns[k]].values;
              for (unsigned int j = 0; j < 3; ++j)
                there[j] -= block[3 * j] * x + block[3 * j + 1] * y +
                            block[3 * j + 2] * z;
            }
        }
      for (unsigned int row = n; row-- > 0;)
        {
          Numbers *const       here = solution[row].values;
          const Numbers        x = here[0], y = here[1], z = here[2];
          const Numbers *const inverse = blocks[row_begin[row]].values;
          Numbers              sums[3];
          for (unsigned int i = 0; i < 3; ++i)
            sums[i] = inverse[i] * x + inverse[3 + i] * y + inverse[6 + i] * z;
          for (unsigned int k = row_begin[row] + 1; k < row_begin[row + 1]; ++k)
            {
              const Numbers *const block = blocks[k].values;
              const Numbers *const there = solution[columns[k]].values;
              for (unsigned int i = 0; i < 3; ++i)
                sums[i] -= block[i] * there[0] + block[3 + i] * there[1] +
                           block[6 + i] * there[2];
            }
          for (unsigned int i = 0; i < 3; ++i)
            here[i] = sums[i];
        }

      MatrixLanes::scatter(solution, residuals.n_rows, results);
    }
  } // namespace Solver
} // namespace Heddle
