#ifndef heddle_contributions_constant_stiffness_h
#define heddle_contributions_constant_stiffness_h

#include <heddle/system/block_system.h>

#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * A stiffness that does not depend on the configuration, put together once:
     * the 3x3 blocks of the owned rows [first, first + n), and the local blocks
     * that they belong to.
     */
    class ConstantStiffness
    {
    public:
      /**
       * @p columns: for each row the local blocks that it is coupled to, in any
       * order, each once.
       */
      ConstantStiffness(const unsigned int                            first,
                        const std::vector<std::vector<unsigned int>> &columns);

      /** Add a block; @p row must be one of the rows. */
      void
      add(const unsigned int  row,
          const unsigned int  column,
          const Tensor<2, 3> &value);

      void
      add_pattern(System::BlockPattern &pattern) const;

      /** Add the rows to the tangent. */
      void
      add_to(System::BlockSystem &system) const;

      /**
       * Return the product of the rows with @p values, one for each local
       * block.
       */
      template <typename Values>
      std::vector<Tensor<1, 3>>
      times(const Values &values) const
      {
        std::vector<Tensor<1, 3>> product(row_begin.size() - 1);
        for (unsigned int row = 0; row < product.size(); ++row)
          for (unsigned int k = row_begin[row]; k < row_begin[row + 1]; ++k)
            product[row] += blocks[k] * values(columns[k]);
        return product;
      }

      unsigned int
      first_row() const
      {
        return first;
      }

    private:
      const unsigned int        first;
      std::vector<unsigned int> row_begin;
      std::vector<unsigned int> columns; /**< in ascending order in a row */
      std::vector<Tensor<2, 3>> blocks;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
