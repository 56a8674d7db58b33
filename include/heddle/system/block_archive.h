#ifndef heddle_system_block_archive_h
#define heddle_system_block_archive_h

#include <heddle/base/archive.h>
#include <heddle/system/state.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace System
  {
    /**
     * Write what belongs to the owned blocks: a table @p name for those of the
     * fibers, and records by the identity of the node for those of the matrix.
     * @note Collective, like the functions below.
     */
    void
    write_blocks(ArchiveWriter                   &archive,
                 const std::string               &name,
                 const State                     &state,
                 const std::vector<Tensor<1, 3>> &owned);

    /** Return the owned blocks that were written by any number of ranks. */
    std::vector<Tensor<1, 3>>
    read_blocks(const ArchiveReader &archive,
                const std::string   &name,
                const State         &state);

    /**
     * The same for positions. A matrix that was not there yet when they were
     * written is at rest.
     */
    std::vector<Tensor<1, 3>>
    read_positions(const ArchiveReader &archive,
                   const std::string   &name,
                   const State         &state);
  } // namespace System
} // namespace Heddle

#endif
