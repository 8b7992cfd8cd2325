// The first lines of the MOTION part of a BVH file: how many frames, and how fast.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "rigless/math/status.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/text_scanner.h"

namespace rigless::detail {

// Seconds a frame, of a value that may be milliseconds or a rate where that is a usual one; 0 if it is of no use.
inline double usable_frame_time(double value, FrameTimeUnit& unit) {
  constexpr double rates[] = {24, 25, 29.97, 30, 48, 50, 59.94, 60, 72, 90, 100, 120, 200, 240};
  const auto usual = [&](double rate, double within) {
    return std::any_of(std::begin(rates), std::end(rates), [&](double r) { return std::abs(r - rate) < within * r; });
  };
  unit = FrameTimeUnit::seconds;
  if (value > 1 && usual(value, 0.004)) {
    unit = FrameTimeUnit::rate;
    return 1 / value;
  }
  if (value > 1 && usual(1000 / value, 0.05)) {  // 17 is 60 a second
    unit = FrameTimeUnit::milliseconds;
    return value / 1000;
  }
  return value >= 1e-4 && value <= 10 ? value : 0;
}

// The lines in either order, with or without colons; each may be missing. Errors: unexpected_end; bad_number;
// bad_syntax: another line.
inline Status read_bvh_motion_header(TextScanner& scanner, double& frame_time, ParseNotes& notes) {
  frame_time = 0;
  bool counted = false;
  bool timed = false;
  while (true) {
    const std::string_view word = scanner.peek();
    double value = 0;
    if (word.empty() && !(counted && timed)) return scanner.fail(Error::unexpected_end);
    if (word.empty()) break;
    if (scan_number(word, value) > 0) break;  // the first row
    const std::string_view key = word.substr(0, word.find(':'));
    const bool is_count = same_word(key, "Frames");
    if (!is_count && !same_word(key, "Frame") && !same_word(key, "FrameTime")) return scanner.fail(Error::bad_syntax);
    scanner.take(key.size());
    if (same_word(key, "Frame") && !scanner.skip(':') && same_word(scanner.peek().substr(0, 4), "Time"))
      scanner.take(4);
    scanner.skip_space();
    scanner.skip(':');
    if (const Status status = scanner.number(value); !status.ok()) return status;
    (is_count ? counted : timed) = true;
    if (is_count) {
      notes.frames_declared = static_cast<std::int32_t>(std::min(std::max(value, 0.0), 2e9));
    } else {
      frame_time = usable_frame_time(value, notes.frame_time_unit);
    }
  }
  notes.frame_time_assumed = frame_time == 0;  // a motion at 30 fps is better than none
  if (notes.frame_time_assumed) frame_time = 1.0 / 30.0;
  return {};
}

}  // namespace rigless::detail
