#include <heddle/base/petsc.h>
#include <heddle/solver/yarn_motions.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/unordered_map.hpp>

#include <algorithm>
#include <map>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /**
       * Intervals between nodes from one station to the next. More stations
       * hardly save an iteration.
       */
      constexpr unsigned int station_distance = 5;
    } // namespace



    YarnMotions::YarnMotions(const System::State &state)
      : state(state)
      , first_station(state.space.n_fibers(), 0)
      , n_stations(state.space.n_fibers(), 0)
    {
      find_stations();
    }



    void
    YarnMotions::find_stations()
    {
      const System::FiberSpace                         &space = state.space;
      std::map<unsigned int, std::vector<unsigned int>> yarns;
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        yarns[space.fiber(f).yarn_id].push_back(f);
      for (const auto &yarn : yarns)
        if (yarn.second.size() > 1)
          {
            unsigned int n_intervals = 0;
            for (const unsigned int f : yarn.second)
              n_intervals = std::max(n_intervals, space.fiber(f).n_nodes - 1);
            const unsigned int n = 2 + (n_intervals - 1) / station_distance;
            for (const unsigned int f : yarn.second)
              {
                first_station[f] = n_all_stations;
                n_stations[f]    = n;
              }
            n_all_stations += n;
          }
      values.resize(3 * n_all_stations);
    }



    YarnMotions::Share
    YarnMotions::share(const unsigned int fiber, const unsigned int block) const
    {
      const System::FiberSpace &space      = state.space;
      const unsigned int        n_per_node = space.n_blocks_per_node();
      const unsigned int        kind       = block % n_per_node;
      if (n_stations[fiber] == 0 || (n_per_node == 3 && kind > 0))
        return {numbers::invalid_unsigned_int, 0., 0.};

      // A position moves by this cubic, a tangent by its derivative.
      const double per_length =
        (n_stations[fiber] - 1) / space.fiber(fiber).length;
      const double t =
        space.node_positions(fiber)[block / n_per_node] * per_length;
      const unsigned int k = std::min<unsigned int>(t, n_stations[fiber] - 2);
      const double       x = t - k;
      if (kind == 0)
        {
          const double next = x * x * (3. - 2. * x);
          return {first_station[fiber] + k, 1. - next, next};
        }
      const double slope = 6. * x * (1. - x) * per_length;
      return {first_station[fiber] + k, -slope, slope};
    }



    void
    YarnMotions::find_shares()
    {
      shares.assign(state.n_local_blocks(),
                    {numbers::invalid_unsigned_int, 0., 0.});
      remote_blocks.clear();
      const std::vector<int> global = state.global_blocks();
      for (unsigned int f = 0; f < state.space.n_fibers(); ++f)
        if (state.has(f))
          {
            const auto held = state.held_blocks(f);
            for (unsigned int local = held.first; local < held.second; ++local)
              {
                shares[local] = share(f, local - state.local_block(f));
                if (!state.space.owns(f))
                  remote_blocks[global[local]] = local;
              }
          }
    }



    void
    YarnMotions::set_up(Mat tangent, const System::LocalBlocks &own)
    {
      usable = n_all_stations > 0;
      if (!usable)
        return;
      if (shares.empty() || ghost_version != state.ghost_version())
        find_shares();
      ghost_version = state.ghost_version();

      CoarseBlocks coarse;
      for (unsigned int row = 0; row < state.n_owned_fiber_blocks(); ++row)
        if (shares[row].station != numbers::invalid_unsigned_int)
          own.for_each_of_upper_row(
            row, [&](const unsigned int column, const double *block) {
              project(
                shares[row], shares[column], block, column != row, coarse);
            });
      if (Utilities::MPI::n_mpi_processes(state.space.communicator()) > 1)
        project_remote(tangent, coarse);
      factorize(coarse);
    }



    void
    YarnMotions::project(const Share  &row,
                         const Share  &column,
                         const double *block,
                         const bool    twice,
                         CoarseBlocks &coarse) const
    {
      if (column.station == numbers::invalid_unsigned_int)
        return;
      const double of_row[2]    = {row.here, row.next};
      const double of_column[2] = {column.here, column.next};
      for (unsigned int r = 0; r < 2; ++r)
        for (unsigned int c = 0; c < 2; ++c)
          {
            // The lower half is enough: a block above it stands for its
            // transpose there, and one on the diagonal for both.
            const double        weight = of_row[r] * of_column[c];
            const std::uint64_t i = row.station + r, j = column.station + c;
            const bool          as_it_is = i >= j, transposed = twice && i <= j;
            if (weight == 0. || (!as_it_is && !transposed))
              continue;
            std::array<double, 9> &sum =
              coarse[std::max(i, j) * n_all_stations + std::min(i, j)];
            for (unsigned int k = 0; k < 9; ++k)
              sum[k] +=
                weight * ((as_it_is ? block[k] : 0.) +
                          (transposed ? block[3 * (k % 3) + k / 3] : 0.));
          }
    }



    void
    YarnMotions::project_remote(Mat tangent, CoarseBlocks &coarse) const
    {
      PetscInt begin, end;
      petsc(MatGetOwnershipRange(tangent, &begin, &end));
      PetscBool only_upper;
      petsc(PetscObjectTypeCompare(
        reinterpret_cast<PetscObject>(tangent), MATMPISBAIJ, &only_upper));
      if (only_upper)
        petsc(MatGetRowUpperTriangular(tangent));
      for (unsigned int row = 0; row < state.n_owned_fiber_blocks(); ++row)
        if (shares[row].station != numbers::invalid_unsigned_int)
          for (unsigned int i = 0; i < 3; ++i)
            {
              const PetscInt     number = begin + 3 * row + i;
              PetscInt           n;
              const PetscInt    *columns;
              const PetscScalar *entries;
              petsc(MatGetRow(tangent, number, &n, &columns, &entries));
              for (PetscInt k = 0; k < n; ++k)
                {
                  const auto found = remote_blocks.find(columns[k] / 3);
                  if (columns[k] < end || found == remote_blocks.end())
                    continue;
                  double block[9]                 = {};
                  block[3 * (columns[k] % 3) + i] = entries[k];
                  project(shares[row],
                          shares[found->second],
                          block,
                          /*twice=*/true,
                          coarse);
                }
              petsc(MatRestoreRow(tangent, number, &n, &columns, &entries));
            }
      if (only_upper)
        petsc(MatRestoreRowUpperTriangular(tangent));
    }



    void
    YarnMotions::factorize(const CoarseBlocks &coarse)
    {
      // All ranks add in the same order, and so hold the same factors, which
      // are computed from the lower half.
      std::vector<Eigen::Triplet<double>> entries;
      for (const CoarseBlocks &part :
           Utilities::MPI::all_gather(state.space.communicator(), coarse))
        for (const auto &block : part)
          for (unsigned int k = 0; k < 9; ++k)
            entries.emplace_back(3 * (block.first / n_all_stations) + k % 3,
                                 3 * (block.first % n_all_stations) + k / 3,
                                 block.second[k]);
      Eigen::SparseMatrix<double> system(values.size(), values.size());
      system.setFromTriplets(entries.begin(), entries.end());
      factorization.compute(system);
      usable = factorization.info() == Eigen::Success &&
               factorization.vectorD().minCoeff() > 0.;
    }



    int
    YarnMotions::add_correction(const double *residual, double *result) const
    {
      if (!usable)
        return MPI_SUCCESS;
      const auto for_each_share = [this](const auto &action) {
        for (unsigned int b = 0; b < state.n_owned_fiber_blocks(); ++b)
          if (shares[b].station != numbers::invalid_unsigned_int)
            action(shares[b], 3 * b, 3 * shares[b].station);
      };
      values.setZero();
      for_each_share([&](const Share &share, const auto b, const auto s) {
        for (unsigned int d = 0; d < 3; ++d)
          {
            values[s + d] += share.here * residual[b + d];
            values[s + 3 + d] += share.next * residual[b + d];
          }
      });
      const int code = MPI_Allreduce(MPI_IN_PLACE,
                                     values.data(),
                                     values.size(),
                                     MPI_DOUBLE,
                                     MPI_SUM,
                                     state.space.communicator());
      values         = factorization.solve(values).eval();
      for_each_share([&](const Share &share, const auto b, const auto s) {
        for (unsigned int d = 0; d < 3; ++d)
          result[b + d] +=
            share.here * values[s + d] + share.next * values[s + 3 + d];
      });
      return code;
    }
  } // namespace Solver
} // namespace Heddle
