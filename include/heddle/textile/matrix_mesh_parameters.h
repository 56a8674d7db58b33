#ifndef heddle_textile_matrix_mesh_parameters_h
#define heddle_textile_matrix_mesh_parameters_h

#include <heddle/textile/matrix_mesh_description.h>

#include <deal.II/base/parameter_acceptor.h>

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

      const MatrixMeshDescription &
      description() const
      {
        return mesh;
      }

    private:
      MatrixMeshDescription mesh;
    };
  } // namespace Textile
} // namespace Heddle

#endif
