#ifndef heddle_contributions_matrix_elasticity_h
#define heddle_contributions_matrix_elasticity_h

#include <heddle/contributions/constant_stiffness.h>
#include <heddle/solid/cell_kernel.h>
#include <heddle/system/contribution.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace dealii
{
  template <int dim, int spacedim>
  class FEValues;
} // namespace dealii

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Elastic forces of the hexahedra of the matrix. A linear law is put
     * together once; others cell by cell in every iteration.
     */
    class MatrixElasticity : public System::Contribution
    {
    public:
      /**
       * @p parts: for each cell of the mesh the part of its volume that counts,
       * 1 unless fibers take the place of the rest.
       */
      MatrixElasticity(const System::MatrixSpace       &matrix,
                       std::unique_ptr<Solid::Material> law,
                       const bool                       mean_dilatation,
                       const std::vector<double>       &parts);

      ~MatrixElasticity();

      std::string
      name() const override
      {
        return "matrix elasticity";
      }

      void
      add_pattern(const System::State  &state,
                  System::BlockPattern &pattern) override;

      void
      assemble(const System::State &state,
               System::BlockSystem &system) override;

      /** No cell of a law of large strains is turned inside out. */
      double
      largest_step(const System::State     &state,
                   const System::Increment &increment) const override;

      void
      raise_stiffness(System::NodeStiffness &stiffness) const override
      {
        stiffness.of_matrix = std::max(stiffness.of_matrix, stiffest);
      }

      void
      report(const System::State           &state,
             std::map<std::string, double> &values) const override;

      /** Strain and stress at the quadrature points of cell @p c. */
      std::vector<Solid::PointState>
      evaluate(const System::State &state, const unsigned int c) const;

      /** Where a law that takes turns for strains is wrong. */
      struct Turns
      {
        double part    = 0.; /**< of the volume, above the limit [-] */
        double largest = 0.; /**< [rad] */
      };

      /**
       * How far the material has turned, and what part of it by more than
       * @p limit [rad]; nothing unless the law is linear.
       * @note Collective.
       */
      Turns
      turns(const System::State &state, const double limit) const;

      /** How often the tangents of cells were computed. */
      unsigned int
      n_assemblies() const
      {
        return assemblies;
      }

    private:
      /** Numbers of a cell for the kernel; places of its nodes. */
      struct CellData
      {
        std::vector<unsigned int> blocks;
        std::vector<Tensor<1, 3>> places;
        std::vector<double>       gradients;
        std::vector<double>       weights;
      };

      /** Fill @p data with what belongs to cell @p c. */
      void
      visit(const System::State &state,
            const unsigned int   c,
            CellData            &data) const;

      void
      assemble_once(const System::State &state);

      /** Of the nodes of all cells that are looked at here, cell by cell. */
      double
      find_largest_stiffness() const;

      const System::MatrixSpace             &matrix;
      const std::unique_ptr<Solid::Material> law;
      const std::vector<double>              parts;
      const std::unique_ptr<FEValues<3, 3>>  shapes;
      mutable Solid::CellKernel              kernel;
      const double                           stiffest;
      std::unique_ptr<ConstantStiffness>     stiffness;
      unsigned int                           assemblies = 0;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
