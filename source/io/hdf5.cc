#include <heddle/io/hdf5.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Heddle
{
  namespace IO
  {
    using namespace dealii;

    void
    hdf5(const herr_t error, const std::string &what)
    {
      AssertThrow(error >= 0, ExcMessage("HDF5 cannot " + what + "."));
    }



    Hdf5Handle::Hdf5Handle(const hid_t        id,
                           const Close        close,
                           const std::string &what)
      : id(id)
      , close(close)
    {
      AssertThrow(id >= 0, ExcMessage("HDF5 cannot " + what + "."));
    }



    Hdf5Handle::~Hdf5Handle()
    {
      close_now();
    }



    bool
    Hdf5Handle::close_now()
    {
      const bool success = id < 0 || close(id) >= 0;
      id                 = H5I_INVALID_HID;
      return success;
    }



    namespace Hdf5
    {
      namespace
      {
        /** A list of properties made by @p set; invalid if that failed. */
        template <typename Set>
        hid_t
        property_list(const hid_t kind, const Set &set)
        {
          const hid_t list = H5Pcreate(kind);
          if (list < 0 || set(list) >= 0)
            return list;
          H5Pclose(list);
          return H5I_INVALID_HID;
        }
      } // namespace



      bool
      by_mpi(const MPI_Comm communicator)
      {
        return Utilities::MPI::n_mpi_processes(communicator) > 1;
      }



      Hdf5Handle
      file_access(const MPI_Comm communicator)
      {
        const auto set = [communicator](const hid_t list) {
          return by_mpi(communicator)
                   ? H5Pset_fapl_mpio(list, communicator, MPI_INFO_NULL)
                   : 0;
        };
        return {property_list(H5P_FILE_ACCESS, set),
                H5Pclose,
                "prepare access to a file"};
      }



      Hdf5Handle
      access_to_write(const MPI_Comm communicator)
      {
        if (by_mpi(communicator))
          return file_access(communicator);
        const auto set = [](const hid_t list) {
          constexpr std::size_t piece = 1 << 20;
          return H5Pset_fapl_core(list, piece, /*backing_store=*/false);
        };
        return {
          property_list(H5P_FILE_ACCESS, set), H5Pclose, "prepare a file"};
      }



      Hdf5Handle
      transfer(const MPI_Comm communicator)
      {
        const auto set = [communicator](const hid_t list) {
          return by_mpi(communicator)
                   ? H5Pset_dxpl_mpio(list, H5FD_MPIO_COLLECTIVE)
                   : 0;
        };
        return {
          property_list(H5P_DATASET_XFER, set), H5Pclose, "prepare a transfer"};
      }



      Hdf5Handle
      with_groups()
      {
        const auto set = [](const hid_t list) {
          return H5Pset_create_intermediate_group(list, 1);
        };
        return {
          property_list(H5P_LINK_CREATE, set), H5Pclose, "prepare groups"};
      }



      Hdf5Handle
      without_dates()
      {
        const auto set = [](const hid_t list) {
          return H5Pset_obj_track_times(list, false);
        };
        return {
          property_list(H5P_DATASET_CREATE, set), H5Pclose, "prepare data"};
      }



      void
      select_rows(const hid_t         space,
                  const std::uint64_t first,
                  const std::uint64_t n,
                  const unsigned int  n_columns)
      {
        const hsize_t offset[2] = {first, 0};
        const hsize_t count[2]  = {n, n_columns};
        hdf5((n == 0)
               ? H5Sselect_none(space)
               : H5Sselect_hyperslab(
                   space, H5S_SELECT_SET, offset, nullptr, count, nullptr),
             "select rows");
      }



      std::string
      image(const hid_t file)
      {
        const ssize_t size = H5Fget_file_image(file, nullptr, 0);
        std::string   bytes(std::max<ssize_t>(size, 0), ' ');
        if (size > 0 && H5Fget_file_image(file, &bytes[0], size) != size)
          bytes.clear();
        return bytes;
      }



      void
      silence()
      {
        // All but the first call of this are said to fail.
        H5dont_atexit();
        hdf5(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "be silent");
      }
    } // namespace Hdf5
  }   // namespace IO
} // namespace Heddle
