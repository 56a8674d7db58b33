#include <heddle/io/matrix_output.h>

#include <deal.II/fe/fe_tools.h>

namespace Heddle
{
  namespace IO
  {
    namespace
    {
      const std::vector<std::string> &
      fields_of_cells()
      {
        static const std::vector<std::string> names = {"displacement[3]",
                                                       "strain_xx",
                                                       "strain_yy",
                                                       "strain_zz",
                                                       "strain_xy",
                                                       "strain_xz",
                                                       "strain_yz",
                                                       "stress_xx",
                                                       "stress_yy",
                                                       "stress_zz",
                                                       "stress_xy",
                                                       "stress_xz",
                                                       "stress_yz",
                                                       "von_mises_stress"};
        return names;
      }

    } // namespace



    MatrixOutput::MatrixOutput(const std::string &directory,
                               const MPI_Comm     communicator,
                               const unsigned int resume_at)
      : communicator(communicator)
      , cells(directory, "matrix", communicator, resume_at)
      , points(directory, "coupling", communicator, resume_at)
    {
    }



    void
    MatrixOutput::write(
      const System::State                                &state,
      const std::function<CellMeans(const unsigned int)> &means,
      const std::vector<LinkPoint>                       &links,
      const unsigned int                                  number,
      const double                                        time,
      const std::string                                  &stage)
    {
      write_cells(state, means, cells.path(number));
      cells.add(number, time, stage);
      write_links(links, points.path(number));
      points.add(number, time, stage);
    }



    void
    MatrixOutput::write_cells(
      const System::State                                &state,
      const std::function<CellMeans(const unsigned int)> &means,
      const std::string                                  &path)
    {
      const System::MatrixSpace &matrix = *state.matrix();
      const unsigned int         degree = matrix.degree();
      const auto                 node_at =
        FETools::lexicographic_to_hierarchic_numbering<3>(degree);

      PatchFile<3> file(fields_of_cells());
      for (const unsigned int c : matrix.near_cells())
        if (matrix.owns(matrix.cell(c)[0]))
          {
            PatchFile<3>::Patch patch;
            patch.patch_index    = file.patches.size();
            patch.n_subdivisions = degree;
            patch.reference_cell = ReferenceCells::Hexahedron;
            // The last three are the places of the points.
            patch.points_are_available = true;
            patch.data.reinit(file.n_components() + 3, node_at.size());
            const CellMeans mean = means(c);
            for (unsigned int i = 0; i < node_at.size(); ++i)
              {
                const unsigned int block =
                  state.matrix_block(matrix.cell(c)[node_at[i]]);
                const Tensor<1, 3> displacement =
                  state.current()[block] - state.matrix_reference(block);
                for (unsigned int d = 0; d < 3; ++d)
                  {
                    patch.data(d, i) = displacement[d];
                    patch.data(file.n_components() + d, i) =
                      state.current()[block][d];
                  }
                for (unsigned int k = 0; k < 6; ++k)
                  {
                    patch.data(3 + k, i) = mean.strain.access_raw_entry(k);
                    patch.data(9 + k, i) = mean.stress.access_raw_entry(k);
                  }
                patch.data(15, i) = mean.von_mises;
              }
            file.patches.push_back(patch);
          }
      file.write(path, communicator);
    }



    void
    MatrixOutput::write_links(const std::vector<LinkPoint> &links,
                              const std::string            &path)
    {
      PatchFile<0> file({"force[3]", "force_per_length", "fiber_id"});
      for (const LinkPoint &link : links)
        {
          PatchFile<0>::Patch patch;
          patch.patch_index = file.patches.size();
          patch.vertices[0] = Point<3>(link.position);
          patch.data.reinit(file.n_components(), 1);
          for (unsigned int d = 0; d < 3; ++d)
            patch.data(d, 0) = link.force[d];
          patch.data(3, 0) = link.force.norm() / link.length;
          patch.data(4, 0) = link.fiber;
          file.patches.push_back(patch);
        }
      file.write(path, communicator);
    }
  } // namespace IO
} // namespace Heddle
