// Where the model's origin travels, so that what stands on the ground stays where it is.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/motion/contacts.h"
#include "rigless/retarget/constraints.h"
#include "rigless/retarget/detail/flight.h"
#include "rigless/retarget/detail/smoothing.h"

namespace rigless {

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

// The root of T frames from the controls that stand: per frame it moves against their mean horizontal motion, counting
// the controls labelled in this frame and the one before. While nothing stands it moves as the source does, scaled, or
// keeps its speed if the source is unknown. The speed is smoothed and summed; y puts the smoothed lowest sole on the
// ground. tracks: T x C local positions with the source's yaw put back; labels: T x C, not 0 while a control stands;
// ground: C, rest height of each control above the lowest vertex; root: T. Allocates. Errors: no_controls;
// size_mismatch.
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

// The paper's root: in each frame the lowest control is the anchor; it is on the ground and has not moved since the
// frame before. The anchor stays while no other is lower. In a flight there is none (-1): the body goes on with the
// velocity that the middle of its controls had over the last three frames, and its height is a throw that lands in
// time. Works without contacts, but steps whenever the anchor changes.
// tracks: T x C; flights: inside the clip, in order, apart; gravity: units per frame^2, negative; root: T; anchors: T
// control indices. Allocates. Errors: no_controls; size_mismatch. Source: thesis 3.3.4 and Eq 3.31.
template <class S>
Status root_from_anchor(Span<const Vec3<S>> tracks, std::int32_t control_count, Span<const Flight> flights, S gravity,
                        std::vector<Vec3<S>>& root, std::vector<std::int32_t>& anchors) {
  if (control_count <= 0) return {Error::no_controls, -1};
  const auto controls = static_cast<std::size_t>(control_count);
  if (tracks.size() % controls != 0) return {Error::size_mismatch, -1};
  const std::size_t frames = tracks.size() / controls;
  root.assign(frames, Vec3<S>::Zero());
  anchors.assign(frames, -1);
  const auto lowest = [&](std::size_t f, std::size_t anchor) {
    for (std::size_t c = 0; c < controls; ++c)
      if (tracks[f * controls + c].y() < tracks[f * controls + anchor].y()) anchor = c;
    return anchor;
  };
  const auto middle = [&](std::size_t f) {
    Vec3<S> sum = Vec3<S>::Zero();
    for (std::size_t c = 0; c < controls; ++c) sum += tracks[f * controls + c];
    return (sum / static_cast<S>(controls) + root[f]).eval();
  };
  std::vector<S> heights;
  const Flight* flight = flights.begin();
  std::size_t anchor = 0;
  for (std::size_t f = 0; f < frames; ++f) {
    anchor = lowest(f, anchor);
    if (f > 0) root[f] = root[f - 1] - (tracks[f * controls + anchor] - tracks[(f - 1) * controls + anchor]);
    root[f].y() = -tracks[f * controls + anchor].y();
    anchors[f] = static_cast<std::int32_t>(anchor);
    if (flight == flights.end() || static_cast<std::int32_t>(f) != flight->take_off) continue;
    const auto landing = static_cast<std::size_t>(flight->landing);
    const std::size_t back = std::min<std::size_t>(f, 3);
    Vec3<S> velocity = Vec3<S>::Zero();
    if (back > 0) velocity = (middle(f) - middle(f - back)) / static_cast<S>(back);
    anchor = lowest(landing, 0);
    flight_heights(root[f].y(), -tracks[landing * controls + anchor].y(), flight->landing - flight->take_off, gravity,
                   heights);
    for (std::size_t g = f + 1; g <= landing; ++g) {
      root[g] = root[g - 1] + velocity;
      root[g].y() = heights[g - f];
    }
    anchors[landing] = static_cast<std::int32_t>(anchor);
    f = landing;
    ++flight;
  }
  return {};
}

// Where the anchor changes, the new one must be as low as the old one: their heights above their soles are equal there.
// anchors: T; ground: C, rest height of each control above the lowest vertex. Allocates. Source: thesis Fig 3.7.
template <class S>
std::vector<HeightConstraint<S>> anchor_constraints(Span<const std::int32_t> anchors, Span<const S> ground) {
  std::vector<HeightConstraint<S>> constraints;
  for (std::size_t f = 1; f < anchors.size(); ++f) {
    const std::int32_t now = anchors[f], before = anchors[f - 1];
    if (now < 0 || before < 0 || now == before) continue;
    constraints.push_back({now, before, static_cast<std::int32_t>(f),
                           ground[static_cast<std::size_t>(now)] - ground[static_cast<std::size_t>(before)]});
  }
  return constraints;
}

}  // namespace rigless
