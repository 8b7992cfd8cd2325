// What no clip may exceed, whatever its file says.
#pragma once

#include <cstddef>

#include "rigless/motion/clip.h"

namespace rigless::detail {

inline constexpr std::size_t max_clip_positions = std::size_t{1} << 26;

// False if a number is too large for S to hold the sums.
template <class S>
bool all_finite(const Clip<S>& clip) {
  for (const Vec3<S>& p : clip.positions) {
    if (!p.allFinite()) return false;
  }
  return true;
}

}  // namespace rigless::detail
