// Hard constraints on control tracks.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rigless/math/status.h"
#include "rigless/math/types.h"

namespace rigless {

using AxisMask = std::array<bool, 3>;

// The track passes through `position` at `frame`, on the axes of the mask. Source: thesis Eq 3.27.
template <class S>
struct PositionConstraint {
  std::int32_t track = 0;
  std::int32_t frame = 0;
  Vec3<S> position = Vec3<S>::Zero();
  AxisMask axes = {true, true, true};
};

// The track moves by `velocity` from frame - 1 to frame (units per frame), on the axes of the mask.
// Source: thesis Eq 3.28.
template <class S>
struct VelocityConstraint {
  std::int32_t track = 0;
  std::int32_t frame = 1;
  Vec3<S> velocity = Vec3<S>::Zero();
  AxisMask axes = {true, true, true};
};

// y of `track` minus y of `other` is `difference` at `frame`, so that the anchor can change from one to the other. Give
// the difference of the two controls' rest heights above the sole. Source: thesis Fig 3.7.
template <class S>
struct HeightConstraint {
  std::int32_t track = 0;
  std::int32_t other = 0;
  std::int32_t frame = 0;
  S difference = 0;
};

template <class S>
struct Constraints {
  std::vector<PositionConstraint<S>> positions;
  std::vector<VelocityConstraint<S>> velocities;
  std::vector<HeightConstraint<S>> heights;

  std::size_t size() const { return positions.size() + velocities.size() + heights.size(); }
};

// One scalar equation: the sum of factor * (track at frame)[axis] over its two terms equals `target`. A factor may be
// 0.
template <class S>
struct ConstraintRow {
  struct Term {
    std::int32_t track, frame, axis;
    S factor;
  };
  std::array<Term, 2> terms;
  S target;
  std::int32_t constraint;  // counted through positions, velocities, heights
};

// The equations behind the constraints on C tracks of T frames. Allocates.
// Errors: bad_constraint (where: counted through positions, velocities, heights).
template <class S>
Status constraint_rows(const Constraints<S>& constraints, std::int32_t frames, std::int32_t tracks,
                       std::vector<ConstraintRow<S>>& rows) {
  std::vector<ConstraintRow<S>> result;
  std::int32_t index = 0;
  const auto inside = [&](std::int32_t track, std::int32_t frame) {
    return track >= 0 && track < tracks && frame >= 0 && frame < frames;
  };
  for (const auto& c : constraints.positions) {
    if (!inside(c.track, c.frame)) return {Error::bad_constraint, index};
    for (std::int32_t axis = 0; axis < 3; ++axis) {
      if (!c.axes[static_cast<std::size_t>(axis)]) continue;
      result.push_back({{{{c.track, c.frame, axis, 1}, {c.track, c.frame, axis, 0}}}, c.position[axis], index});
    }
    ++index;
  }
  for (const auto& c : constraints.velocities) {
    if (!inside(c.track, c.frame) || c.frame == 0) return {Error::bad_constraint, index};
    for (std::int32_t axis = 0; axis < 3; ++axis) {
      if (!c.axes[static_cast<std::size_t>(axis)]) continue;
      result.push_back({{{{c.track, c.frame, axis, 1}, {c.track, c.frame - 1, axis, -1}}}, c.velocity[axis], index});
    }
    ++index;
  }
  for (const auto& c : constraints.heights) {
    if (!inside(c.track, c.frame) || !inside(c.other, c.frame)) return {Error::bad_constraint, index};
    result.push_back({{{{c.track, c.frame, 1, 1}, {c.other, c.frame, 1, -1}}}, c.difference, index});
    ++index;
  }
  for (const auto& row : result)
    if (!std::isfinite(row.target)) return {Error::bad_constraint, row.constraint};
  rows = std::move(result);
  return {};
}

}  // namespace rigless
