// From the text of a file to a motion on the stage.
#pragma once

#include <string_view>
#include <utility>

#include "rigless/motion/detail/mirror_clip.h"
#include "rigless/motion/detail/motion_format.h"
#include "rigless/motion/parse_acclaim.h"
#include "rigless/motion/parse_bvh.h"
#include "rigless/motion/standardise.h"
#include "rigless/scene/staged_motion.h"

namespace rigless::detail {

// A motion as it was read: what was worked around, what was guessed of the file, and what came of it.
struct MotionRead {
  ParseNotes notes;
  Standardised<double> file;
  StagedMotion<double> staged;
};

// What the user says of a motion.
struct MotionEdits {
  Corrections file;
  bool mirror = false;
  MotionCut cut;
};

// A motion in any format, and the skeleton beside it where its format has one (AMC: the ASF); else that is empty.
// Allocates. Errors: those of the format's parser and of stage_motion(); `in_skeleton` then says whether the line is
// the skeleton's. On failure `motion` keeps what it had.
inline Status read_motion(std::string_view text, std::string_view skeleton, const MotionEdits& edits,
                          MotionRead& motion, bool& in_skeleton) {
  Clip<double> clip;
  MotionRead read;
  in_skeleton = false;
  if (motion_format(text) == MotionFormat::amc) {
    AcclaimSkeleton bones;
    const Status status = parse_asf(skeleton, bones);
    in_skeleton = !status.ok();
    if (in_skeleton) return status;
    if (const Status amc = parse_amc(text, bones, clip, &read.notes); !amc.ok()) return amc;
  } else {
    if (const Status status = parse_bvh(text, clip, &read.notes, edits.file.hips()); !status.ok()) return status;
  }
  const double fps = clip.fps;
  read.file = standardise<double>(clip, read.notes.rest, edits.file);
  if (edits.mirror) mirror_clip(clip, read.file.roles);
  const Status status = stage_motion(clip, read.file.roles, read.staged, edits.cut);
  if (!status.ok()) return status;
  read.staged.source_fps = fps;  // whatever is said of it
  motion = std::move(read);
  return {};
}

}  // namespace rigless::detail
