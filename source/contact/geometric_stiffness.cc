#include <heddle/contact/geometric_stiffness.h>

namespace Heddle
{
  namespace Contact
  {
    namespace
    {
      /** Of h over its value between straight fibers. */
      constexpr double least_convexity = 0.2;

      /** Particles so close to an end, in radii, are those of the end. */
      constexpr double at_end = 1e-9;

      bool
      is_end(const Curve &curve, const double s)
      {
        const double tolerance = at_end * curve.radius;
        return s < tolerance || s > curve.length() - tolerance;
      }
    } // namespace



    SymmetricTensor<2, 3>
    geometric_stiffness(const Curve          &a,
                        const Curve          &b,
                        const ContactElement &element,
                        const double          distance)
    {
      const Tensor<1, 3>   &normal = element.normal;
      SymmetricTensor<2, 3> turns =
        unit_symmetric_tensor<3>() - symmetrize(outer_product(normal, normal));
      if (!is_end(a, element.s_a) && !is_end(b, element.s_b))
        {
          unsigned int in_a     = a.interval(element.s_a),
                       in_b     = b.interval(element.s_b);
          const CurvePoint on_a = a.evaluate(element.s_a, in_a),
                           on_b = b.evaluate(element.s_b, in_b);
          const Tensor<1, 3> along =
            on_a.tangent + double(element.orientation) * on_b.tangent;
          const double straight = along * along;
          const double convexity =
            straight + distance * (normal * (on_a.curvature - on_b.curvature));
          if (convexity < least_convexity * straight)
            return {};
          turns -= symmetrize(outer_product(along, along)) / convexity;
        }
      return -element.force / distance * turns;
    }
  } // namespace Contact
} // namespace Heddle
