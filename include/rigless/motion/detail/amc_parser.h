// AMC (Acclaim motion): the values that the bones of a skeleton have in every frame.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "rigless/math/status.h"
#include "rigless/motion/detail/acclaim_skeleton.h"
#include "rigless/motion/detail/clip_limits.h"
#include "rigless/motion/detail/text_scanner.h"

namespace rigless::detail {

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
  bool fps_assumed() const { return fps_assumed_; }
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
  bool fps_assumed_ = true;
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
      fps_assumed_ = false;
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
  const std::int32_t found = skeleton_.find(name);
  if (found < 0) return scanner_.fail(Error::unknown_joint);
  const std::size_t bone = static_cast<std::size_t>(found);
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

}  // namespace rigless::detail
