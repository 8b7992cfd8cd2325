// What a user says of a motion file where the guesses are wrong.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "rigless/motion/clip.h"
#include "rigless/motion/detail/body_parts.h"

namespace rigless::detail {

struct Corrections {
  double metres_per_unit = 0;  // of the file; 0: guessed
  double fps = 0;              // 0: the file's
  std::int32_t up = -1;        // an UpAxis; -1: guessed
  std::int32_t turns = 0;      // quarter turns about the vertical, counter-clockwise from above
  std::array<std::string_view, 6>
      joints;  // names: hips, head, left and right hand, left and right foot; empty: guessed

  std::string_view hips() const { return joints[0]; }
};

// -1: no joint is called so.
inline std::int32_t joint_named(const Skeleton& skeleton, std::string_view name) {
  for (std::size_t j = 0; j < skeleton.names.size(); ++j)
    if (skeleton.names[j] == name) return static_cast<std::int32_t>(j);
  return -1;
}

// The roles with those that are said: the two joints above a hand or a foot go with it, and what hangs on a foot.
inline void correct_roles(const Skeleton& skeleton, const Corrections& said, JointRoles& roles) {
  const auto above = [&](std::int32_t j) { return j < 0 ? -1 : skeleton.parents[static_cast<std::size_t>(j)]; };
  const auto below = [&](std::int32_t j) {
    const auto child = std::find(skeleton.parents.begin(), skeleton.parents.end(), j);
    return j < 0 || child == skeleton.parents.end() ? -1 : static_cast<std::int32_t>(child - skeleton.parents.begin());
  };
  for (std::size_t k = 0; k < said.joints.size(); ++k) {
    const std::int32_t joint = said.joints[k].empty() ? -1 : joint_named(skeleton, said.joints[k]);
    if (joint < 0) continue;
    LimbRoles& limb = k % 2 == 0 ? roles.left : roles.right;
    if (k == 0) roles.root = joint;
    if (k == 1) roles.head = joint;
    if (k == 2 || k == 3) {
      limb.hand = joint;
      limb.elbow = above(joint);
      limb.shoulder = above(limb.elbow);
      limb.collar = -1;
    }
    if (k >= 4) {
      limb.ankle = joint;
      limb.knee = above(joint);
      limb.hip = above(limb.knee);
      limb.toe = below(joint);
      limb.tip = below(limb.toe);
    }
  }
}

}  // namespace rigless::detail
