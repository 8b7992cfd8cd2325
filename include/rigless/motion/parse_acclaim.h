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
#include "rigless/motion/detail/euler.h"
#include "rigless/motion/detail/parse_asf.h"
#include "rigless/motion/detail/parse_notes.h"
#include "rigless/motion/detail/text_scanner.h"
#include "rigless/motion/parse_bvh.h"

namespace rigless {

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

// The values of all frames: for each the bones in the skeleton's order, each with its channels.
class AmcParser {
 public:
  AmcParser(std::string_view text, const AcclaimSkeleton& skeleton) : scanner_(text), skeleton_(skeleton) {
    first_.reserve(skeleton.bones.size());
    for (const AcclaimBone& bone : skeleton.bones) {
      first_.push_back(stride_);
      stride_ += bone.channels.size();
    }
  }

  Status parse();

  std::size_t first(std::size_t bone) const { return first_[bone]; }
  std::size_t stride() const { return stride_; }
  std::size_t frames() const { return frames_; }
  const double* frame(std::size_t f) const { return values_.data() + f * stride_; }
  bool degrees() const { return degrees_; }
  double fps() const { return fps_; }
  bool frame_cut() const { return frame_cut_; }

 private:
  Status read_header();
  void begin_frame();
  Status read_bone(std::string_view name);
  void drop_cut_frame(bool inside_bone);

  TextScanner scanner_;
  const AcclaimSkeleton& skeleton_;
  std::vector<std::size_t> first_;
  std::vector<double> values_;
  std::vector<std::int32_t> lines_;  // bones that each frame names
  std::size_t stride_ = 0;
  std::size_t frames_ = 0;
  bool degrees_ = true;
  double fps_ = 120;
  bool frame_cut_ = false;
};

inline Status AmcParser::read_header() {
  if (!scanner_.more()) return {Error::empty_input, -1};
  degrees_ = skeleton_.degrees;
  while (!scanner_.peek().empty() && scanner_.peek()[0] == ':') {
    const std::string_view word = scanner_.word();
    if (same_word(word, ":degrees")) degrees_ = true;
    if (same_word(word, ":radians")) degrees_ = false;
    if (same_word(word, ":samples-per-second")) {
      if (const Status status = scanner_.number(fps_); !status.ok()) return status;
      if (!(fps_ >= 0.1 && fps_ <= 1e4)) return scanner_.fail(Error::bad_number);
    } else if (same_word(word, ":version") || same_word(word, ":bonedata") || same_word(word, ":root")) {
      return scanner_.fail(Error::not_this_format);  // a skeleton
    }
  }
  double number = 0;
  const std::string_view word = scanner_.peek();
  if (word.empty()) return {Error::no_frames, -1};
  return scan_number(word, number) == word.size() ? Status{} : scanner_.fail(Error::not_this_format);
}

inline void AmcParser::begin_frame() {
  values_.resize((frames_ + 1) * stride_, 0.0);
  if (frames_ > 0) {
    std::copy_n(frame(frames_ - 1), skeleton_.bones[0].channels.size(), values_.data() + frames_ * stride_);
  }
  ++frames_;
  lines_.push_back(0);
}

inline Status AmcParser::read_bone(std::string_view name) {
  const auto found = skeleton_.index.find(std::string(name));
  if (found == skeleton_.index.end()) return scanner_.fail(Error::unknown_joint);
  const std::size_t bone = static_cast<std::size_t>(found->second);
  double* values = values_.data() + (frames_ - 1) * stride_ + first_[bone];
  const std::int32_t line = scanner_.line();
  for (std::size_t k = 0; k < skeleton_.bones[bone].channels.size(); ++k) {
    if (scanner_.more() && scanner_.line() != line) return {Error::bad_syntax, line};
    if (const Status status = scanner_.number(values[k]); !status.ok()) return status;
  }
  double excess = 0;
  const std::string_view next = scanner_.peek();
  const bool too_many = !next.empty() && scanner_.line() == line && scan_number(next, excess) > 0;
  ++lines_.back();
  return too_many ? scanner_.fail(Error::bad_syntax) : Status{};
}

// The last frame is whole if its last bone is, and it names as many bones as the first.
inline void AmcParser::drop_cut_frame(bool inside_bone) {
  if (frames_ == 0 || (!inside_bone && lines_.back() >= lines_.front())) return;
  --frames_;
  lines_.pop_back();
  frame_cut_ = true;
}

inline Status AmcParser::parse() {
  if (const Status status = read_header(); !status.ok()) return status;
  bool inside_bone = false;
  while (scanner_.more() && !inside_bone) {
    const std::string_view word = scanner_.word();
    double number = 0;
    if (scan_number(word, number) == word.size()) {
      begin_frame();
      if (frames_ > max_clip_positions / skeleton_.order.size()) return {Error::out_of_memory, -1};
      if (stride_ > 0 && frames_ > max_clip_positions / stride_) return {Error::out_of_memory, -1};
      continue;
    }
    const Status status = read_bone(word);
    inside_bone = status.error == Error::unexpected_end;
    if (!status.ok() && !inside_bone) return status;
  }
  drop_cut_frame(inside_bone);
  return frames_ == 0 ? Status{Error::no_frames, -1} : Status{};
}

// One frame of world positions and rotations, in file units. Bone by bone C M inverse(C) turns it from rest in its
// parent's axes; M applies the channels first to last.
inline void pose_acclaim(const AcclaimSkeleton& skeleton, const AmcParser& motion, const double* values,
                         std::vector<Vec3<double>>& positions, std::vector<Mat3<double>>& rotations) {
  const double angle_unit = motion.degrees() ? radians_per_degree : 1.0;
  for (const std::int32_t index : skeleton.order) {
    const std::size_t b = static_cast<std::size_t>(index);
    const AcclaimBone& bone = skeleton.bones[b];
    Vec3<double> translation = bone.parent < 0 ? skeleton.root_position : Vec3<double>(bone.direction * bone.length);
    Mat3<double> turn = Mat3<double>::Identity();
    const double* value = values + motion.first(b);
    for (std::size_t k = bone.channels.size(); k-- > 0;) {
      const AcclaimChannel& channel = bone.channels[k];
      if (channel.kind == AcclaimChannel::Kind::rotation) turn_about_axis(channel.axis, value[k] * angle_unit, turn);
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
  AmcParser motion(text, skeleton);
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
