#include <heddle/solver/matrix_lanes.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    BlockStructure::BlockStructure(
      const std::vector<std::vector<unsigned int>> &columns_of_row)
    {
      row_begin.push_back(0);
      for (const std::vector<unsigned int> &row : columns_of_row)
        {
          columns.insert(columns.end(), row.begin(), row.end());
          row_begin.push_back(columns.size());
        }
    }



    unsigned int
    BlockStructure::position(const unsigned int row,
                             const unsigned int column) const
    {
      const auto end = columns.begin() + row_begin[row + 1];
      const auto found =
        std::lower_bound(columns.begin() + row_begin[row], end, column);
      Assert(found != end && *found == column, ExcInternalError());
      return found - columns.begin();
    }



    MatrixLanes::MatrixLanes(
      const std::shared_ptr<const BlockStructure> &structure)
      : shared_structure(structure)
      , blocks(structure->n_blocks())
      , input(structure->n_rows())
      , output(structure->n_rows())
    {
    }



    void
    MatrixLanes::clear()
    {
      std::fill(blocks.begin(), blocks.end(), Block());
    }



    void
    MatrixLanes::set_block(const unsigned int lane,
                           const unsigned int position,
                           const double      *block)
    {
      for (unsigned int k = 0; k < 9; ++k)
        blocks[position].values[k][lane] = block[k];
    }



    void
    MatrixLanes::multiply(const Vectors                       &vectors,
                          const std::array<double *, n_lanes> &products) const
    {
      gather(vectors, input);
      std::fill(output.begin(), output.end(), Triple());

      // A block above the diagonal stands for the one below it, too. What
      // blocks add to their row is summed beside it: nothing waits for the rows
      // before.
      const BlockStructure &structure = *shared_structure;
      for (unsigned int row = 0; row < structure.n_rows(); ++row)
        {
          const Numbers *const here = input[row].values;
          const Numbers        x = here[0], y = here[1], z = here[2];
          const Numbers *const diagonal =
            blocks[structure.row_begin[row]].values;
          Numbers sums[3];
          for (unsigned int i = 0; i < 3; ++i)
            sums[i] =
              diagonal[i] * x + diagonal[3 + i] * y + diagonal[6 + i] * z;
          for (unsigned int k = structure.row_begin[row] + 1;
               k < structure.row_begin[row + 1];
               ++k)
            {
              const Numbers *const block = blocks[k].values;
              const Numbers *const there = input[structure.columns[k]].values;
              Numbers *const       below = output[structure.columns[k]].values;
              for (unsigned int i = 0; i < 3; ++i)
                sums[i] += block[i] * there[0] + block[3 + i] * there[1] +
                           block[6 + i] * there[2];
              for (unsigned int j = 0; j < 3; ++j)
                below[j] += block[3 * j] * x + block[3 * j + 1] * y +
                            block[3 * j + 2] * z;
            }
          for (unsigned int i = 0; i < 3; ++i)
            output[row].values[i] += sums[i];
        }
      scatter(output, vectors.n_rows, products);
    }



    void
    MatrixLanes::gather(const Vectors &vectors, std::vector<Triple> &rows)
    {
      std::fill(rows.begin(), rows.end(), Triple());
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        for (unsigned int row = 0; row < vectors.n_rows[lane]; ++row)
          for (unsigned int d = 0; d < 3; ++d)
            rows[row].values[d][lane] = vectors.begin[lane][3 * row + d];
    }



    void
    MatrixLanes::scatter(const std::vector<Triple>               &rows,
                         const std::array<unsigned int, n_lanes> &n_rows,
                         const std::array<double *, n_lanes>     &results)
    {
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        if (results[lane])
          for (unsigned int row = 0; row < n_rows[lane]; ++row)
            for (unsigned int d = 0; d < 3; ++d)
              results[lane][3 * row + d] = rows[row].values[d][lane];
    }
  } // namespace Solver
} // namespace Heddle
