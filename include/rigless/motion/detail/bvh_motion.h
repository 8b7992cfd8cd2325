// The MOTION part of a BVH file, and the joint positions that it gives a hierarchy.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "rigless/math/status.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/bvh_hierarchy.h"
#include "rigless/motion/detail/euler.h"
#include "rigless/motion/detail/fold_root.h"
#include "rigless/motion/detail/text_scanner.h"

namespace rigless::detail {

struct BvhMotion {
  double frame_time = 0;
  std::vector<double> values;  // whole frames
};

// The header lines, in either order.
inline Status read_bvh_motion_header(TextScanner& scanner, BvhMotion& motion, ParseNotes& notes) {
  bool timed = false;
  bool counted = false;
  while (!timed || !counted) {
    std::string_view word = scanner.peek();
    if (word.empty()) return scanner.fail(Error::unexpected_end);
    const std::string_view key = word.substr(0, word.find(':'));
    const bool is_count = same_word(key, "Frames");
    const bool is_time = same_word(key, "Frame") || same_word(key, "FrameTime");
    if (!is_count && !is_time) return scanner.fail(Error::bad_syntax);
    scanner.rest_of_line(':');
    double value = 0;
    if (!scanner.skip(':')) return scanner.fail(scanner.more() ? Error::bad_syntax : Error::unexpected_end);
    if (const Status status = scanner.number(value); !status.ok()) return status;
    if (is_count) {
      counted = true;
      notes.frames_declared = static_cast<std::int32_t>(std::min(std::max(value, 0.0), 2e9));
    } else {
      timed = true;
      motion.frame_time = value;
    }
  }
  // 0, or milliseconds, or nonsense: a motion at 30 fps is better than none.
  notes.frame_time_assumed = !(motion.frame_time >= 1e-4 && motion.frame_time <= 10);
  if (notes.frame_time_assumed) motion.frame_time = 1.0 / 30.0;
  return {};
}

inline Status read_bvh_values(TextScanner& scanner, std::size_t channels, BvhMotion& motion, ParseNotes& notes) {
  const std::size_t declared = static_cast<std::size_t>(notes.frames_declared);
  const std::size_t wanted = declared * channels;  // 0: all there is
  const std::size_t present = scanner.remaining() / 2 + 1;
  motion.values.reserve(wanted == 0 ? present / 4 : std::min(wanted, present));
  while ((wanted == 0 || motion.values.size() < wanted) && scanner.more()) {
    double value = 0;
    if (const Status status = scanner.number(value); !status.ok()) return status;
    motion.values.push_back(value);
  }
  notes.text_after_end = scanner.more();
  const std::size_t frames = channels == 0 ? 0 : motion.values.size() / channels;
  notes.frame_cut = motion.values.size() != frames * channels;
  motion.values.resize(frames * channels);
  notes.frames_read = static_cast<std::int32_t>(frames);
  return frames == 0 ? Status{Error::no_frames, -1} : Status{};
}

// Do the position channels of joints below the root hold the whole translation (true), or what comes on top of OFFSET?
// Exporters do either; the sum of squares tells which, because bones hardly change their length.
inline bool bvh_positions_stand_for_offset(const BvhHierarchy& hierarchy, const BvhMotion& motion) {
  double from_offset = 0;
  double from_zero = 0;
  const std::size_t stride = static_cast<std::size_t>(hierarchy.channels);
  std::size_t first = 0;
  for (const BvhNode& node : hierarchy.nodes) {
    for (std::size_t k = 0; k < node.channels.size() && node.parent >= 0; ++k) {
      if (node.channels[k].rotation) continue;
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

// One frame of world positions and rotations.
inline void pose_bvh(const BvhHierarchy& hierarchy, const double* values, bool stand_for_offset,
                     std::vector<Vec3<double>>& positions, std::vector<Mat3<double>>& rotations) {
  for (std::size_t j = 0; j < static_cast<std::size_t>(hierarchy.joints); ++j) {
    const BvhNode& node = hierarchy.nodes[j];
    const bool root = node.parent < 0;
    Vec3<double> translation = node.offset;
    Mat3<double> rotation = root ? Mat3<double>::Identity() : rotations[static_cast<std::size_t>(node.parent)];
    const Mat3<double> frame = rotation;
    for (const BvhChannel& channel : node.channels) {
      const double value = *values++;
      if (channel.rotation) {
        turn_about_axis(channel.axis, value * radians_per_degree, rotation);
      } else {
        translation[channel.axis] = root || stand_for_offset ? value : node.offset[channel.axis] + value;
      }
    }
    positions[j] = frame * translation;
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
void pose_bvh_clip(const BvhHierarchy& hierarchy, const BvhMotion& motion, const Skeleton& skeleton, Clip<S>& clip,
                   ParseNotes& notes) {
  const std::size_t joints = skeleton.names.size();
  const bool stand_for_offset = bvh_positions_stand_for_offset(hierarchy, motion);
  std::vector<Vec3<double>> positions(joints);
  std::vector<Mat3<double>> rotations(joints);
  pose_bvh(hierarchy, motion.values.data(), stand_for_offset, positions, rotations);
  const KeptJoints kept = joints_from_hips(skeleton, positions);
  clip.skeleton = kept_skeleton(skeleton, kept);
  notes.joints_folded = kept.above;
  notes.rest = bvh_rest(hierarchy, kept, rotations);
  clip.positions.reserve(static_cast<std::size_t>(clip.frames) * kept.joints.size());
  clip.root_rotation.reserve(static_cast<std::size_t>(clip.frames));
  const std::size_t stride = static_cast<std::size_t>(hierarchy.channels);
  for (std::size_t i = 0; i < motion.values.size(); i += stride) {
    pose_bvh(hierarchy, motion.values.data() + i, stand_for_offset, positions, rotations);
    for (const std::int32_t j : kept.joints) clip.positions.push_back(positions[static_cast<std::size_t>(j)].cast<S>());
    clip.root_rotation.push_back(Eigen::Quaterniond(rotations[kept.hips()]).normalized().cast<S>());
  }
}

}  // namespace rigless::detail
