// Starters of a model whose limbs are not known: its controls move as far from rest as the human's joints from their
// middle.
#pragma once

#include "rigless/retarget/detail/starter_model.h"

namespace rigless::detail {

template <class S>
struct OffsetOptions {
  S bob = S(2);      // how much the trunk rises and falls with the human's pelvis
  S lean = S(0.7);   // how much it leans with the human's
  S most = S(0.07);  // how far it goes at most, in heights of the model
};

// What the system would have a model of which no limb is known do in a pose, before anybody has shown it. A control is
// as far from its rest position as its joint is from its median, scaled by the model's size: legs by their length, and
// less where its neighbours are nearer than those of the joint. A control without a joint of its own belongs to the
// trunk, which bobs with the pelvis and leans with the head.
template <class S>
class StarterOffsets {
 public:
  // Keeps what it is given. Allocates.
  RIGLESS_COLD StarterOffsets(Span<const Vec3<S>> clip, std::int32_t joint_count, Span<const std::int32_t> pairs,
                              const StarterModel<S>& model, const OffsetOptions<S>& options)
      : joints_(to_size(joint_count)),
        pairs_(pairs),
        model_(model),
        options_(options),
        median_(median_pose(clip, joint_count)),
        scale_(pairs.size()) {
    const auto lower = [](const Vec3<S>& a, const Vec3<S>& b) { return a.y() < b.y(); };
    head_ = to_size(std::max_element(median_.begin(), median_.end(), lower) - median_.begin());
    const S human = figure_height(clip, joint_count);
    size_ = human > S(1e-6) ? model.height / human : S(1);
    legs_ = legs(human);
    for (std::size_t c = 0; c < pairs.size(); ++c) scale_[c] = control_scale(c, human);
  }

  // Where control c is in a pose (J). No allocation.
  RIGLESS_COLD Vec3<S> place(const Vec3<S>* pose, std::size_t c) const {
    const Vec3<S>& rest = model_.rest[c];
    if (!has_joint(c)) return trunk(pose, rest);
    const auto j = to_size(pairs_[c]);
    return rest + scale_[c] * (pose[j] - median_[j]);
  }

 private:
  // The root joint is the origin of every pose.
  bool has_joint(std::size_t c) const { return pairs_[c] > 0; }
  // Model's legs over the human's: what is below the lowest control that does not stand, within reason.
  S legs(S human) const {
    const S human_leg = -median_low();
    S leg = model_.height;
    for (std::size_t c = 0; c < pairs_.size(); ++c)
      if (!is_foot(model_, c)) leg = std::min(leg, model_.rest[c].y() - model_.floor);
    leg = std::clamp(leg, S(0.2) * model_.height, S(0.55) * model_.height);
    return human_leg > S(0.1) * human ? leg / human_leg : size_;
  }

  S median_low() const {
    S low = 0;
    for (const Vec3<S>& p : median_) low = std::min(low, p.y());
    return low;
  }

  // Legs as long as they are, all else as large as the model; less where its neighbours are nearer than the human's.
  RIGLESS_COLD S control_scale(std::size_t c, S human) const {
    const S scale = is_foot(model_, c) ? legs_ : size_;
    if (!has_joint(c)) return scale;
    S nearest = scale;
    for (std::size_t other = 0; other < pairs_.size(); ++other) {
      if (!has_joint(other)) continue;
      const Vec3<S> way = nth(median_, pairs_[other]) - nth(median_, pairs_[c]);
      if (way.norm() > S(0.08) * human)
        nearest = std::min(nearest, (model_.rest[other] - model_.rest[c]).norm() / way.norm());
    }
    return std::max(nearest, scale / S(4));
  }

  RIGLESS_COLD Vec3<S> trunk(const Vec3<S>* pose, const Vec3<S>& rest) const {
    S low = 0;
    for (std::size_t j = 0; j < joints_; ++j) low = std::min(low, pose[j].y());
    const auto lean = [&](int axis) {
      const Vec3<S>&now = pose[head_], &usual = median_[head_];
      return options_.lean * (std::atan2(now[axis], now.y()) - std::atan2(usual[axis], usual.y()));
    };
    // About the hips, where the human has them; what is below them only rises and falls in front and behind.
    const S pitch = lean(2), roll = lean(0);
    const S above = std::max(S(0), rest.y() - model_.floor + median_low() * size_);
    const Vec3<S> move(roll * above, options_.bob * size_ * (median_low() - low) - pitch * rest.z() - roll * rest.x(),
                       pitch * above);
    const S most = options_.most * model_.height;
    return rest + most / std::sqrt(most * most + move.squaredNorm()) * move;
  }

  std::size_t joints_;
  Span<const std::int32_t> pairs_;  // C
  StarterModel<S> model_;
  OffsetOptions<S> options_;
  std::vector<Vec3<S>> median_;  // J
  std::vector<S> scale_;         // C
  std::size_t head_ = 0;
  S size_ = 1, legs_ = 1;  // model over human
};

}  // namespace rigless::detail
