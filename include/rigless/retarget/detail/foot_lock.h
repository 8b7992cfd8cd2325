// Feet that stand do not slide.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/band_solver.h"

namespace rigless::detail {

template <class S>
struct FootLockOptions {
  S fps = 30;
  S smoothness = 3;         // of the correction in x and z, at 30 fps
  S height_smoothness = 1;  // in y; 3 would dip below the floor between two contacts
  S weight = S(0.02);       // cost of the squared correction between the contacts, in x and z
  S height_weight = S(1);   // in y: a foot that swings does not skim the ground on its way
};

// Holds each control while it stands: x and z at their mean over the run, y at the control's ground height. Elsewhere
// the correction o minimises weight |o|^2 + |smoothness D2 o|^2, in y by its own weight and smoothness, so it fades in
// before the contact and out after it. A pinned coordinate is where it shall be: a run stands at its pinned places
// instead of its mean, and elsewhere o is 0. tracks: T x C world positions, changed in place; labels: T x C, not 0
// while a control stands; pins: T x C, bit k for axis k, or empty; ground: C, rest height of each control above the
// lowest vertex. Allocates. Errors: no_controls; size_mismatch.
template <class S>
Status lock_feet(Span<Vec3<S>> tracks, Span<const std::uint8_t> labels, Span<const std::uint8_t> pins,
                 Span<const S> ground, const FootLockOptions<S>& options) {
  const std::size_t controls = ground.size();
  if (controls == 0) return {Error::no_controls, -1};
  if (tracks.size() % controls != 0 || labels.size() != tracks.size() ||
      (!pins.empty() && pins.size() != tracks.size()))
    return {Error::size_mismatch, -1};
  const std::size_t frames = tracks.size() / controls;
  const S rate = options.fps / S(30);
  BandSolver<S, 1> system;
  std::vector<Vec3<S>> correction(frames);
  std::vector<Eigen::Matrix<S, 1, 1>> right(frames);

  for (std::size_t c = 0; c < controls; ++c) {
    const auto at = [&](std::size_t f) -> Vec3<S>& { return tracks[f * controls + c]; };
    const auto stands = [&](std::size_t f) { return labels[f * controls + c] != 0; };
    const auto pinned = [&](std::size_t f, int axis) {
      return !pins.empty() && (pins[f * controls + c] >> axis & 1) != 0;
    };
    bool any = false;
    for (std::size_t f = 0; f < frames; ++f) {
      correction[f].setZero();
      if (!stands(f)) continue;
      any = true;
      std::size_t end = f;
      Vec3<S> mean = Vec3<S>::Zero(), pin = Vec3<S>::Zero(), count = Vec3<S>::Zero();
      for (; end < frames && stands(end); ++end) {
        mean += at(end);
        for (int axis = 0; axis < 3; ++axis) {
          if (!pinned(end, axis)) continue;
          pin[axis] += at(end)[axis];
          count[axis] += S(1);
        }
      }
      mean /= static_cast<S>(end - f);
      mean.y() = ground[c];
      for (int axis = 0; axis < 3; ++axis)
        if (count[axis] > S(0)) mean[axis] = pin[axis] / count[axis];
      for (; f < end; ++f) correction[f] = mean - at(f);
      --f;
    }
    if (!any) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const S lambda = (axis == 1 ? options.height_smoothness : options.smoothness) * rate * rate;
      system.bind(static_cast<std::int32_t>(frames));
      for (std::size_t f = 0; f < frames; ++f) {
        const auto second = second_difference_row<S>(static_cast<std::int32_t>(frames), static_cast<std::int32_t>(f));
        typename BandSolver<S, 1>::Row row;
        const bool held = stands(f) || pinned(f, axis);
        for (std::size_t g = 0; g < 5; ++g) row[g](0) = held ? S(0) : lambda * lambda * second[g];
        row[2](0) += held ? S(1) : axis == 1 ? options.height_weight : options.weight;
        system.append(row);
        right[f](0) = correction[f][axis];
      }
      system.solve_in_place(right);
      for (std::size_t f = 0; f < frames; ++f) at(f)[axis] += right[f](0);
    }
  }
  return {};
}

}  // namespace rigless::detail
