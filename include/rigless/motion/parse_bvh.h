// BVH (Biovision hierarchy) to joint positions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "rigless/math/status.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/bvh_header.h"
#include "rigless/motion/detail/bvh_hierarchy.h"
#include "rigless/motion/detail/bvh_motion.h"
#include "rigless/motion/detail/bvh_rows.h"
#include "rigless/motion/detail/clip_limits.h"
#include "rigless/motion/detail/text_scanner.h"

namespace rigless {

// Joint origins of every whole frame, in the file's own lengths and axes (metres_per_unit is 1: see units.h and
// up_axis.h). End Sites are joints named <parent>_end. Rotations multiply in the order of the channels; position
// channels stand for the OFFSET, on joints other than the root also beside it, whichever the values fit. Of several
// ROOTs the first is read; joints above the hips are left out, and what hangs beside these; names become unique.
// `hips`: the name of that joint, where it is known. Allocates in proportion to what the text holds, whatever it
// declares. Errors: empty_input, not_this_format, unexpected_end, bad_syntax, bad_number, unsupported with their line
// (a common reason for bad_number is NaN, for unexpected_end a download that was cut); no_frames: not one whole frame;
// not_finite: a number too large for S; out_of_memory: more than 2^26 positions. `clip` and `notes` then keep what they
// had.
template <class S>
Status parse_bvh(std::string_view text, Clip<S>& clip, ParseNotes* notes = nullptr, std::string_view hips = {});

// ---------------------------------------------------------------------------------------------------------------------

template <class S>
Status parse_bvh(std::string_view text, Clip<S>& clip, ParseNotes* notes, std::string_view hips) {
  detail::TextScanner scanner(text);
  detail::BvhHierarchy hierarchy;
  detail::BvhMotion motion;
  ParseNotes found;
  if (const Status status = detail::parse_bvh_hierarchy(scanner, hierarchy); !status.ok()) return status;
  if (const Status status = detail::read_bvh_motion_header(scanner, motion.frame_time, found); !status.ok())
    return status;
  const std::size_t channels = static_cast<std::size_t>(hierarchy.channels);
  if (const Status status = detail::read_bvh_values(scanner, channels, motion, found); !status.ok()) return status;

  const std::size_t joints = static_cast<std::size_t>(hierarchy.joints);
  if (motion.values.size() / channels > detail::max_clip_positions / joints) return {Error::out_of_memory, -1};
  Clip<S> result;
  result.fps = static_cast<S>(1.0 / motion.frame_time);
  result.metres_per_unit = 1;
  result.frames = found.frames_read;
  Skeleton skeleton;
  for (std::size_t j = 0; j < joints; ++j) {
    skeleton.names.push_back(std::move(hierarchy.nodes[j].name));
    skeleton.parents.push_back(hierarchy.nodes[j].parent);
  }
  detail::pose_bvh_clip(hierarchy, motion, skeleton, hips, result, found);
  if (!detail::all_finite(result)) return {Error::not_finite, -1};

  found.roots = hierarchy.roots;
  found.renamed = hierarchy.renamed;
  clip = std::move(result);
  if (notes != nullptr) *notes = std::move(found);
  return {};
}

}  // namespace rigless
