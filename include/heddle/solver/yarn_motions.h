#ifndef heddle_solver_yarn_motions_h
#define heddle_solver_yarn_motions_h

#include <heddle/system/block_system.h>

#include <Eigen/SparseCholesky>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * Coarse part of a preconditioner: the motions in which all fibers of a
     * part of a yarn, see yarn_parts(), move alike. What resists them is much
     * softer than what holds one fiber among its neighbours, which is all that
     * a preconditioner sees that takes fibers one by one. A part has stations
     * along it; between two of them its motion is the cubic that has no slope
     * at either.
     *
     * With the matrix P of these motions the correction is
     * $P (P^T A P)^{-1} P^T$. Its system is small: all ranks hold it.
     */
    class YarnMotions
    {
    public:
      YarnMotions(const System::State &state);

      /**
       * Take the coarse system from the symmetric tangent of @p system, the
       * part of whose matrix on this rank is @p own.
       * @note Collective.
       */
      void
      set_up(const System::BlockSystem &system, const System::LocalBlocks &own);

      /**
       * Add to @p result the correction for @p residual, both of the own
       * blocks. Return an error code of MPI.
       * @note Collective.
       */
      int
      add_correction(const double *residual, double *result) const;

    private:
      /** By how much a block moves with a station, and with the next one. */
      struct Share
      {
        unsigned int station; /**< or invalid_unsigned_int: with none */
        double       here, next;
      };

      /**
       * By two stations, the first of which is not before the second: the 3x3
       * block between them, column by column.
       */
      using CoarseBlocks =
        std::unordered_map<std::uint64_t, std::array<double, 9>>;

      /** Give every part of a yarn its stations. @note Collective. */
      void
      find_stations();

      /** Set the shares of the blocks that are held here. */
      void
      find_shares();

      Share
      share(const unsigned int fiber, const unsigned int block) const;

      /**
       * Add the 3x3 block @p block of the tangent between two blocks to what
       * it couples, and its transpose if it stands @p twice.
       */
      void
      project(const Share  &row,
              const Share  &column,
              const double *block,
              const bool    twice,
              CoarseBlocks &coarse) const;

      /** First station that @p n blocks follow, and the one after the last. */
      std::pair<unsigned int, unsigned int>
      stations_of(const unsigned int n, const unsigned int *blocks) const;

      /** Project what couples the fibers of this rank, and is in no matrix. */
      template <unsigned int n_of_side>
      void
      project_couplings(const System::BlockSystem              &system,
                        const System::PairCouplings<n_of_side> &couplings,
                        CoarseBlocks                           &coarse) const;

      /** The same for terms between @p blocks some of which are constrained. */
      template <unsigned int n_of_side>
      void
      project_constrained(
        const System::BlockSystem                               &system,
        const typename System::PairCouplings<n_of_side>::Blocks &blocks,
        const typename System::PairCouplings<n_of_side>::Term   *first,
        const typename System::PairCouplings<n_of_side>::Term   *end,
        CoarseBlocks                                            &coarse) const;

      /** Project what couples own blocks to those of later ranks. */
      void
      project_remote(Mat tangent, CoarseBlocks &coarse) const;

      /**
       * The blocks of all ranks, one after the other: two stations and nine
       * entries each. @note Collective.
       */
      std::vector<double>
      gather(const CoarseBlocks &coarse) const;

      /** Factorize the sum over all ranks. */
      void
      factorize(const CoarseBlocks &coarse);

      const System::State                  &state;
      std::vector<unsigned int>             first_station; /**< by fiber */
      std::vector<unsigned int>             n_stations;    /**< by fiber */
      unsigned int                          n_all_stations = 0;
      unsigned int                          ghost_version  = 0;
      std::vector<Share>                    shares; /**< by local block */
      std::unordered_map<int, unsigned int> remote_blocks; /**< global, local */

      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factorization;
      bool                                               usable = false;
      mutable Eigen::VectorXd                            values;
    };
  } // namespace Solver
} // namespace Heddle

#endif
