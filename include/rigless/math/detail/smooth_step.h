// A step without corners.
#pragma once

#include <algorithm>

namespace rigless::detail {

// From 0 at x <= 0 to 1 at x >= 1, level at both ends.
template <class S>
S smooth_step(S x) {
  x = std::clamp(x, S(0), S(1));
  return x * x * (S(3) - S(2) * x);
}

}  // namespace rigless::detail
