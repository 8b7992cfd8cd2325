// A motion as a mirror shows it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/motion/clip.h"
#include "rigless/motion/detail/mirror_joints.h"

namespace rigless::detail {

// Reflects a clip as standardise() leaves it, whose left is +X, and lets each joint do what its partner did. Allocates
// scratch.
template <class S>
void mirror_clip(Clip<S>& clip, const JointRoles& roles) {
  const std::vector<std::int32_t> partner = mirror_joints(clip.skeleton, roles);
  const std::vector<Vec3<S>> was = clip.positions;
  for (std::size_t i = 0; i < was.size(); ++i) {
    const std::size_t j = i % partner.size();
    const Vec3<S>& p = was[i - j + static_cast<std::size_t>(partner[j])];
    clip.positions[i] = Vec3<S>(-p.x(), p.y(), p.z());
  }
  for (Eigen::Quaternion<S>& q : clip.root_rotation) q = Eigen::Quaternion<S>(q.w(), q.x(), -q.y(), -q.z());
}

}  // namespace rigless::detail
