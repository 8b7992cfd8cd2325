// The motions that the page holds.
#pragma once

#include "handle_table.h"
#include "rigless/motion/parse_acclaim.h"
#include "rigless/motion/standardise.h"
#include "rigless/scene/staged_motion.h"

namespace rigless_wasm {

// A motion as it was read, and what of it goes to the page as float32.
struct Motion {
  rigless::AcclaimSkeleton skeleton;
  rigless::ParseNotes notes;
  rigless::Standardised<double> file;
  rigless::StagedMotion<double> staged;
  std::vector<rigless::BodyPlace> places;
  std::vector<float> positions, local, yaw;
};

inline HandleTable<Motion> motions;

}  // namespace rigless_wasm
