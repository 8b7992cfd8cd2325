// How much standing controls slide.
#pragma once

#include <algorithm>
#include <cmath>

#include "rigless/scene/performance.h"

namespace rigless::detail {

// Horizontal speed, in units per second, of controls over the pairs of frames in both of which they are labelled;
// divide by the model's height for heights per second. 0 when nothing stands. tracks: T x C world positions; labels: T
// x C, not 0 while a control stands. No allocation.
template <class S>
Slip<S> measure_slip(Span<const Vec3<S>> tracks, Span<const std::uint8_t> labels, std::int32_t control_count, S fps) {
  RIGLESS_ASSERT(labels.size() == tracks.size());
  const auto controls = to_size(control_count);
  Slip<S> slip;
  S pairs = 0;
  for (std::size_t i = controls; i < tracks.size(); ++i) {
    if (labels[i] == 0 || labels[i - controls] == 0) continue;
    const Vec3<S> step = tracks[i] - tracks[i - controls];
    const S speed = std::sqrt(step.x() * step.x() + step.z() * step.z()) * fps;
    slip.mean += speed;
    slip.maximum = std::max(slip.maximum, speed);
    pairs += S(1);
  }
  if (pairs > S(0)) slip.mean /= pairs;
  return slip;
}

}  // namespace rigless::detail
