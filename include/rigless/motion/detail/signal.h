// Filters over one coordinate of a clip: a running mean, a running minimum, the acceleration of a fitted parabola.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/detail/macros.h"
#include "rigless/math/status.h"

namespace rigless::detail {

// Frames on each side of the middle so that the window spans about `seconds`.
template <class S>
std::int32_t half_window(S seconds, S fps) {
  return static_cast<std::int32_t>(seconds * fps / 2 + S(0.5));
}

// Mean over 2 half + 1 frames; the first and last frame go on beyond the ends. Allocates the result.
template <class S>
std::vector<S> running_mean(const std::vector<S>& x, std::int32_t half);

// Minimum over the frames within `half` of each, in linear time. Allocates the result and scratch.
template <class S>
std::vector<S> running_minimum(const std::vector<S>& x, std::int32_t half);

// Second derivative, per second squared, of the least-squares parabola over 2 half + 1 frames; near the ends that of
// the nearest whole window, zeros if there is none. `half` >= 1. Allocates the result.
template <class S>
std::vector<S> parabola_acceleration(const std::vector<S>& x, std::int32_t half, S fps);

// ---------------------------------------------------------------------------------------------------------------------

template <class S>
std::vector<S> running_mean(const std::vector<S>& x, std::int32_t half) {
  const std::int32_t last = static_cast<std::int32_t>(x.size()) - 1;
  std::vector<S> mean(x.size());
  for (std::int32_t f = 0; f <= last; ++f) {
    S sum = 0;
    for (std::int32_t k = f - half; k <= f + half; ++k) sum += x[static_cast<std::size_t>(std::clamp(k, 0, last))];
    mean[static_cast<std::size_t>(f)] = sum / static_cast<S>(2 * half + 1);
  }
  return mean;
}

template <class S>
std::vector<S> running_minimum(const std::vector<S>& x, std::int32_t half) {
  const std::size_t h = static_cast<std::size_t>(half);
  std::vector<S> minimum(x.size());
  std::vector<std::size_t> candidates;  // rising values; those before `first` have left the window
  std::size_t first = 0;
  std::size_t next = 0;
  for (std::size_t f = 0; f < x.size(); ++f) {
    for (; next < x.size() && next <= f + h; ++next) {
      while (candidates.size() > first && x[candidates.back()] >= x[next]) candidates.pop_back();
      candidates.push_back(next);
    }
    while (candidates[first] + h < f) ++first;
    minimum[f] = x[candidates[first]];
  }
  return minimum;
}

template <class S>
std::vector<S> parabola_acceleration(const std::vector<S>& x, std::int32_t half, S fps) {
  RIGLESS_ASSERT(half >= 1);
  const std::int32_t frames = static_cast<std::int32_t>(x.size());
  std::vector<S> acceleration(x.size(), 0);
  if (frames < 2 * half + 1) return acceleration;
  // The parabola's leading coefficient: k^2 without its mean is orthogonal to the constant and to k.
  const S mean = static_cast<S>(half) * static_cast<S>(half + 1) / 3;
  S norm = 0;
  for (std::int32_t k = -half; k <= half; ++k) norm += (static_cast<S>(k * k) - mean) * (static_cast<S>(k * k) - mean);
  for (std::int32_t f = 0; f < frames; ++f) {
    const std::int32_t middle = std::clamp(f, half, frames - 1 - half);
    const S level = x[static_cast<std::size_t>(middle)];  // keeps a float from losing digits
    S sum = 0;
    for (std::int32_t k = -half; k <= half; ++k) {
      sum += (static_cast<S>(k * k) - mean) * (x[static_cast<std::size_t>(middle + k)] - level);
    }
    acceleration[static_cast<std::size_t>(f)] = 2 * fps * fps * sum / norm;
  }
  return acceleration;
}

}  // namespace rigless::detail
