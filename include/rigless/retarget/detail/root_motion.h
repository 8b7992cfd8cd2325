// Where the model's origin travels, so that what stands on the ground stays where it is.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/detail/macros.h"
#include "rigless/math/detail/smooth_step.h"
#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/smoothing.h"

namespace rigless::detail {

template <class S>
struct RootMotionOptions {
  S fps = 30;
  S window = 5;  // length of the Hann window in frames at 30 fps; 1: no smoothing
};

// How the human's root travels, for the time in which nothing stands.
template <class S>
struct SourceTravel {
  Span<const Vec3<S>> root;  // T, world; empty: unknown
  S scale = 1;               // model's way over human's, as far as the frames in which something stands do not tell
};

// How many times as far as the source `velocity` goes over the frames that `known` marks; as far as both hardly move,
// `travel.scale`. No allocation.
template <class S>
S travel_ratio(const SourceTravel<S>& travel, const std::vector<Vec3<S>>& velocity,
               const std::vector<std::uint8_t>& known, S fps) {
  const S hardly = S(0.15) / fps;  // metres per frame
  S both = 0, own = 0;
  for (std::size_t f = 1; f < velocity.size(); ++f) {
    if (known[f] == 0) continue;
    const Vec3<S> step = travel.root[f] - travel.root[f - 1];
    both += velocity[f].x() * step.x() + velocity[f].z() * step.z() + travel.scale * hardly * hardly;
    own += step.x() * step.x() + step.z() * step.z() + hardly * hardly;
  }
  return own > S(0) ? std::clamp(both / own, travel.scale / S(3), travel.scale * S(3)) : travel.scale;
}

// Turns `velocity` (T, per frame) to where the source goes, as far as that goes anywhere within half a second: legs
// that swing otherwise than the human's would lead a body astray. How fast it is stays, and how it sways. Allocates.
template <class S>
RIGLESS_COLD void steer(const SourceTravel<S>& source, S fps, std::vector<Vec3<S>>& velocity) {
  constexpr S window = S(21), walks = S(0.5);  // frames at 30 fps; metres per second
  std::vector<Vec3<S>> way(velocity.size(), Vec3<S>::Zero()), own = velocity;
  for (std::size_t f = 1; f < way.size(); ++f) way[f] = source.root[f] - source.root[f - 1];
  smooth_hann(way, window, fps);
  smooth_hann(own, window, fps);
  for (std::size_t f = 0; f < way.size(); ++f) {
    const S far = std::sqrt(way[f].x() * way[f].x() + way[f].z() * way[f].z());
    const S fast = std::sqrt(own[f].x() * own[f].x() + own[f].z() * own[f].z());
    const S share = smooth_step(far * fps / walks);
    for (const int axis : {0, 2})
      if (far > S(0)) velocity[f][axis] += share * (fast / far * way[f][axis] - own[f][axis]);
  }
}

// The root of T frames from the controls that stand: per frame it moves against their mean horizontal motion, counting
// the controls labelled in this frame and the one before. While nothing stands it moves as the source does, scaled, or
// keeps its speed if the source is unknown; and it goes where the source does, see steer(). The speed is smoothed and
// summed; y puts the smoothed lowest sole on the ground. tracks: T x C local positions with the source's yaw put back;
// labels: T x C, not 0 while a control stands; ground: C, rest height of each control above the lowest vertex; root: T.
// Allocates. Errors: no_controls; size_mismatch.
template <class S>
Status root_from_contacts(Span<const Vec3<S>> tracks, Span<const std::uint8_t> labels, Span<const S> ground,
                          const SourceTravel<S>& source, const RootMotionOptions<S>& options,
                          std::vector<Vec3<S>>& root) {
  const std::size_t controls = ground.size();
  if (controls == 0) return {Error::no_controls, -1};
  if (tracks.size() % controls != 0 || labels.size() != tracks.size()) return {Error::size_mismatch, -1};
  const std::size_t frames = tracks.size() / controls;
  if (!source.root.empty() && source.root.size() != frames) return {Error::size_mismatch, -1};
  std::vector<Vec3<S>> velocity(frames, Vec3<S>::Zero());
  std::vector<std::uint8_t> stood(frames, 0);
  std::vector<S> lowest(frames);
  for (std::size_t f = 0; f < frames; ++f) {
    Vec3<S> sum = Vec3<S>::Zero();
    S standing = 0;
    lowest[f] = tracks[f * controls].y() - ground[0];
    for (std::size_t c = 0; c < controls; ++c) {
      const std::size_t i = f * controls + c;
      lowest[f] = std::min(lowest[f], tracks[i].y() - ground[c]);
      if (f == 0 || labels[i] == 0 || labels[i - controls] == 0) continue;
      sum -= tracks[i] - tracks[i - controls];
      standing += S(1);
    }
    if (f > 0) velocity[f] = standing > S(0) ? (sum / standing).eval() : velocity[f - 1];
    stood[f] = standing > S(0) ? 1 : 0;
  }
  if (!source.root.empty()) {
    const S ratio = travel_ratio(source, velocity, stood, options.fps);
    for (std::size_t f = 1; f < frames; ++f)
      if (stood[f] == 0) velocity[f] = ratio * (source.root[f] - source.root[f - 1]);
    steer(source, options.fps, velocity);
  }
  smooth_hann(velocity, options.window, options.fps);
  smooth_hann(lowest, options.window, options.fps);
  root.resize(frames);
  Vec3<S> at = Vec3<S>::Zero();
  for (std::size_t f = 0; f < frames; ++f) {
    at += velocity[f];
    root[f] = {at.x(), -lowest[f], at.z()};
  }
  return {};
}

}  // namespace rigless::detail
