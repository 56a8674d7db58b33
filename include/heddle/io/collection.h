#ifndef heddle_io_collection_h
#define heddle_io_collection_h

#include <mpi.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace IO
  {
    /**
     * A series of VTU files over the load steps, as one entry in ParaView:
     * DIRECTORY/NAME.pvd lists the files DIRECTORY/NAME/NAME-00012.vtu.
     *
     * The list is written anew, and renamed into place, with every file.
     */
    class Collection
    {
    public:
      /**
       * With @p resume_at, the number of the next file, an earlier run's list
       * is continued, without its files from that number on, which are
       * written over as the run gets there.
       */
      Collection(const std::string &directory,
                 const std::string &name,
                 const MPI_Comm     communicator,
                 const unsigned int resume_at = 0);

      /** Remove the list and its files, if there are any. Local. */
      static void
      remove(const std::string &directory, const std::string &name);

      /** Path of file @p number, which is yet to be written. */
      std::string
      path(const unsigned int number) const;

      /**
       * List the file @p number, which must exist now, under the @p time that
       * ParaView shows, and the @p stage, which it shows as the group.
       */
      void
      add(const unsigned int number,
          const double       time,
          const std::string &stage);

    private:
      void
      write_list() const;

      std::string
      file_name(const unsigned int number) const;

      const std::string        directory;
      const std::string        name;
      const bool               first_rank;
      std::vector<std::string> entries;
    };
  } // namespace IO
} // namespace Heddle

#endif
