// Forelegs: hands on the ground. They step with the foot across, as in a trot, until the human raises the hand.
#pragma once

#include <algorithm>

#include "rigless/math/detail/smooth_step.h"
#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/motion/joint_roles.h"

namespace rigless::detail {

// 0 for a hand that hangs or swings, 1 for one above the shoulder. pose: J.
template <class S>
S raised(const Vec3<S>* pose, const LimbRoles& arm) {
  if (arm.shoulder < 0 || arm.hand < 0) return S(0);
  const Vec3<S>&shoulder = pose[arm.shoulder], &hand = pose[arm.hand];
  const S reach =
      arm.elbow < 0 ? (hand - shoulder).norm() : (pose[arm.elbow] - shoulder).norm() + (hand - pose[arm.elbow]).norm();
  const S up = (hand.y() - shoulder.y()) / std::max(reach, S(1e-6));
  return smooth_step((up + S(0.6)) / S(0.8));
}

}  // namespace rigless::detail
