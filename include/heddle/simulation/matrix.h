#ifndef heddle_simulation_matrix_h
#define heddle_simulation_matrix_h

#include <heddle/contributions/fiber_matrix_coupling.h>
#include <heddle/contributions/matrix_elasticity.h>
#include <heddle/io/summary.h>
#include <heddle/simulation/matrix_parameters.h>
#include <heddle/system/state.h>
#include <heddle/textile/matrix_mesh.h>

#include <memory>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /**
     * The matrix around fibers: its mesh, made for the configuration in which
     * they are embedded, its place in the state, and what acts in it.
     */
    class Matrix
    {
    public:
      /**
       * Embed the fibers as they lie in @p state, and add the matrix to it.
       * @p sections_are_turned is whether anything turns sections of fibers.
       * Throws InputError if there is no sound mesh.
       * @note Collective.
       */
      Matrix(const MatrixParameters &parameters,
             System::State          &state,
             const bool              sections_are_turned);

      /** Write where the fibers were embedded, so that it can be done again. */
      void
      save(ArchiveWriter &archive, const System::State &state) const;

      static bool
      is_in(const ArchiveReader &archive);

      /** Lay the fibers of @p state to where they were embedded. */
      static void
      load(const ArchiveReader &archive, System::State &state);

      /**
       * Throws InputError, which begins with @p where, if this is not the
       * matrix that @p archive holds.
       */
      void
      check(const ArchiveReader &archive, const std::string &where) const;

      /** One line for the log. */
      std::string
      in_words() const;

      /**
       * How much of a matrix of the linear law has turned so far that another
       * one is right, or nothing.
       * @note Collective.
       */
      std::string
      turned_in_words(const System::State &state) const;

      const std::shared_ptr<Contributions::MatrixElasticity> &
      elasticity() const
      {
        return matrix_elasticity;
      }

      const std::shared_ptr<Contributions::FiberMatrixCoupling> &
      coupling() const
      {
        return fiber_coupling;
      }

      const System::MatrixSpace &
      space() const
      {
        return *matrix_space;
      }

      /** How much there is of all, over all ranks. */
      IO::MatrixSummary
      summary() const;

    private:
      /** Beside what the summary tells of it, that is for the log. */
      struct Sizes : IO::MatrixSummary
      {
        unsigned int n_left_out = 0; /**< cells deep inside of yarns */
        unsigned int n_dropped  = 0; /**< cells that nothing holds */
        double subtracted = 0.; /**< of doubled_volume, from cells [mm^3] */

        /** Part of the fibers' length that lies in cells without links [-]. */
        double unlinked = 0.;

        /** Fibers no point of which is where cells are or were left out. */
        unsigned int n_outside = 0;
      };

      using Points = std::vector<Contributions::EmbeddedPoint>;

      /** Numbers that another matrix does not have. */
      std::vector<std::pair<std::string, double>>
      identity() const;

      void
      make_mesh(const System::State &state);

      /** Rank of each cell: near the fibers that it owns. */
      std::vector<unsigned int>
      distribute(const System::State &state) const;

      /** Particles of own fibers that lie in cells. */
      Points
      embed(const System::State &state) const;

      /** Own points, and those of others in cells with own nodes. */
      Points
      exchange(const Points &own) const;

      void
      add_to(System::State &state, const Points &points) const;

      /** See Sizes::unlinked. @note Collective. */
      double
      find_unlinked_part(const Points             &own,
                         const System::FiberSpace &space) const;

      /** See Sizes::n_outside. */
      unsigned int
      count_outside() const;

      /** Volume of fibers in each cell, over that of the cell. */
      std::vector<double>
      find_doubled_parts();

      const MatrixParameters                             &parameters;
      const bool                                          links_sections;
      std::vector<Tensor<1, 3>>                           embedded_at;
      std::vector<Textile::FiberAxis>                     axes;
      std::unique_ptr<Textile::MatrixMesh>                mesh;
      std::unique_ptr<System::MatrixSpace>                matrix_space;
      std::shared_ptr<Contributions::MatrixElasticity>    matrix_elasticity;
      std::shared_ptr<Contributions::FiberMatrixCoupling> fiber_coupling;
      Sizes                                               counted;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
