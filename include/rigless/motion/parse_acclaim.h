// ASF/AMC (Acclaim skeleton and motion) to joint positions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rigless/math/detail/macros.h"
#include "rigless/math/status.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/acclaim_skeleton.h"
#include "rigless/motion/detail/amc_parser.h"
#include "rigless/motion/detail/asf_parser.h"
#include "rigless/motion/detail/euler.h"
#include "rigless/motion/detail/parse_notes.h"
#include "rigless/motion/parse_bvh.h"

namespace rigless {

// An ASF file. Sections in any order; what is unknown (limits, masses, comments) is skipped. Allocates in proportion to
// the text. Errors: empty_input; not_this_format: no :root, :bonedata and :hierarchy, for example an AMC file;
// unexpected_end, bad_number, bad_syntax, duplicate_joint, unknown_joint with their line; unsupported: more than 4096
// bones. `skeleton` then keeps what it had.
inline Status parse_asf(std::string_view text, AcclaimSkeleton& skeleton);

// An AMC file on a skeleton that was read before. A joint is the END of its bone, in metres; 120 frames per second
// unless the file says otherwise (:SAMPLES-PER-SECOND). Bones may come in any order; one that a frame leaves out is at
// rest, the root stays where it was. Values that stretch or shift a bone are read and ignored. Allocates in proportion
// to the text. Errors: empty_input, not_this_format; unknown_joint: a bone that the skeleton has not, commonly because
// the two files belong to different people; bad_number, bad_syntax: not as many values as the bone has dofs, with their
// line; no_frames; not_finite: a number too large for S; out_of_memory: more than 2^26 positions. `clip` and `notes`
// then keep what they had.
template <class S>
Status parse_amc(std::string_view text, const AcclaimSkeleton& skeleton, Clip<S>& clip, ParseNotes* notes = nullptr);

// Both files; errors as parse_asf and parse_amc. Whoever has to say in which file a line is calls those two.
template <class S>
Status parse_acclaim(std::string_view asf, std::string_view amc, Clip<S>& clip, ParseNotes* notes = nullptr);

// ---------------------------------------------------------------------------------------------------------------------

inline Status parse_asf(std::string_view text, AcclaimSkeleton& skeleton) {
  detail::AsfParser parser(text);
  if (const Status status = parser.parse(); !status.ok()) return status;
  skeleton = std::move(parser.skeleton());
  return {};
}

// One frame of world positions and rotations, in file units. Bone by bone C M inverse(C) turns it from rest in its
// parent's axes; M applies the channels first to last.
inline void pose_acclaim(const AcclaimSkeleton& skeleton, const detail::AmcParser& motion, const double* values,
                         std::vector<Vec3<double>>& positions, std::vector<Mat3<double>>& rotations) {
  const double angle_unit = motion.degrees() ? detail::radians_per_degree : 1.0;
  for (const std::int32_t index : skeleton.order) {
    const std::size_t b = static_cast<std::size_t>(index);
    const AcclaimBone& bone = skeleton.bones[b];
    Vec3<double> translation = bone.parent < 0 ? skeleton.root_position : Vec3<double>(bone.direction * bone.length);
    Mat3<double> turn = Mat3<double>::Identity();
    const double* value = values + motion.first(b);
    for (std::size_t k = bone.channels.size(); k-- > 0;) {
      const AcclaimChannel& channel = bone.channels[k];
      if (channel.kind == AcclaimChannel::Kind::rotation)
        detail::turn_about_axis(channel.axis, value[k] * angle_unit, turn);
      if (channel.kind == AcclaimChannel::Kind::translation && bone.parent < 0) translation[channel.axis] = value[k];
    }
    rotations[b] = bone.axis * turn * bone.axis.transpose();
    positions[b] = translation;
    if (bone.parent < 0) continue;
    const std::size_t parent = static_cast<std::size_t>(bone.parent);
    rotations[b] = (rotations[parent] * rotations[b]).eval();
    positions[b] = positions[parent] + rotations[b] * translation;
  }
}

template <class S>
void add_acclaim_skeleton(const AcclaimSkeleton& skeleton, Clip<S>& clip, ParseNotes& notes) {
  std::vector<std::int32_t> joint_of_bone(skeleton.bones.size(), -1);
  for (const std::int32_t index : skeleton.order) {
    const AcclaimBone& bone = skeleton.bones[static_cast<std::size_t>(index)];
    joint_of_bone[static_cast<std::size_t>(index)] = clip.joints();
    const std::int32_t parent = bone.parent < 0 ? -1 : joint_of_bone[static_cast<std::size_t>(bone.parent)];
    clip.skeleton.names.push_back(bone.name);
    clip.skeleton.parents.push_back(parent);
    notes.rest.push_back(
        parent < 0 ? Vec3<double>(0, 0, 0)
                   : Vec3<double>(notes.rest[static_cast<std::size_t>(parent)] + bone.direction * bone.length));
    for (const AcclaimChannel& channel : bone.channels) {
      const bool used = channel.kind == AcclaimChannel::Kind::rotation ||
                        (channel.kind == AcclaimChannel::Kind::translation && parent < 0);
      notes.lengths_ignored += used ? 0 : 1;
    }
  }
}

template <class S>
Status parse_amc(std::string_view text, const AcclaimSkeleton& skeleton, Clip<S>& clip, ParseNotes* notes) {
  RIGLESS_ASSERT(!skeleton.order.empty());
  detail::AmcParser motion(text, skeleton);
  if (const Status status = motion.parse(); !status.ok()) return status;

  const double scale = 0.0254 / skeleton.length_unit;
  Clip<S> result;
  ParseNotes found;
  add_acclaim_skeleton(skeleton, result, found);
  result.fps = static_cast<S>(motion.fps());
  result.metres_per_unit = static_cast<S>(scale);
  result.frames = static_cast<std::int32_t>(motion.frames());
  result.positions.reserve(motion.frames() * skeleton.order.size());
  result.root_rotation.reserve(motion.frames());
  std::vector<Vec3<double>> positions(skeleton.bones.size());
  std::vector<Mat3<double>> rotations(skeleton.bones.size());
  for (std::size_t f = 0; f < motion.frames(); ++f) {
    pose_acclaim(skeleton, motion, motion.frame(f), positions, rotations);
    for (const std::int32_t bone : skeleton.order) {
      result.positions.push_back((positions[static_cast<std::size_t>(bone)] * scale).template cast<S>());
    }
    result.root_rotation.push_back(Eigen::Quaterniond(rotations[0]).normalized().cast<S>());
  }
  if (!all_finite(result)) return {Error::not_finite, -1};
  found.frames_read = result.frames;
  found.frame_cut = motion.frame_cut();
  clip = std::move(result);
  if (notes != nullptr) *notes = std::move(found);
  return {};
}

template <class S>
Status parse_acclaim(std::string_view asf, std::string_view amc, Clip<S>& clip, ParseNotes* notes) {
  AcclaimSkeleton skeleton;
  if (const Status status = parse_asf(asf, skeleton); !status.ok()) return status;
  return parse_amc(amc, skeleton, clip, notes);
}

}  // namespace rigless
