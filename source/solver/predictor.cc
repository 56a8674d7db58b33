#include <heddle/solver/predictor.h>

#include <deal.II/base/exceptions.h>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** A parabola has so many points. */
      constexpr unsigned int most_points = 3;

      std::string
      entry(const unsigned int i, const std::string &name)
      {
        return "predictor/point-" + std::to_string(i) + "/" + name;
      }
    } // namespace



    void
    Predictor::begin(const System::State &state)
    {
      points.clear();
      add(state);
    }



    void
    Predictor::add(const System::State &state)
    {
      Assert(points.empty() || points.back().load_factor < state.load_factor,
             ExcMessage("Load factors do not ascend."));
      const auto first = state.current().begin();
      points.push_back(
        {state.load_factor, {first, first + state.n_owned_blocks()}});
      if (points.size() > most_points)
        points.erase(points.begin());
    }



    System::Increment
    Predictor::guess(const System::State &state) const
    {
      if (points.size() < 2)
        return {};

      // Lagrange's polynomial.
      System::Increment motion(state.n_owned_blocks());
      for (const Point &point : points)
        {
          double weight = 1.;
          for (const Point &other : points)
            if (&other != &point)
              weight *= (state.load_factor - other.load_factor) /
                        (point.load_factor - other.load_factor);
          for (unsigned int b = 0; b < motion.size(); ++b)
            motion[b] += weight * point.blocks[b];
        }
      for (unsigned int b = 0; b < motion.size(); ++b)
        motion[b] -= state.current()[b];
      return motion;
    }



    void
    Predictor::save(ArchiveWriter            &archive,
                    const System::FiberSpace &space) const
    {
      archive.write_number("predictor/n_points", points.size());
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          archive.write_number(entry(i, "load factor"), points[i].load_factor);
          std::vector<double> values;
          for (const Tensor<1, 3> &block : points[i].blocks)
            values.insert(values.end(), block.begin_raw(), block.end_raw());
          archive.write(entry(i, "blocks"),
                        space.owned_blocks().first,
                        space.n_blocks(),
                        values,
                        3);
        }
    }



    void
    Predictor::load(const ArchiveReader      &archive,
                    const System::FiberSpace &space)
    {
      points.resize(archive.read_number("predictor/n_points"));
      const auto owned = space.owned_blocks();
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          points[i].load_factor = archive.read_number(entry(i, "load factor"));
          points[i].blocks.resize(owned.second - owned.first);
          const std::vector<double> values = archive.read(
            entry(i, "blocks"), owned.first, points[i].blocks.size(), 3);
          for (unsigned int b = 0; b < points[i].blocks.size(); ++b)
            for (unsigned int d = 0; d < 3; ++d)
              points[i].blocks[b][d] = values[3 * b + d];
        }
    }
  } // namespace Solver
} // namespace Heddle
