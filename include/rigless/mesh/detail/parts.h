// What a model is of: a trunk and limbs, which must not grow together where they touch.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace rigless::detail {

// A part of a model: 0 for the trunk, l for limb l, -l for where that begins. What goes with every part, and what is of
// no part yet.
inline constexpr std::int32_t any_part = std::numeric_limits<std::int32_t>::min();
inline constexpr std::int32_t no_part = std::numeric_limits<std::int32_t>::max();

// Whether two parts must not grow together: a limb goes with where it begins, and that with the trunk.
inline bool parted(std::int32_t a, std::int32_t b) {
  if (a == any_part || b == any_part || a == b || a == -b) return false;
  return a > 0 || b > 0 || (a < 0 && b < 0);
}

// What is of two parts is where a limb begins if that goes with both, or of any.
inline void join_part(std::int32_t& own, std::int32_t other) {
  if (own == no_part || own == other) {
    own = other;
  } else {
    own = parted(own, other) ? any_part : std::min(own, other);
  }
}

}  // namespace rigless::detail
