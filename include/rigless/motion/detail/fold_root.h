// Joints above the hips ("Reference", "Armature", "root"), whose motion becomes that of the hips.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "rigless/math/types.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/body_tree.h"
#include "rigless/motion/detail/corrections.h"
#include "rigless/motion/detail/role_finder.h"
#include "rigless/motion/detail/skeleton_tree.h"

namespace rigless::detail {

// What a clip keeps of a file's joints: the hips, which become joint 0, and all that hangs on them.
struct KeptJoints {
  std::vector<std::int32_t> joints;  // ascending, the hips first
  std::int32_t above = 0;            // joints above the hips

  std::size_t hips() const { return static_cast<std::size_t>(joints[0]); }
};

// All joints, unless the joints of the body can be told and the hips, which carry more than half of all, are not the
// root. `pose`: J, joint positions of any frame; `said`: what the hips are called, or empty. Allocates.
inline KeptJoints joints_from_hips(const Skeleton& skeleton, const std::vector<Vec3<double>>& pose,
                                   std::string_view said) {
  const SkeletonTree tree(skeleton);
  const JointRoles roles = RoleFinder(skeleton).find(Poses(pose, pose.size()));
  const std::int32_t own = said.empty() ? -1 : joint_named(skeleton, said);
  const std::int32_t hips = own < 0 ? roles.root : own;
  const bool fold = own >= 0 || (roles.known() && 2 * tree.size(hips) > tree.joints());
  KeptJoints kept;
  for (std::int32_t j = 0; j < tree.joints(); ++j) {
    if (!fold || tree.within(j, hips)) kept.joints.push_back(j);
    if (fold && tree.below(hips, j)) ++kept.above;
  }
  return kept;
}

// The skeleton of the kept joints alone. Allocates.
inline Skeleton kept_skeleton(const Skeleton& skeleton, const KeptJoints& kept) {
  Skeleton result;
  std::vector<std::int32_t> new_index(skeleton.names.size(), -1);
  for (const std::int32_t j : kept.joints) {
    const auto old = static_cast<std::size_t>(j);
    const std::int32_t parent = skeleton.parents[old];
    new_index[old] = static_cast<std::int32_t>(result.names.size());
    result.names.push_back(skeleton.names[old]);
    result.parents.push_back(parent < 0 ? -1 : new_index[static_cast<std::size_t>(parent)]);
  }
  return result;
}

}  // namespace rigless::detail
