#include <heddle/solver/predictor.h>
#include <heddle/system/block_archive.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <Eigen/Geometry>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** A parabola has so many points, and one more tells how good it was. */
      constexpr unsigned int most_points = 4;



      std::string
      entry(const unsigned int i, const std::string &name)
      {
        return "predictor/point-" + std::to_string(i) + "/" + name;
      }



      /** Columns: the orthonormal frame of a section, from its two vectors. */
      Eigen::Matrix3d
      frame_of(const Tensor<1, 3> *vectors)
      {
        const Eigen::Map<const Eigen::Vector3d> first(vectors[0].begin_raw()),
          second(vectors[1].begin_raw());
        Eigen::Matrix3d frame;
        frame.col(0) = first.normalized();
        frame.col(2) = first.cross(second).normalized();
        frame.col(1) = frame.col(2).cross(frame.col(0));
        return frame;
      }



      /** From frame @p a to frame @p b [rad]. */
      Eigen::Vector3d
      rotation_vector(const Eigen::Matrix3d &a, const Eigen::Matrix3d &b)
      {
        const Eigen::AngleAxisd rotation(b * a.transpose());
        return rotation.angle() * rotation.axis();
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

      const unsigned int        n = points.size();
      const std::vector<double> weights =
        lagrange(n, n_points_of_guess(state), state.load_factor);
      System::Increment motion(state.n_owned_blocks());
      for (unsigned int b = 0; b < motion.size(); ++b)
        {
          for (unsigned int i = 0; i < points.size(); ++i)
            motion[b] += weights[i] * points[i].blocks[b];
          motion[b] -= state.current()[b];
        }
      if (state.space.n_blocks_per_node() == 3)
        for (unsigned int b = 1; b < state.n_owned_fiber_blocks(); b += 3)
          rotate_section(weights, b, motion.data() + b);
      return motion;
    }



    std::vector<double>
    Predictor::lagrange(const unsigned int end,
                        const unsigned int n,
                        const double       load_factor) const
    {
      std::vector<double> weights(points.size(), 0.);
      for (unsigned int i = end - n; i < end; ++i)
        {
          weights[i] = 1.;
          for (unsigned int j = end - n; j < end; ++j)
            if (i != j)
              weights[i] *= (load_factor - points[j].load_factor) /
                            (points[i].load_factor - points[j].load_factor);
        }
      return weights;
    }



    double
    Predictor::miss(const System::State &state, const unsigned int n) const
    {
      const unsigned int        last = points.size() - 1;
      const std::vector<double> weights =
        lagrange(last, n, points[last].load_factor);
      double sum = 0.;
      for (unsigned int b = 0; b < state.n_owned_fiber_blocks();
           b += state.space.n_blocks_per_node())
        {
          Tensor<1, 3> error = points[last].blocks[b];
          for (unsigned int i = last - n; i < last; ++i)
            error -= weights[i] * points[i].blocks[b];
          sum += error.norm_square();
        }
      return Utilities::MPI::sum(sum, state.space.communicator());
    }



    unsigned int
    Predictor::n_points_of_guess(const System::State &state) const
    {
      return points.size() == most_points && miss(state, 3) < miss(state, 2)
               ? 3
               : 2;
    }



    void
    Predictor::rotate_section(const std::vector<double> &weights,
                              const unsigned int         first,
                              Tensor<1, 3>              *motion) const
    {
      const Tensor<1, 3>   *vectors = points.back().blocks.data() + first;
      const Eigen::Matrix3d frame   = frame_of(vectors);
      Eigen::Vector3d       turned  = Eigen::Vector3d::Zero();
      for (unsigned int i = 0; i + 1 < points.size(); ++i)
        turned +=
          weights[i] *
          rotation_vector(frame, frame_of(points[i].blocks.data() + first));
      const double angle = turned.norm();
      if (angle == 0.)
        {
          motion[0] = motion[1] = Tensor<1, 3>();
          return;
        }
      const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(angle, turned / angle).toRotationMatrix();
      for (unsigned int k = 0; k < 2; ++k)
        for (unsigned int d = 0; d < 3; ++d)
          {
            motion[k][d] = -vectors[k][d];
            for (unsigned int e = 0; e < 3; ++e)
              motion[k][d] += rotation(d, e) * vectors[k][e];
          }
    }



    void
    Predictor::save(ArchiveWriter &archive, const System::State &state) const
    {
      archive.write_number("predictor/n_points", points.size());
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          archive.write_number(entry(i, "load factor"), points[i].load_factor);
          System::write_blocks(
            archive, entry(i, "blocks"), state, points[i].blocks);
        }
    }



    void
    Predictor::load(const ArchiveReader &archive, const System::State &state)
    {
      points.resize(archive.read_number("predictor/n_points"));
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          points[i].load_factor = archive.read_number(entry(i, "load factor"));
          points[i].blocks =
            System::read_blocks(archive, entry(i, "blocks"), state);
        }
    }
  } // namespace Solver
} // namespace Heddle
