// Which motion format a text is, from its first words.
#pragma once

#include <cstdint>
#include <string_view>

#include "rigless/motion/detail/text_scanner.h"

namespace rigless::detail {

enum class MotionFormat : std::int32_t { unknown, bvh, asf, amc };

// Looks at the first words only: a text that is sniffed right can still fail to parse. Does not allocate.
inline MotionFormat motion_format(std::string_view text) {
  TextScanner scanner(text);
  std::string_view word = scanner.word();
  if (same_word(word, "HIERARCHY") || same_word(word, "ROOT")) return MotionFormat::bvh;
  // An AMC file goes from its keywords, if it has any, to a frame number; an ASF file has values after the first
  // keyword.
  if (same_word(word, ":fully-specified") || same_word(word, ":degrees") || same_word(word, ":radians") ||
      same_word(word, ":samples-per-second")) {
    return MotionFormat::amc;
  }
  for (const std::string_view section : {":version", ":name", ":units", ":documentation", ":root", ":bonedata"}) {
    if (same_word(word, section)) return MotionFormat::asf;
  }
  double frame = 0;
  double value = 0;
  const bool frame_number = !word.empty() && scan_number(word, frame) == word.size();
  const std::string_view bone = scanner.word();
  if (frame_number && !bone.empty() && scan_number(bone, value) == 0 && scanner.number(value).ok()) {
    return MotionFormat::amc;
  }
  return MotionFormat::unknown;
}

}  // namespace rigless::detail
