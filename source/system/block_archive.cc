#include <heddle/system/block_archive.h>

#include <deal.II/base/exceptions.h>

#include <map>
#include <utility>

namespace Heddle
{
  namespace System
  {
    namespace
    {
      std::string
      matrix_entry(const std::string &name)
      {
        return name + " of the matrix";
      }



      /** All owned blocks, of which those of the fibers are set. */
      std::vector<Tensor<1, 3>>
      read_fibers(const ArchiveReader &archive,
                  const std::string   &name,
                  const State         &state)
      {
        std::vector<Tensor<1, 3>> owned(state.n_owned_blocks());
        const unsigned int        n_fiber_blocks = state.n_owned_fiber_blocks();
        const std::vector<double> values         = archive.read(
          name, state.space.owned_blocks().first, n_fiber_blocks, 3);
        for (unsigned int b = 0; b < n_fiber_blocks; ++b)
          for (unsigned int d = 0; d < 3; ++d)
            owned[b][d] = values[3 * b + d];
        return owned;
      }
    } // namespace



    void
    write_blocks(ArchiveWriter                   &archive,
                 const std::string               &name,
                 const State                     &state,
                 const std::vector<Tensor<1, 3>> &owned)
    {
      const unsigned int  n_fiber_blocks = state.n_owned_fiber_blocks();
      std::vector<double> values;
      values.reserve(3 * n_fiber_blocks);
      for (unsigned int b = 0; b < n_fiber_blocks; ++b)
        values.insert(values.end(), owned[b].begin_raw(), owned[b].end_raw());
      archive.write(name,
                    state.space.owned_blocks().first,
                    state.space.n_blocks(),
                    values,
                    3);

      const MatrixSpace *matrix = state.matrix();
      if (!matrix)
        return;
      Records rows;
      rows.n_values    = 3;
      const auto nodes = matrix->owned_nodes();
      rows.reserve(nodes.second - nodes.first);
      for (unsigned int node = nodes.first; node < nodes.second; ++node)
        {
          const Tensor<1, 3> &block = owned[state.matrix_block(node)];
          rows.keys.push_back(matrix->identity(node));
          rows.values.insert(
            rows.values.end(), block.begin_raw(), block.end_raw());
        }
      archive.write(matrix_entry(name), std::move(rows));
    }



    std::vector<Tensor<1, 3>>
    read_blocks(const ArchiveReader &archive,
                const std::string   &name,
                const State         &state)
    {
      std::vector<Tensor<1, 3>> owned  = read_fibers(archive, name, state);
      const MatrixSpace        *matrix = state.matrix();
      if (!matrix)
        return owned;
      std::map<std::int64_t, unsigned int> block_of;
      const auto                           nodes = matrix->owned_nodes();
      for (unsigned int node = nodes.first; node < nodes.second; ++node)
        block_of[matrix->identity(node)] = state.matrix_block(node);
      const Records rows = archive.read_records(
        matrix_entry(name), [&block_of](const std::int64_t *key) {
          return block_of.count(*key) > 0;
        });
      AssertThrow(rows.size() == block_of.size(),
                  ExcMessage("The checkpoint is of another matrix."));
      for (std::size_t i = 0; i < rows.size(); ++i)
        for (unsigned int d = 0; d < 3; ++d)
          owned[block_of[*rows.key(i)]][d] = rows.value(i)[d];
      return owned;
    }



    std::vector<Tensor<1, 3>>
    read_positions(const ArchiveReader &archive,
                   const std::string   &name,
                   const State         &state)
    {
      if (!state.matrix() || archive.has(matrix_entry(name)))
        return read_blocks(archive, name, state);
      std::vector<Tensor<1, 3>> owned = read_fibers(archive, name, state);
      for (unsigned int b = state.n_owned_fiber_blocks(); b < owned.size(); ++b)
        owned[b] = state.matrix_reference(b);
      return owned;
    }
  } // namespace System
} // namespace Heddle
