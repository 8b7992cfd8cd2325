// Accents: what smoothing takes from a movement near two hertz comes back, and more of it where that is asked for.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/detail/macros.h"
#include "rigless/math/detail/smooth_step.h"
#include "rigless/math/types.h"
#include "rigless/retarget/constraints.h"
#include "rigless/scene/detail/loop.h"
#include "rigless/scene/staged_motion.h"

namespace rigless::detail {

inline constexpr double accent_gain = 4;          // frames squared, at 30 fps
inline constexpr std::int32_t accent_reach = 13;  // frames, at 30 fps
inline constexpr std::int32_t accent_rest = 8;    // frames in which a control comes to rest

// A smoothed second difference, -reach to +reach: strongest at 2.8 Hz, and nothing where a track stands still. Smoothed
// by binomial weights, which are exact.
template <class S>
std::array<S, 2 * accent_reach + 1> accent_kernel() {
  std::array<S, 2 * accent_reach + 1> kernel{};
  S binomial = S(1) / S(1 << (2 * accent_reach - 2));
  for (std::int32_t k = 0; k <= 2 * accent_reach - 2; ++k) {
    kernel[to_size(k)] += binomial;
    kernel[to_size(k + 1)] -= 2 * binomial;
    kernel[to_size(k + 2)] += binomial;
    binomial = binomial * static_cast<S>(2 * accent_reach - 2 - k) / static_cast<S>(k + 1);
  }
  return kernel;
}

// How free each control is to move at each frame: 0 where `held`, 1 from accent_rest frames away. T x C. Allocates.
inline std::vector<double> freedom_of(const std::vector<std::uint8_t>& held, std::size_t controls, std::int32_t frames,
                                      std::int32_t period) {
  std::vector<double> freedom(held.size(), 1);
  for (std::int32_t f = 0; f < frames; ++f) {
    for (std::size_t c = 0; c < controls; ++c) {
      std::int32_t nearest = accent_rest;
      for (std::int32_t k = 0; k < nearest; ++k)
        for (const std::int32_t g : {f - k, f + k})
          if (held[to_size(frame_around(g, frames, period)) * controls + c] != 0) nearest = k;
      freedom[to_size(f) * controls + c] = smooth_step(static_cast<double>(nearest) / accent_rest);
    }
  }
  return freedom;
}

// One track at any frame: a loop goes on, another clip goes on beyond its ends as it came.
template <class S>
struct Track {
  Span<const Vec3<S>> all;  // T x C
  std::size_t count, index;
  std::int32_t period;

  std::int32_t frames() const { return static_cast<std::int32_t>(all.size() / count); }
  Vec3<S> at(std::int32_t f) const {
    const std::int32_t last = frames() - 1;
    if (period > 0 || (f >= 0 && f <= last)) return all[to_size(frame_around(f, last + 1, period)) * count + index];
    const std::int32_t end = f < 0 ? 0 : last;
    return 2 * at(end) - at(std::clamp(2 * end - f, 0, last));
  }
};

// The accent of a track at each frame, T: its smoothed acceleration. Allocates.
template <class S>
std::vector<Vec3<S>> accents_of(const Track<S>& track) {
  const auto kernel = accent_kernel<S>();
  std::vector<Vec3<S>> accents;
  for (std::int32_t f = 0; f < track.frames(); ++f) {
    accents.push_back(Vec3<S>::Zero());
    for (std::int32_t k = -accent_reach; k <= accent_reach; ++k)
      accents.back() += kernel[to_size(k + accent_reach)] * track.at(f + k);
  }
  return accents;
}

// How strong the accents of a track are beside its movement, after any gain: all of it is linear in the track, so six
// sums tell.
template <class S>
class AccentSums {
 public:
  // Allocates.
  explicit AccentSums(const Track<S>& track) {
    const std::vector<Vec3<S>> accents = accents_of(track);
    const std::vector<Vec3<S>> again = accents_of(Track<S>{accents, 1, 0, track.period});
    const auto frames = static_cast<S>(track.frames());
    Vec3<S> mean = Vec3<S>::Zero(), accent_mean = Vec3<S>::Zero();
    for (std::size_t f = 0; f < accents.size(); ++f) {
      mean += track.at(static_cast<std::int32_t>(f)) / frames;
      accent_mean += accents[f] / frames;
    }
    for (std::size_t f = 0; f < accents.size(); ++f) {
      const Vec3<S> moved = track.at(static_cast<std::int32_t>(f)) - mean, change = accents[f] - accent_mean;
      accents_.add(accents[f], again[f]);
      movement_.add(moved, change);
    }
  }

  // Accents over movement, squared; 0 where nothing moves.
  S share(S gain) const {
    const S moved = movement_.at(gain);
    return moved > S(0) ? accents_.at(gain) / moved : S(0);
  }

 private:
  // |x - gain y|^2
  struct Quadratic {
    S xx = 0, xy = 0, yy = 0;
    void add(const Vec3<S>& x, const Vec3<S>& y) {
      xx += x.squaredNorm();
      xy += x.dot(y);
      yy += y.squaredNorm();
    }
    S at(S gain) const { return xx - 2 * gain * xy + gain * gain * yy; }
  };
  Quadratic accents_, movement_;
};

// Takes `gain` times its accents from one of C tracks: a movement winds up before it begins and goes beyond where it
// ends. freedom: T x C; grounded: it may only go up, since the body stands on it. Allocates. Source: Wang, Drucker,
// Agrawala, Cohen, The Cartoon Animation Filter, 2006.
template <class S>
void accentuate(S gain, const std::vector<double>& freedom, bool grounded, std::size_t count, std::size_t index,
                std::int32_t period, std::vector<Vec3<S>>& tracks) {
  const std::vector<Vec3<S>> accents = accents_of(Track<S>{tracks, count, index, period});
  for (std::size_t f = 0; f < accents.size(); ++f) {
    const std::size_t i = f * count + index;
    Vec3<S> move = -gain * static_cast<S>(freedom[i]) * accents[f];
    if (grounded) move.y() = std::max(move.y(), S(0));
    tracks[i] += move;
  }
}

// The gain that gives a track the share of accents that its joint has, or as much of it as accent_gain can.
template <class S>
S gain_towards(S share, const AccentSums<S>& sums) {
  constexpr int halvings = 8;
  S low = 0, high = S(accent_gain);
  if (sums.share(low) >= share) return low;
  if (sums.share(high) <= share) return high;
  for (int k = 0; k < halvings; ++k) {
    const S middle = (low + high) / 2;
    (sums.share(middle) < share ? low : high) = middle;
  }
  return low;
}

// T x C, 1 where a constraint holds a control, or where it stands. Allocates.
template <class S>
std::vector<std::uint8_t> held_controls(const Constraints<S>& constraints, const Performance<S>& p) {
  std::vector<std::uint8_t> held = p.contacts;
  const auto hold = [&](const TrackFrame& at) { held[to_size(at.frame) * p.control_count() + to_size(at.track)] = 1; };
  for (const Constraint<S>& c : constraints) {
    hold(c.at);
    if (c.from) hold(*c.from);
  }
  return held;
}

// Gives each control the accents that its joint has, less of them for an energy below 0, more than it has for one
// above. pairs: C; freedom: T x C. Allocates.
template <class S>
void give_accents(const StagedMotion<S>& motion, Span<const std::int32_t> pairs, const std::vector<double>& freedom,
                  S energy, Performance<S>& p) {
  const std::size_t controls = pairs.size(), joints = motion.clip.skeleton.names.size();
  const std::int32_t period = motion.loop_period;
  for (std::size_t c = 0; c < controls; ++c) {
    S gain = S(accent_gain) * std::max(energy, S(0));
    if (pairs[c] >= 0) {
      const AccentSums<S> joint(Track<S>{motion.local, joints, to_size(pairs[c]), period});
      const AccentSums<S> own(Track<S>{p.controls, controls, c, period});
      gain += (1 + std::min(energy, S(0))) * gain_towards(joint.share(S(0)), own);
    }
    bool grounded = false;
    for (std::size_t i = c; i < p.contacts.size(); i += controls) grounded = grounded || p.contacts[i] != 0;
    accentuate(gain, freedom, grounded, controls, c, period, p.controls);
  }
}

}  // namespace rigless::detail
