#include <heddle/contributions/constant_stiffness.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Heddle
{
  namespace Contributions
  {
    ConstantStiffness::ConstantStiffness(
      const unsigned int                            first,
      const std::vector<std::vector<unsigned int>> &columns_of)
      : first(first)
      , row_begin(1, 0)
    {
      for (const auto &row : columns_of)
        {
          columns.insert(columns.end(), row.begin(), row.end());
          std::sort(columns.begin() + row_begin.back(), columns.end());
          row_begin.push_back(columns.size());
        }
      blocks.resize(columns.size());
    }



    void
    ConstantStiffness::add(const unsigned int  row,
                           const unsigned int  column,
                           const Tensor<2, 3> &value)
    {
      const auto begin = columns.begin() + row_begin[row - first];
      const auto end   = columns.begin() + row_begin[row - first + 1];
      const auto found = std::lower_bound(begin, end, column);
      Assert(found != end && *found == column, ExcInternalError());
      blocks[found - columns.begin()] += value;
    }



    void
    ConstantStiffness::add_pattern(System::BlockPattern &pattern) const
    {
      for (unsigned int row = 0; row + 1 < row_begin.size(); ++row)
        pattern.add_row(first + row,
                        row_begin[row + 1] - row_begin[row],
                        columns.data() + row_begin[row]);
    }



    void
    ConstantStiffness::add_to(System::BlockSystem &system) const
    {
      for (unsigned int row = 0; row + 1 < row_begin.size(); ++row)
        system.add_row(first + row,
                       row_begin[row + 1] - row_begin[row],
                       columns.data() + row_begin[row],
                       blocks.data() + row_begin[row]);
    }
  } // namespace Contributions
} // namespace Heddle
