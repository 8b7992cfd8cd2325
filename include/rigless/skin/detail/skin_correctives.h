// Morph targets for what joints cannot hold: they act at rest, before the joints do.
// Source: Kry, James and Pai 2002, "EigenSkin: real time large deformation character skinning in hardware".
#pragma once

#include <vector>

#include "rigless/skin/detail/frame_pose.h"
#include "rigless/skin/detail/morph_builder.h"

namespace rigless::detail {

// What the joints of a frame do to a point.
struct BlendedMotion {
  Mat3<double> A = Mat3<double>::Zero();
  Vec3<double> b = Vec3<double>::Zero();
};

// pose: J of a frame.
template <class S>
BlendedMotion blended(const Influences& of, const std::vector<Vec3<S>>& centre, const RigidPose<S>* pose) {
  BlendedMotion out;
  for (int a = 0; a < of.used(); ++a) {
    const auto j = to_size(nth(of.joint, a));
    const Mat3<double> R = pose[j].turn.toRotationMatrix().template cast<double>();
    out.A += nth(of.weight, a) * R;
    out.b += nth(of.weight, a) * (pose[j].place.template cast<double>() - R * centre[j].template cast<double>());
  }
  return out;
}

// Where a point has to be at rest so that its joints take it to p; where these squeeze it flat, as near as that.
inline Vec3<double> before(const BlendedMotion& motion, const Vec3<double>& p) {
  constexpr double flat = 0.05;
  const Vec3<double> q = p - motion.b;
  return (motion.A.transpose() * motion.A + flat * flat * Mat3<double>::Identity())
      .ldlt()
      .solve(motion.A.transpose() * q);
}

}  // namespace rigless::detail
