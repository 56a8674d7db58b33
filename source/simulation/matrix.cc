#include <heddle/base/exceptions.h>
#include <heddle/post/centerline.h>
#include <heddle/simulation/coupling_points.h>
#include <heddle/simulation/matrix.h>
#include <heddle/textile/fiber_volume.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Straight pieces between two nodes of a fiber. */
      constexpr unsigned int n_pieces_of_axis = 4;

      /** Of a cell that is full of fibers this part counts nevertheless. */
      constexpr double least_part = 0.05;

      /** Fibers seldom miss more of the cells that they pass by chance [-]. */
      constexpr double much_unlinked = 0.2;

      const std::string embedding = "matrix/embedding";
    } // namespace



    Matrix::Matrix(const MatrixParameters &parameters,
                   System::State          &state,
                   const bool              sections_are_turned)
      : parameters(parameters)
      , links_sections(parameters.section_links == SectionLinks::always ||
                       (parameters.section_links == SectionLinks::automatic &&
                        sections_are_turned))
      , embedded_at(state.current().begin(),
                    state.current().begin() + state.n_owned_fiber_blocks())
    {
      make_mesh(state);
      const Points own = embed(state);
      counted.n_links =
        Utilities::MPI::sum(own.size(), state.space.communicator());
      require(counted.n_links > 0,
              "Matrix: no " +
                std::string(parameters.points_per_element == 0
                              ? "node"
                              : "coupling point") +
                " of a fiber lies in a cell, so that nothing links fibers and "
                "matrix; choose a larger \"Overlap depth\", finer fibers, or "
                "other corners of the block.");
      counted.unlinked    = find_unlinked_part(own, state.space);
      counted.n_outside   = count_outside();
      const Points points = exchange(own);
      add_to(state, points);

      std::vector<double> parts = find_doubled_parts();
      for (unsigned int c = 0; c < parts.size(); ++c)
        {
          parts[c] = parameters.subtract_fiber_volume
                       ? std::max(1. - parts[c], least_part)
                       : 1.;
          counted.subtracted += (1. - parts[c]) * mesh->volume(c);
        }
      matrix_elasticity = std::make_shared<Contributions::MatrixElasticity>(
        *matrix_space,
        parameters.material.material(),
        parameters.material.has_mean_dilatation(parameters.degree),
        parts);
      fiber_coupling = std::make_shared<Contributions::FiberMatrixCoupling>(
        *matrix_space,
        state,
        points,
        parameters.stiffness_factor * parameters.material.youngs_modulus);

      counted.n_nodes = matrix_space->n_nodes();
    }



    void
    Matrix::save(ArchiveWriter &archive, const System::State &state) const
    {
      std::vector<double> values;
      for (const Tensor<1, 3> &block : embedded_at)
        values.insert(values.end(), block.begin_raw(), block.end_raw());
      archive.write(embedding,
                    state.space.owned_blocks().first,
                    state.space.n_blocks(),
                    values,
                    3);
      for (const auto &number : identity())
        archive.write_number("matrix/" + number.first, number.second);
    }



    std::vector<std::pair<std::string, double>>
    Matrix::identity() const
    {
      return {{"cells", counted.n_cells},
              {"nodes", counted.n_nodes},
              {"links", counted.n_links},
              {"cubic millimeters", counted.volume}};
    }



    void
    Matrix::check(const ArchiveReader &archive, const std::string &where) const
    {
      for (const auto &number : identity())
        {
          const double there = archive.read_number("matrix/" + number.first);
          std::ostringstream sentence;
          sentence << where << " is of another matrix: its " << number.first
                   << " are " << there << ", and " << number.second
                   << " in the scene; take the entries of section \"Matrix\" "
                      "that it was written with.";
          require(std::abs(there - number.second) <= 1e-10 * number.second,
                  sentence.str());
        }
    }



    bool
    Matrix::is_in(const ArchiveReader &archive)
    {
      return archive.has(embedding);
    }



    void
    Matrix::load(const ArchiveReader &archive, System::State &state)
    {
      const std::vector<double> values =
        archive.read(embedding,
                     state.space.owned_blocks().first,
                     state.n_owned_fiber_blocks(),
                     3);
      std::vector<Tensor<1, 3>> blocks = state.current();
      for (unsigned int k = 0; k < values.size(); ++k)
        blocks[k / 3][k % 3] = values[k];
      state.set(blocks);
      state.update_ghosts();
    }



    std::string
    Matrix::in_words() const
    {
      std::ostringstream text;
      text << "Matrix: " << counted.n_cells << " cells, " << counted.n_nodes
           << " nodes, " << counted.n_links << " coupling elements; "
           << counted.n_left_out << " cells inside yarns are left out, "
           << counted.n_dropped << " that nothing holds; volume "
           << std::setprecision(4) << counted.volume << " mm^3, of which "
           << counted.doubled_volume << " is also fibers";
      if (parameters.subtract_fiber_volume)
        text << ", and " << counted.subtracted << " is subtracted";
      if (counted.unlinked > much_unlinked)
        text << "\nNote           " << std::lround(100. * counted.unlinked)
             << " % of the length of fibers in the matrix lie in cells without "
                "a coupling element, and do not reinforce these: raise "
                "Matrix/Coupling points per element, or choose longer cells or "
                "more elements of fibers";
      if (counted.n_outside > 0)
        text << "\nNote           " << counted.n_outside << " of "
             << axes.size()
             << " fibers lie wholly outside of the matrix, which does not feel "
                "them; where it is sheared, choose Fabric loading/Yarn ends "
                "'gripped', for embedded ends it holds across the yarn";
      return text.str();
    }



    std::string
    Matrix::turned_in_words(const System::State &state) const
    {
      // Turned by an angle, material seems strained by half of its square.
      constexpr double large = 0.15, much = 0.05;
      const auto       turns = matrix_elasticity->turns(state, large);
      if (turns.part < much)
        return "";
      std::ostringstream text;
      text << std::setprecision(2) << "Matrix/Law is linear, which takes turns "
           << "for strains: " << std::lround(100. * turns.part)
           << " % of the matrix has turned by more than " << large
           << " rad, up to " << turns.largest << "; another law is right there";
      return text.str();
    }



    IO::MatrixSummary
    Matrix::summary() const
    {
      IO::MatrixSummary told = counted;
      told.n_assemblies      = matrix_elasticity->n_assemblies();
      return told;
    }



    void
    Matrix::make_mesh(const System::State &state)
    {
      const System::FiberSpace &space = state.space;
      const auto                lines = Utilities::MPI::broadcast(
        space.communicator(),
        Post::gather_centerlines(state, n_pieces_of_axis));
      std::vector<Tensor<1, 3>> nodes;
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        {
          axes.push_back(
            {lines[f], space.fiber(f).radius, space.fiber(f).yarn_id});
          for (unsigned int i = 0; i < lines[f].size(); i += n_pieces_of_axis)
            nodes.push_back(lines[f][i]);
        }
      mesh = std::make_unique<Textile::MatrixMesh>(
        parameters.mesh.description(), axes, nodes);
      counted.n_cells    = mesh->cells().size();
      counted.n_left_out = mesh->n_left_out();
      counted.n_dropped  = mesh->dropped().n_cells;
      counted.volume     = mesh->volume();

      System::HexahedralMesh hexahedra;
      hexahedra.vertices = mesh->vertices();
      for (const auto &cell : mesh->cells())
        hexahedra.cells.push_back(cell.vertices);
      for (const auto &face : mesh->boundary())
        {
          hexahedra.faces.emplace_back();
          hexahedra.faces.back().side = face.side;
          for (unsigned int v = 0; v < 4; ++v)
            hexahedra.faces.back().vertices[v] =
              mesh->cells()[face.cell]
                .vertices[GeometryInfo<3>::face_to_cell_vertices(face.face, v)];
        }
      hexahedra.ranks = distribute(state);
      matrix_space    = std::make_unique<System::MatrixSpace>(
        space.communicator(), hexahedra, parameters.degree);
    }



    std::vector<unsigned int>
    Matrix::distribute(const System::State &state) const
    {
      const auto n_ranks =
        Utilities::MPI::n_mpi_processes(state.space.communicator());
      std::vector<unsigned int> ranks(mesh->cells().size(), 0);
      if (n_ranks == 1)
        return ranks;

      // Fibers are numbered rank by rank: cells in the order of the fibers next
      // to them are cut into equal parts.
      std::vector<Point<3>>     places;
      std::vector<unsigned int> fibers;
      for (unsigned int f = 0; f < axes.size(); ++f)
        for (unsigned int i = 0; i < axes[f].points.size();
             i += n_pieces_of_axis)
          {
            places.emplace_back(axes[f].points[i]);
            fibers.push_back(f);
          }
      const auto tree = pack_rtree_of_indices(places);
      std::vector<std::pair<unsigned int, unsigned int>> order;
      for (unsigned int c = 0; c < ranks.size(); ++c)
        {
          Point<3> center;
          for (const unsigned int v : mesh->cells()[c].vertices)
            center += 0.125 * Tensor<1, 3>(mesh->vertices()[v]);
          for (const auto nearest :
               tree | boost::geometry::index::adaptors::queried(
                        boost::geometry::index::nearest(center, 1)))
            order.emplace_back(fibers[nearest], c);
        }
      std::sort(order.begin(), order.end());
      for (unsigned int i = 0; i < order.size(); ++i)
        ranks[order[i].second] =
          static_cast<unsigned long>(i) * n_ranks / order.size();
      return ranks;
    }



    Matrix::Points
    Matrix::embed(const System::State &state) const
    {
      CouplingPoints places(state, *mesh, *matrix_space, links_sections);
      const auto     owned = state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        if (parameters.points_per_element == 0)
          places.add_nodes(f);
        else
          places.add_gauss_points(f, parameters.points_per_element);
      return places.points();
    }



    Matrix::Points
    Matrix::exchange(const Points &own) const
    {
      const MPI_Comm     communicator = matrix_space->communicator();
      const unsigned int me = Utilities::MPI::this_mpi_process(communicator);
      std::map<unsigned int, Points> to_send;
      for (const auto &point : own)
        {
          std::set<unsigned int> ranks;
          for (unsigned int a = 0; a < matrix_space->n_nodes_per_cell(); ++a)
            ranks.insert(
              matrix_space->owner(matrix_space->cell(point.cell)[a]));
          for (const unsigned int rank : ranks)
            if (rank != me)
              to_send[rank].push_back(point);
        }
      Points all = own;
      for (const auto &received :
           Utilities::MPI::some_to_some(communicator, to_send))
        all.insert(all.end(), received.second.begin(), received.second.end());
      return all;
    }



    void
    Matrix::add_to(System::State &state, const Points &points) const
    {
      std::set<unsigned int>                    nodes;
      std::map<unsigned int, System::NodeRange> fibers;
      const auto add_cell = [&](const unsigned int c) {
        for (unsigned int a = 0; a < matrix_space->n_nodes_per_cell(); ++a)
          if (!matrix_space->owns(matrix_space->cell(c)[a]))
            nodes.insert(matrix_space->cell(c)[a]);
      };
      for (const unsigned int c : matrix_space->near_cells())
        add_cell(c);
      for (const auto &point : points)
        {
          add_cell(point.cell);
          if (!state.space.owns(point.fiber))
            for (unsigned int k = 0; k < point.particle.blocks.size(); ++k)
              if (point.particle.values[k] != 0.)
                {
                  const unsigned int i =
                    point.particle.blocks[k] / state.space.n_blocks_per_node();
                  System::NodeRange &range =
                    fibers.insert({point.fiber, {i, i + 1}}).first->second;
                  range.begin = std::min(range.begin, i);
                  range.end   = std::max(range.end, i + 1);
                }
        }
      std::vector<System::GhostFiber> linked;
      for (const auto &piece : fibers)
        linked.push_back({piece.first, piece.second});
      state.set_matrix(
        matrix_space.get(), {nodes.begin(), nodes.end()}, linked);
    }



    double
    Matrix::find_unlinked_part(const Points             &own,
                               const System::FiberSpace &space) const
    {
      std::vector<unsigned int> n_links(mesh->cells().size());
      for (const auto &point : own)
        ++n_links[point.cell];
      Utilities::MPI::sum(n_links, space.communicator(), n_links);

      double within = 0., unlinked = 0.;
      for (const Textile::FiberAxis &axis : axes)
        for (unsigned int i = 0; i + 1 < axis.points.size(); ++i)
          {
            const Tensor<1, 3> piece = axis.points[i + 1] - axis.points[i];
            const unsigned int cell =
              mesh->locate(axis.points[i] + 0.5 * piece).cell;
            if (cell == Textile::no_cell)
              continue;
            within += piece.norm();
            unlinked += n_links[cell] == 0 ? piece.norm() : 0.;
          }
      return within > 0. ? unlinked / within : 0.;
    }



    unsigned int
    Matrix::count_outside() const
    {
      const Textile::LayeredGrid &grid = mesh->grid();
      return std::count_if(
        axes.begin(), axes.end(), [&](const Textile::FiberAxis &axis) {
          return std::none_of(axis.points.begin(),
                              axis.points.end(),
                              [&](const Tensor<1, 3> &point) {
                                return grid.locate(point).cell !=
                                       Textile::no_cell;
                              });
        });
    }



    std::vector<double>
    Matrix::find_doubled_parts()
    {
      Textile::FiberVolumes       volumes = Textile::fiber_volumes(*mesh, axes);
      const Textile::LayeredGrid &grid    = mesh->grid();
      counted.doubled_volume =
        std::accumulate(volumes.in_cells.begin(), volumes.in_cells.end(), 0.);
      counted.ply_thickness = grid.mean_thickness();
      counted.ply_volume_fraction =
        volumes.in_grid / (grid.columns().area() * counted.ply_thickness);
      for (unsigned int c = 0; c < volumes.in_cells.size(); ++c)
        volumes.in_cells[c] /= mesh->volume(c);
      return volumes.in_cells;
    }
  } // namespace Simulation
} // namespace Heddle
