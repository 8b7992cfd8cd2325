// A motion as positions: what every parser gives and everything after it takes.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "rigless/math/types.h"

namespace rigless {

// J joints in hierarchy order: a parent comes before its children, joint 0 is the root (parent -1).
struct Skeleton {
  std::vector<std::string> names;     // J, unique
  std::vector<std::int32_t> parents;  // J
};

// T frames of J joint positions in world space.
template <class S>
struct Clip {
  Skeleton skeleton;
  S fps = 0;                                        // frames per second
  S metres_per_unit = 0;                            // what the file's lengths were multiplied by
  std::int32_t frames = 0;                          // T
  std::vector<Vec3<S>> positions;                   // T x J, frame by frame, metres
  std::vector<Eigen::Quaternion<S>> root_rotation;  // T, unit, the root joint's world orientation

  std::int32_t joints() const { return static_cast<std::int32_t>(skeleton.names.size()); }
  const Vec3<S>& at(std::int32_t frame, std::int32_t joint) const {
    return positions[static_cast<std::size_t>(frame) * skeleton.names.size() + static_cast<std::size_t>(joint)];
  }
};

}  // namespace rigless
