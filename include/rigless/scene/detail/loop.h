// Clips that begin again where they end, and how they are solved.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/detail/macros.h"
#include "rigless/math/detail/smooth_step.h"
#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/retarget/constraints.h"

namespace rigless::detail {

// Root mean square distance of J joints at two frames. No allocation.
template <class S>
S pose_distance(Span<const Vec3<S>> poses, std::size_t joints, std::size_t a, std::size_t b) {
  S sum = 0;
  for (std::size_t j = 0; j < joints; ++j) sum += (poses[a * joints + j] - poses[b * joints + j]).squaredNorm();
  return std::sqrt(sum / static_cast<S>(joints));
}

inline constexpr int shortest_loop = 8;  // frames in which anything can be said

// After how many frames a clip of T frames begins again: T, or T - 1 where the last frame is the first once more; 0 if
// the way from its end to its beginning is no step of its own. poses: T x J, body-local. No allocation.
template <class S>
std::int32_t loop_period(Span<const Vec3<S>> poses, std::size_t joints) {
  const std::size_t frames = poses.size() / joints;
  if (frames < to_size(shortest_loop)) return 0;
  const auto step = [&](std::size_t a, std::size_t b) { return pose_distance(poses, joints, a, b); };
  S squares = 0;
  for (std::size_t f = 1; f < frames; ++f) squares += step(f - 1, f) * step(f - 1, f);
  const S usual = std::sqrt(squares / static_cast<S>(frames - 1));
  const S before = step(frames - 2, frames - 1), after = step(0, 1), seam = step(frames - 1, 0);
  if (seam > S(1.5) * std::max({usual, before, after, S(1e-6)})) return 0;
  const bool twice = seam < S(0.25) * std::max({usual, before, after});
  return static_cast<std::int32_t>(twice ? frames - 1 : frames);
}

// Which frame of a clip `f` is, however far before its beginning or after its end: a loop goes on, other clips stay at
// their ends.
inline std::int32_t frame_around(std::int32_t f, std::int32_t frames, std::int32_t period) {
  if (f >= 0 && f < frames) return f;
  if (period == 0) return f < 0 ? 0 : frames - 1;
  const std::int32_t around = f % period;
  return around < 0 ? around + period : around;
}

// A loop is solved with some frames of the laps before and after it, so that its ends meet as its other frames do.
struct LapMargin {
  std::int32_t frames = 0, period = 0;
  std::int32_t most = 15;  // frames: how far the smoothing of a track reaches

  std::int32_t margin() const { return std::min(most, period); }

  // (T + 2 margin) x J of T x J, which are put together in `wound` where there is a margin. Allocates.
  template <class S>
  Span<const Vec3<S>> wind(Span<const Vec3<S>> poses, std::size_t joints, std::vector<Vec3<S>>& wound) const {
    if (margin() == 0) return poses;
    wound.clear();
    for (std::int32_t f = -margin(); f < frames + margin(); ++f)
      for (std::size_t j = 0; j < joints; ++j)
        wound.push_back(poses[to_size(frame_around(f, frames, period)) * joints + j]);
    return wound;
  }

  // The same constraints on the wound clip.
  template <class S>
  void shift(Constraints<S>& constraints) const {
    for (Constraint<S>& c : constraints) {
      c.at.frame += margin();
      if (c.from) c.from->frame += margin();
    }
  }

  // Leads the end of tracks, T x C, to their beginning where the last frame is the first again. No allocation.
  template <class S>
  void close(std::vector<Vec3<S>>& tracks) const {
    const std::size_t controls = tracks.size() / to_size(frames), end = tracks.size() - controls;
    const std::int32_t lead = period == frames - 1 ? std::min(most, period / 2) : 0;
    for (std::size_t c = 0; c < controls; ++c) {
      const Vec3<S> gap = tracks[c] - tracks[end + c];
      for (std::int32_t k = 0; k < lead; ++k)
        tracks[end + c - to_size(k) * controls] += smooth_step(static_cast<S>(lead - k) / static_cast<S>(lead)) * gap;
    }
  }

  // The clip's own frames, T x C, of (T + 2 margin) x C. No allocation.
  template <class S>
  void unwind(std::vector<Vec3<S>>& tracks) const {
    const std::size_t controls = tracks.size() / to_size(frames + 2 * margin()), own = to_size(frames) * controls;
    for (std::size_t i = 0; i < own; ++i) tracks[i] = tracks[i + to_size(margin()) * controls];
    tracks.resize(own);
  }
};

}  // namespace rigless::detail
