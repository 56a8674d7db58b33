#ifndef heddle_tests_textile_woven_fabric_h
#define heddle_tests_textile_woven_fabric_h

#include <heddle/textile/fiber_axis.h>
#include <heddle/textile/weave.h>

#include <string>
#include <vector>

/** The crimped start of a small fabric, as the mesh of a matrix sees it. */
struct WovenFabric
{
  static constexpr double radius = 0.0045;

  std::vector<Heddle::Textile::FiberAxis> fibers;
  std::vector<dealii::Tensor<1, 3>>       nodes;

  WovenFabric(const std::string &pattern,
              const unsigned int n_yarns   = 4,
              const unsigned int n_bundles = 1)
  {
    Heddle::Textile::WeaveDescription description;
    description.pattern                = pattern;
    description.warp.n_yarns           = n_yarns;
    description.warp.packing.n_bundles = n_bundles;
    description.warp.packing.radius    = radius;
    description.weft                   = description.warp;
    const Heddle::Textile::Weave weave(description);
    for (const Heddle::Textile::FiberPath &path : weave.paths(60))
      {
        fibers.push_back({path.points, path.radius, path.yarn_id});
        nodes.insert(nodes.end(), path.points.begin(), path.points.end());
      }
  }
};

#endif
