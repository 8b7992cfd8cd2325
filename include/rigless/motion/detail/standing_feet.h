// When each foot stands: it is slow for what this clip's feet do, and low or else carries the body.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
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

  std::array<FrameLabels, 2> find(const std::array<std::vector<std::int32_t>, 2>& feet) {
    for (std::size_t k = 0; k < 2; ++k)
      for (const std::int32_t joint : feet[k]) tracks_[k].push_back(track(joint));
    std::vector<S> lowest = tracks_[0][0].height, fastest(frames_, 0);
    for (const auto& foot : tracks_) {
      for (const Track& joint : foot) {
        for (std::size_t f = 0; f < frames_; ++f) {
          lowest[f] = std::min(lowest[f], joint.height[f]);
          fastest[f] = std::min(fastest[f], joint.speed[f]);
        }
      }
    }
    floor_ = window_minimum(lowest, Limits::floor_window);
    fastest = window_minimum(fastest, Limits::around);
    std::array<FrameLabels, 2> low, standing;
    for (std::size_t k = 0; k < 2; ++k) {
      for (Track& joint : tracks_[k]) set_limit(fastest, joint);
      low[k] = on_floor(tracks_[k]);
    }
    standing = low;
    for (std::size_t k = 0; k < 2; ++k) {
      for (const Track& joint : tracks_[k]) add_raised(joint, low[1 - k], standing[k]);
      drop_short(standing[k], 0);
      drop_short(standing[k], 1);
    }
    return standing;
  }

 private:
  using Limits = Standing<S>;
  struct Track {
    std::vector<S> height;  // T, smoothed
    std::vector<S> speed;   // T, minus it: the running minimum is the greatest
    std::vector<S> limit;   // T, minus the speed below which it stands
  };

  std::vector<S> window_minimum(const std::vector<S>& x, S seconds) const {
    return running_minimum(x, half_window(seconds, clip_.fps));
  }

  // The speed is that of the slower step beside a frame, so that a stance of three frames keeps all of them.
  Track track(std::int32_t joint) const {
    std::array<std::vector<S>, 3> p;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<S> x;
      for (std::int32_t f = 0; f < clip_.frames; ++f) x.push_back(clip_.at(f, joint)[static_cast<Eigen::Index>(axis)]);
      p[axis] = running_mean(x, static_cast<std::int32_t>(Limits::smoothing * clip_.fps / 2));
    }
    std::vector<S> speed(frames_, frames_ < 2 ? S(0) : S(-1e9));
    for (std::size_t f = 1; f < frames_; ++f) {
      const Vec3<S> step(p[0][f] - p[0][f - 1], p[1][f] - p[1][f - 1], p[2][f] - p[2][f - 1]);
      speed[f] = -step.norm() * clip_.fps;
      speed[f - 1] = std::max(speed[f - 1], speed[f]);
    }
    return {std::move(p[1]), std::move(speed), {}};
  }

  void set_limit(const std::vector<S>& fastest, Track& joint) const {
    joint.limit = window_minimum(joint.speed, Limits::nearby);
    for (std::size_t f = 0; f < frames_; ++f) {
      const S usual = std::clamp(-Limits::slow * fastest[f], Limits::still * leg_, Limits::brisk * leg_);
      joint.limit[f] = -std::max(usual, std::min(-Limits::own * joint.limit[f], Limits::fastest * leg_));
    }
  }

  FrameLabels on_floor(const std::vector<Track>& foot) const {
    FrameLabels on(frames_, 0);
    for (const Track& joint : foot) {
      const std::vector<S> floor = window_minimum(joint.height, Limits::floor_window);
      for (std::size_t f = 0; f < frames_; ++f) {
        const bool low =
            joint.height[f] < floor[f] + Limits::height * leg_ && floor[f] < floor_[f] + Limits::step * leg_;
        if (low && joint.speed[f] >= joint.limit[f]) on[f] = 1;
      }
    }
    return on;
  }

  // A foot on a block or a rung, which it came down on or leaves upwards: a foot that is held in the air came up to its
  // place and goes down from it, and does not carry while the other one is in the air.
  void add_raised(const Track& joint, const FrameLabels& other, FrameLabels& on) const {
    FrameLabels slow(frames_);
    for (std::size_t f = 0; f < frames_; ++f) slow[f] = joint.speed[f] >= joint.limit[f] ? 1 : 0;
    const auto least = static_cast<std::size_t>(Limits::carrying * clip_.fps) + 1;
    for (std::size_t begin = 0, end = 0; begin < frames_; begin = end) {
      end = run_end(slow, begin);
      if (slow[begin] == 0) continue;
      const auto at = [&](std::size_t f) { return joint.height.begin() + static_cast<std::ptrdiff_t>(f); };
      const S level = *std::min_element(at(begin), at(end));
      const auto above = [&](std::size_t from, std::size_t to) {
        return from == to || *std::max_element(at(from), at(to)) > level + Limits::settling * leg_;
      };
      std::size_t alone = 0;
      for (std::size_t f = begin; f < end; ++f) alone += other[f] == 0 && 2 * joint.speed[f] >= joint.limit[f] ? 1 : 0;
      if (alone < (begin > 0 && end < frames_ ? least : 1)) continue;  // the clip's ends may cut it
      if (!above(begin - std::min(begin, least), begin) && !above(end, std::min(end + least, frames_))) continue;
      for (std::size_t f = begin; f < end; ++f)
        if (*at(f) < level + Limits::height * leg_) on[f] = 1;
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
  std::array<std::vector<Track>, 2> tracks_;  // left, right
  std::vector<S> floor_;                      // T, of the lowest of all
};

template <class S>
S leg_length(const Clip<S>& clip, const JointRoles& roles) {
  return std::max({chain_length(clip, roles.left.ankle, roles.root), chain_length(clip, roles.right.ankle, roles.root),
                   standing_height(clip, roles) / 2});
}

template <class S>
std::array<FrameLabels, 2> find_standing(const Clip<S>& clip, const JointRoles& roles) {
  std::array<std::vector<std::int32_t>, 2> feet;
  for (std::size_t k = 0; k < 2; ++k) {
    // What touches the ground: ball and tip, or ankle and end of a foot without a ball. The ankle of a foot with a ball
    // would call the heel's swing into the ground a contact.
    const LimbRoles& limb = k == 0 ? roles.left : roles.right;
    for (const std::int32_t j : {limb.tip >= 0 ? -1 : limb.ankle, limb.toe, limb.tip})
      if (j >= 0) feet[k].push_back(j);
    if (clip.frames == 0 || feet[k].empty()) return {};
  }
  return StandingFinder<S>(clip, leg_length(clip, roles)).find(feet);
}

}  // namespace rigless::detail
