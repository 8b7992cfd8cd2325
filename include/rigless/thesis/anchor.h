// The paper's root motion: the lowest control stands.
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

namespace rigless {

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
  const auto controls = to_size(control_count);
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
    const auto landing = to_size(flight->landing);
    const std::size_t back = std::min<std::size_t>(f, 3);
    Vec3<S> velocity = Vec3<S>::Zero();
    if (back > 0) velocity = (middle(f) - middle(f - back)) / static_cast<S>(back);
    anchor = lowest(landing, 0);
    detail::flight_heights(root[f].y(), -tracks[landing * controls + anchor].y(), flight->landing - flight->take_off,
                           gravity, heights);
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
Constraints<S> anchor_constraints(Span<const std::int32_t> anchors, Span<const S> ground) {
  Constraints<S> constraints;
  for (std::size_t f = 1; f < anchors.size(); ++f) {
    const std::int32_t now = anchors[f], before = anchors[f - 1];
    if (now < 0 || before < 0 || now == before) continue;
    constraints.push_back(
        height_constraint<S>(now, before, static_cast<std::int32_t>(f), nth(ground, now) - nth(ground, before)));
  }
  return constraints;
}

}  // namespace rigless
