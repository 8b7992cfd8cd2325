// The motions that the page holds.
#pragma once

#include "handle_table.h"
#include "rigless/scene/detail/read_motion.h"

namespace rigless_wasm {

// A motion as it was read.
struct Motion : rigless::detail::MotionRead {
  bool in_skeleton = false;                // what was wrong
  std::vector<rigless::BodyPlace> places;  // J
};

inline HandleTable<Motion> motions;

}  // namespace rigless_wasm
