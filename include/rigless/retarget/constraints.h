// Hard constraints on control tracks.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "rigless/math/types.h"

namespace rigless {

using AxisMask = std::array<bool, 3>;

struct TrackFrame {
  std::int32_t track = 0;
  std::int32_t frame = 0;
};

// Where a track is at a frame, or the way to there from where one is at a frame, is `value` on the axes of the mask.
template <class S>
struct Constraint {
  TrackFrame at;
  std::optional<TrackFrame> from;  // none: `value` is a position
  Vec3<S> value = Vec3<S>::Zero();
  AxisMask axes = {true, true, true};
};

template <class S>
using Constraints = std::vector<Constraint<S>>;

// The track passes through `position` at `frame`. Source: thesis Eq 3.27.
template <class S>
Constraint<S> position_constraint(std::int32_t track, std::int32_t frame, const Vec3<S>& position,
                                  const AxisMask& axes = {true, true, true}) {
  return {{track, frame}, std::nullopt, position, axes};
}

// The track moves by `velocity` from frame - 1 to frame (units per frame). Source: thesis Eq 3.28.
template <class S>
Constraint<S> velocity_constraint(std::int32_t track, std::int32_t frame, const Vec3<S>& velocity,
                                  const AxisMask& axes = {true, true, true}) {
  return {{track, frame}, TrackFrame{track, frame - 1}, velocity, axes};
}

// y of `track` minus y of `other` is `difference` at `frame`, so that the anchor can change from one to the other. Give
// the difference of the two controls' rest heights above the sole. Source: thesis Fig 3.7.
template <class S>
Constraint<S> height_constraint(std::int32_t track, std::int32_t other, std::int32_t frame, S difference) {
  return {{track, frame}, TrackFrame{other, frame}, Vec3<S>(0, difference, 0), {false, true, false}};
}

}  // namespace rigless
