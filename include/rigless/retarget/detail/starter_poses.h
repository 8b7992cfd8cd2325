// What the system would have a model do in a pose, before anybody has shown it anything.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/rests_on_ground.h"
#include "rigless/retarget/detail/starter_figure.h"
#include "rigless/retarget/detail/starter_model.h"

namespace rigless::detail {

template <class S>
struct LimbOptions {
  S lean = S(0.9);  // how much a trunk leans with the human's
  S nod = S(1.3);   // how much a head turns with the human's, whose neck is all that is known
  S rear = S(0.5);  // radians by which a body on four legs rears when both hands are raised
  S wave = S(0.5);  // how far the tail of a body without legs goes aside, in lengths from its hips
};

// What the system would have a model do in a pose, before anybody has shown it. A limb of the model points where the
// human's does and is as far stretched, whatever pose the model rests in: an arm that rests level hangs when the human
// lets his hang. It starts where the trunk carries its base. The trunk leans and turns with the human's about the hips,
// which stay where they are; a leg goes with the human's from the straight one on which the model rests, so that a
// stance stays as wide as it is. A foreleg is a leg that goes with the foot across, until the human raises its hand:
// then it is lifted before the body, which rears.
template <class S>
class StarterPoses {
 public:
  // Keeps what it is given. Allocates.
  RIGLESS_COLD StarterPoses(Span<const std::int32_t> pairs, const StarterFigure<S>& figure,
                            const StarterModel<S>& model, const LimbOptions<S>& options)
      : pairs_(pairs), figure_(figure), model_(model), options_(options) {
    for (const std::int32_t joint : pairs) follows_.push_back(figure.limb(joint));
    find_hips();
    for (std::size_t c = 0; c < pairs.size(); ++c) limbs_.push_back(model_limb(c));
  }

  // Where control c is in a pose (J). No allocation.
  RIGLESS_COLD Vec3<S> place(const Vec3<S>* pose, std::size_t c) const {
    const Vec3<S>& rest = model_.rest[c];
    const FollowedLimb<S>& limb = follows_[c];
    const ModelLimb<S>& own = limbs_[c];
    switch (limb.part) {
      case FollowedPart::arm:
        if (is_foreleg(c)) return foreleg(pose, c);
        return carried(pose, own.base) + own.length * swung(along(pose, c), own, rest);
      case FollowedPart::leg:
        return stepped(along(pose, c), c);
      case FollowedPart::head: {
        const Eigen::Quaternion<S> nod = figure_.nod(pose), none = Eigen::Quaternion<S>::Identity();
        return carried(pose, own.base + none.slerp(options_.nod, nod) * (rest - own.base)) + waved(pose, c);
      }
      case FollowedPart::trunk:
        break;
    }
    return carried(pose, rest) + waved(pose, c);
  }

 private:
  // From the base of the human's limb to the control's joint, in lengths of that limb.
  Vec3<S> along(const Vec3<S>* pose, std::size_t c) const {
    const FollowedLimb<S>& limb = follows_[c];
    return (pose[pairs_[c]] - pose[limb.base]) / std::max(limb.reach, S(1e-6));
  }

  // A leg from the straight one on which the model rests.
  Vec3<S> stepped(const Vec3<S>& leg, std::size_t c) const {
    return model_.rest[c] + limbs_[c].length * (leg + Vec3<S>::UnitY());
  }

  bool is_foreleg(std::size_t c) const {
    return follows_[c].part == FollowedPart::arm && on_all_fours_ &&
           rests_on_ground(model_.rest[c], model_.floor, model_.height);
  }

  RIGLESS_COLD Vec3<S> foreleg(const Vec3<S>* pose, std::size_t c) const {
    const ModelLimb<S>& own = limbs_[c];
    const Vec3<S> hand = along(pose, c), step = stepped(figure_.across(pose, follows_[c]), c);
    const Vec3<S> way(S(0.4) * hand.x(), S(0.4) * hand.y() - S(0.2), S(0.5) + S(0.4) * std::abs(hand.z()));
    const S reach = S(0.85) * std::min(own.length, (model_.rest[c] - own.base).norm());
    const Vec3<S> lifted = carried(pose, own.base) + reach * way.normalized();
    return step + figure_.raised(pose, follows_[c]) * (lifted - step);
  }

  // The mean of its forelegs' hands; 0 for a body without.
  RIGLESS_COLD S reared(const Vec3<S>* pose) const {
    S sum = 0, count = 0;
    for (std::size_t c = 0; c < follows_.size(); ++c) {
      if (!is_foreleg(c)) continue;
      sum += figure_.raised(pose, follows_[c]);
      count += S(1);
    }
    return sum / std::max(count, S(1));
  }

  // A stump that pointed where an arm does would go into the body: it gives way only so far.
  static Vec3<S> swung(const Vec3<S>& along, const ModelLimb<S>& own, const Vec3<S>& rest) {
    const Vec3<S> way = own.swing * along.normalized() + (S(1) - own.swing) * (rest - own.base).normalized();
    return along.norm() * way.normalized();
  }

  // Where the hips are held, else what is below the lowest control that does not stand, within reason.
  RIGLESS_COLD void find_hips() {
    S high = model_.height, feet = 0, hands = 0;
    hips_ = Vec3<S>::Zero();
    for (std::size_t c = 0; c < pairs_.size(); ++c) {
      const bool low = rests_on_ground(model_.rest[c], model_.floor, model_.height);
      feet += follows_[c].part == FollowedPart::leg ? S(1) : S(0);
      hands += follows_[c].part == FollowedPart::arm && low ? S(1) : S(0);
      if (follows_[c].part != FollowedPart::leg && !is_foot(model_, c) && !low)
        high = std::min(high, model_.rest[c].y() - model_.floor);
    }
    for (std::size_t c = 0; c < pairs_.size(); ++c) {
      if (pairs_[c] != 0) continue;
      hips_ = model_.rest[c];
      high = hips_.y() - model_.floor;
    }
    hips_.y() = model_.floor + std::clamp(high, S(0.2) * model_.height, S(0.55) * model_.height);
    on_all_fours_ = feet > S(0) && feet + hands > S(2);
    if (feet > S(0)) return;
    for (std::size_t c = 0; c < pairs_.size(); ++c) {
      const Vec3<S> way = model_.rest[c] - hips_;
      if (follows_[c].part == FollowedPart::head) swims_ = std::hypot(way.x(), way.z()) > std::abs(way.y());
      if (pairs_[c] < 0) tail_ = std::max(tail_, way.norm());
    }
  }

  // A body without legs waves as feet step: its tail, which follows nothing, to one side, and less its head to the
  // other.
  RIGLESS_COLD Vec3<S> waved(const Vec3<S>* pose, std::size_t c) const {
    const S share = pairs_[c] < 0 ? S(1) : S(-0.3);
    const S way = tail_ > S(0) ? (model_.rest[c] - hips_).norm() : S(0);
    return {share * options_.wave * way * figure_.stride(pose), S(0), S(0)};
  }

  // As the shape has it, else as a human of this height would. An elbow is on the way to its hand.
  RIGLESS_COLD ModelLimb<S> model_limb(std::size_t c) const {
    const std::size_t end = end_of_limb(c);
    ModelLimb<S> limb = model_.limbs.empty() ? ModelLimb<S>() : model_.limbs[end];
    const Vec3<S>&rest = model_.rest[c], &tip = model_.rest[end];
    const bool known = limb.length > S(0);
    const S height = model_.height;
    switch (is_foreleg(c) ? FollowedPart::leg : follows_[c].part) {
      case FollowedPart::leg: {
        // Seen from its tip a leg ends where it meets the other; it swings from the hips.
        const S hips = std::max(hips_.y() - tip.y(), S(0.1) * height);
        limb.length = std::clamp(known ? limb.base.y() - tip.y() : hips, S(0.75) * hips, hips);
        if (!known) limb.base = tip + limb.length * Vec3<S>::UnitY();
        break;
      }
      case FollowedPart::arm: {
        if (!known) {
          limb.base = {S(0.3) * tip.x(), hips_.y() + S(0.6) * (top() - hips_.y()), hips_.z()};
          limb.length = (tip - limb.base).norm();
        }
        // The way along it, seen in steps, is longer than it is; and it does not reach the ground.
        limb.length = std::min(limb.length, S(1.1) * (tip - limb.base).norm());
        limb.length = std::min(limb.length, std::max(S(0.85) * (limb.base.y() - model_.floor), S(0.1) * height));
        break;
      }
      case FollowedPart::head:
        limb.base = hips_ + S(0.6) * (rest - hips_);
        break;
      case FollowedPart::trunk:
        break;
    }
    limb.length *= follows_[c].reach / std::max(follows_[end].reach, S(1e-6));
    return limb;
  }

  // The control of the same limb that is farthest out on the human.
  std::size_t end_of_limb(std::size_t c) const {
    std::size_t end = c;
    for (std::size_t other = 0; other < follows_.size(); ++other)
      if (follows_[other].base == follows_[c].base && follows_[other].reach > follows_[end].reach) end = other;
    return end;
  }

  S top() const {
    for (std::size_t c = 0; c < pairs_.size(); ++c)
      if (follows_[c].part == FollowedPart::head) return model_.rest[c].y();
    return model_.floor + model_.height;
  }

  // Moved with the trunk, which bends between the hips and what is a quarter of the height away from them; what is
  // below them stays. A trunk that lies level on four legs gives less.
  RIGLESS_COLD Vec3<S> carried(const Vec3<S>* pose, const Vec3<S>& rest) const {
    const TrunkPose<S> human = figure_.trunk(pose);
    const Vec3<S> arm = rest - hips_;
    const S height = model_.height;
    const S above = swims_ ? S(1) : std::clamp(S(1) + arm.y() / (S(0.15) * height), S(0), S(1));
    const S share =
        std::min(S(1), arm.norm() / (S(0.25) * height)) * above * options_.lean * (on_all_fours_ ? S(0.4) : S(1));
    const S most = on_all_fours_ ? S(0.25) : swims_ ? S(0.6) : S(1.2);
    const auto held = [&](S angle, S limit) { return limit * std::tanh(share * angle / limit); };
    const S pitch = swims_ ? S(0.3) : most, rear = share * options_.rear * reared(pose);
    return hips_ +
           trunk_rotation<S>({held(human.pitch, pitch) - rear, held(human.roll, most), held(human.twist, most)}) * arm;
  }

  Span<const std::int32_t> pairs_;  // C
  const StarterFigure<S>& figure_;
  StarterModel<S> model_;
  LimbOptions<S> options_;
  std::vector<FollowedLimb<S>> follows_;  // C
  std::vector<ModelLimb<S>> limbs_;       // C
  Vec3<S> hips_ = Vec3<S>::Zero();        // of the model at rest
  bool on_all_fours_ = false;
  bool swims_ = false;  // or crawls: it has no legs, and its head is before its hips
  S tail_ = 0;          // from the hips to the end of a body without legs
};

}  // namespace rigless::detail
