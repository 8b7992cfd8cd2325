// A motion as positions: what every parser gives and everything after it takes.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "rigless/math/types.h"

namespace rigless {

// J joints in hierarchy order: a parent comes before its children, joint 0 is the root (parent -1).
struct Skeleton {
  std::vector<std::string> names;     // J, unique
  std::vector<std::int32_t> parents;  // J
};

// T frames of J joint positions in world space.
template <class S>
struct Clip {
  Skeleton skeleton;
  S fps = 0;                                        // frames per second
  S metres_per_unit = 0;                            // what the file's lengths were multiplied by
  std::int32_t frames = 0;                          // T
  std::vector<Vec3<S>> positions;                   // T x J, frame by frame, metres
  std::vector<Eigen::Quaternion<S>> root_rotation;  // T, unit, the root joint's world orientation

  std::int32_t joints() const { return static_cast<std::int32_t>(skeleton.names.size()); }
  const Vec3<S>& at(std::int32_t frame, std::int32_t joint) const {
    return positions[static_cast<std::size_t>(frame) * skeleton.names.size() + static_cast<std::size_t>(joint)];
  }
};

// What a file's frame time is in, which should be seconds.
enum class FrameTimeUnit : std::int32_t { seconds, milliseconds, rate };

// What a parser worked around, so that the user can be told.
struct ParseNotes {
  std::int32_t frames_declared = 0;  // what the header says; 0 when it says nothing
  std::int32_t frames_read = 0;
  bool frame_cut = false;           // the text ends inside a frame, which is left out
  bool text_after_end = false;      // something follows the declared frames and is not read
  bool frame_time_assumed = false;  // no usable frame time or rate: 1/30 s, of an AMC 1/120 s
  FrameTimeUnit frame_time_unit = FrameTimeUnit::seconds;
  bool frame_numbers = false;        // each row begins with its number, which is not read
  std::int32_t rows_replaced = 0;    // rows with too few or too many numbers, which became copies of those before
  std::int32_t row_replaced = -1;    // the line of the first of them
  bool radians = false;              // angles are, although the format says degrees
  std::int32_t roots = 1;            // more than one: only the first hierarchy is read
  std::int32_t renamed = 0;          // joints whose name was taken or empty
  std::int32_t lengths_ignored = 0;  // channels that stretch or shift a bone (ASF `l`, `tx`; BVH scales that are not 1)
  std::int32_t joints_folded = 0;    // joints above the hips, whose motion is the hips' now
  std::vector<Vec3<double>> rest;    // J, joint positions without any motion, file units, root at the origin
};

}  // namespace rigless
