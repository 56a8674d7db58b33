#include <heddle/system/block_pattern.h>

#include <algorithm>
#include <numeric>

namespace Heddle
{
  namespace System
  {
    BlockPattern::BlockPattern(const unsigned int n_owned_blocks,
                               const bool         couplings_apart)
      : couplings_apart(couplings_apart)
      , n_rows(n_owned_blocks)
    {
    }



    void
    BlockPattern::add_group(const unsigned int n, const unsigned int *blocks)
    {
      group_blocks.insert(group_blocks.end(), blocks, blocks + n);
      group_begin.push_back(group_blocks.size());
    }



    void
    BlockPattern::couple(const unsigned int n, const unsigned int *blocks)
    {
      for (unsigned int i = 0; i < n; ++i)
        if (blocks[i] < n_rows)
          uses.emplace_back(blocks[i], group_begin.size() - 1);
      add_group(n, blocks);
    }



    void
    BlockPattern::add_row(const unsigned int  row,
                          const unsigned int  n,
                          const unsigned int *blocks)
    {
      uses.emplace_back(row, group_begin.size() - 1);
      add_group(n, blocks);
    }



    std::vector<std::vector<unsigned int>>
    BlockPattern::columns() const
    {
      std::vector<unsigned int> first_use(n_rows + 1, 0), groups(uses.size());
      for (const auto &use : uses)
        ++first_use[use.first + 1];
      std::partial_sum(first_use.begin(), first_use.end(), first_use.begin());
      std::vector<unsigned int> next = first_use;
      for (const auto &use : uses)
        groups[next[use.first]++] = use.second;

      // A block is marked with the last row that has it: most stand in many
      // groups of a row, and sorting them all would take the longest.
      const auto last =
        std::max_element(group_blocks.begin(), group_blocks.end());
      std::vector<unsigned int> mark(
        std::max(n_rows, last == group_blocks.end() ? 0 : *last + 1), n_rows);
      std::vector<std::vector<unsigned int>> result(n_rows);
      std::vector<unsigned int>              row_blocks;
      for (unsigned int row = 0; row < n_rows; ++row)
        {
          row_blocks.assign(1, row);
          mark[row] = row;
          for (unsigned int u = first_use[row]; u < first_use[row + 1]; ++u)
            for (unsigned int k = group_begin[groups[u]];
                 k < group_begin[groups[u] + 1];
                 ++k)
              if (mark[group_blocks[k]] != row)
                {
                  mark[group_blocks[k]] = row;
                  row_blocks.push_back(group_blocks[k]);
                }
          std::sort(row_blocks.begin(), row_blocks.end());
          result[row] = row_blocks;
        }
      return result;
    }
  } // namespace System
} // namespace Heddle
