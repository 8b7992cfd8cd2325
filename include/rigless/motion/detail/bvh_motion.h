// The joint positions that the rows of a BVH file give its hierarchy.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "rigless/motion/clip.h"
#include "rigless/motion/detail/bvh_hierarchy.h"
#include "rigless/motion/detail/bvh_rows.h"
#include "rigless/motion/detail/euler.h"
#include "rigless/motion/detail/fold_root.h"

namespace rigless::detail {

// Do the position channels of joints below the root hold the whole translation (true), or what comes on top of OFFSET?
// Exporters do either; the sum of squares tells which, because bones hardly change their length.
inline bool bvh_positions_stand_for_offset(const BvhHierarchy& hierarchy, const BvhMotion& motion) {
  double from_offset = 0;
  double from_zero = 0;
  const std::size_t stride = static_cast<std::size_t>(hierarchy.channels);
  std::size_t first = 0;
  for (const BvhNode& node : hierarchy.nodes) {
    for (std::size_t k = 0; k < node.channels.size() && node.parent >= 0; ++k) {
      if (node.channels[k].kind != BvhChannel::Kind::position) continue;
      const double offset = node.offset[node.channels[k].axis];
      for (std::size_t i = first + k; i < motion.values.size(); i += stride) {
        from_offset += (motion.values[i] - offset) * (motion.values[i] - offset);
        from_zero += motion.values[i] * motion.values[i];
      }
    }
    first += node.channels.size();
  }
  return from_offset <= from_zero;
}

// The largest value of a frame of a kind of channel below the root, in size.
template <class Size>
double largest_below_root(const BvhHierarchy& hierarchy, const BvhMotion& motion, BvhChannel::Kind kind, Size size) {
  double largest = 0;
  const std::size_t stride = static_cast<std::size_t>(hierarchy.channels);
  std::size_t first = 0;
  for (const BvhNode& node : hierarchy.nodes) {
    for (std::size_t k = 0; k < node.channels.size() && node.parent >= 0; ++k) {
      if (node.channels[k].kind != kind) continue;
      for (std::size_t i = first + k; i < motion.values.size(); i += stride)
        largest = std::max(largest, size(motion.values[i]));
    }
    first += node.channels.size();
  }
  return largest;
}

// Angles are radians where those of many joints stay within half a turn of them and one is a bend that is seen: nobody
// moves for whole seconds and bends no joint by more than 3.15 degrees.
inline bool bvh_in_radians(const BvhHierarchy& hierarchy, const BvhMotion& motion) {
  const double bend =
      largest_below_root(hierarchy, motion, BvhChannel::Kind::rotation, [](double x) { return std::abs(x); });
  return hierarchy.joints >= 12 && bend > 0.6 && bend < 3.15;
}

// How the values of a file are meant.
struct BvhReading {
  bool stand_for_offset;  // position channels below the root
  double angle_unit;      // radians
};

// One frame of world positions and rotations.
inline void pose_bvh(const BvhHierarchy& hierarchy, const double* values, const BvhReading& reading,
                     std::vector<Vec3<double>>& positions, std::vector<Mat3<double>>& rotations) {
  for (std::size_t j = 0; j < static_cast<std::size_t>(hierarchy.joints); ++j) {
    const BvhNode& node = hierarchy.nodes[j];
    const bool root = node.parent < 0;
    Vec3<double> translation = node.offset;
    Mat3<double> rotation = root ? Mat3<double>::Identity() : rotations[static_cast<std::size_t>(node.parent)];
    const Mat3<double> frame = rotation;
    for (const BvhChannel& channel : node.channels) {
      const double value = *values++;
      if (channel.kind == BvhChannel::Kind::rotation) {
        turn_about_axis(channel.axis, value * reading.angle_unit, rotation);
      } else if (channel.kind == BvhChannel::Kind::position) {
        translation[channel.axis] = root || reading.stand_for_offset ? value : node.offset[channel.axis] + value;
      }
    }
    for (int k = 0; k < 3; ++k)
      positions[j][k] = frame(k, 0) * translation[0] + (frame(k, 1) * translation[1] + frame(k, 2) * translation[2]);
    if (!root) positions[j] += positions[static_cast<std::size_t>(node.parent)];
    rotations[j] = rotation;
  }
}

// Joint positions without motion from the hips on, in the axes in which a joint above them leaves them in a pose.
inline std::vector<Vec3<double>> bvh_rest(const BvhHierarchy& hierarchy, const KeptJoints& kept,
                                          const std::vector<Mat3<double>>& rotations) {
  std::vector<Vec3<double>> rest(static_cast<std::size_t>(hierarchy.joints), Vec3<double>::Zero());
  std::vector<Vec3<double>> result;
  for (const std::int32_t j : kept.joints) {
    const BvhNode& node = hierarchy.nodes[static_cast<std::size_t>(j)];
    Vec3<double>& at = rest[static_cast<std::size_t>(j)];
    if (!result.empty()) at = rest[static_cast<std::size_t>(node.parent)] + node.offset;
    result.push_back(at);
  }
  const std::int32_t above = hierarchy.nodes[kept.hips()].parent;
  for (Vec3<double>& p : result) {
    if (above >= 0) p = (rotations[static_cast<std::size_t>(above)] * p).eval();
  }
  return result;
}

// The world positions of the joints that the clip keeps; the root's rotation is that of the hips.
template <class S>
void pose_bvh_clip(const BvhHierarchy& hierarchy, const BvhMotion& motion, const Skeleton& skeleton,
                   std::string_view hips, Clip<S>& clip, ParseNotes& notes) {
  const std::size_t joints = skeleton.names.size();
  notes.radians = bvh_in_radians(hierarchy, motion);
  const BvhReading reading = {bvh_positions_stand_for_offset(hierarchy, motion),
                              notes.radians ? 1.0 : radians_per_degree};
  const auto stretch = [](double x) { return std::abs(x - 1); };
  notes.lengths_ignored = largest_below_root(hierarchy, motion, BvhChannel::Kind::scale, stretch) > 1e-3 ? 1 : 0;
  std::vector<Vec3<double>> positions(joints);
  std::vector<Mat3<double>> rotations(joints);
  pose_bvh(hierarchy, motion.values.data(), reading, positions, rotations);
  const KeptJoints kept = joints_from_hips(skeleton, positions, hips);
  clip.skeleton = kept_skeleton(skeleton, kept);
  notes.joints_folded = kept.above;
  notes.rest = bvh_rest(hierarchy, kept, rotations);
  clip.positions.reserve(static_cast<std::size_t>(clip.frames) * kept.joints.size());
  clip.root_rotation.reserve(static_cast<std::size_t>(clip.frames));
  const std::size_t stride = static_cast<std::size_t>(hierarchy.channels);
  for (std::size_t i = 0; i < motion.values.size(); i += stride) {
    pose_bvh(hierarchy, motion.values.data() + i, reading, positions, rotations);
    for (const std::int32_t j : kept.joints) clip.positions.push_back(positions[static_cast<std::size_t>(j)].cast<S>());
    clip.root_rotation.push_back(Eigen::Quaterniond(rotations[kept.hips()]).normalized().cast<S>());
  }
}

}  // namespace rigless::detail
