// Heights of a body in the air.
#pragma once

#include <cstdint>
#include <vector>

#include "rigless/math/detail/macros.h"

namespace rigless::detail {

// First velocity (units per frame) of a flight of `frames` frames that ends `rise` above its start, when each frame
// does v += gravity, x += v (semi-implicit Euler: lands exactly). gravity: units per frame^2, negative. No allocation.
// Source: thesis Eq 3.31.
template <class S>
S flight_velocity(S rise, std::int32_t frames, S gravity) {
  RIGLESS_ASSERT(frames > 0);
  const auto n = static_cast<S>(frames);
  return (rise - n * (n + S(1)) * gravity / S(2)) / n;
}

// Heights from `start` to `end` over `frames` frames, both ends included: frames + 1 values, overwritten. Allocates.
// Source: thesis Eq 3.31.
template <class S>
void flight_heights(S start, S end, std::int32_t frames, S gravity, std::vector<S>& heights) {
  S velocity = flight_velocity(end - start, frames, gravity);
  heights.assign(1, start);
  for (std::int32_t f = 0; f < frames; ++f) {
    velocity += gravity;
    heights.push_back(heights.back() + velocity);
  }
}

// Gravity in units per frame^2 for a model whose unit is the metre.
template <class S>
S gravity_per_frame(S fps) {
  return S(-9.81) / (fps * fps);
}

}  // namespace rigless::detail
