// Which joint is the left ankle: by name in any vocabulary, by the tree and its bones where names say nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rigless/motion/clip.h"
#include "rigless/motion/detail/body_frame.h"
#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/role_finder.h"

namespace rigless {

// By names, as read_joint_names() reads them, of which the tree keeps those that lie along one limb; gaps are filled
// from the joints above and below. Allocates scratch.
inline JointRoles find_joint_roles(const Skeleton& skeleton);

// The same, checked against the lengths of the bones; limbs without names by the tree: two equal chains that start at
// the hips are the legs, two higher up the arms, the end between these the head, and left is left of where the toes
// point. In any axes and lengths. Allocates scratch.
template <class S>
JointRoles find_joint_roles(const Clip<S>& clip);

// ---------------------------------------------------------------------------------------------------------------------

inline JointRoles find_joint_roles(const Skeleton& skeleton) { return detail::RoleFinder(skeleton).find(); }

template <class S>
JointRoles find_joint_roles(const Clip<S>& clip) {
  if (clip.frames == 0) return find_joint_roles(clip.skeleton);
  constexpr std::int32_t enough = 32;  // frames
  const std::int32_t step = (clip.frames + enough - 1) / enough;
  const std::vector<S> yaw = detail::body_yaw(clip);
  std::vector<Vec3<double>> positions;
  for (std::int32_t f = 0; f < clip.frames; f += step) {
    for (std::int32_t j = 0; j < clip.joints(); ++j) {
      const S turn = yaw[static_cast<std::size_t>(f)];
      positions.push_back(detail::to_body<S>(clip.at(f, j), clip.at(f, 0), turn).template cast<double>());
    }
  }
  return detail::RoleFinder(clip.skeleton).find(detail::Poses(std::move(positions), clip.skeleton.names.size()));
}

}  // namespace rigless
