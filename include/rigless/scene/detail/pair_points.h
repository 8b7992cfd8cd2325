// Which joint moves a point: the one that is called so, or that has the role.
#pragma once

#include <string>
#include <string_view>

#include "rigless/mesh/detail/body_points.h"
#include "rigless/motion/joint_roles.h"

namespace rigless {

// The joint of that name, else the one whose part of the body the name means in any of the usual spellings ("left
// foot", "lfoot"); -1 where there is none. Allocates scratch.
inline std::int32_t find_joint(const Skeleton& skeleton, const JointRoles& roles, std::string_view name) {
  for (std::size_t j = 0; j < skeleton.names.size(); ++j)
    if (skeleton.names[j] == name) return static_cast<std::int32_t>(j);
  const Skeleton alone{{std::string(name)}, {-1}};
  const JointRoles meant = find_joint_roles(alone);
  if (meant.head == 0) return roles.head;
  for (const auto limb : {&JointRoles::left, &JointRoles::right}) {
    for (const auto part :
         {&LimbRoles::hip, &LimbRoles::knee, &LimbRoles::ankle, &LimbRoles::toe, &LimbRoles::tip, &LimbRoles::hand})
      if (meant.*limb.*part == 0) return roles.*limb.*part;
  }
  const JointName said = read_joint_name(name);
  const bool root = said.core == "hips" || said.core == "root" || said.core == "pelvis";
  return root ? roles.root : -1;
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
