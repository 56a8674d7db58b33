#ifndef heddle_tests_system_state_checks_h
#define heddle_tests_system_state_checks_h

#include "small_scene.h"

#include <algorithm>

/** Pieces of most foreign fibers, others on each rank and in each call. */
inline Pieces
random_pieces(const System::FiberSpace &space, std::mt19937 &generator)
{
  Pieces pieces;
  for (unsigned int f = 0; f < space.n_fibers(); ++f)
    if (!space.owns(f) && generator() % 4 > 0)
      {
        const unsigned int n     = space.fiber(f).n_nodes;
        const unsigned int begin = generator() % n;
        pieces.push_back(
          {f, {begin, begin + 1 + unsigned(generator() % (n - begin))}});
      }
  return pieces;
}



/**
 * Whether the state holds its fibers, and of foreign ones what @p some and @p
 * others ask for with all that lies between.
 */
inline bool
holds(const System::State &state, const Pieces &some, const Pieces &others)
{
  const System::FiberSpace      &space = state.space;
  std::vector<System::NodeRange> expected(space.n_fibers());
  for (const Pieces *pieces : {&some, &others})
    for (const auto &[f, nodes] : *pieces)
      expected[f] =
        expected[f].empty()
          ? nodes
          : System::NodeRange{std::min(expected[f].begin, nodes.begin),
                              std::max(expected[f].end, nodes.end)};
  bool good = true;
  for (unsigned int f = 0; f < space.n_fibers(); ++f)
    {
      if (space.owns(f))
        expected[f] = space.all_nodes(f);
      good = good && state.held_nodes(f) == expected[f] &&
             state.has(f) == !expected[f].empty();
    }
  return good;
}



/** Different vectors for all blocks of the scene, the same on all ranks. */
inline Vectors
values_of_blocks(const System::State &state)
{
  Vectors values;
  for (const unsigned int number : identities(state))
    values.push_back(Tensor<1, 3>({1. + number, 3. * number, -2. * number}));
  return values;
}



/** Whether each local block is one of a fiber or of the matrix. */
inline bool
are_numbered(const System::State &state)
{
  bool good = true;
  for (const unsigned int number : identities(state))
    good = good && number != numbers::invalid_unsigned_int;
  return good;
}



/** @p values, but for ghosts, which have something else. */
inline Vectors
with_lost_ghosts(const System::State &state, Vectors values)
{
  std::fill(values.begin() + state.n_owned_blocks(),
            values.end(),
            Tensor<1, 3>({-7., -7., -7.}));
  return values;
}



/** Whether ghosts, which had none, get the values of their owners. */
inline bool
brings_values(const System::State &state)
{
  const Vectors expected = values_of_blocks(state);
  Vectors       values   = with_lost_ghosts(state, expected);
  state.update_ghosts(values);
  return values == expected;
}



/**
 * Whether the system has the owned blocks of a rank in a row behind those of
 * lower ranks, and ghosts have the numbers that their owners give them.
 */
inline bool
are_global(const System::State &state)
{
  const auto owned =
    Utilities::MPI::all_gather(MPI_COMM_WORLD, state.n_owned_blocks());
  unsigned int begin = 0;
  for (unsigned int rank = 0;
       rank < Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
       ++rank)
    begin += owned[rank];
  Vectors numbers(state.n_local_blocks());
  for (unsigned int b = 0; b < state.n_owned_blocks(); ++b)
    numbers[b][0] = begin + b;
  state.update_ghosts(numbers);
  const std::vector<int> found = state.global_blocks();
  bool                   good  = found.size() == numbers.size();
  for (unsigned int b = 0; good && b < numbers.size(); ++b)
    good = found[b] == numbers[b][0];
  return good;
}

#endif
