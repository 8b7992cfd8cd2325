// How far two poses are apart, measured in how far their joints spread over a clip.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"

namespace rigless::detail {

// The joints that `pairs` (C joint indices below joint_count, or -1) names, without repeats, in order of the controls;
// all joints when no control is paired. Allocates.
inline std::vector<std::int32_t> paired_joints(Span<const std::int32_t> pairs, std::int32_t joint_count) {
  std::vector<std::int32_t> joints;
  std::vector<bool> seen(to_size(joint_count), false);
  for (const std::int32_t j : pairs) {
    if (j < 0 || nth(seen, j)) continue;
    nth(seen, j) = true;
    joints.push_back(j);
  }
  if (joints.empty())
    for (std::int32_t j = 0; j < joint_count; ++j) joints.push_back(j);
  return joints;
}

// Where a joint of a set of poses is on average, and how far from there (root mean square).
template <class S>
struct JointSpread {
  Vec3<S> mean = Vec3<S>::Zero();
  S rms = 0;

  // What a distance is divided by: a joint that does not move keeps its metres.
  S scale() const { return rms > S(1e-9) ? rms : S(1); }
};

// Mean and spread of each joint of T x J positions; rows that are not finite do not count. Allocates.
template <class S>
std::vector<JointSpread<S>> joint_spreads(Span<const Vec3<S>> poses, std::int32_t joint_count) {
  const auto joints = to_size(joint_count);
  const std::size_t frames = poses.size() / joints;
  std::vector<JointSpread<S>> spreads(joints);
  for (std::size_t j = 0; j < joints; ++j) {
    std::size_t known = 0;
    for (std::size_t f = 0; f < frames; ++f) {
      const Vec3<S>& p = poses[f * joints + j];
      if (!p.allFinite()) continue;
      spreads[j].mean += p;
      ++known;
    }
    if (known == 0) continue;
    spreads[j].mean /= static_cast<S>(known);
    S sum = 0;
    for (std::size_t f = 0; f < frames; ++f) {
      const Vec3<S>& p = poses[f * joints + j];
      if (p.allFinite()) sum += (p - spreads[j].mean).squaredNorm();
    }
    spreads[j].rms = std::sqrt(sum / static_cast<S>(known));
  }
  return spreads;
}

// Squared distance of two poses (J joints each) over `joints`, each joint measured in its spread, averaged over the
// joints that both know; infinite if there is none. Two random poses of the clip that gave the spreads lie 2 apart on
// average. No allocation.
template <class S>
S pose_distance_squared(const Vec3<S>* a, const Vec3<S>* b, Span<const std::int32_t> joints,
                        const std::vector<JointSpread<S>>& spreads) {
  S sum = 0;
  std::size_t known = 0;
  for (const std::int32_t index : joints) {
    const auto j = to_size(index);
    if (!a[j].allFinite() || !b[j].allFinite()) continue;
    sum += ((a[j] - b[j]) / spreads[j].scale()).squaredNorm();
    ++known;
  }
  return known > 0 ? sum / static_cast<S>(known) : std::numeric_limits<S>::infinity();
}

// Fills in the joints that examples do not know (an example made on another skeleton): each from the frame of the clip
// that resembles the example most in the paired joints that it does know, or from the clip's mean when it knows none.
// clip: T x J; examples: N x J, changed in place. Allocates.
template <class S>
void fill_unknown_joints(Span<const Vec3<S>> clip, Span<const std::int32_t> paired, std::int32_t joint_count,
                         Span<Vec3<S>> examples) {
  const auto joints = to_size(joint_count);
  const auto spreads = joint_spreads(clip, joint_count);
  for (std::size_t first = 0; first < examples.size(); first += joints) {
    bool whole = true;
    for (std::size_t j = 0; j < joints; ++j) whole = whole && examples[first + j].allFinite();
    if (whole) continue;
    S nearest = std::numeric_limits<S>::infinity();
    std::size_t source = clip.size();
    for (std::size_t f = 0; f < clip.size(); f += joints) {
      const S distance = pose_distance_squared(&examples[first], &clip[f], paired, spreads);
      if (distance >= nearest) continue;
      nearest = distance;
      source = f;
    }
    for (std::size_t j = 0; j < joints; ++j)
      if (!examples[first + j].allFinite())
        examples[first + j] = source < clip.size() ? clip[source + j] : spreads[j].mean;
  }
}

}  // namespace rigless::detail
