#ifndef heddle_io_hdf5_archive_h
#define heddle_io_hdf5_archive_h

#include <heddle/base/archive.h>
#include <heddle/io/hdf5.h>

#include <mpi.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace Heddle
{
  namespace IO
  {
    /**
     * An archive in one HDF5 file that all ranks write together. It is written
     * beside and takes its name in commit() only: without that, the file is
     * removed again.
     */
    class Hdf5Writer : public ArchiveWriter
    {
    public:
      /** @note Collective. */
      Hdf5Writer(const std::string &path, const MPI_Comm communicator);
      ~Hdf5Writer() override;

      void
      write(const std::string         &name,
            const std::uint64_t        first_row,
            const std::uint64_t        n_rows,
            const std::vector<double> &values,
            const unsigned int         n_columns = 1) override;

      void
      write(const std::string &name, Records records) override;

      void
      write_number(const std::string &name, const double value) override;

      void
      write_text(const std::string &name, const std::string &text) override;

      /**
       * Close the file and give it its name, if all of it could be written.
       * @note Collective.
       */
      void
      commit();

    private:
      /**
       * Throw, on all ranks, if the disk has no room for so many bytes: on
       * several ranks HDF5 waits for ever when it cannot write. Of one rank it
       * is not asked. @note Collective.
       */
      void
      check_space(const std::uint64_t bytes) const;

      /** Throw unless @p success. Local. */
      static void
      check_written(const bool success, const std::string &what);

      /** Write this rank's rows of a new table of numbers of any type. */
      void
      write_rows(const std::string  &name,
                 const hid_t         type,
                 const std::uint64_t first_row,
                 const std::uint64_t n_my_rows,
                 const std::uint64_t n_rows,
                 const unsigned int  n_columns,
                 const void         *values);

      const std::string           path;
      const std::string           beside;
      const MPI_Comm              communicator;
      std::unique_ptr<Hdf5Handle> file;
    };



    /** An archive that Hdf5Writer has written, read on any number of ranks. */
    class Hdf5Reader : public ArchiveReader
    {
    public:
      /** @note Collective. */
      Hdf5Reader(const std::string &path, const MPI_Comm communicator);

      bool
      has(const std::string &name) const override;

      std::uint64_t
      n_rows(const std::string &name) const override;

      std::vector<double>
      read(const std::string  &name,
           const std::uint64_t first_row,
           const std::uint64_t n_rows,
           const unsigned int  n_columns = 1) const override;

      Records
      read_records(
        const std::string                               &name,
        const std::function<bool(const std::int64_t *)> &wanted) const override;

      double
      read_number(const std::string &name) const override;

      std::string
      read_text(const std::string &name) const override;

    private:
      /** Numbers of rows and columns of a table. */
      std::array<hsize_t, 2>
      shape(const std::string &name) const;

      void
      read_rows(const std::string  &name,
                const hid_t         type,
                const std::uint64_t first_row,
                const std::uint64_t n_rows,
                const unsigned int  n_columns,
                void               *values) const;

      const std::string           path;
      const MPI_Comm              communicator;
      std::unique_ptr<Hdf5Handle> file;
    };
  } // namespace IO
} // namespace Heddle

#endif
