// The human as starters know it: what part of the body moves each control, and how it stands upright.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/detail/rotation.h"
#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/motion/joint_roles.h"
#include "rigless/retarget/detail/foreleg.h"

namespace rigless::detail {

enum class FollowedPart : std::int32_t { trunk, head, arm, leg };

// What a joint hangs on: of a hand the arm, whose base is the shoulder.
template <class S>
struct FollowedLimb {
  FollowedPart part = FollowedPart::trunk;
  std::int32_t base = 0;  // joint
  S reach = 0;            // from there to the joint along the bones
};

// How a trunk leans forward, to its left, and turns its shoulders against its hips; radians.
template <class S>
struct TrunkPose {
  S pitch = 0, roll = 0, twist = 0;
};

// Turned first, then bent over in the direction in which it leans.
template <class S>
Eigen::Quaternion<S> trunk_rotation(const TrunkPose<S>& trunk) {
  const S lean = std::hypot(trunk.pitch, trunk.roll);
  const Vec3<S> axis(trunk.pitch, S(0), -trunk.roll);
  const Eigen::AngleAxis<S> turn(trunk.twist, Vec3<S>::UnitY());
  if (!(lean > S(1e-6))) return Eigen::Quaternion<S>(turn);
  return Eigen::AngleAxis<S>(lean, axis / lean) * turn;
}

template <class S>
class StarterFigure {
 public:
  StarterFigure() = default;

  // clip: T x J, body-local. Allocates.
  RIGLESS_COLD StarterFigure(Span<const Vec3<S>> clip, const Skeleton& skeleton, const JointRoles& roles)
      : roles_(roles), joints_(skeleton.names.size()) {
    limbs_.resize(joints_);
    for (std::int32_t j = 0; j < count_of(skeleton.names); ++j) {
      FollowedLimb<S>& limb = nth(limbs_, j);
      S reach = 0;
      for (std::int32_t at = j; at >= 0; at = nth(skeleton.parents, at)) {
        const FollowedPart part = part_from(at);
        if (part != FollowedPart::trunk) {
          if (at != j) limb = {part, at, reach};
          break;
        }
        const std::int32_t parent = nth(skeleton.parents, at);
        if (parent >= 0 && !clip.empty()) reach += (nth(clip, at) - nth(clip, parent)).norm();
      }
    }
    top_ = roles.neck >= 0 ? roles.neck : roles.chest >= 0 ? roles.chest : roles.head;
    if (roles.head < 0 || top_ < 0) return;
    Vec3<S> sum = Vec3<S>::Zero();
    for (std::size_t i = 0; i + joints_ <= clip.size(); i += joints_) sum += nape(&clip[i]).normalized();
    if (sum.norm() > S(1e-6)) usual_nape_ = sum.normalized();
  }

  // Of joint j, or of none (-1).
  FollowedLimb<S> limb(std::int32_t j) const {
    return j < 0 || to_size(j) >= limbs_.size() ? FollowedLimb<S>() : nth(limbs_, j);
  }

  // No allocation.
  RIGLESS_COLD TrunkPose<S> trunk(const Vec3<S>* pose) const {
    TrunkPose<S> trunk;
    if (top_ > 0) {
      const Vec3<S>& top = pose[top_];
      const S up = std::max(top.y(), S(1e-6));
      trunk.pitch = std::atan2(top.z(), up);
      trunk.roll = std::atan2(top.x(), up);
    }
    if (roles_.left.shoulder >= 0 && roles_.right.shoulder >= 0) {
      const Vec3<S> across = pose[roles_.left.shoulder] - pose[roles_.right.shoulder];
      trunk.twist = std::atan2(-across.z(), std::max(across.x(), S(1e-6)));
    }
    return trunk;
  }

  // How far the left foot is before the right, and the hips to the left of both: in legs, about -1 to 1. No allocation.
  RIGLESS_COLD S stride(const Vec3<S>* pose) const {
    const std::int32_t left = roles_.left.ankle, right = roles_.right.ankle;
    if (left < 0 || right < 0) return S(0);
    const Vec3<S>&l = pose[left], &r = pose[right];
    const S leg = std::max(nth(limbs_, left).reach, S(1e-6));
    return std::tanh((l.z() - r.z() - S(1.5) * (l.x() + r.x())) / leg);
  }

  // Of a limb that is an arm: how far its hand is raised, see detail::raised(). No allocation.
  S raised(const Vec3<S>* pose, const FollowedLimb<S>& arm) const {
    return detail::raised(pose, arm.base == roles_.left.shoulder ? roles_.left : roles_.right);
  }

  // Of a limb that is an arm: from the hip across to its ankle, in lengths of that leg; straight down where there is
  // none. No allocation.
  Vec3<S> across(const Vec3<S>* pose, const FollowedLimb<S>& arm) const {
    const LimbRoles& leg = arm.base == roles_.left.shoulder ? roles_.right : roles_.left;
    if (leg.hip < 0 || leg.ankle < 0) return -Vec3<S>::UnitY();
    return (pose[leg.ankle] - pose[leg.hip]) / std::max(nth(limbs_, leg.ankle).reach, S(1e-6));
  }

  // How the head is turned on the trunk, from how it mostly is. No allocation.
  RIGLESS_COLD Eigen::Quaternion<S> nod(const Vec3<S>* pose) const {
    if (roles_.head < 0 || top_ < 0 || top_ == roles_.head) return Eigen::Quaternion<S>::Identity();
    return Eigen::Quaternion<S>(shortest_arc<S>(usual_nape_, nape(pose).normalized()));
  }

 private:
  FollowedPart part_from(std::int32_t joint) const {
    if (joint == roles_.left.shoulder || joint == roles_.right.shoulder) return FollowedPart::arm;
    if (joint == roles_.left.hip || joint == roles_.right.hip) return FollowedPart::leg;
    if (joint == roles_.neck) return FollowedPart::head;
    return FollowedPart::trunk;
  }

  // From the top of the trunk to the head, as the trunk sees it.
  Vec3<S> nape(const Vec3<S>* pose) const {
    const TrunkPose<S> t = trunk(pose);
    return trunk_rotation(t).conjugate() * (pose[roles_.head] - pose[top_]);
  }

  JointRoles roles_;
  std::size_t joints_ = 0;
  std::int32_t top_ = -1;               // joint at the upper end of the trunk
  std::vector<FollowedLimb<S>> limbs_;  // J
  Vec3<S> usual_nape_ = Vec3<S>::UnitY();
};

}  // namespace rigless::detail
