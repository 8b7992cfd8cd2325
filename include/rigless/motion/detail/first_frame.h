// How a take begins: without the pose that some programs put in front of it, and not with its back to the viewer.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/body_frame.h"
#include "rigless/motion/joint_roles.h"

namespace rigless::detail {

// Leaves out the first frames that show the skeleton at rest (J, as ParseNotes::rest) where the body jumps from them
// into the take. Answers their number. Does not allocate.
template <class S>
std::int32_t leave_out_pose_in_front(Clip<S>& clip, Span<const Vec3<double>> rest);

// By how much a clip is to be turned about Y whose body begins with its back to +Z, so that it begins facing +Z; 0 for
// others. Radians. No allocation.
template <class S>
double turn_to_viewer(const Clip<S>& clip, const JointRoles& roles);

// Turns a clip about Y. Radians. Does not allocate.
template <class S>
void turn_about_y(Clip<S>& clip, double angle);

// ---------------------------------------------------------------------------------------------------------------------

// A joint seen from the root, in the root's axes.
template <class S>
Vec3<double> from_root(const Clip<S>& clip, std::int32_t frame, std::int32_t joint) {
  const Eigen::Quaternion<S> to_root = clip.root_rotation[static_cast<std::size_t>(frame)].conjugate();
  return (to_root * Vec3<S>(clip.at(frame, joint) - clip.at(frame, 0))).template cast<double>();
}

// How far a joint of a frame is, at most, from where `place` has it against the root.
template <class S, class Place>
double farthest_from(const Clip<S>& clip, std::int32_t frame, Place place) {
  double farthest = 0;
  for (std::int32_t j = 1; j < clip.joints(); ++j)
    farthest = std::max(farthest, (from_root(clip, frame, j) - place(j)).norm());
  return farthest;
}

template <class S>
std::int32_t leave_out_pose_in_front(Clip<S>& clip, Span<const Vec3<double>> rest) {
  constexpr double same = 0.01, jump = 0.1, calm = 0.25;  // of the body; of the body; of the jump
  const std::size_t joints = clip.skeleton.names.size();
  if (rest.size() != joints || clip.frames < 4) return 0;
  double size = 0;
  for (const Vec3<double>& p : rest) size = std::max(size, (p - rest[0]).norm());
  const auto at_rest = [&](std::int32_t j) -> Vec3<double> { return rest[static_cast<std::size_t>(j)] - rest[0]; };
  const auto step = [&](std::int32_t f) {  // from frame f to the next
    return farthest_from(clip, f + 1, [&](std::int32_t j) { return from_root(clip, f, j); });
  };
  std::int32_t posed = 0;
  const std::int32_t most = std::min(clip.frames - 3, static_cast<std::int32_t>(clip.fps));
  while (posed < most && farthest_from(clip, posed, at_rest) < same * size) ++posed;
  if (posed == 0 || posed == most) return 0;
  const double leap = step(posed - 1);
  if (!(leap > jump * size && std::max(step(posed), step(posed + 1)) < calm * leap)) return 0;
  clip.positions.erase(clip.positions.begin(),
                       clip.positions.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(posed) * joints));
  clip.root_rotation.erase(clip.root_rotation.begin(), clip.root_rotation.begin() + posed);
  clip.frames -= posed;
  return posed;
}

template <class S>
double turn_to_viewer(const Clip<S>& clip, const JointRoles& roles) {
  constexpr double side = 1.9;  // radians: a little more than a quarter turn
  if (!roles.known() || clip.frames == 0) return 0;
  const Eigen::Quaternion<S>& q = clip.root_rotation[0];
  const double yaw = std::remainder(2 * std::atan2(static_cast<double>(q.y()), static_cast<double>(q.w())),
                                    2 * 3.14159265358979323846);
  return std::abs(yaw) > side ? -yaw : 0;
}

template <class S>
void turn_about_y(Clip<S>& clip, double angle) {
  if (angle == 0) return;
  const Eigen::Quaternion<S> turn(Eigen::AngleAxis<S>(static_cast<S>(angle), Vec3<S>::UnitY()));
  for (Vec3<S>& p : clip.positions) p = turn * p;
  for (Eigen::Quaternion<S>& r : clip.root_rotation) r = (turn * r).normalized();
}

}  // namespace rigless::detail
