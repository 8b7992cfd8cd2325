// Root joints whose own axes are not the body's, turned so that yaw 0 means facing +Z.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "rigless/math/types.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/joint_roles.h"

namespace rigless::detail {

// Gives the root new axes, X to the body's left and Y to its head, by the quarter turns nearest to where the hips and
// the head are on average; false, and nothing changes, if they are there already or the roles are missing. Some
// programs let the root's X point up, and the twist about Y of such a root is not the body's heading. Positions stay.
// Does not allocate.
template <class S>
bool align_root_axes(Clip<S>& clip, const JointRoles& roles);

// ---------------------------------------------------------------------------------------------------------------------

// The coordinate axis nearest to `v`, other than +-`taken`.
inline Vec3<double> nearest_axis(const Vec3<double>& v, const Vec3<double>& taken) {
  const Vec3<double> size = v.cwiseAbs() - 1e30 * taken.cwiseAbs();
  Eigen::Index k = 0;
  size.maxCoeff(&k);
  Vec3<double> axis = Vec3<double>::Zero();
  axis[k] = v[k] < 0 ? -1 : 1;
  return axis;
}

template <class S>
bool align_root_axes(Clip<S>& clip, const JointRoles& roles) {
  if (roles.head < 0 || roles.left.hip < 0 || roles.right.hip < 0) return false;
  Vec3<double> left = Vec3<double>::Zero();
  Vec3<double> up = Vec3<double>::Zero();
  for (std::int32_t f = 0; f < clip.frames; ++f) {
    const Eigen::Quaternion<S> to_root = clip.root_rotation[static_cast<std::size_t>(f)].conjugate();
    const Vec3<S> hips = to_root * Vec3<S>(clip.at(f, roles.left.hip) - clip.at(f, roles.right.hip));
    const Vec3<S> trunk = to_root * Vec3<S>(clip.at(f, roles.head) - clip.at(f, 0));
    left += hips.template cast<double>().stableNormalized();
    up += trunk.template cast<double>().stableNormalized();
  }
  if (!(left.norm() > 0.1 * clip.frames) || !(up.norm() > 0.1 * clip.frames)) return false;

  Mat3<double> axes;
  axes.col(1) = nearest_axis(up, Vec3<double>::Zero());
  axes.col(0) = nearest_axis(left, axes.col(1));
  axes.col(2) = axes.col(0).cross(axes.col(1));
  if (axes.isIdentity()) return false;
  const Eigen::Quaternion<S> turn = Eigen::Quaterniond(axes).cast<S>();
  for (Eigen::Quaternion<S>& q : clip.root_rotation) q = (q * turn).normalized();
  return true;
}

}  // namespace rigless::detail
