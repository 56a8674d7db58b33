#ifndef heddle_textile_fiber_path_h
#define heddle_textile_fiber_path_h

#include <heddle/base/polyline.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /** "Belongs to no yarn" and "belongs to no bundle". */
    constexpr unsigned int no_id = std::numeric_limits<unsigned int>::max();

    /**
     * One fiber before any mechanics: where its axis starts from, and whose it
     * is. A list of these is all that the mechanics learns of a textile.
     */
    struct FiberPath
    {
      /**
       * Knots of the axis from which the computation starts, equally spaced in
       * arc length, at least two [mm].
       */
      Polyline points;

      /**
       * Length of the fiber when it is free of stress [mm]. Smaller than the
       * length of the polygon of @p points if the fiber starts stretched.
       */
      double reference_length = 0.;

      /**
       * How far the points that it was read from are from the curve through
       * @p points, at most [mm].
       */
      double missed = 0.;

      /** Points that it was read from at which it turns by more than 90
       * degrees. */
      unsigned int n_turns = 0;

      /** Of the points that it was read from, the two that follow each other
       * at the largest distance [mm]. */
      std::array<Tensor<1, 3>, 2> gap;

      /** Radius of the circular section [mm]. */
      double radius = 0.;

      /** Of the filaments for which it stands [mm]; 0: it is one itself. */
      double filament_radius = 0.;

      /** Density [g/cm^3]; 0: not known, or to be had from its material. */
      double density = 0.;

      /** Number of the yarn; in a weave warp yarns come before weft yarns. */
      unsigned int yarn_id = no_id;

      /** Number of the bundle in its yarn. */
      unsigned int bundle_id = no_id;

      /** Name by which supports and loads find it, "warp" and "weft" here. */
      std::string set;

      /** To be sent to other ranks. */
      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &points &reference_length &missed &n_turns &gap &radius
          &filament_radius &density &yarn_id &bundle_id &set;
      }
    };



    /** Numbers of the fibers of each yarn, by its own number; without those
     * that belong to none. */
    inline std::map<unsigned int, std::vector<unsigned int>>
    fibers_of_yarns(const std::vector<FiberPath> &paths)
    {
      std::map<unsigned int, std::vector<unsigned int>> yarns;
      for (unsigned int f = 0; f < paths.size(); ++f)
        if (paths[f].yarn_id != no_id)
          yarns[paths[f].yarn_id].push_back(f);
      return yarns;
    }
  } // namespace Textile
} // namespace Heddle

#endif
