#ifndef heddle_system_block_pattern_h
#define heddle_system_block_pattern_h

#include <utility>
#include <vector>

namespace Heddle
{
  namespace System
  {
    /** Collects which blocks of the tangent contributions will write. */
    class BlockPattern
    {
    public:
      /** With @p couplings_apart for a system that keeps them so. */
      BlockPattern(const unsigned int n_owned_blocks,
                   const bool         couplings_apart = false);

      /** All pairs of these local blocks. */
      void
      couple(const unsigned int n, const unsigned int *blocks);

      /** An owned row with these local blocks. */
      void
      add_row(const unsigned int  row,
              const unsigned int  n,
              const unsigned int *blocks);

      /** Sorted local blocks of all rows, each once and with the diagonal. */
      std::vector<std::vector<unsigned int>>
      columns() const;

      /** Whether what couples fibers needs no place. */
      const bool couplings_apart;

    private:
      void
      add_group(const unsigned int n, const unsigned int *blocks);

      const unsigned int        n_rows;
      std::vector<unsigned int> group_begin = {0}, group_blocks;

      /** A row, and a group that it holds. */
      std::vector<std::pair<unsigned int, unsigned int>> uses;
    };
  } // namespace System
} // namespace Heddle

#endif
