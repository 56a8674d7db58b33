#include <heddle/beam/section_rotation.h>

#include <Eigen/Geometry>

namespace Heddle
{
  namespace Beam
  {
    namespace
    {
      Eigen::Vector3d
      vector(const Tensor<1, 3> &v)
      {
        return {v[0], v[1], v[2]};
      }



      /** Along the first vector, across it in their plane, and normal to it. */
      Eigen::Matrix3d
      frame(const Tensor<1, 3> *vectors)
      {
        Eigen::Matrix3d axes;
        axes.col(0) = vector(vectors[0]).normalized();
        axes.col(2) = axes.col(0).cross(vector(vectors[1])).normalized();
        axes.col(1) = axes.col(2).cross(axes.col(0));
        return axes;
      }
    } // namespace



    Tensor<1, 3>
    section_rotation(const unsigned int  n_vectors,
                     const Tensor<1, 3> *before,
                     const Tensor<1, 3> *after)
    {
      const Eigen::AngleAxisd turn(
        n_vectors == 1
          ? Eigen::Quaterniond::FromTwoVectors(vector(*before), vector(*after))
              .toRotationMatrix()
          : Eigen::Matrix3d(frame(after) * frame(before).transpose()));
      const Eigen::Vector3d rotation = turn.angle() * turn.axis();
      return Tensor<1, 3>({rotation[0], rotation[1], rotation[2]});
    }
  } // namespace Beam
} // namespace Heddle
