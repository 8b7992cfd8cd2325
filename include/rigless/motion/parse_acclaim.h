// ASF/AMC (Acclaim skeleton and motion) to joint positions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rigless/math/detail/macros.h"
#include "rigless/math/status.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/acclaim_skeleton.h"
#include "rigless/motion/detail/amc_parser.h"
#include "rigless/motion/detail/asf_parser.h"
#include "rigless/motion/detail/clip_limits.h"
#include "rigless/motion/detail/pose_acclaim.h"

namespace rigless {

// An ASF file. Sections in any order; what is unknown (limits, masses, comments) is skipped. Allocates in proportion to
// the text. Errors: empty_input; not_this_format: no :root, :bonedata and :hierarchy, for example an AMC file;
// unexpected_end, bad_number, bad_syntax, duplicate_joint, unknown_joint with their line; unsupported: more than 4096
// bones. `skeleton` then keeps what it had.
inline Status parse_asf(std::string_view text, AcclaimSkeleton& skeleton);

// An AMC file on a skeleton that was read before. A joint is the END of its bone, in metres; 120 frames per second
// unless the file says otherwise (:SAMPLES-PER-SECOND). Bones may come in any order; one that a frame leaves out is at
// rest, the root stays where it was. Values that stretch or shift a bone are read and ignored. Allocates in proportion
// to the text. Errors: empty_input, not_this_format; unknown_joint: a bone that the skeleton has not, commonly because
// the two files belong to different people; bad_number, bad_syntax: not as many values as the bone has dofs, with their
// line; no_frames; not_finite: a number too large for S; out_of_memory: more than 2^26 positions. `clip` and `notes`
// then keep what they had.
template <class S>
Status parse_amc(std::string_view text, const AcclaimSkeleton& skeleton, Clip<S>& clip, ParseNotes* notes = nullptr);

// Both files; errors as parse_asf and parse_amc. Whoever has to say in which file a line is calls those two.
template <class S>
Status parse_acclaim(std::string_view asf, std::string_view amc, Clip<S>& clip, ParseNotes* notes = nullptr);

// ---------------------------------------------------------------------------------------------------------------------

inline Status parse_asf(std::string_view text, AcclaimSkeleton& skeleton) {
  detail::AsfParser parser(text);
  if (const Status status = parser.parse(); !status.ok()) return status;
  skeleton = std::move(parser.skeleton());
  return {};
}

template <class S>
Status parse_amc(std::string_view text, const AcclaimSkeleton& skeleton, Clip<S>& clip, ParseNotes* notes) {
  RIGLESS_ASSERT(!skeleton.order.empty());
  detail::AmcParser motion(text, skeleton);
  if (const Status status = motion.parse(); !status.ok()) return status;

  const double scale = 0.0254 / skeleton.length_unit;
  Clip<S> result;
  ParseNotes found;
  detail::add_acclaim_skeleton(skeleton, result, found);
  result.fps = static_cast<S>(motion.fps());
  result.metres_per_unit = static_cast<S>(scale);
  result.frames = static_cast<std::int32_t>(motion.frames());
  result.positions.reserve(motion.frames() * skeleton.order.size());
  result.root_rotation.reserve(motion.frames());
  std::vector<Vec3<double>> positions(skeleton.bones.size());
  std::vector<Mat3<double>> rotations(skeleton.bones.size());
  for (std::size_t f = 0; f < motion.frames(); ++f) {
    detail::pose_acclaim(skeleton, motion, motion.frame(f), positions, rotations);
    for (const std::int32_t bone : skeleton.order) {
      result.positions.push_back((positions[static_cast<std::size_t>(bone)] * scale).template cast<S>());
    }
    result.root_rotation.push_back(Eigen::Quaterniond(rotations[0]).normalized().cast<S>());
  }
  if (!detail::all_finite(result)) return {Error::not_finite, -1};
  found.frames_read = result.frames;
  found.frame_cut = motion.frame_cut();
  found.frame_time_assumed = motion.fps_assumed();
  clip = std::move(result);
  if (notes != nullptr) *notes = std::move(found);
  return {};
}

template <class S>
Status parse_acclaim(std::string_view asf, std::string_view amc, Clip<S>& clip, ParseNotes* notes) {
  AcclaimSkeleton skeleton;
  if (const Status status = parse_asf(asf, skeleton); !status.ok()) return status;
  return parse_amc(amc, skeleton, clip, notes);
}

}  // namespace rigless
