// The model as starters know it, and the human about its middle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/example.h"

namespace rigless::detail {

// The model as starters know it. C controls.
template <class S>
struct StarterModel {
  Span<const Vec3<S>> rest;           // C, mesh-local
  S floor = 0;                        // y of the lowest vertex at rest
  S height = 1;                       // of the mesh at rest
  Span<const std::uint8_t> stands{};  // T x C, not 0 while a control stands; or empty
  Span<const ModelLimb<S>> limbs{};   // C, or empty
};

// Whether a control stands in a frame, and whether it ever does.
template <class S>
bool stands(const StarterModel<S>& model, std::size_t frame, std::size_t c) {
  return !model.stands.empty() && model.stands[frame * model.rest.size() + c] != 0;
}
template <class S>
bool is_foot(const StarterModel<S>& model, std::size_t c) {
  for (std::size_t i = c; i < model.stands.size(); i += model.rest.size())
    if (model.stands[i] != 0) return true;
  return false;
}

// Makes soles that stand in a frame level, and no other lower. places: C. No allocation.
template <class S>
RIGLESS_COLD void level_soles(const StarterModel<S>& model, std::size_t frame, Span<Vec3<S>> places) {
  S sum = 0, count = 0;
  for (std::size_t c = 0; c < places.size(); ++c) {
    if (!stands(model, frame, c)) continue;
    sum += places[c].y() - model.rest[c].y();
    count += S(1);
  }
  for (std::size_t c = 0; c < places.size() && count > S(0); ++c) {
    if (!is_foot(model, c)) continue;
    const S level = model.rest[c].y() + sum / count;
    places[c].y() = stands(model, frame, c) ? level : std::max(places[c].y(), level);
  }
}

// The pose about which a clip moves: each joint's median, axis by axis. A person who stands and jumps once stands.
// clip: T x J; J positions. Allocates.
template <class S>
RIGLESS_COLD std::vector<Vec3<S>> median_pose(Span<const Vec3<S>> clip, std::int32_t joint_count) {
  const auto joints = to_size(joint_count);
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

}  // namespace rigless::detail
