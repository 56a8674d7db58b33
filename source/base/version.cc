#include <heddle/base/version.h>

#include <deal.II/base/config.h>

#include <Eigen/Core>
#include <hdf5.h>
#include <mpi.h>
#include <petscsys.h>

#include <sstream>

namespace Heddle
{
  std::string
  version()
  {
    return HEDDLE_VERSION;
  }



  std::string
  build_type()
  {
    return HEDDLE_BUILD_TYPE;
  }



  std::string
  revision()
  {
    return HEDDLE_REVISION;
  }



  std::string
  version_text()
  {
    char mpi[MPI_MAX_LIBRARY_VERSION_STRING];
    int  length;
    MPI_Get_library_version(mpi, &length);
    const std::string mpi_name(mpi, length);

    unsigned int hdf5[3];
    H5get_libversion(&hdf5[0], &hdf5[1], &hdf5[2]);

    std::ostringstream text;
    text << "heddle " << version() << " (" << build_type() << ")\n";
    if (!revision().empty())
      text << "revision " << revision() << '\n';
    text << "deal.II " << DEAL_II_PACKAGE_VERSION << '\n'
         << "PETSc " << PETSC_VERSION_MAJOR << '.' << PETSC_VERSION_MINOR << '.'
         << PETSC_VERSION_SUBMINOR << '\n'
         << "MPI " << mpi_name.substr(0, mpi_name.find(',')) << '\n'
         << "HDF5 " << hdf5[0] << '.' << hdf5[1] << '.' << hdf5[2] << '\n'
         << "Eigen " << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.'
         << EIGEN_MINOR_VERSION << '\n';
    return text.str();
  }
} // namespace Heddle
