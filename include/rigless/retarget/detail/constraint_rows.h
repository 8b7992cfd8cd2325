// The equations behind the constraints.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "rigless/math/status.h"
#include "rigless/retarget/constraints.h"

namespace rigless::detail {

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
      if (!nth(c.axes, axis)) continue;
      result.push_back({{{{c.track, c.frame, axis, 1}, {c.track, c.frame, axis, 0}}}, c.position[axis], index});
    }
    ++index;
  }
  for (const auto& c : constraints.velocities) {
    if (!inside(c.track, c.frame) || c.frame == 0) return {Error::bad_constraint, index};
    for (std::int32_t axis = 0; axis < 3; ++axis) {
      if (!nth(c.axes, axis)) continue;
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

}  // namespace rigless::detail
