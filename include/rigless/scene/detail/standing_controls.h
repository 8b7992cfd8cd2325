// Which controls stand on the ground, and when.
#pragma once

#include <algorithm>

#include "rigless/math/span.h"
#include "rigless/retarget/detail/foreleg.h"
#include "rigless/retarget/detail/rests_on_ground.h"
#include "rigless/scene/staged_motion.h"

namespace rigless::detail {

// K of the C controls, with the labels that the human's feet give them.
template <class S>
struct StandingControls {
  std::vector<std::int32_t> control;  // K
  std::vector<std::uint8_t> labels;   // T x K
  std::vector<S> ground;              // K, rest height above the lowest vertex
};

// Whether `joint` is another, or hangs on it.
inline bool hangs_on(const Skeleton& skeleton, std::int32_t other, std::int32_t joint) {
  if (other < 0) return false;
  for (; joint >= 0; joint = nth(skeleton.parents, joint)) {
    if (joint == other) return true;
  }
  return false;
}

// Controls that are paired with a joint of a foot stand when that foot does; beside them a hand that rests on the
// ground stands as a foreleg does: when the foot across does and the human's hand is not raised. A body without any (a
// cactus, a cup) stands on its lowest controls, those within 5 % of its height of the lowest at rest, when either foot
// does; but one that is held at its hips swims, crawls or flies where the human goes. rest: C; floor: y of the lowest
// vertex at rest; height: of the mesh. Allocates.
template <class S>
RIGLESS_COLD StandingControls<S> standing_controls(const StagedMotion<S>& motion, Span<const std::int32_t> pairs,
                                                   Span<const Vec3<S>> rest, S floor, S height) {
  struct Foot {
    bool left, right;                // which foot it follows
    const LimbRoles* arm = nullptr;  // of a foreleg
  };
  StandingControls<S> standing;
  std::vector<Foot> feet;  // K
  const Skeleton& skeleton = motion.clip.skeleton;
  const LimbRoles &l = motion.roles.left, &r = motion.roles.right;
  const auto on_foot = [&](std::int32_t joint) {
    return hangs_on(skeleton, l.ankle, joint) || hangs_on(skeleton, r.ankle, joint);
  };
  const bool has_feet = std::any_of(pairs.begin(), pairs.end(), on_foot);
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    Foot foot{hangs_on(skeleton, l.ankle, pairs[c]), hangs_on(skeleton, r.ankle, pairs[c])};
    if (has_feet && rests_on_ground(rest[c], floor, height)) {
      if (hangs_on(skeleton, l.shoulder, pairs[c])) foot = {false, true, &l};
      if (hangs_on(skeleton, r.shoulder, pairs[c])) foot = {true, false, &r};
    }
    if (!foot.left && !foot.right) continue;
    standing.control.push_back(static_cast<std::int32_t>(c));
    feet.push_back(foot);
  }
  if (standing.control.empty() && !rest.empty()) {
    const bool glides = std::find(pairs.begin(), pairs.end(), 0) != pairs.end();
    S lowest = rest[0].y();
    for (const Vec3<S>& p : rest) lowest = std::min(lowest, p.y());
    for (std::size_t c = 0; c < rest.size(); ++c) {
      if (rest[c].y() > lowest + S(0.05) * height) continue;
      standing.control.push_back(static_cast<std::int32_t>(c));
      feet.push_back({!glides, !glides, nullptr});
    }
  }
  for (const std::int32_t c : standing.control) standing.ground.push_back(nth(rest, c).y() - floor);
  for (std::size_t f = 0; f < motion.left.size(); ++f) {
    const Vec3<S>* pose = &motion.local[f * skeleton.names.size()];
    for (const auto& [left, right, arm] : feet) {
      const bool on = (left && motion.left[f] != 0) || (right && motion.right[f] != 0);
      const bool lifted = arm != nullptr && raised(pose, *arm) > S(0.1);
      standing.labels.push_back(on && !lifted ? 1 : 0);
    }
  }
  return standing;
}

// The same with the user's runs instead of those of the controls that they name, which must exist; runs are cut to the
// clip. rest: C; floor: y of the lowest vertex at rest. Allocates.
template <class S>
RIGLESS_COLD void edit_standing(Span<const ContactEdit> edits, Span<const Vec3<S>> rest, S floor, std::int32_t frames,
                                StandingControls<S>& standing) {
  const auto count = to_size(frames);
  StandingControls<S> edited = standing;
  const auto named = [&](std::int32_t c) {
    return std::any_of(edits.begin(), edits.end(), [c](const ContactEdit& e) { return e.control == c; });
  };
  const auto known = [&](std::int32_t c) {
    return std::find(edited.control.begin(), edited.control.end(), c) != edited.control.end();
  };
  for (const ContactEdit& edit : edits) {
    if (known(edit.control)) continue;
    edited.control.push_back(edit.control);
    edited.ground.push_back(nth(rest, edit.control).y() - floor);
  }
  const std::size_t before = standing.control.size(), after = edited.control.size();
  edited.labels.assign(count * after, 0);
  for (std::size_t k = 0; k < after; ++k) {
    if (!named(edited.control[k]))
      for (std::size_t f = 0; f < count; ++f) edited.labels[f * after + k] = standing.labels[f * before + k];
    for (const ContactEdit& edit : edits) {
      if (edit.control != edited.control[k]) continue;
      for (std::int32_t f = std::max(edit.run.begin, 0); f < std::min(edit.run.end, frames); ++f)
        edited.labels[to_size(f) * after + k] = 1;
    }
  }
  standing = std::move(edited);
}

}  // namespace rigless::detail
