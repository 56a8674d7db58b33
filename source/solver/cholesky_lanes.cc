#include <heddle/solver/cholesky_lanes.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <iterator>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    FactorStructure::FactorStructure(
      std::vector<std::vector<unsigned int>> columns_of_row)
    {
      // Eliminating a row couples all that it is coupled to.
      for (const std::vector<unsigned int> &row : columns_of_row)
        for (auto a = row.begin() + 1; a < row.end(); ++a)
          {
            std::vector<unsigned int> more, &of_a = columns_of_row[*a];
            std::set_union(
              of_a.begin(), of_a.end(), a, row.end(), std::back_inserter(more));
            of_a = more;
          }

      row_begin.push_back(0);
      for (const std::vector<unsigned int> &row : columns_of_row)
        {
          columns.insert(columns.end(), row.begin(), row.end());
          row_begin.push_back(columns.size());
        }
      for (const std::vector<unsigned int> &row : columns_of_row)
        for (auto a = row.begin() + 1; a < row.end(); ++a)
          for (auto b = a; b < row.end(); ++b)
            changed.push_back(position(*a, *b));
    }



    unsigned int
    FactorStructure::position(const unsigned int row,
                              const unsigned int column) const
    {
      const auto end = columns.begin() + row_begin[row + 1];
      const auto found =
        std::lower_bound(columns.begin() + row_begin[row], end, column);
      Assert(found != end && *found == column, ExcInternalError());
      return found - columns.begin();
    }



    CholeskyLanes::CholeskyLanes(
      const std::shared_ptr<const FactorStructure> &structure)
      : shared_structure(structure)
      , blocks(structure->n_blocks())
      , solution(structure->n_rows())
    {
    }



    void
    CholeskyLanes::clear()
    {
      std::fill(blocks.begin(), blocks.end(), Block());
    }



    void
    CholeskyLanes::set_block(const unsigned int lane,
                             const unsigned int position,
                             const double      *block)
    {
      for (unsigned int k = 0; k < 9; ++k)
        blocks[position].values[k][lane] = block[k];
    }



    void
    CholeskyLanes::add(const unsigned int lane,
                       const unsigned int position,
                       const unsigned int d,
                       const double       value)
    {
      blocks[position].values[4 * d][lane] += value;
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
      const unsigned int *changed = shared_structure->changed.data();
      for (unsigned int row = 0; row < shared_structure->n_rows(); ++row)
        {
          const unsigned int begin = shared_structure->row_begin[row],
                             n =
                               shared_structure->row_begin[row + 1] - begin - 1;
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
    CholeskyLanes::solve(const std::array<const double *, n_lanes> &residuals,
                         const std::array<unsigned int, n_lanes>   &n_rows,
                         const std::array<double *, n_lanes> &results) const
    {
      const unsigned int n = shared_structure->n_rows();
      std::fill(solution.begin(), solution.end(), Triple());
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        if (results[lane])
          for (unsigned int row = 0; row < n_rows[lane]; ++row)
            for (unsigned int d = 0; d < 3; ++d)
              solution[row].values[d][lane] = residuals[lane][3 * row + d];

      const unsigned int *const columns   = shared_structure->columns.data();
      const unsigned int *const row_begin = shared_structure->row_begin.data();
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

      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        if (results[lane])
          for (unsigned int row = 0; row < n_rows[lane]; ++row)
            for (unsigned int d = 0; d < 3; ++d)
              results[lane][3 * row + d] = solution[row].values[d][lane];
    }
  } // namespace Solver
} // namespace Heddle
