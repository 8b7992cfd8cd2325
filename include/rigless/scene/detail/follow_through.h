// Parts that no joint moves lag behind the body, swing beyond it and settle: springs on their way through the world.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/detail/macros.h"
#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/motion/detail/body_frame.h"
#include "rigless/retarget/detail/flight.h"
#include "rigless/scene/performance.h"

namespace rigless::detail {

template <class S>
struct Spring {
  S frequency;  // hertz
  S damping;    // 1: it does not swing beyond
};

template <class S>
Spring<S> spring_of(FollowThrough follow) {
  return follow == FollowThrough::bouncy ? Spring<S>{S(2.2), S(0.2)} : Spring<S>{S(1.3), S(0.15)};
}

// How far the springs' ends are from where they are held, T, in axes that turn with the body: a damped oscillation
// driven by the acceleration of `path`. A loop is run until it repeats itself. path: T, world metres; yaw: T; reach:
// farther than so many metres no end comes. Allocates.
template <class S>
RIGLESS_COLD std::vector<Vec3<S>> spring_lag(const Spring<S>& spring, const std::vector<Vec3<S>>& path,
                                             const std::vector<S>& yaw, S reach, bool loops) {
  constexpr std::int32_t substeps = 8, laps = 3;
  const std::size_t frames = path.size();
  std::vector<Vec3<S>> lag(frames, Vec3<S>::Zero());
  if (frames < 3) return lag;
  const S step = S(1 / performance_fps / substeps);
  const S rate = S(2 * 3.14159265358979323846) * spring.frequency;
  Vec3<S> at = Vec3<S>::Zero(), velocity = Vec3<S>::Zero();
  for (std::int32_t lap = loops ? 0 : laps - 1; lap < laps; ++lap) {
    for (std::size_t f = 0; f < frames; ++f) {
      const S far = at.norm() / reach;
      lag[f] = at / std::sqrt(1 + far * far);
      const std::size_t middle = f == 0 ? 1 : f == frames - 1 ? frames - 2 : f;
      const Vec3<S> bend = path[middle + 1] - 2 * path[middle] + path[middle - 1];
      const Vec3<S> drive = to_body<S>(bend, Vec3<S>::Zero(), yaw[f]) * S(performance_fps * performance_fps);
      for (std::int32_t k = 0; k < substeps; ++k) {
        velocity += step * (-rate * rate * at - 2 * spring.damping * rate * velocity - drive);
        at += step * velocity;
      }
    }
  }
  return lag;
}

// The height of the root over each flight: a throw from where it left the ground to where it lands.
template <class S>
void throw_root(const std::vector<Flight>& flights, std::vector<Vec3<S>>& root) {
  std::vector<S> heights;
  for (const Flight& flight : flights) {
    const S start = nth(root, flight.take_off).y(), end = nth(root, flight.landing).y();
    flight_heights(start, end, flight.landing - flight.take_off, gravity_per_frame(S(performance_fps)), heights);
    for (std::size_t k = 0; k < heights.size(); ++k) root[to_size(flight.take_off) + k].y() = heights[k];
  }
}

// Moves the controls that hang on the body. follow: C, or empty; root: T, the body's origin in the world, its height as
// the controls have it; height: of the mesh. Allocates.
template <class S>
RIGLESS_COLD void follow_through(Span<const FollowThrough> follow, std::vector<Vec3<S>> root, S height, bool loops,
                                 Performance<S>& p) {
  const std::size_t controls = p.control_count(), frames = to_size(p.frames);
  throw_root<S>(p.flights, root);
  std::vector<Vec3<S>> path(frames);
  for (std::size_t c = 0; c < follow.size(); ++c) {
    if (follow[c] == FollowThrough::stiff) continue;
    for (std::size_t f = 0; f < frames; ++f) path[f] = from_body<S>(p.controls[f * controls + c], root[f], p.yaw[f]);
    const std::vector<Vec3<S>> lag = spring_lag(spring_of<S>(follow[c]), path, p.yaw, S(0.2) * height, loops);
    for (std::size_t f = 0; f < frames; ++f) p.controls[f * controls + c] += lag[f];
  }
}

}  // namespace rigless::detail
