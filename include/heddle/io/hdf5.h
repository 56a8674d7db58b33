#ifndef heddle_io_hdf5_h
#define heddle_io_hdf5_h

#include <hdf5.h>
#include <mpi.h>

#include <cstdint>
#include <string>

namespace Heddle
{
  namespace IO
  {
    /** Throw if the function of HDF5 that gave @p error could not do @p what.
     */
    void
    hdf5(const herr_t error, const std::string &what);



    /** Something that HDF5 has opened, closed when it goes out of scope. */
    class Hdf5Handle
    {
    public:
      using Close = herr_t (*)(hid_t);

      /** @p id is checked; @p what names the failed action, if it failed. */
      Hdf5Handle(const hid_t id, const Close close, const std::string &what);
      Hdf5Handle(const Hdf5Handle &) = delete;
      Hdf5Handle &
      operator=(const Hdf5Handle &) = delete;
      ~Hdf5Handle();

      /**
       * Close it before it goes out of scope, and return whether that went
       * well: what HDF5 has kept back is written only now.
       */
      bool
      close_now();

      /** Leave it open for good. */
      void
      abandon()
      {
        id = H5I_INVALID_HID;
      }

      operator hid_t() const
      {
        return id;
      }

    private:
      hid_t       id;
      const Close close;
    };



    /** What is asked of HDF5 for archives. */
    namespace Hdf5
    {
      /** One rank needs no MPI to read and write files. */
      bool
      by_mpi(const MPI_Comm communicator);

      Hdf5Handle
      file_access(const MPI_Comm communicator);

      /**
       * One rank makes a file in its memory and writes it at once: HDF5 can
       * not give up a file that it cannot write, and crashes at the end.
       */
      Hdf5Handle
      access_to_write(const MPI_Comm communicator);

      Hdf5Handle
      transfer(const MPI_Comm communicator);

      /** "contact/zones" makes the group "contact" if it is not there. */
      Hdf5Handle
      with_groups();

      /** Dates would make every file differ from the last run's. */
      Hdf5Handle
      without_dates();

      /** The rows [first, first + n) of a data set; none if n is zero. */
      void
      select_rows(const hid_t         space,
                  const std::uint64_t first,
                  const std::uint64_t n,
                  const unsigned int  n_columns);

      /** What is in a file that is made in memory; empty if it is not. */
      std::string
      image(const hid_t file);

      /**
       * HDF5 tells of its errors in pages; ours are one sentence. What could
       * not be written it tries again when the program ends, and crashes.
       */
      void
      silence();
    } // namespace Hdf5
  }   // namespace IO
} // namespace Heddle

#endif
