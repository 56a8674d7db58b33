#ifndef heddle_textile_matrix_mesh_parameters_h
#define heddle_textile_matrix_mesh_parameters_h

#include <heddle/textile/matrix_mesh_description.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace Heddle
{
  namespace Textile
  {
    /** The entries that describe the mesh of a matrix. */
    class MatrixMeshParameters
    {
    public:
      /** Declare the entries in the section of @p owner. */
      void
      add_parameters(ParameterAcceptor &owner);

      MatrixMeshDescription
      description() const;

    private:
      MatrixMeshDescription mesh;
      std::string           shape = "fabric";
    };
  } // namespace Textile
} // namespace Heddle

#endif
