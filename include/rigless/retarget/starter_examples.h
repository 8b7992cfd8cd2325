// Examples made up by the system, so that a model moves before the user has shown it anything.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/retarget/example.h"
#include "rigless/retarget/key_poses.h"

namespace rigless {

template <class S>
struct StarterOptions {
  std::int32_t count = 6;   // starters at most
  std::int32_t enough = 4;  // with that many examples by the user there are none
  // A starter this near to an example of the user is dropped, in spreads per joint: half the distance that two random
  // poses of the clip have.
  S nearest = S(0.7);
};

// The pose about which a clip moves: each joint's median, axis by axis. A person who stands and jumps once stands.
// clip: T x J; J positions. Allocates.
template <class S>
std::vector<Vec3<S>> median_pose(Span<const Vec3<S>> clip, std::int32_t joint_count) {
  const auto joints = static_cast<std::size_t>(joint_count);
  std::vector<Vec3<S>> pose(joints, Vec3<S>::Zero());
  std::vector<S> values;
  for (std::size_t j = 0; j < joints; ++j) {
    for (int axis = 0; axis < 3; ++axis) {
      values.clear();
      for (std::size_t i = j; i < clip.size(); i += joints) values.push_back(clip[i][axis]);
      if (values.empty()) continue;
      const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
      std::nth_element(values.begin(), middle, values.end());
      pose[j][axis] = *middle;
    }
  }
  return pose;
}

// How tall a clip's figure is in its median pose. clip: T x J. Allocates.
template <class S>
S figure_height(Span<const Vec3<S>> clip, std::int32_t joint_count) {
  const std::vector<Vec3<S>> median = median_pose(clip, joint_count);
  const auto lower = [](const Vec3<S>& a, const Vec3<S>& b) { return a.y() < b.y(); };
  const auto ends = std::minmax_element(median.begin(), median.end(), lower);
  return median.empty() ? S(0) : ends.second->y() - ends.first->y();
}

// Appends starters to the examples of the user: at key poses of the clip, each control is as far from its rest position
// as its joint is from its median, scaled by the model's height over the human's; a control without a joint rests. What
// the user showed counts more: see StarterOptions.
// clip: T x J, body-local metres; pairs: C joint indices or -1; rest: C, mesh-local; height: of the rest mesh;
// examples: the user's, N x J and N x C, to which starters are appended. Allocates. Errors: no_frames; size_mismatch;
// index_out_of_range (where: control). On failure the examples are untouched.
template <class S>
Status add_starters(Span<const Vec3<S>> clip, std::int32_t joint_count, Span<const std::int32_t> pairs,
                    Span<const Vec3<S>> rest, S height, const StarterOptions<S>& options, ExampleStorage<S>& examples) {
  if (joint_count <= 0 || clip.empty()) return {Error::no_frames, -1};
  const auto joints = static_cast<std::size_t>(joint_count);
  const std::size_t controls = pairs.size(), users = controls > 0 ? examples.controls.size() / controls : 0;
  if (rest.size() != controls || clip.size() % joints != 0 || examples.joints.size() != users * joints ||
      examples.controls.size() != users * controls)
    return {Error::size_mismatch, -1};
  for (std::size_t c = 0; c < controls; ++c)
    if (pairs[c] < -1 || pairs[c] >= joint_count) return {Error::index_out_of_range, static_cast<std::int32_t>(c)};
  if (users >= static_cast<std::size_t>(std::max(options.enough, 0))) return {};

  const std::vector<Vec3<S>> median = median_pose(clip, joint_count);
  const S human = figure_height(clip, joint_count);
  const S scale = human > S(1e-6) ? height / human : S(1);

  const std::vector<std::int32_t> paired = paired_joints(pairs, joint_count);
  const auto spreads = joint_spreads(clip, joint_count);
  for (const KeyPose& key : suggest_key_poses<S>(clip, joint_count, paired, options.count)) {
    const Vec3<S>* pose = &clip[static_cast<std::size_t>(key.frame) * joints];
    bool near = false;
    for (std::size_t n = 0; n < users; ++n) {
      const S distance = pose_distance_squared<S>(&examples.joints[n * joints], pose, paired, spreads);
      near = near || distance < options.nearest * options.nearest;
    }
    if (near) continue;
    examples.joints.insert(examples.joints.end(), pose, pose + joints);
    for (std::size_t c = 0; c < controls; ++c) {
      const auto j = static_cast<std::size_t>(std::max(pairs[c], 0));
      examples.controls.push_back(pairs[c] < 0 ? rest[c] : (rest[c] + scale * (pose[j] - median[j])).eval());
    }
  }
  return {};
}

}  // namespace rigless
