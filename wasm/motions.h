// The motions that the page holds.
#pragma once

#include "handle_table.h"
#include "rigless/scene/detail/read_motion.h"

namespace rigless_wasm {

// A motion as it was read, and what of it goes to the page as float32.
struct Motion : rigless::detail::MotionRead {
  bool in_skeleton = false;                // what was wrong
  std::vector<rigless::BodyPlace> places;  // J
  std::vector<float> positions, local, yaw;
};

inline HandleTable<Motion> motions;

}  // namespace rigless_wasm
