// The spacetime system with bounds on the weights: the quadratic program that the paper leaves to others.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rigless/retarget/detail/spacetime.h"

namespace rigless::detail {

// SpacetimeSolver under lower <= w <= upper for every weight in use. A primal-dual interior point method: each of its
// iterations is one spacetime system with a stiffness and a pull on the weights, so it stays linear in T. Where no
// bound is touched, one system is all. Constraints that the bounds cannot meet end at a compromise; see residuals().
// Source: thesis, end of 3.3.3.
template <class S>
class BoundedSpacetimeSolver {
 public:
  // Sets the bounds; call before begin(). lower < upper.
  void set_bounds(S lower, S upper) {
    RIGLESS_ASSERT(lower < upper);
    lower_ = lower;
    upper_ = upper;
  }

  // As SpacetimeSolver. Allocates.
  Status begin(Span<const TrackInput<S>> tracks, std::int32_t frames, const Constraints<S>& constraints,
               const SpacetimeOptions<S>& options) {
    if (const Status status = solver_.begin(tracks, frames, constraints, options); !status.ok()) return status;
    tracks_.assign(tracks.begin(), tracks.end());
    frames_ = frames;
    constraints_ = constraints;
    options_ = options;
    weights_.clear();
    gap_ = 1;
    iteration_ = 0;
    return {};
  }

  // Allocates between two systems.
  bool advance(std::int32_t budget) {
    if (solver_.advance(budget)) return true;
    if (!solver_.finish().ok() || iteration_ == most_iterations || gap_ < S(1e-13) || !improve()) return false;
    ++iteration_;
    return true;
  }

  Status finish() { return solver_.finish(); }
  double progress() const { return (iteration_ + solver_.progress()) / (most_iterations + 1); }
  Span<const Vec3<S>> track(std::int32_t index) const { return solver_.track(index); }
  Span<const S> weights(std::int32_t index) const { return solver_.weights(index); }
  Span<const S> residuals() const { return solver_.residuals(); }
  Span<const std::int32_t> opponents() const { return solver_.opponents(); }

 private:
  static constexpr int most_iterations = 60;

  // One weight: where it is, and how hard each bound pushes.
  struct Weight {
    S w, low, high;
    bool used;
  };

  // Steps towards what the solver found, and sets up the next system. False when nothing touches a bound.
  bool improve() {
    if (weights_.empty()) {
      if (!start()) return false;
    } else {
      step();
    }
    S gap = 0, count = 0;
    for (const Weight& x : weights_) {
      if (!x.used) continue;
      gap += (x.w - lower_) * x.low + (upper_ - x.w) * x.high;
      count += S(2);
    }
    gap_ = gap / count;
    aim_ = gap_ * S(0.1);
    stiffness_.assign(weights_.size(), S(0));
    pull_.assign(weights_.size(), S(0));
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const Weight& x = weights_[i];
      if (!x.used) continue;
      stiffness_[i] = x.low / (x.w - lower_) + x.high / (upper_ - x.w);
      pull_[i] = aim_ / (x.w - lower_) - aim_ / (upper_ - x.w) + stiffness_[i] * x.w;
    }
    std::size_t first = 0;
    for (TrackInput<S>& track : tracks_) {
      const std::size_t size = to_size(frames_) * track.example_controls.size();
      track.stiffness = {&stiffness_[first], size};
      track.pull = {&pull_[first], size};
      first += size;
    }
    return solver_.begin(tracks_, frames_, constraints_, options_).ok();
  }

  // From the unbounded solution, moved inside. A weight that is exactly 0 belongs to an example that the frame does not
  // use.
  bool start() {
    const S margin = (upper_ - lower_) / S(10);
    bool inside = true;
    each_weight([&](std::size_t, S w) {
      const bool used = w != S(0);
      inside = inside && (!used || (w >= lower_ && w <= upper_));
      weights_.push_back({std::clamp(w, lower_ + margin, upper_ - margin), S(1), S(1), used});
    });
    return !inside;
  }

  // As far as weights and pushes stay on their side, at most all the way.
  void step() {
    S primal = 1, dual = 1;
    std::vector<Weight> change(weights_.size());
    const auto limit = [](S& step, S value, S move) {
      if (move < S(0)) step = std::min(step, S(-0.995) * value / move);
    };
    each_weight([&](std::size_t i, S w) {
      const Weight& x = weights_[i];
      if (!x.used) return;
      const S below = x.w - lower_, above = upper_ - x.w, move = w - x.w;
      change[i] = {move, (aim_ - x.low * move) / below - x.low, (aim_ + x.high * move) / above - x.high, true};
      limit(primal, below, move);
      limit(primal, above, -move);
      limit(dual, x.low, change[i].low);
      limit(dual, x.high, change[i].high);
    });
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      if (!weights_[i].used) continue;
      weights_[i].w += primal * change[i].w;
      weights_[i].low += dual * change[i].low;
      weights_[i].high += dual * change[i].high;
    }
  }

  template <class Visit>
  void each_weight(Visit visit) const {
    std::size_t i = 0;
    for (std::size_t t = 0; t < tracks_.size(); ++t)
      for (const S w : solver_.weights(static_cast<std::int32_t>(t))) visit(i++, w);
  }

  SpacetimeSolver<S> solver_;
  std::vector<TrackInput<S>> tracks_;  // C
  std::int32_t frames_ = 0;            // T
  Constraints<S> constraints_;
  SpacetimeOptions<S> options_;
  S lower_ = 0, upper_ = 1;
  std::vector<Weight> weights_;  // C x T x N
  std::vector<S> stiffness_, pull_;
  S gap_ = 1, aim_ = 0;  // mean product of slack and push, and what the next system aims at
  int iteration_ = 0;
};

}  // namespace rigless::detail
