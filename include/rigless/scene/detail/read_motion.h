// From the text of a file to a motion on the stage.
#pragma once

#include <string_view>

#include "rigless/motion/detail/motion_format.h"
#include "rigless/motion/parse_acclaim.h"
#include "rigless/motion/parse_bvh.h"
#include "rigless/motion/standardise.h"
#include "rigless/scene/staged_motion.h"

namespace rigless::detail {

// A BVH file, or an AMC file on the skeleton of an ASF file. Allocates. Errors: those of parse_bvh() or
// parse_acclaim(), and of stage_motion(). On failure `motion` keeps what it had.
inline Status read_motion(std::string_view text, std::string_view skeleton, StagedMotion<double>& motion) {
  Clip<double> clip;
  ParseNotes notes;
  if (motion_format(text) == MotionFormat::amc) {
    if (const Status status = parse_acclaim(skeleton, text, clip, &notes); !status.ok()) return status;
  } else {
    if (const Status status = parse_bvh(text, clip, &notes); !status.ok()) return status;
  }
  const JointRoles roles = standardise<double>(clip, notes.rest).roles;
  return stage_motion(clip, roles, motion);
}

}  // namespace rigless::detail
