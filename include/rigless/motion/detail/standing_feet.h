// When each foot stands: it is slow for what this clip's feet do, and low or else carries the body.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/types.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/signal.h"
#include "rigless/motion/detail/units.h"

namespace rigless::detail {

// T, 1 in the frames that have it.
using FrameLabels = std::vector<std::uint8_t>;

// Seconds, and lengths and speeds in legs: those of a child and a giant are as long. Measured on real captures at 30 to
// 120 fps: walks, runs, jumps, dances, a climb on a ladder.
template <class S>
struct Standing {
  static constexpr S smoothing = S(0.05);
  static constexpr S around = S(8);          // over which the feet are as fast as their fastest
  static constexpr S slow = S(0.22);         // of that speed: what stands is slower,
  static constexpr S still = S(0.15);        // and so is whatever is slower than this,
  static constexpr S brisk = S(0.7);         // and nothing that is faster than this,
  static constexpr S nearby = S(2);          // but for a foot that is very fast itself over so long
  static constexpr S own = S(0.14);          // and slower than this part of that: the short stances of a sprint,
  static constexpr S fastest = S(2.5);       // if not faster than this
  static constexpr S floor_window = S(1.4);  // its lowest point in it is its floor: those of captures drift and climb
  static constexpr S height = S(0.042);      // above its floor up to which a foot stands
  static constexpr S step = S(0.22);         // between the floors of the two feet: what rests higher must carry
  static constexpr S carrying = S(0.1);      // for which it does so at least
  static constexpr S settling = S(0.01);     // by which it comes down on what carries it, or leaves it upwards
  static constexpr S shortest = S(0.06);     // shorter runs and gaps are noise
};

// Length of a leg in the clip: from the ankle up to the root, or half of a body whose legs are shorter, as a dog's are.
// Allocates scratch.
template <class S>
S leg_length(const Clip<S>& clip, const JointRoles& roles);

// Labels of the left and the right foot; empty ones without foot roles, or frames. Allocates.
template <class S>
std::array<FrameLabels, 2> find_standing(const Clip<S>& clip, const JointRoles& roles);

// ---------------------------------------------------------------------------------------------------------------------

// The next run of equal labels from `begin`: where it ends.
inline std::size_t run_end(const FrameLabels& labels, std::size_t begin) {
  std::size_t end = begin;
  while (end < labels.size() && labels[end] == labels[begin]) ++end;
  return end;
}

template <class S>
class StandingFinder {
 public:
  StandingFinder(const Clip<S>& clip, S leg) : clip_(clip), leg_(leg), frames_(static_cast<std::size_t>(clip.frames)) {}

  // feet: three joints of the left foot and three of the right, -1 for none.
  std::array<FrameLabels, 2> find(const std::array<std::int32_t, 6>& feet) {
    std::vector<S> fastest(frames_, 0);
    floor_.assign(frames_, S(1e9));
    for (std::size_t k = 0; k < feet.size(); ++k) {
      if (feet[k] < 0) continue;
      tracks_[k] = track(feet[k]);
      for (std::size_t f = 0; f < frames_; ++f) {
        floor_[f] = std::min(floor_[f], tracks_[k].height[f]);
        fastest[f] = std::min(fastest[f], tracks_[k].speed[f]);
      }
    }
    floor_ = window_minimum(floor_, Limits::floor_window);
    fastest = window_minimum(fastest, Limits::around);
    std::array<FrameLabels, 2> low = {FrameLabels(frames_, 0), FrameLabels(frames_, 0)};
    for (std::size_t k = 0; k < feet.size(); ++k)
      if (feet[k] >= 0) add_low(fastest, tracks_[k], low[k / 3]);
    std::array<FrameLabels, 2> standing = low;
    for (std::size_t k = 0; k < feet.size(); ++k)
      if (feet[k] >= 0) add_raised(tracks_[k], low[1 - k / 3], standing[k / 3]);
    for (FrameLabels& on : standing) {
      drop_short(on, 0);
      drop_short(on, 1);
    }
    return standing;
  }

 private:
  using Limits = Standing<S>;
  struct Track {
    std::vector<S> height;  // T, smoothed
    std::vector<S> speed;   // T, minus it: the running minimum is the greatest
    FrameLabels slow;       // T; 2: half as fast would do
  };

  std::vector<S> window_minimum(const std::vector<S>& x, S seconds) const {
    return running_minimum(x, half_window(seconds, clip_.fps));
  }

  // The speed is that of the slower step beside a frame, so that a stance of three frames keeps all of them.
  Track track(std::int32_t joint) const {
    Track track;
    const auto half = static_cast<std::int32_t>(Limits::smoothing * clip_.fps / 2);
    Vec3<S> last;
    for (std::int32_t f = 0; f < clip_.frames; ++f) {
      Vec3<S> p = Vec3<S>::Zero();
      for (std::int32_t k = f - half; k <= f + half; ++k) p += clip_.at(std::clamp(k, 0, clip_.frames - 1), joint);
      p /= static_cast<S>(2 * half + 1);
      const S speed = f > 0 ? -(p - last).norm() * clip_.fps : clip_.frames > 1 ? S(-1e9) : S(0);
      if (f > 0) track.speed.back() = std::max(track.speed.back(), speed);
      track.height.push_back(p.y());
      track.speed.push_back(speed);
      last = p;
    }
    return track;
  }

  void add_low(const std::vector<S>& fastest, Track& joint, FrameLabels& on) const {
    const std::vector<S> floor = window_minimum(joint.height, Limits::floor_window);
    const std::vector<S> own = window_minimum(joint.speed, Limits::nearby);
    for (std::size_t f = 0; f < frames_; ++f) {
      const S usual = std::clamp(-Limits::slow * fastest[f], Limits::still * leg_, Limits::brisk * leg_);
      const S limit = std::max(usual, std::min(-Limits::own * own[f], Limits::fastest * leg_));
      const S speed = -joint.speed[f];
      joint.slow.push_back(speed > limit ? 0 : speed > limit / 2 ? 1 : 2);
      const bool low = joint.height[f] < floor[f] + Limits::height * leg_;
      if (low && joint.slow[f] != 0 && floor[f] < floor_[f] + Limits::step * leg_) on[f] = 1;
    }
  }

  // A foot on a block or a rung, which it came down on or leaves upwards: a foot that is held in the air came up to its
  // place and goes down from it, and does not carry while the other one is in the air.
  void add_raised(const Track& joint, const FrameLabels& other, FrameLabels& on) const {
    const auto least = static_cast<std::size_t>(Limits::carrying * clip_.fps) + 1;
    for (std::size_t begin = 0, end = 0; begin < frames_; begin = end) {
      std::size_t alone = 0;
      S level = S(1e9), around = S(-1e9);
      for (end = begin; end < frames_ && joint.slow[end] != 0; ++end) {
        level = std::min(level, joint.height[end]);
        alone += other[end] == 0 && joint.slow[end] == 2 ? 1 : 0;
      }
      if (end == begin) {
        ++end;
        continue;
      }
      const bool cut = begin == 0 || end == frames_;  // by the clip's ends
      if (alone < (cut ? 1 : least)) continue;
      const std::size_t before = begin - std::min(begin, least), after = std::min(end + least, frames_);
      for (std::size_t f = before; f < after; ++f)
        if (f < begin || f >= end) around = std::max(around, joint.height[f]);
      if (!cut && around <= level + Limits::settling * leg_) continue;
      for (std::size_t f = begin; f < end; ++f)
        if (joint.height[f] < level + Limits::height * leg_) on[f] = 1;
    }
  }

  // Runs of `value` that are too short take the other one, except at the ends.
  void drop_short(FrameLabels& on, std::uint8_t value) const {
    for (std::size_t begin = 0, end = 0; begin < frames_; begin = end) {
      end = run_end(on, begin);
      if (on[begin] != value || begin == 0 || end == frames_) continue;
      if (static_cast<std::int32_t>(end - begin) >= static_cast<std::int32_t>(Limits::shortest * clip_.fps)) continue;
      for (std::size_t f = begin; f < end; ++f) on[f] = static_cast<std::uint8_t>(1 - value);
    }
  }

  const Clip<S>& clip_;
  S leg_;
  std::size_t frames_;
  std::array<Track, 6> tracks_;
  std::vector<S> floor_;  // T, of the lowest of all
};

template <class S>
S leg_length(const Clip<S>& clip, const JointRoles& roles) {
  const S left = chain_length(clip, roles.left.ankle, roles.root);
  const S right = chain_length(clip, roles.right.ankle, roles.root);
  return std::max(std::max(left, right), standing_height(clip, roles) / 2);
}

template <class S>
std::array<FrameLabels, 2> find_standing(const Clip<S>& clip, const JointRoles& roles) {
  // What touches the ground: ball and tip, or ankle and end of a foot without a ball. The ankle of a foot with a ball
  // would call the heel's swing into the ground a contact.
  const LimbRoles &l = roles.left, &r = roles.right;
  if (clip.frames == 0 || l.ankle < 0 || r.ankle < 0) return {};
  return StandingFinder<S>(clip, leg_length(clip, roles))
      .find({l.tip < 0 ? l.ankle : -1, l.toe, l.tip, r.tip < 0 ? r.ankle : -1, r.toe, r.tip});
}

}  // namespace rigless::detail
