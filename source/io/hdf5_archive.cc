#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/throw_together.h>
#include <heddle/io/hdf5.h>
#include <heddle/io/hdf5_archive.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace Heddle
{
  namespace IO
  {
    using namespace dealii;

    namespace internal
    {
      namespace Hdf5Archive
      {
        /** Records are read in pieces: a rank never holds the whole list. */
        constexpr std::uint64_t rows_at_once = 1 << 16;



        /** What a file needs beside its data, at most [bytes]. */
        constexpr std::uint64_t spare = 1 << 20;
      } // namespace Hdf5Archive
    }   // namespace internal



    Hdf5Writer::Hdf5Writer(const std::string &path, const MPI_Comm communicator)
      : path(path)
      , beside(path + ".part")
      , communicator(communicator)
    {
      Hdf5::silence();
      const auto access = Hdf5::access_to_write(communicator);
      file              = std::make_unique<Hdf5Handle>(
        H5Fcreate(beside.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access),
        H5Fclose,
        "create the file \"" + beside + "\"");
    }



    Hdf5Writer::~Hdf5Writer()
    {
      if (file == nullptr)
        return;
      // Ranks close a file together: who failed alone would wait for ever.
      if (Hdf5::by_mpi(communicator))
        file->abandon();
      file.reset();
      std::error_code nobody_is_left_to_tell;
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        std::filesystem::remove(beside, nobody_is_left_to_tell);
    }



    void
    Hdf5Writer::write_rows(const std::string  &name,
                           const hid_t         type,
                           const std::uint64_t first_row,
                           const std::uint64_t n_my_rows,
                           const std::uint64_t n_rows,
                           const unsigned int  n_columns,
                           const void         *values)
    {
      check_space(n_rows * n_columns * sizeof(double));
      const std::string what     = "write \"" + name + "\" to " + beside;
      const hsize_t     all[2]   = {n_rows, n_columns};
      const hsize_t     mine[2]  = {n_my_rows, n_columns};
      const auto        groups   = Hdf5::with_groups();
      const auto        undated  = Hdf5::without_dates();
      const auto        transfer = Hdf5::transfer(communicator);

      const Hdf5Handle space(H5Screate_simple(2, all, nullptr), H5Sclose, what);
      const Hdf5Handle memory(
        H5Screate_simple(2, mine, nullptr), H5Sclose, what);
      Hdf5Handle data(
        H5Dcreate2(
          *file, name.c_str(), type, space, groups, undated, H5P_DEFAULT),
        H5Dclose,
        what);
      if (n_rows == 0)
        return;

      Hdf5::select_rows(space, first_row, n_my_rows, n_columns);
      if (n_my_rows == 0)
        hdf5(H5Sselect_none(memory), what);
      const bool written =
        H5Dwrite(data, type, memory, space, transfer, values) >= 0;
      const bool closed = data.close_now();
      check_written(written && closed, what);
    }



    void
    Hdf5Writer::check_space(const std::uint64_t bytes) const
    {
      if (!Hdf5::by_mpi(communicator))
        return;
      int enough = 1;
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        {
          std::error_code unknown;
          const auto      space = std::filesystem::space(
            std::filesystem::absolute(beside).parent_path(), unknown);
          enough =
            unknown || space.available >= bytes + internal::Hdf5Archive::spare;
        }
      check_written(Utilities::MPI::broadcast(communicator, enough) != 0,
                    "write " + beside);
    }



    void
    Hdf5Writer::check_written(const bool success, const std::string &what)
    {
      // No rank may wait for others here: those may be waiting in HDF5 for one
      // that has failed there.
      if (!success)
        throw std::runtime_error("HDF5 cannot " + what +
                                 ": is there space on the disk?");
    }



    void
    Hdf5Writer::write(const std::string         &name,
                      const std::uint64_t        first_row,
                      const std::uint64_t        n_rows,
                      const std::vector<double> &values,
                      const unsigned int         n_columns)
    {
      Assert(values.size() % n_columns == 0,
             ExcMessage("\"" + name + "\" has rows of unequal length."));
      write_rows(name,
                 H5T_NATIVE_DOUBLE,
                 first_row,
                 values.size() / n_columns,
                 n_rows,
                 n_columns,
                 values.data());
    }



    void
    Hdf5Writer::write(const std::string &name, Records records)
    {
      records.sort();

      const std::uint64_t n_mine = records.size();
      std::uint64_t       first  = 0;
      const int           ierr =
        MPI_Exscan(&n_mine, &first, 1, MPI_UINT64_T, MPI_SUM, communicator);
      AssertThrowMPI(ierr);
      const std::uint64_t n = Utilities::MPI::sum(n_mine, communicator);

      write_rows(name + "/keys",
                 H5T_NATIVE_INT64,
                 first,
                 n_mine,
                 n,
                 records.n_key_parts,
                 records.keys.data());
      write_rows(name + "/values",
                 H5T_NATIVE_DOUBLE,
                 first,
                 n_mine,
                 n,
                 records.n_values,
                 records.values.data());
    }



    void
    Hdf5Writer::write_number(const std::string &name, const double value)
    {
      const bool first_rank =
        Utilities::MPI::this_mpi_process(communicator) == 0;
      write_rows(name, H5T_NATIVE_DOUBLE, 0, first_rank ? 1 : 0, 1, 1, &value);
    }



    void
    Hdf5Writer::write_text(const std::string &name, const std::string &text)
    {
      const bool first_rank =
        Utilities::MPI::this_mpi_process(communicator) == 0;
      write_rows(name,
                 H5T_NATIVE_CHAR,
                 0,
                 first_rank ? text.size() : 0,
                 text.size(),
                 1,
                 text.data());
    }



    void
    Hdf5Writer::commit()
    {
      check_space(0);
      const bool flushed = H5Fflush(*file, H5F_SCOPE_GLOBAL) >= 0;
      if (!Hdf5::by_mpi(communicator))
        {
          const std::string bytes = Hdf5::image(*file);
          check_written(flushed && !bytes.empty(), "write " + path);
          file.reset();
          write_file(path, bytes);
          return;
        }
      const bool closed = file->close_now();
      check_written(flushed && closed, "write " + beside);
      file.reset();
      MPI_Barrier(communicator);
      write_together([this]() { std::filesystem::rename(beside, path); },
                     communicator);
    }



    Hdf5Reader::Hdf5Reader(const std::string &path, const MPI_Comm communicator)
      : path(path)
      , communicator(communicator)
    {
      Hdf5::silence();

      const bool is_there = ask_first_rank(
        [&]() {
          std::error_code unreachable;
          return std::filesystem::is_regular_file(path, unreachable) &&
                 H5Fis_hdf5(path.c_str()) > 0;
        },
        communicator);
      require(is_there,
              "The checkpoint \"" + path +
                "\" does not exist or is no complete HDF5 file.");

      const auto  access = Hdf5::file_access(communicator);
      const hid_t id     = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
      require(id >= 0,
              "The checkpoint \"" + path + "\" is damaged or cut off.");
      file = std::make_unique<Hdf5Handle>(id, H5Fclose, "open a file");
    }



    bool
    Hdf5Reader::has(const std::string &name) const
    {
      // HDF5 wants to be asked folder by folder.
      for (auto end = name.find('/'); end != std::string::npos;
           end      = name.find('/', end + 1))
        if (H5Lexists(*file, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
          return false;
      return H5Lexists(*file, name.c_str(), H5P_DEFAULT) > 0;
    }



    std::uint64_t
    Hdf5Reader::n_rows(const std::string &name) const
    {
      return shape(name)[0];
    }



    std::array<hsize_t, 2>
    Hdf5Reader::shape(const std::string &name) const
    {
      require(has(name),
              "The checkpoint \"" + path + "\" holds no \"" + name +
                "\": it was written for another scene; resume it with the "
                "parameters of its run.");
      const std::string what = "read \"" + name + "\" from " + path;
      const Hdf5Handle  data(
        H5Dopen2(*file, name.c_str(), H5P_DEFAULT), H5Dclose, what);
      const Hdf5Handle space(H5Dget_space(data), H5Sclose, what);

      std::array<hsize_t, 2> n = {{0, 0}};
      AssertThrow(H5Sget_simple_extent_ndims(space) == 2 &&
                    H5Sget_simple_extent_dims(space, n.data(), nullptr) == 2,
                  ExcMessage("HDF5 cannot " + what + "."));
      return n;
    }



    void
    Hdf5Reader::read_rows(const std::string  &name,
                          const hid_t         type,
                          const std::uint64_t first_row,
                          const std::uint64_t n_rows,
                          const unsigned int  n_columns,
                          void               *values) const
    {
      const auto n = shape(name);
      require(n[1] == n_columns && first_row + n_rows <= n[0],
              "The checkpoint \"" + path + "\" holds " + std::to_string(n[0]) +
                " rows of " + std::to_string(n[1]) + " numbers of \"" + name +
                "\", fewer or others than this scene needs.");
      if (n[0] == 0)
        return;

      const std::string what     = "read \"" + name + "\" from " + path;
      const hsize_t     mine[2]  = {n_rows, n_columns};
      const auto        transfer = Hdf5::transfer(communicator);
      const Hdf5Handle  data(
        H5Dopen2(*file, name.c_str(), H5P_DEFAULT), H5Dclose, what);
      const Hdf5Handle space(H5Dget_space(data), H5Sclose, what);
      const Hdf5Handle memory(
        H5Screate_simple(2, mine, nullptr), H5Sclose, what);
      Hdf5::select_rows(space, first_row, n_rows, n_columns);
      if (n_rows == 0)
        hdf5(H5Sselect_none(memory), what);
      require(H5Dread(data, type, memory, space, transfer, values) >= 0,
              "The checkpoint \"" + path + "\" is damaged: \"" + name +
                "\" cannot be read.");
    }



    std::vector<double>
    Hdf5Reader::read(const std::string  &name,
                     const std::uint64_t first_row,
                     const std::uint64_t n_rows,
                     const unsigned int  n_columns) const
    {
      std::vector<double> values(n_rows * n_columns);
      read_rows(
        name, H5T_NATIVE_DOUBLE, first_row, n_rows, n_columns, values.data());
      return values;
    }



    Records
    Hdf5Reader::read_records(
      const std::string                               &name,
      const std::function<bool(const std::int64_t *)> &wanted) const
    {
      const auto shape_keys   = shape(name + "/keys");
      const auto shape_values = shape(name + "/values");

      Records mine, piece;
      mine.n_key_parts = piece.n_key_parts = shape_keys[1];
      mine.n_values = piece.n_values = shape_values[1];
      for (std::uint64_t first = 0; first < shape_keys[0];
           first += internal::Hdf5Archive::rows_at_once)
        {
          const std::uint64_t n = std::min<std::uint64_t>(
            internal::Hdf5Archive::rows_at_once, shape_keys[0] - first);
          piece.keys.resize(n * piece.n_key_parts);
          read_rows(name + "/keys",
                    H5T_NATIVE_INT64,
                    first,
                    n,
                    piece.n_key_parts,
                    piece.keys.data());
          piece.values = read(name + "/values", first, n, piece.n_values);
          for (std::uint64_t i = 0; i < n; ++i)
            if (wanted(piece.key(i)))
              {
                mine.keys.insert(mine.keys.end(),
                                 piece.key(i),
                                 piece.key(i) + piece.n_key_parts);
                mine.values.insert(mine.values.end(),
                                   piece.value(i),
                                   piece.value(i) + piece.n_values);
              }
        }
      mine.sort();
      return mine;
    }



    double
    Hdf5Reader::read_number(const std::string &name) const
    {
      return read(name, 0, 1)[0];
    }



    std::string
    Hdf5Reader::read_text(const std::string &name) const
    {
      std::string text(shape(name)[0], ' ');
      read_rows(name, H5T_NATIVE_CHAR, 0, text.size(), 1, &text[0]);
      return text;
    }
  } // namespace IO
} // namespace Heddle
