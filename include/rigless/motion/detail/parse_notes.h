// What a parser worked around, so that the user can be told. Public through the parsers.
#pragma once

#include <cstdint>
#include <vector>

#include "rigless/math/types.h"

namespace rigless {

struct ParseNotes {
  std::int32_t frames_declared = 0;  // what the header says; 0 when it says nothing
  std::int32_t frames_read = 0;
  bool frame_cut = false;            // the text ends inside a frame, which is left out
  bool text_after_end = false;       // something follows the declared frames and is not read
  bool frame_time_assumed = false;   // no usable frame time: 1/30 s
  std::int32_t roots = 1;            // more than one: only the first hierarchy is read
  std::int32_t renamed = 0;          // joints whose name was taken or empty
  std::int32_t lengths_ignored = 0;  // channels that stretch or shift a bone (ASF `l`, `tx`), per skeleton
  std::int32_t joints_folded = 0;    // joints above the hips, whose motion is the hips' now
  std::vector<Vec3<double>> rest;    // J, joint positions without any motion, file units, root at the origin
};

}  // namespace rigless
