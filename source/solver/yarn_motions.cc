#include <heddle/base/gather.h>
#include <heddle/base/petsc.h>
#include <heddle/solver/yarn_motions.h>
#include <heddle/solver/yarn_parts.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /**
       * Intervals between nodes from one station to the next. With 2 or 3 there
       * are 26 or 27 instead of 30 iterations, in no less time
       * (doc/what_was_tried.md).
       */
      constexpr unsigned int station_distance = 5;



      /** Two stations and the entries of the block between them. */
      constexpr unsigned int numbers_of_block = 11;
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
      for (const FiberNumbers &part : yarn_parts(state))
        {
          unsigned int n_intervals = 0;
          for (const unsigned int f : part)
            n_intervals =
              std::max(n_intervals, state.space.fiber(f).n_nodes - 1);
          const unsigned int n = 2 + (n_intervals - 1) / station_distance;
          for (const unsigned int f : part)
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
    YarnMotions::set_up(const System::BlockSystem &system,
                        const System::LocalBlocks &own)
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
        project_remote(system.tangent(), coarse);

      project_couplings(system, system.axis_couplings(), coarse);
      project_couplings(system, system.section_couplings(), coarse);
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



    std::pair<unsigned int, unsigned int>
    YarnMotions::stations_of(const unsigned int  n,
                             const unsigned int *blocks) const
    {
      unsigned int first = n_all_stations, end = 0;
      for (unsigned int i = 0; i < n; ++i)
        if (shares[blocks[i]].station != numbers::invalid_unsigned_int)
          {
            first = std::min(first, shares[blocks[i]].station);
            end   = std::max(end, shares[blocks[i]].station + 2);
          }
      return {first, end};
    }



    template <unsigned int n_of_side>
    void
    YarnMotions::project_couplings(
      const System::BlockSystem              &system,
      const System::PairCouplings<n_of_side> &couplings,
      CoarseBlocks                           &coarse) const
    {
      using Couplings = System::PairCouplings<n_of_side>;
      using Stations  = std::pair<unsigned int, unsigned int>;

      // The weights of the stations follow from those of the blocks.
      std::vector<double> weights[2];
      const auto          weigh = [this](const unsigned int  *blocks,
                                const double        *of_blocks,
                                const Stations      &stations,
                                std::vector<double> &of_stations) {
        of_stations.assign(stations.second - stations.first, 0.);
        for (unsigned int i = 0; i < n_of_side; ++i)
          if (shares[blocks[i]].station != numbers::invalid_unsigned_int)
            {
              const Share       &share = shares[blocks[i]];
              const unsigned int k = share.station - stations.first;
              of_stations[k] += share.here * of_blocks[i];
              of_stations[k + 1] += share.next * of_blocks[i];
            }
      };

      std::vector<SymmetricTensor<2, 3>> sums;
      couplings.for_each_group([&](const typename Couplings::Blocks &blocks,
                                   const typename Couplings::Term   *first,
                                   const typename Couplings::Term   *end) {
        // Both ranks have the terms between their fibers: one projects them.
        const unsigned int *of_a = blocks.data(), *of_b = of_a + n_of_side;
        const Stations      a = stations_of(n_of_side, of_a),
                       b      = stations_of(n_of_side, of_b);
        if (of_a[0] >= state.n_owned_fiber_blocks() || a.first >= a.second ||
            b.first >= b.second)
          return;
        if (std::any_of(blocks.begin(), blocks.end(), [&](const auto block) {
              return system.constraints().is_constrained(block);
            }))
          {
            project_constrained<n_of_side>(system, blocks, first, end, coarse);
            return;
          }
        const unsigned int n_b = b.second - b.first;
        sums.assign((a.second - a.first) * n_b, SymmetricTensor<2, 3>());
        for (const typename Couplings::Term *term = first; term < end; ++term)
          {
            weigh(of_a, term->weights.data(), a, weights[0]);
            weigh(of_b, term->weights.data() + n_of_side, b, weights[1]);
            for (unsigned int i = 0; i < weights[0].size(); ++i)
              for (unsigned int j = 0; j < n_b; ++j)
                sums[n_b * i + j] +=
                  weights[0][i] * weights[1][j] * term->stiffness;
          }
        for (std::uint64_t i = a.first; i < a.second; ++i)
          for (std::uint64_t j = b.first; j < b.second; ++j)
            {
              // Within a station it stands for its transpose as well.
              const auto &sum = sums[n_b * (i - a.first) + (j - b.first)];
              std::array<double, 9> &block =
                coarse[std::max(i, j) * n_all_stations + std::min(i, j)];
              for (unsigned int k = 0; k < 9; ++k)
                block[k] += (i == j ? 2. : 1.) * sum[k / 3][k % 3];
            }
      });
    }



    template <unsigned int n_of_side>
    void
    YarnMotions::project_constrained(
      const System::BlockSystem                               &system,
      const typename System::PairCouplings<n_of_side>::Blocks &blocks,
      const typename System::PairCouplings<n_of_side>::Term   *first,
      const typename System::PairCouplings<n_of_side>::Term   *end,
      CoarseBlocks                                            &coarse) const
    {
      for (unsigned int i = 0; i < n_of_side; ++i)
        for (unsigned int j = n_of_side; j < 2 * n_of_side; ++j)
          {
            const unsigned int row = blocks[i], column = blocks[j];
            if (shares[row].station == numbers::invalid_unsigned_int ||
                shares[column].station == numbers::invalid_unsigned_int)
              continue;
            SymmetricTensor<2, 3> sum;
            for (const auto *term = first; term < end; ++term)
              sum += term->weights[i] * term->weights[j] * term->stiffness;
            const Tensor<2, 3> free =
              system.constraints().constrained(row, column, sum);
            double block[9];
            for (unsigned int k = 0; k < 9; ++k)
              block[k] = free[k % 3][k / 3];
            project(shares[row], shares[column], block, /*twice=*/true, coarse);
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



    std::vector<double>
    YarnMotions::gather(const CoarseBlocks &coarse) const
    {
      std::vector<double> mine;
      mine.reserve(numbers_of_block * coarse.size());
      for (const auto &block : coarse)
        {
          mine.push_back(block.first / n_all_stations);
          mine.push_back(block.first % n_all_stations);
          mine.insert(mine.end(), block.second.begin(), block.second.end());
        }
      return gather_on_all(mine, state.space.communicator());
    }



    void
    YarnMotions::factorize(const CoarseBlocks &coarse)
    {
      // All ranks add in the same order, and so hold the same factors, which
      // are computed from the lower half.
      const std::vector<double>           blocks = gather(coarse);
      std::vector<Eigen::Triplet<double>> entries;
      entries.reserve(blocks.size() / numbers_of_block * 9);
      for (auto block = blocks.begin(); block != blocks.end();
           block += numbers_of_block)
        for (unsigned int k = 0; k < 9; ++k)
          entries.emplace_back(3 * static_cast<int>(block[0]) + k % 3,
                               3 * static_cast<int>(block[1]) + k / 3,
                               block[2 + k]);
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
