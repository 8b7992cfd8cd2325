// What a control is learned from: its joint, and in what pose the whole body is.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/example.h"
#include "rigless/retarget/detail/pose_spread.h"

namespace rigless::detail {

// Poses over the P paired joints, each joint centred on its examples' mean and divided by their spread (RMS), so that
// metres or inches, hands or hips weigh the same.
//
// The features of a control are [its joint, a * the whole pose]; of a control without a joint, the whole pose. The
// whole pose is divided by sqrt(P), so that it weighs like one joint however many are paired. Where a control depends
// on more than its joint (a squash while both knees bend), the joint alone is ambiguous.
template <class S>
class PoseFeatures {
 public:
  // clip: T x J and examples: N x J, finite. A single example has no spread, and examples that hardly differ in a joint
  // say nothing about it: the spread is at least a tenth of the clip's. Allocates.
  void bind(Span<const Vec3<S>> clip, Span<const Vec3<S>> examples, std::int32_t joint_count,
            Span<const std::int32_t> paired) {
    const bool single = examples.size() == to_size(joint_count);
    const auto clip_spreads = joint_spreads(clip, joint_count);
    const auto spreads = single ? clip_spreads : joint_spreads(examples, joint_count);
    paired_.assign(paired.begin(), paired.end());
    clip_ = normalise(clip, to_size(joint_count), spreads, clip_spreads);
    examples_ = normalise(examples, to_size(joint_count), spreads, clip_spreads);
  }

  // The whole poses of the clip, T x 3P, before any weight.
  Span<const S> poses() const { return {clip_.data()->data(), 3 * clip_.size()}; }

  // The features of a control paired with `joint` (or -1): of the clip its own joint, T x 3 or none, in `clip`, behind
  // which come poses() times what is returned; of the examples all of them, N x D. Allocates.
  S features(std::int32_t joint, S pose_weight, std::vector<S>& clip, std::vector<S>& examples) const {
    const auto found = std::find(paired_.begin(), paired_.end(), joint);
    const bool own = joint >= 0 && found != paired_.end();
    const auto slot = to_size(found - paired_.begin());
    const S weight = (own ? pose_weight : S(1)) / std::sqrt(static_cast<S>(paired_.size()));
    const auto fill = [&](const std::vector<Vec3<S>>& poses, bool whole, std::vector<S>& out) {
      out.clear();
      for (std::size_t first = 0; first < poses.size(); first += paired_.size()) {
        if (own) out.insert(out.end(), poses[first + slot].data(), poses[first + slot].data() + 3);
        for (std::size_t p = 0; whole && p < paired_.size(); ++p)
          for (int axis = 0; axis < 3; ++axis) out.push_back(weight * poses[first + p][axis]);
      }
    };
    fill(clip_, false, clip);
    fill(examples_, true, examples);
    return weight;
  }

 private:
  std::vector<Vec3<S>> normalise(Span<const Vec3<S>> poses, std::size_t joints,
                                 const std::vector<JointSpread<S>>& spreads,
                                 const std::vector<JointSpread<S>>& clip_spreads) const {
    std::vector<Vec3<S>> out;
    out.reserve(poses.size() / joints * paired_.size());
    for (std::size_t first = 0; first < poses.size(); first += joints) {
      for (const std::int32_t index : paired_) {
        const auto j = to_size(index);
        const JointSpread<S> spread = {spreads[j].mean, std::max(spreads[j].rms, clip_spreads[j].rms / S(10))};
        out.push_back((poses[first + j] - spread.mean) / spread.scale());
      }
    }
    return out;
  }

  std::vector<std::int32_t> paired_;      // P
  std::vector<Vec3<S>> clip_, examples_;  // T x P, N x P
};

// One centre per control and one spread for all controls of a mesh, over the N x C positions that are known. Examples
// that do not differ get the spread 1. Allocates.
template <class S>
struct ControlSpace {
  std::vector<Vec3<S>> centre;  // C
  S spread = 1;

  static ControlSpace of(Span<const Vec3<S>> controls, std::size_t control_count) {
    ControlSpace space;
    space.centre.assign(control_count, Vec3<S>::Zero());
    std::vector<S> known(control_count, 0);
    for (std::size_t i = 0; i < controls.size(); ++i) {
      if (!controls[i].allFinite()) continue;
      space.centre[i % control_count] += controls[i];
      known[i % control_count] += S(1);
    }
    for (std::size_t c = 0; c < control_count; ++c) space.centre[c] /= std::max(known[c], S(1));
    S sum = 0, count = 0;
    for (std::size_t i = 0; i < controls.size(); ++i) {
      if (!controls[i].allFinite()) continue;
      sum += (controls[i] - space.centre[i % control_count]).squaredNorm();
      count += S(1);
    }
    const S rms = std::sqrt(sum / std::max(count, S(1)));
    if (rms > S(1e-9)) space.spread = rms;
    return space;
  }

  Vec3<S> in(const Vec3<S>& p, std::size_t control) const { return (p - centre[control]) / spread; }
  Vec3<S> out(const Vec3<S>& p, std::size_t control) const { return centre[control] + spread * p; }
};

}  // namespace rigless::detail
