// A clip at another frame rate.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "rigless/math/detail/macros.h"
#include "rigless/math/status.h"
#include "rigless/motion/clip.h"

namespace rigless::detail {

// Frames at another rate that lie in the duration of `clip`: floor((frames - 1) * ratio) + 1.
template <class S>
std::int32_t resampled_frames(const Clip<S>& clip, S fps);

// Positions go along Catmull-Rom curves (straight pieces between frames would show as jerks when a slow clip is sped
// up), root rotations along the shortest arc. The first frame stays the first; a frame that falls on a source frame
// equals it. `fps` > 0. Allocates the result, which may be `clip` itself. Errors: no_frames; out_of_memory: more than
// 2^26 positions would come out. `out` then keeps what it had. `first`, `last`: of the frames at the new rate those
// that are wanted, as far as there are so many.
template <class S>
Status resample(const Clip<S>& clip, S fps, Clip<S>& out, std::int32_t first = 0, std::int32_t last = 1 << 30);

// ---------------------------------------------------------------------------------------------------------------------

// Rates such as 30.003 come from rounded frame times: the last frame counts although it is a hair too late.
template <class S>
std::int32_t resampled_frames(const Clip<S>& clip, S fps) {
  RIGLESS_ASSERT(fps > 0 && clip.fps > 0);
  const double last = static_cast<double>(clip.frames - 1) * static_cast<double>(fps) / static_cast<double>(clip.fps);
  return static_cast<std::int32_t>(std::min(last + 0.05, 2e9)) + 1;
}

template <class S>
Status resample(const Clip<S>& clip, S fps, Clip<S>& out, std::int32_t first, std::int32_t last) {
  if (clip.frames == 0) return {Error::no_frames, -1};
  const std::size_t joints = clip.skeleton.names.size();
  last = std::clamp(last, 0, resampled_frames(clip, fps) - 1);
  first = std::clamp(first, 0, last);
  const std::int32_t frames = last - first + 1;
  if (static_cast<std::size_t>(frames) > (std::size_t{1} << 26) / joints) return {Error::out_of_memory, -1};

  Clip<S> result;
  result.skeleton = clip.skeleton;
  result.fps = fps;
  result.metres_per_unit = clip.metres_per_unit;
  result.frames = frames;
  result.positions.reserve(static_cast<std::size_t>(frames) * joints);
  result.root_rotation.reserve(static_cast<std::size_t>(frames));
  const double step = static_cast<double>(clip.fps) / static_cast<double>(fps);
  for (std::int32_t f = first; f <= last; ++f) {
    const double time = std::min(f * step, static_cast<double>(clip.frames - 1));
    const std::int32_t b = static_cast<std::int32_t>(time);
    const std::int32_t a = std::max(b - 1, 0);
    const std::int32_t c = std::min(b + 1, clip.frames - 1);
    const std::int32_t d = std::min(b + 2, clip.frames - 1);
    const S u = static_cast<S>(time - b);
    S wa = u * (-1 + u * (2 - u)) / 2;
    S wb = 1 + u * u * (-5 + 3 * u) / 2;
    S wc = u * (1 + u * (4 - 3 * u)) / 2;
    S wd = u * u * (u - 1) / 2;
    if (b == 0) {  // the frame before the first goes on in a straight line, as does the one after the last
      wb += 2 * wa;
      wc -= std::exchange(wa, S(0));
    }
    if (b + 2 >= clip.frames) {
      wc += 2 * wd;
      wb -= std::exchange(wd, S(0));
    }
    for (std::int32_t j = 0; j < clip.joints(); ++j) {
      result.positions.push_back(wa * clip.at(a, j) + wb * clip.at(b, j) + wc * clip.at(c, j) + wd * clip.at(d, j));
    }
    const Eigen::Quaternion<S>& from = clip.root_rotation[static_cast<std::size_t>(b)];
    result.root_rotation.push_back(from.slerp(u, clip.root_rotation[static_cast<std::size_t>(c)]));
  }
  out = std::move(result);
  return {};
}

}  // namespace rigless::detail
