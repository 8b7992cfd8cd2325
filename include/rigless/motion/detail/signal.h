// Filters over one coordinate of a clip: a running minimum, the acceleration of a fitted parabola.
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

// Minimum over the frames within `half` of each, in linear time. Allocates the result and scratch.
template <class S>
std::vector<S> running_minimum(const std::vector<S>& x, std::int32_t half);

// Second derivative, per second squared, of the least-squares parabola through x[first] to x[last], at least 3 values.
template <class S>
S parabola_acceleration(const std::vector<S>& x, std::size_t first, std::size_t last, S fps);

// ---------------------------------------------------------------------------------------------------------------------

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
S parabola_acceleration(const std::vector<S>& x, std::size_t first, std::size_t last, S fps) {
  RIGLESS_ASSERT(first + 2 <= last && last < x.size());
  // The parabola's leading coefficient: k^2 without its mean is orthogonal to the constant and to k.
  const S n = static_cast<S>(last - first);
  S sum = 0, norm = 0;
  for (std::size_t f = first; f <= last; ++f) {
    const S k = static_cast<S>(f - first) - n / 2;
    const S weight = k * k - n * (n + 2) / 12;
    sum += weight * (x[f] - x[first]);  // the difference keeps a float from losing digits
    norm += weight * weight;
  }
  return 2 * fps * fps * sum / norm;
}

}  // namespace rigless::detail
