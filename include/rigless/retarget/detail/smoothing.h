// Hann-window smoothing of a series.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "rigless/math/span.h"

namespace rigless::detail {

// Smooths `values` (T) in place by a Hann window as long as `frames_at_30` frames at 30 fps (an odd number of frames at
// `fps`), its zero ends left out; the ends of the series are repeated. T: a scalar or a vector. Allocates.
template <class T, class S>
void smooth_hann(std::vector<T>& values, S frames_at_30, S fps) {
  const S half = frames_at_30 * fps / S(30) / S(2);
  const auto reach = static_cast<std::ptrdiff_t>(std::max(S(0), half));
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  std::vector<S> window;
  S total = 0;
  for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
    const S angle = S(3.14159265358979323846) * static_cast<S>(k) / static_cast<S>(reach + 1);
    window.push_back((S(1) + std::cos(angle)) / S(2));
    total += window.back();
  }
  const std::vector<T> raw = values;
  for (std::ptrdiff_t f = 0; f < count; ++f) {
    T sum = nth(raw, f) * S(0);
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
      const std::ptrdiff_t g = std::clamp<std::ptrdiff_t>(f + k, 0, count - 1);
      sum += nth(raw, g) * (nth(window, k + reach) / total);
    }
    nth(values, f) = sum;
  }
}

}  // namespace rigless::detail
