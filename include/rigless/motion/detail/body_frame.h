// The body-local frame: the root joint as origin, its yaw removed, nothing else.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/motion/clip.h"

namespace rigless::detail {

// T, radians about +Y: the twist of the root's rotation in its swing-twist decomposition, the first in (-pi, pi], then
// unwrapped so that it never jumps by a turn. A frame in which the root is upside down has none and keeps the last.
// Exact under turns of the whole motion about Y, unlike the direction of the hips. Allocates the result.
template <class S>
std::vector<S> body_yaw(const Clip<S>& clip);

// R_y(-yaw) (p - origin) and back. Do not allocate.
template <class S>
Vec3<S> to_body(const Vec3<S>& p, const Vec3<S>& origin, S yaw);
template <class S>
Vec3<S> from_body(const Vec3<S>& p, const Vec3<S>& origin, S yaw);

// T x J positions in the body-local frame; `yaw` has T entries. Allocates the result.
template <class S>
std::vector<Vec3<S>> body_local_positions(const Clip<S>& clip, Span<const S> yaw);

// ---------------------------------------------------------------------------------------------------------------------

template <class S>
std::vector<S> body_yaw(const Clip<S>& clip) {
  constexpr double turn = 2 * 3.14159265358979323846;
  std::vector<S> yaw;
  yaw.reserve(clip.root_rotation.size());
  double last = 0;  // summed in double: a float would drift over many turns
  for (const Eigen::Quaternion<S>& q : clip.root_rotation) {
    const double w = static_cast<double>(q.w());
    const double y = static_cast<double>(q.y());
    if (w * w + y * y > 1e-12) {
      const double angle = 2 * std::atan2(y, w);
      last = angle + turn * std::round((last - angle) / turn);
    }
    yaw.push_back(static_cast<S>(last));
  }
  return yaw;
}

template <class S>
Vec3<S> to_body(const Vec3<S>& p, const Vec3<S>& origin, S yaw) {
  const S c = std::cos(yaw);
  const S s = std::sin(yaw);
  const Vec3<S> d = p - origin;
  return {c * d.x() - s * d.z(), d.y(), s * d.x() + c * d.z()};
}

template <class S>
Vec3<S> from_body(const Vec3<S>& p, const Vec3<S>& origin, S yaw) {
  return to_body<S>(p, Vec3<S>::Zero(), -yaw) + origin;
}

template <class S>
std::vector<Vec3<S>> body_local_positions(const Clip<S>& clip, Span<const S> yaw) {
  RIGLESS_ASSERT(yaw.size() == static_cast<std::size_t>(clip.frames));
  std::vector<Vec3<S>> local;
  local.reserve(clip.positions.size());
  for (std::int32_t f = 0; f < clip.frames; ++f) {
    for (std::int32_t j = 0; j < clip.joints(); ++j) {
      local.push_back(to_body<S>(clip.at(f, j), clip.at(f, 0), yaw[static_cast<std::size_t>(f)]));
    }
  }
  return local;
}

}  // namespace rigless::detail
