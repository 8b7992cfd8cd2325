// Poses that a smaller or a larger actor showed.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"

namespace rigless::detail {

// The same bones in another pose: how many times as long they are in all. 1 where hardly any is known, or the
// difference is one of rounding. parents: J; pose and other: J, not finite where unknown. No allocation.
template <class S>
S bone_ratio(Span<const std::int32_t> parents, Span<const Vec3<S>> pose, Span<const Vec3<S>> other) {
  constexpr int fewest = 3;
  constexpr double rounding = 0.02;
  S length = 0, other_length = 0;
  int bones = 0;
  for (std::size_t j = 0; j < parents.size(); ++j) {
    if (parents[j] < 0) continue;
    const auto p = to_size(parents[j]);
    const S bone = (pose[j] - pose[p]).norm(), other_bone = (other[j] - other[p]).norm();
    if (!std::isfinite(bone + other_bone) || !(bone > S(0)) || !(other_bone > S(0))) continue;
    length += bone;
    other_length += other_bone;
    ++bones;
  }
  if (bones < fewest) return S(1);
  const S ratio = other_length / length;
  return std::abs(ratio - S(1)) < S(rounding) ? S(1) : ratio;
}

// Makes the actor of each of N poses as large as the one of `pose` (J): a child's jump teaches what a giant's does.
// examples: N x J, body-local. No allocation.
template <class S>
void scale_to_actor(Span<const std::int32_t> parents, Span<const Vec3<S>> pose, std::vector<Vec3<S>>& examples) {
  const std::size_t joints = parents.size();
  for (std::size_t first = 0; first < examples.size(); first += joints) {
    const S ratio = bone_ratio<S>(parents, {examples.data() + first, joints}, pose);
    for (std::size_t j = 0; j < joints; ++j) examples[first + j] *= ratio;
  }
}

}  // namespace rigless::detail
