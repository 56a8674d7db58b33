#include <heddle/base/exceptions.h>
#include <heddle/base/folder_lock.h>

#include <deal.II/base/mpi.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace Heddle
{
  using namespace dealii;

  FolderLock::FolderLock(const std::string &name, const MPI_Comm communicator)
  {
    int is_free = 1;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        descriptor = ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0)
          is_free = errno == EWOULDBLOCK ? 0 : 1;
      }
    is_free = Utilities::MPI::broadcast(communicator, is_free);
    if (is_free == 0 && descriptor >= 0)
      ::close(descriptor);
    require(is_free != 0,
            "Another run writes to the folder \"" + name +
              "\": wait for its end, or give another folder by "
              "--output-directory.");
  }



  FolderLock::~FolderLock()
  {
    if (descriptor >= 0)
      ::close(descriptor);
  }
} // namespace Heddle
