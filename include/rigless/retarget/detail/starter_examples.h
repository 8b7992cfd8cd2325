// Examples made up by the system, so that a model moves before the user has shown it anything.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/example.h"
#include "rigless/retarget/detail/key_poses.h"
#include "rigless/retarget/detail/pose_spread.h"
#include "rigless/retarget/detail/starter_offsets.h"
#include "rigless/retarget/detail/starter_poses.h"

namespace rigless::detail {

template <class S>
struct StarterOptions {
  std::int32_t count = 12;  // starters at most where limbs are known, half of them elsewhere
  std::int32_t enough = 4;  // with that many examples by the user there are none, with fewer there are fewer
  // A starter this near to an example of the user is dropped, in spreads per joint: half the distance that two random
  // poses of the clip have.
  S nearest = S(0.7);
};

// The starters that `poses` would make of key poses, at most so many. Poses: StarterPoses or StarterOffsets.
template <class S, class Poses>
RIGLESS_COLD void append_starters(const Poses& poses, const StarterModel<S>& model, Span<const Vec3<S>> clip,
                                  std::int32_t joint_count, Span<const std::int32_t> pairs, std::int32_t most,
                                  std::int32_t users, const StarterOptions<S>& options, ExampleStorage<S>& examples) {
  const auto joints = to_size(joint_count);
  const std::size_t controls = pairs.size(), known = examples.controls.size() / controls;
  const std::vector<std::int32_t> paired = paired_joints(pairs, joint_count);
  const auto spreads = joint_spreads(clip, joint_count);
  std::int32_t left = most * (options.enough - users) / std::max(options.enough, 1);
  std::vector<Vec3<S>> places(controls), lesson(controls);
  std::vector<S> heard(controls);
  for (const KeyPose& key : suggest_key_poses<S>(clip, joint_count, paired, most)) {
    const Vec3<S>* pose = &clip[to_size(key.frame) * joints];
    for (std::size_t c = 0; c < controls; ++c) places[c] = poses.place(pose, c);
    level_soles<S>(model, to_size(key.frame), places);
    std::fill(lesson.begin(), lesson.end(), Vec3<S>::Zero());
    std::fill(heard.begin(), heard.end(), S(0.5));
    bool near = false;
    for (std::size_t n = 0; n < known; ++n) {
      const Vec3<S>* example = &examples.joints[n * joints];
      const S distance = pose_distance_squared<S>(example, pose, paired, spreads);
      near = near || distance < options.nearest * options.nearest;
      const S alike = S(1) / (S(1) + distance * distance);
      for (std::size_t c = 0; c < controls; ++c) {
        const Vec3<S>& shown = examples.controls[n * controls + c];
        if (!shown.allFinite()) continue;
        lesson[c] += alike * (shown - poses.place(example, c));
        heard[c] += alike;
      }
    }
    if (near || left-- <= 0) continue;
    examples.joints.insert(examples.joints.end(), pose, pose + joints);
    for (std::size_t c = 0; c < controls; ++c) examples.controls.push_back(places[c] + lesson[c] / heard[c]);
  }
}

// Appends starters to the examples of the user, at key poses of the clip. What the user showed counts more: starters
// learn from it how the user differs from them, most from the poses that are most alike; the more examples there are,
// the fewer starters.
// Where the model's limbs are known they point where the human's do, else controls move by what their joints do.
// clip: T x J, body-local metres; pairs: C joint indices or -1; figure: of the clip; users: how many of the examples
// the user made (the others are their images); examples: N x J and N x C, to which starters are appended. Allocates.
// Errors: no_frames; size_mismatch; index_out_of_range (where: control). On failure the examples are untouched.
template <class S>
RIGLESS_COLD Status add_starters(Span<const Vec3<S>> clip, std::int32_t joint_count, Span<const std::int32_t> pairs,
                                 const StarterFigure<S>& figure, const StarterModel<S>& model, std::int32_t users,
                                 const StarterOptions<S>& options, ExampleStorage<S>& examples) {
  if (joint_count <= 0 || clip.empty()) return {Error::no_frames, -1};
  const auto joints = to_size(joint_count);
  const std::size_t controls = pairs.size(), known = controls > 0 ? examples.controls.size() / controls : 0;
  if (model.rest.size() != controls || clip.size() % joints != 0 || examples.joints.size() != known * joints ||
      examples.controls.size() != known * controls ||
      (!model.stands.empty() && model.stands.size() != clip.size() / joints * controls))
    return {Error::size_mismatch, -1};
  for (std::size_t c = 0; c < controls; ++c)
    if (pairs[c] < -1 || pairs[c] >= joint_count) return {Error::index_out_of_range, c};
  if (users >= options.enough || controls == 0) return {};

  if (model.limbs.empty()) {
    const StarterOffsets<S> poses(clip, joint_count, pairs, model, {});
    append_starters<S>(poses, model, clip, joint_count, pairs, options.count / 2, users, options, examples);
  } else {
    const StarterPoses<S> poses(pairs, figure, model, {});
    append_starters<S>(poses, model, clip, joint_count, pairs, options.count, users, options, examples);
  }
  return {};
}

}  // namespace rigless::detail
