// Files in which Z points up, or whose people stand on their heads, turned so that Y does.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/length_unit.h"
#include "rigless/motion/joint_roles.h"

namespace rigless::detail {

// Z if head and hips are, on average over the clip, above the feet along Z rather than Y, and the skeleton at rest (J,
// file units, or empty; ParseNotes::rest) does not itself stand along Y, as that of a man who lies down does. Minus
// where body and rest are upside down. Where names do not tell, or the body leans too much to tell, as a dog does, Z if
// its lowest joint stays level along Z and not along Y. Y in doubt. Allocates scratch.
template <class S>
UpAxis guess_up_axis(const Clip<S>& clip, const JointRoles& roles, Span<const Vec3<double>> rest);

// Turns the whole world about X so that the axis becomes Y: Z by -90 degrees, Y becoming -Z. The root's axes turn with
// it at rest, so that an upright root stays the identity and its yaw stays its yaw. Does not allocate.
template <class S>
void turn_upright(Clip<S>& clip, UpAxis up);

// ---------------------------------------------------------------------------------------------------------------------

// From the feet to the head, and to the hips, over J positions: a dog's head is before it and its hips are above.
template <class S>
Vec3<double> body_up(const JointRoles& roles, const Vec3<S>* positions) {
  const auto at = [&](std::int32_t joint) -> Vec3<double> {
    return positions[static_cast<std::size_t>(joint)].template cast<double>();
  };
  return at(roles.head) + at(roles.root) - at(roles.left.ankle) - at(roles.right.ankle);
}

// The value below which so many tenths of all lie. Reorders them.
inline double tenth(std::vector<double>& values, std::size_t tenths) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * tenths / 10);
  std::nth_element(values.begin(), at, values.end());  // std::sort would bring a kilobyte of wasm
  return *at;
}

// How much the lowest joint along an axis goes up and down, by the size of the body: nearly nothing along the one that
// is up, for whoever walks on a floor. Without the tenths at either end, which are jumps. Allocates scratch.
template <class S>
double unevenness(const Clip<S>& clip, Eigen::Index axis) {
  std::vector<double> lowest;
  double size = 1e-30;  // of all frames
  for (std::int32_t f = 0; f < clip.frames; ++f) {
    Vec3<double> low = clip.at(f, 0).template cast<double>(), high = low;
    for (std::int32_t j = 1; j < clip.joints(); ++j) {
      const Vec3<double> p = clip.at(f, j).template cast<double>();
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    lowest.push_back(low[axis]);
    size += (high - low).maxCoeff();
  }
  return (tenth(lowest, 9) - tenth(lowest, 1)) * static_cast<double>(clip.frames) / size;
}

template <class S>
UpAxis guess_up_axis(const Clip<S>& clip, const JointRoles& roles, Span<const Vec3<double>> rest) {
  constexpr double level = 0.06, uneven = 0.12;  // real files: .025 at most, .17 at least
  const std::size_t joints = clip.skeleton.names.size();
  const auto by_level = [&] {
    return clip.frames > 10 && unevenness(clip, 2) < level && unevenness(clip, 1) > uneven ? UpAxis::z : UpAxis::y;
  };
  if (roles.head < 0 || roles.left.ankle < 0 || roles.right.ankle < 0) return by_level();
  Vec3<double> up = Vec3<double>::Zero();
  for (std::size_t i = 0; i < clip.positions.size(); i += joints) up += body_up(roles, clip.positions.data() + i);
  const Vec3<double> rest_up = rest.size() == joints ? body_up(roles, rest.data()) : up;
  const bool rests_along_y =
      std::abs(rest_up.y()) > std::abs(rest_up.x()) && std::abs(rest_up.y()) > std::abs(rest_up.z());
  if (std::abs(up.z()) > 2 * std::abs(up.y()) && std::abs(up.z()) > std::abs(up.x())) {
    if (rest.size() == joints && rests_along_y) return UpAxis::y;
    return up.z() < 0 && rest_up.z() < 0 ? UpAxis::minus_z : UpAxis::z;
  }
  if (std::abs(up.y()) > 2 * std::abs(up.z())) return up.y() < 0 && rest_up.y() < 0 ? UpAxis::minus_y : UpAxis::y;
  return std::abs(rest_up.y()) > 2 * std::abs(rest_up.z()) ? UpAxis::y : by_level();
}

template <class S>
void turn_upright(Clip<S>& clip, UpAxis up) {
  using Quaternion = Eigen::Quaternion<S>;
  if (up == UpAxis::z || up == UpAxis::minus_z) {
    for (Vec3<S>& p : clip.positions) p = Vec3<S>(p.x(), p.z(), -p.y());
    for (Quaternion& q : clip.root_rotation) q = Quaternion(q.w(), q.x(), q.z(), -q.y());
  }
  if (up == UpAxis::minus_y || up == UpAxis::minus_z) {
    for (Vec3<S>& p : clip.positions) p = Vec3<S>(p.x(), -p.y(), -p.z());
    for (Quaternion& q : clip.root_rotation) q = Quaternion(q.w(), q.x(), -q.y(), -q.z());
  }
}

}  // namespace rigless::detail
