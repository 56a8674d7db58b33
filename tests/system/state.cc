// What ranks hold: fibers are cut into whole, consecutive, even shares, with
// ranks that get none; nodes of the matrix likewise. Ghosts are the pieces that
// were asked for and have the values of their owners, in the configuration, in
// the accepted one and in any array, and local numbers are those of one system.
#include "space_checks.h"
#include "state_checks.h"

using Sizes = std::vector<unsigned int>;

/** Fibers alike, one that is longer than others, fewer fibers than ranks. */
void
partition()
{
  for (const Sizes &n_elements : {Sizes(12, 4),
                                  Sizes{40, 3, 3, 5, 2, 9, 1, 1},
                                  Sizes{1, 2, 40, 1},
                                  Sizes{5, 5},
                                  Sizes{6}})
    for (const auto &[element, degree] :
         {std::pair<std::string, unsigned int>("hermite", 3),
          std::pair<std::string, unsigned int>("director", 2)})
      {
        const auto    space  = make_space(element, degree, n_elements);
        const OfRanks ranges = shares(*space);
        deallog << element << ' ' << degree << ", fibers " << n_elements.size()
                << ": blocks of ranks";
        for (const auto &share : ranges)
          deallog << ' ' << share[3] - share[2];
        deallog << ", consecutive "
                << everywhere(are_consecutive(*space, ranges)) << ", owners "
                << everywhere(are_owners(*space, ranges)) << ", even "
                << everywhere(are_even(*space, ranges)) << std::endl;
      }
}



/** Cells that go to the ranks by turns, more and fewer of them than ranks. */
void
matrix_nodes()
{
  for (const auto &[n_x, n_y] : {std::pair(1, 1), {2, 1}, {3, 2}})
    for (const unsigned int degree : {1, 2})
      {
        const auto                mesh = layer_of_cells(n_x, n_y);
        const System::MatrixSpace matrix(MPI_COMM_WORLD, mesh, degree);
        deallog << "cells " << matrix.n_cells() << ", degree " << degree
                << ", nodes " << matrix.n_nodes() << ": owned "
                << everywhere(are_nodes_owned(matrix)) << ", in place "
                << everywhere(are_in_place(matrix, mesh)) << ", near cells "
                << everywhere(are_near(matrix)) << ", on sides "
                << everywhere(are_on_sides(matrix, mesh))
                << ", identities on all numbers of ranks " << checksum(matrix)
                << std::endl;
      }
}



Vectors
scaled(Vectors values, const double factor)
{
  for (Tensor<1, 3> &value : values)
    value *= factor;
  return values;
}



/** Whether the configuration loses wrong values of ghosts. */
bool
corrects_ghosts(System::State &state)
{
  const Vectors expected = values_of_blocks(state);
  state.set(with_lost_ghosts(state, expected));
  state.update_ghosts();
  return everywhere(state.current() == expected);
}



void
print_checks(const System::State &state,
             const Pieces        &some,
             const Pieces        &others)
{
  deallog << "ghosts "
          << Utilities::MPI::sum(
               state.n_local_blocks() - state.n_owned_blocks(), MPI_COMM_WORLD)
          << ", held " << everywhere(holds(state, some, others))
          << ", each numbered once " << everywhere(are_numbered(state))
          << ", fetched " << everywhere(brings_values(state))
          << ", numbers of the system " << everywhere(are_global(state));
}



/** Whether the configuration goes back to one of other ghosts. */
bool
returns(System::State &state, const Vectors &before, const Vectors &expected)
{
  state.set_owned(before);
  return everywhere(state.current() == expected);
}



/**
 * Ghosts change while the configuration differs from the accepted one: both are
 * fetched, and what is rejected goes back.
 */
void
ghosts()
{
  for (const Sizes &n_elements : {Sizes{4, 7, 2, 5, 3, 6, 4}, Sizes{6}})
    for (const std::string element : {"hermite", "director"})
      {
        const auto    space = make_space(element, /*degree=*/3, n_elements);
        System::State state(*space);
        std::mt19937  generator(
          Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
        for (unsigned int call = 0; call < 3; ++call)
          {
            const unsigned int version = state.ghost_version();
            const Vectors      before  = values_of_blocks(state);
            state.set(before);
            state.accept();
            state.move(0.5, values_of_blocks(state));
            const Pieces pieces = random_pieces(*space, generator);
            state.set_ghost_fibers(pieces);

            const Vectors expected = values_of_blocks(state);
            const bool    moved    = state.current() == scaled(expected, 1.5);
            const bool    accepted = state.accepted() == expected;
            state.reject();
            const bool rejected = state.current() == expected;
            deallog << element << ", fibers " << n_elements.size() << ", call "
                    << call << ": ";
            print_checks(state, pieces, {});
            deallog << ", moved " << everywhere(moved) << ", accepted "
                    << everywhere(accepted) << ", rejected "
                    << everywhere(rejected) << ", corrected "
                    << everywhere(corrects_ghosts(state)) << ", returned "
                    << returns(state, scaled(before, 2.), scaled(expected, 2.))
                    << ", another version "
                    << everywhere(state.ghost_version() > version) << std::endl;
          }
      }
}



/** Whether a new matrix is at rest; just its own and these nodes are held. */
bool
is_at_rest(const System::State &state, const std::vector<unsigned int> &foreign)
{
  const System::MatrixSpace &matrix = *state.matrix();
  bool                       good   = true;
  for (unsigned int node = 0; node < matrix.n_nodes(); ++node)
    {
      const bool held = matrix.owns(node) ||
                        std::count(foreign.begin(), foreign.end(), node) > 0;
      good = good && held == state.has_matrix_node(node);
      if (good && held)
        {
          const unsigned int block = state.matrix_block(node);
          const Point<3>    &place = matrix.reference(node);
          good                     = state.current()[block] == place &&
                 state.accepted()[block] == place &&
                 state.matrix_reference(block) == place;
        }
    }
  return good;
}



/**
 * Fibers get a matrix and, instead of it, another one. Ghosts of fibers are
 * those that are linked to it together with those of later calls.
 */
void
matrices()
{
  for (const unsigned int n_x : {1, 3})
    {
      const auto mesh  = layer_of_cells(n_x, n_x == 1 ? 1 : 2);
      const auto space = make_space("director", 2, {4, 7, 2, 5, 3});
      const System::MatrixSpace linear(MPI_COMM_WORLD, mesh, /*degree=*/1),
        quadratic(MPI_COMM_WORLD, mesh, /*degree=*/2);
      System::State state(*space);
      std::mt19937  generator(Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
      state.set(values_of_blocks(state));
      state.set_ghost_fibers(random_pieces(*space, generator));
      for (const System::MatrixSpace *matrix : {&linear, &quadratic})
        {
          const unsigned int fields  = state.field_version();
          const Pieces       linked  = random_pieces(*space, generator);
          const auto         foreign = foreign_nodes(*matrix);
          const Vectors      before(state.current().begin(),
                               state.current().begin() +
                                 state.n_owned_fiber_blocks());
          state.set_matrix(matrix, foreign, linked);
          const bool kept =
            std::equal(before.begin(), before.end(), state.current().begin());
          const bool   rests = is_at_rest(state, foreign);
          const Pieces later = random_pieces(*space, generator);
          state.set_ghost_fibers(later);
          deallog << "cells " << mesh.cells.size() << ", degree "
                  << matrix->degree() << ", unknowns " << state.n_dofs()
                  << ", ";
          print_checks(state, linked, later);
          deallog << ", matrix at rest " << everywhere(rests)
                  << ", fibers kept " << everywhere(kept) << ", corrected "
                  << everywhere(corrects_ghosts(state)) << ", another system "
                  << everywhere(state.field_version() > fields) << std::endl;
        }
    }
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  run_part("Partition", partition);
  run_part("Nodes of the matrix", matrix_nodes);
  run_part("Ghosts", ghosts);
  run_part("Matrices", matrices);
}
