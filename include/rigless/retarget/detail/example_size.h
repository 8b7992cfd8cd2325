// Examples made larger or smaller: for an actor of another size, and to go farther.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"

namespace rigless::detail {

// The same bones in another pose: how many times as long most of them are (the median). 1 where hardly any is known, or
// the difference is one of rounding. parents: J; pose and other: J, not finite where unknown. Allocates.
template <class S>
S bone_ratio(Span<const std::int32_t> parents, Span<const Vec3<S>> pose, Span<const Vec3<S>> other) {
  constexpr std::size_t fewest = 3;
  constexpr double rounding = 0.02;
  std::vector<S> ratios;
  for (std::size_t j = 0; j < parents.size(); ++j) {
    if (parents[j] < 0) continue;
    const auto p = to_size(parents[j]);
    const S ratio = (other[j] - other[p]).norm() / (pose[j] - pose[p]).norm();
    if (std::isfinite(ratio) && ratio > S(0)) ratios.push_back(ratio);
  }
  if (ratios.size() < fewest) return S(1);
  for (std::size_t i = 1; i < ratios.size(); ++i)  // few: std::sort would bring a kilobyte of wasm
    for (std::size_t k = i; k > 0 && ratios[k] < ratios[k - 1]; --k) std::swap(ratios[k], ratios[k - 1]);
  const S median = ratios[ratios.size() / 2];
  return std::abs(median - S(1)) < S(rounding) ? S(1) : median;
}

// Makes the actor of each of N poses as large as the one of `pose` (J): a child's jump teaches what a giant's does.
// examples: N x J, body-local. Allocates.
template <class S>
RIGLESS_COLD void scale_to_actor(Span<const std::int32_t> parents, Span<const Vec3<S>> pose,
                                 std::vector<Vec3<S>>& examples) {
  const std::size_t joints = parents.size();
  for (std::size_t first = 0; first < examples.size(); first += joints) {
    const S ratio = bone_ratio<S>(parents, {examples.data() + first, joints}, pose);
    for (std::size_t j = 0; j < joints; ++j) examples[first + j] *= ratio;
  }
}

// Poses farther from rest, or nearer to it. rest: C; poses: N x C.
template <class S>
void exaggerate(Span<const Vec3<S>> rest, S energy, std::vector<Vec3<S>>& poses) {
  constexpr double farther = 0.4;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vec3<S>& from = rest[i % rest.size()];
    poses[i] = from + (1 + S(farther) * energy) * (poses[i] - from);
  }
}

}  // namespace rigless::detail
