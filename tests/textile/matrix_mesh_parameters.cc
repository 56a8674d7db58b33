// The entries describe a mesh; without any of them it is the coating of a
// fabric.
#include <heddle/textile/matrix_mesh_parameters.h>

#include "../tests.h"

using namespace Heddle::Textile;



struct Section : ParameterAcceptor
{
  Section()
    : ParameterAcceptor("/Matrix")
  {
    mesh.add_parameters(*this);
  }

  MatrixMeshParameters mesh;
};



int
main()
{
  initlog();
  const Section section;
  for (const std::string entries :
       {"",
        "subsection Matrix\nset Shape = block\nset Columns x = 3\n"
        "set Columns y = 4\nset Layers = 5\nset Coating thickness = 0.5\n"
        "set Margin x = -0.1\nset Margin y = 0.2\nset Overlap depth = 2\n"
        "set Leave out cells inside yarns = false\n"
        "set Lower corner = -1, -2, -3\nset Upper corner = 4, 5, 6\nend\n"})
    {
      ParameterAcceptor::prm.parse_input_from_string(entries);
      ParameterAcceptor::parse_all_parameters();
      const MatrixMeshDescription mesh = section.mesh.description();
      deallog << (mesh.shape == MatrixShape::block ? "block, " : "fabric, ")
              << mesh.n_cells[0] << " x " << mesh.n_cells[1] << " x "
              << mesh.n_cells[2] << " cells, coating " << mesh.coating_thickness
              << ", margins " << mesh.margins[0] << " and " << mesh.margins[1]
              << ", leave out " << mesh.leave_out << ", overlap "
              << mesh.overlap_depth << ", from " << mesh.low_corner << " to "
              << mesh.high_corner << std::endl;
    }
}
