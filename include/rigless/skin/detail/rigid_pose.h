// Rigid motions as files hold them.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "rigless/math/types.h"

namespace rigless::detail {

template <class S>
struct RigidPose {
  Eigen::Quaternion<S, Eigen::DontAlign> turn;
  Vec3<S> place;
};

// Appends one whose turn has the sign of that `step` before it, so that a track goes the short way.
template <class S>
void add_pose(std::vector<RigidPose<S>>& to, std::size_t step, const Mat3<double>& R, const Vec3<double>& place) {
  Eigen::Quaternion<double> q(R);
  q.normalize();
  Eigen::Quaternion<S, Eigen::DontAlign> turn(q.template cast<S>());
  if (to.size() >= step && to[to.size() - step].turn.dot(turn) < 0) turn.coeffs() = -turn.coeffs();
  to.push_back({turn, place.template cast<S>()});
}

}  // namespace rigless::detail
