// The two words of an ASF file that are short for something: what a value of a bone does, and an order of axes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "rigless/motion/detail/acclaim_skeleton.h"
#include "rigless/motion/detail/text_scanner.h"

namespace rigless::detail {

// "rx", "tz", "l". Returns false if it is none of them; then `channel` says nothing.
inline bool read_asf_channel(std::string_view word, AcclaimChannel& channel) {
  channel = {AcclaimChannel::Kind::length, 0};
  if (same_word(word, "l")) return true;
  if (word.size() != 2) return false;
  const char kind = static_cast<char>(word[0] | 0x20);
  channel.kind = kind == 'r' ? AcclaimChannel::Kind::rotation : AcclaimChannel::Kind::translation;
  channel.axis = (word[1] | 0x20) - 'x';
  return (kind == 'r' || kind == 't') && channel.axis >= 0 && channel.axis < 3;
}

// "XYZ". Returns false if it is none; then `order` says nothing.
inline bool read_asf_order(std::string_view word, std::array<std::int32_t, 3>& order) {
  if (word.size() != 3) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    order[k] = (word[k] | 0x20) - 'x';
    if (order[k] < 0 || order[k] > 2) return false;
  }
  return true;
}

}  // namespace rigless::detail
