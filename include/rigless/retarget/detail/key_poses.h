// Which frames to show the user as key poses.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/pose_spread.h"

namespace rigless::detail {

struct KeyPose {
  std::int32_t frame = 0;
  double radius = 0;  // distance of the frame that is farthest from its nearest key pose, this one included
};

// Farthest point sampling: the first key pose is the frame nearest to the mean, each next one the frame farthest from
// all before it, ties by the lowest index; ends early when every frame is a key pose's twin.
// features: T x D; at most `count` key poses. Allocates.
template <class S>
std::vector<KeyPose> farthest_poses(Span<const S> features, std::int32_t frames, std::int32_t count) {
  std::vector<KeyPose> keys;
  if (frames <= 0 || count <= 0) return keys;
  const std::size_t size = features.size() / to_size(frames);
  const auto squared_distance = [&](std::size_t frame, const S* from) {
    const S* const pose = features.data() + frame * size;
    S sum = 0;
    for (std::size_t d = 0; d < size; ++d) sum += (pose[d] - from[d]) * (pose[d] - from[d]);
    return sum;
  };
  std::vector<S> mean(size, 0), distance(to_size(frames), std::numeric_limits<S>::infinity());
  for (std::size_t i = 0; i < features.size(); ++i) mean[i % size] += features[i];
  for (S& m : mean) m /= static_cast<S>(frames);
  std::size_t next = 0;
  S nearest = std::numeric_limits<S>::infinity();
  for (std::size_t f = 0; f < distance.size(); ++f) {
    const S away = squared_distance(f, mean.data());
    if (away < nearest) next = f;
    nearest = std::min(nearest, away);
  }
  while (keys.size() < to_size(count)) {
    const std::size_t key = next;
    S farthest = -1;
    for (std::size_t f = 0; f < distance.size(); ++f) {
      distance[f] = std::min(distance[f], squared_distance(f, features.data() + key * size));
      if (distance[f] > farthest) next = f;
      farthest = std::max(farthest, distance[f]);
    }
    keys.push_back({static_cast<std::int32_t>(key), std::sqrt(static_cast<double>(farthest))});
    if (farthest <= S(0)) break;
  }
  return keys;
}

// Key poses of a clip over `joints`, each joint measured in its spread over the clip; radii in those spreads, averaged
// over the joints. clip: T x J body-local. Allocates.
template <class S>
std::vector<KeyPose> suggest_key_poses(Span<const Vec3<S>> clip, std::int32_t joint_count,
                                       Span<const std::int32_t> joints, std::int32_t count) {
  const auto stride = to_size(joint_count);
  const auto spreads = joint_spreads(clip, joint_count);
  const S shared = std::sqrt(static_cast<S>(joints.size()));
  std::vector<S> features;
  for (std::size_t first = 0; first < clip.size(); first += stride) {
    for (const std::int32_t index : joints) {
      const auto j = to_size(index);
      for (int axis = 0; axis < 3; ++axis)
        features.push_back((clip[first + j][axis] - spreads[j].mean[axis]) / (spreads[j].scale() * shared));
    }
  }
  return farthest_poses<S>(features, static_cast<std::int32_t>(clip.size() / stride), count);
}

}  // namespace rigless::detail
