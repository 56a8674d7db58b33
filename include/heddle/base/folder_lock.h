#ifndef heddle_base_folder_lock_h
#define heddle_base_folder_lock_h

#include <mpi.h>

#include <string>

namespace Heddle
{
  /**
   * Keeps a folder to one run as long as it lives: two that write to the same
   * one would mix their results. Nothing is left in the folder, also if the
   * process is killed. On file systems that have no locks it has no effect.
   */
  class FolderLock
  {
  public:
    /**
     * Throw InputError if another process has locked the folder @p name.
     *
     * @note Collective.
     */
    FolderLock(const std::string &name, const MPI_Comm communicator);

    ~FolderLock();

    FolderLock(const FolderLock &) = delete;
    FolderLock &
    operator=(const FolderLock &) = delete;

  private:
    int descriptor = -1;
  };
} // namespace Heddle

#endif
