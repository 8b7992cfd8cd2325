// Which joint moves a point: the one that is called so, or that has the role.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "rigless/mesh/detail/body_points.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/joint_names.h"
#include "rigless/motion/joint_roles.h"

namespace rigless {

// For each name the joint that is called so, else the one that is the part of the body which the name means, in the
// spelling of any skeleton or in plain words ("left foot"); -1 where there is none. Allocates.
inline std::vector<std::int32_t> find_joints(const Skeleton& skeleton, const JointRoles& roles,
                                             const std::vector<std::string>& names) {
  std::vector<std::int32_t> joints;
  for (const JointName& said : read_joint_names(names)) {
    const auto same = std::find(skeleton.names.begin(), skeleton.names.end(), names[joints.size()]);
    const bool called_so = same != skeleton.names.end();
    joints.push_back(called_so ? static_cast<std::int32_t>(same - skeleton.names.begin())
                               : roles.find(said.side, said.part));
  }
  return joints;
}

// The joint that moves a point of the body, or -1: the whole pose. A body on four legs trots: a foreleg goes with the
// foot across. No allocation.
template <class S>
std::int32_t joint_of_point(const JointRoles& roles, const BodyPoint<S>& point) {
  if (point.role == BodyRole::head) return roles.head;
  if (point.role == BodyRole::hips) return roles.root;
  if (point.side == 0) return -1;
  const LimbRoles& near = point.side > 0 ? roles.left : roles.right;
  const LimbRoles& across = point.side > 0 ? roles.right : roles.left;
  if (point.role == BodyRole::hand) return near.hand;
  if (point.role == BodyRole::foot) return near.ankle;
  if (point.role == BodyRole::foreleg) return across.ankle;
  return -1;
}

}  // namespace rigless
