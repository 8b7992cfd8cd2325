// Files in which Z points up, turned so that Y does.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/length_unit.h"
#include "rigless/motion/joint_roles.h"

namespace rigless::detail {

// Z if the head is, on average over the clip, above the feet along +Z rather than Y, and the skeleton at rest (J, file
// units, or empty; ParseNotes::rest) does not itself stand along Y, as that of a man who lies down does. Y in doubt.
// Does not allocate.
template <class S>
UpAxis guess_up_axis(const Clip<S>& clip, const JointRoles& roles, Span<const Vec3<double>> rest);

// Turns the whole world by -90 degrees about X: Z becomes Y, Y becomes -Z. The root's axes turn with it at rest, so
// that an upright root stays the identity and its yaw stays its yaw. Does not allocate.
template <class S>
void turn_z_up_to_y_up(Clip<S>& clip);

// ---------------------------------------------------------------------------------------------------------------------

// From the feet to the head, over J positions.
template <class S>
Vec3<double> body_up(const JointRoles& roles, const Vec3<S>* positions) {
  const auto at = [&](std::int32_t joint) -> Vec3<double> {
    return positions[static_cast<std::size_t>(joint)].template cast<double>();
  };
  return at(roles.head) - (at(roles.left.ankle) + at(roles.right.ankle)) / 2;
}

template <class S>
UpAxis guess_up_axis(const Clip<S>& clip, const JointRoles& roles, Span<const Vec3<double>> rest) {
  if (roles.head < 0 || roles.left.ankle < 0 || roles.right.ankle < 0) return UpAxis::y;
  const std::size_t joints = clip.skeleton.names.size();
  Vec3<double> up = Vec3<double>::Zero();
  for (std::size_t i = 0; i < clip.positions.size(); i += joints) up += body_up(roles, clip.positions.data() + i);
  if (!(up.z() > 2 * std::abs(up.y()) && up.z() > std::abs(up.x()))) return UpAxis::y;
  if (rest.size() != joints) return UpAxis::z;
  const Vec3<double> rest_up = body_up(roles, rest.data());
  const bool stands_along_y = rest_up.y() > std::abs(rest_up.x()) && rest_up.y() > std::abs(rest_up.z());
  return stands_along_y ? UpAxis::y : UpAxis::z;
}

template <class S>
void turn_z_up_to_y_up(Clip<S>& clip) {
  for (Vec3<S>& p : clip.positions) p = Vec3<S>(p.x(), p.z(), -p.y());
  for (Eigen::Quaternion<S>& q : clip.root_rotation) q = Eigen::Quaternion<S>(q.w(), q.x(), q.z(), -q.y());
}

}  // namespace rigless::detail
