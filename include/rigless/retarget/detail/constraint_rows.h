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
  std::int32_t constraint;
};

// The equations behind the constraints on C tracks of T frames. Allocates.
// Errors: bad_constraint (where: constraint).
template <class S>
Status constraint_rows(const Constraints<S>& constraints, std::int32_t frames, std::int32_t tracks,
                       std::vector<ConstraintRow<S>>& rows) {
  std::vector<ConstraintRow<S>> result;
  std::int32_t index = 0;
  const auto inside = [&](const TrackFrame& at) {
    return at.track >= 0 && at.track < tracks && at.frame >= 0 && at.frame < frames;
  };
  for (const Constraint<S>& c : constraints) {
    const TrackFrame from = c.from.value_or(c.at);
    if (!inside(c.at) || !inside(from)) return {Error::bad_constraint, index};
    for (std::int32_t axis = 0; axis < 3; ++axis) {
      if (!nth(c.axes, axis)) continue;
      const S less = c.from ? S(-1) : S(0);
      result.push_back(
          {{{{c.at.track, c.at.frame, axis, 1}, {from.track, from.frame, axis, less}}}, c.value[axis], index});
    }
    ++index;
  }
  for (const auto& row : result)
    if (!std::isfinite(row.target)) return {Error::bad_constraint, row.constraint};
  rows = std::move(result);
  return {};
}

}  // namespace rigless::detail
