// Weight: a body sinks into its landings and rises on its feet as far as the human does, in its own size; and breathes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "rigless/math/detail/macros.h"
#include "rigless/math/detail/smooth_step.h"
#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/smoothing.h"
#include "rigless/scene/detail/loop.h"
#include "rigless/scene/staged_motion.h"

namespace rigless::detail {

// What weight does to a body, T: metres by which its upper part rises, about their mean; and how far it breathes in.
template <class S>
struct Rise {
  std::vector<S> hips, breath;
};

// The hips of the human over its lowest joint, in the model's size; a breath of 3 % of the model's height, four seconds
// long or as many whole ones as are in a loop, where the human hardly moves. size: the model's height over the human's;
// laps: those of the motion. Allocates.
template <class S>
RIGLESS_COLD Rise<S> rise_of(const StagedMotion<S>& motion, const LapMargin& laps, S size, S height) {
  const std::size_t joints = to_size(motion.clip.joints()), frames = to_size(laps.frames);
  std::vector<Vec3<S>> wound;
  const Span<const Vec3<S>> poses = laps.wind<S>(motion.local, joints, wound);
  Rise<S> rise;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i % joints == 0) {
      rise.hips.push_back(0);
      const std::size_t f = rise.breath.size();
      const S speed = S(performance_fps) * (f > 0 ? pose_distance<S>(poses, joints, f - 1, f) : S(0));
      rise.breath.push_back(1 - smooth_step(size * speed / (S(0.15) * height)));
    }
    rise.hips.back() = std::max(rise.hips.back(), -size * poses[i].y());
  }
  smooth_hann(rise.hips, S(5), S(performance_fps));
  smooth_hann(rise.breath, S(2 * 15 + 1), S(performance_fps));
  S mean = 0;
  const std::int32_t breaths = (laps.period + 60) / 120;
  const S breath = laps.period > 0 ? static_cast<S>(laps.period) / std::max(static_cast<S>(breaths), S(1e-6)) : S(120);
  for (std::size_t f = 0; f < frames; ++f) {
    rise.hips[f] = rise.hips[f + to_size(laps.margin())];
    mean += rise.hips[f] / static_cast<S>(frames);
    const S drawn = 2 * static_cast<S>(f) / breath, phase = drawn - 2 * std::floor(drawn / 2);
    rise.breath[f] = S(0.03) * height * rise.breath[f + to_size(laps.margin())] * smooth_step(1 - std::abs(phase - 1));
  }
  rise.hips.resize(frames);
  rise.breath.resize(frames);
  for (S& r : rise.hips) r -= mean;
  return rise;
}

// What of the human's rise and fall the tracks lack comes to all that is not at the ground. rest: C; floor: y of the
// lowest vertex at rest; freedom: T x C, 0 where a control is held; root: T, of which y puts the lowest sole on the
// ground. No allocation.
template <class S>
RIGLESS_COLD void give_weight(const Rise<S>& human, Span<const Vec3<S>> rest, S floor, S height,
                              const std::vector<double>& freedom, const std::vector<Vec3<S>>& root,
                              std::vector<Vec3<S>>& tracks) {
  const std::size_t controls = rest.size();
  const auto level = [&](std::size_t c) { return (rest[c].y() - floor) / height; };
  const auto share = [&](std::size_t c) { return smooth_step(level(c) / S(0.3)); };
  S shares = S(1e-6), both = 0, own = S(1e-9);
  for (std::size_t c = 0; c < controls; ++c) shares += share(c);
  for (std::size_t f = 0; f < root.size(); ++f) {
    S body = root[f].y();
    for (std::size_t c = 0; c < controls; ++c) body += share(c) / shares * tracks[f * controls + c].y();
    both += human.hips[f] * body;
    own += human.hips[f] * human.hips[f];
  }
  const S lack = S(1.3) * std::clamp(1 - both / own, S(0), S(1));  // the middle of a body goes less far than its points
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const std::size_t f = i / controls, c = i % controls;
    const S rise = lack * human.hips[f], far = rise / (S(0.1) * height);
    tracks[i].y() +=
        static_cast<S>(freedom[i]) * (share(c) * rise / std::sqrt(1 + far * far) + level(c) * human.breath[f]);
  }
}

}  // namespace rigless::detail
