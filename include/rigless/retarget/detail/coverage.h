// How much of a clip the examples teach, and which frame to teach next.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/example.h"
#include "rigless/retarget/detail/pose_spread.h"
#include "rigless/retarget/detail/weight_elimination.h"

namespace rigless::detail {

struct CoverageOptions {
  double enough = 0.15;       // error at which the examples are enough, in pose spreads
  std::int32_t asks = 8;      // frames to ask for at most
  std::int32_t most = 24;     // examples at most until they are enough
  std::int32_t samples = 96;  // frames that are weighed against each other at most, evenly spaced
};

// The poses of a clip as mixtures of the example poses (weights that sum to 1, locality as in the retargeting), in
// spreads of the clip: the mean pose is 1 from a random frame (rms), two random frames are 1.4 apart. A frame's error
// is how far the best mixture is from it; without any example, how far a random frame is.
//
// begin(), then advance() until it returns false. Source: locality-constrained coding; greedy choice by the error that
// one step along a new pose would leave.
class PoseCoverage {
 public:
  // clip: T x J and examples: N x J (N may be 0), finite, body-local; paired: the joints that count; mirror: J, when
  // each example brings its mirror image along (these are among the N), or empty. Copies what it needs. Allocates.
  void begin(Span<const Vec3<double>> clip, std::int32_t joint_count, Span<const std::int32_t> paired,
             Span<const Vec3<double>> examples, Span<const std::int32_t> mirror, const CoverageOptions& options) {
    options_ = options;
    const auto joints = to_size(joint_count);
    frames_ = clip.size() / joints;
    stride_ = std::max<std::size_t>(1, (frames_ + to_size(options.samples) - 1) / to_size(options.samples));
    dimension_ = 3 * paired.size();
    spreads_ = joint_spreads(clip, joint_count);
    const auto plain = [&](const Vec3<double>* pose, std::size_t j) { return pose[j]; };
    const auto mirrored = [&](const Vec3<double>* pose, std::size_t j) {
      const Vec3<double>& p = nth(pose, mirror[j]);
      return Vec3<double>(-p.x(), p.y(), p.z());
    };
    clip_ = features(clip, joints, paired, 1, plain);
    known_ = features(examples, joints, paired, 1, plain);
    images_.clear();
    if (!mirror.empty()) images_ = features(clip, joints, paired, stride_, mirrored);
    coverage_.assign(frames_, 0);
    asks_.clear();
    have_ = want_ = static_cast<std::int32_t>(examples.size() / joints);
    frame_ = 0;
    picks_ = 0;
    covered_ = false;
    stage_ = Stage::frames;
    bind();
  }

  // Works on for about that many frames. Returns true while work is left. Allocates.
  bool advance(std::int32_t budget) {
    while (budget > 0 && stage_ != Stage::done) {
      if (stage_ == Stage::frames) {
        coverage_[frame_] = std::sqrt(reconstruct(frame_, nullptr));
        if (++frame_ == frames_) stage_ = Stage::asks;
        budget -= 1;
      } else {
        next_ask();
        budget -= 4 * options_.samples;
      }
    }
    return stage_ != Stage::done;
  }

  const std::vector<double>& coverage() const { return coverage_; }  // T
  const std::vector<Ask>& asks() const { return asks_; }             // best first
  std::int32_t have() const { return have_; }                        // N
  // Examples until the error is small enough: N if it is, otherwise with those that next_ask() would add, their images
  // counted.
  std::int32_t want() const { return want_; }

 private:
  enum class Stage { frames, asks, done };

  template <class Take>
  std::vector<double> features(Span<const Vec3<double>> poses, std::size_t joints, Span<const std::int32_t> paired,
                               std::size_t stride, Take take) const {
    const double shared = std::sqrt(static_cast<double>(paired.size()));
    std::vector<double> out;
    for (std::size_t first = 0; first < poses.size(); first += stride * joints) {
      for (const std::int32_t index : paired) {
        const auto j = to_size(index);
        const Vec3<double> p = (take(&poses[first], j) - spreads_[j].mean) / (spreads_[j].scale() * shared);
        out.insert(out.end(), p.data(), p.data() + 3);
      }
    }
    return out;
  }

  std::size_t known() const { return known_.size() / dimension_; }
  std::size_t samples() const { return (frames_ + stride_ - 1) / stride_; }
  const double* sample(std::size_t s) const { return &clip_[s * stride_ * dimension_]; }

  void bind() {
    nothing_.assign(known(), Vec3<double>::Zero());
    free_.resize(known());
    response_.resize(known());
    if (known() > 0) mixture_.bind(known_, nothing_, WeightOptions<double>{});
  }

  // Squared error of a frame; `rest`, if given, gets what the mixture leaves of it (D).
  double reconstruct(std::size_t frame, double* rest) {
    const double* j = &clip_[frame * dimension_];
    if (known() > 0) {
      Vec3<double> position;
      Mat3<double> compliance;
      if (!mixture_.eliminate(j, {}, position, compliance, free_.data(), response_.data())) return 0;
    }
    double sum = known() > 0 ? 0 : 1;  // as far as from a random frame
    for (std::size_t d = 0; d < dimension_; ++d) {
      double x = j[d];
      for (std::size_t m = 0; m < known(); ++m) x -= free_[m] * known_[m * dimension_ + d];
      if (rest != nullptr) rest[d] = x;
      sum += x * x;
    }
    return sum;
  }

  // Squared error that sample s would have after one step from its mixture towards a pose.
  double after_step(std::size_t s, const double* pose) const {
    const double* j = sample(s);
    const double* rest = &rest_[s * dimension_];
    double along = 0, length = 0;
    for (std::size_t d = 0; d < dimension_; ++d) {
      const double way = pose[d] - (j[d] - rest[d]);
      along += way * rest[d];
      length += way * way;
    }
    return along > 0 ? errors_[s] - along * along / std::max(length, along) : errors_[s];
  }

  // The error with the examples so far; then the next frame to ask for, which counts as an example from then on.
  void next_ask() {
    rest_.resize(samples() * dimension_);
    errors_.resize(samples());
    double sum = 0;
    for (std::size_t s = 0; s < samples(); ++s) sum += errors_[s] = reconstruct(s * stride_, &rest_[s * dimension_]);
    const double error = std::sqrt(sum / static_cast<double>(samples()));
    const auto count = static_cast<std::int32_t>(known());
    if (picks_ > 0 && asks_.size() == picks_) asks_.back().gain = std::max(0.0, error_ - error);
    if (!covered_) want_ = count;
    covered_ = covered_ || error < options_.enough;
    error_ = error;
    const bool asked = picks_ >= to_size(options_.asks);
    if ((covered_ && asked) || count >= options_.most || error < 1e-6) {
      stage_ = Stage::done;
      return;
    }
    const std::size_t s = known() > 0 ? most_mending() : nearest_to_mean();
    if (!asked) asks_.push_back({static_cast<std::int32_t>(s * stride_), 0});
    ++picks_;
    known_.insert(known_.end(), sample(s), sample(s) + dimension_);
    if (!images_.empty()) known_.insert(known_.end(), &images_[s * dimension_], &images_[s * dimension_] + dimension_);
    bind();
  }

  std::size_t nearest_to_mean() const {
    return to_size(std::min_element(errors_.begin(), errors_.end()) - errors_.begin());
  }

  // The sample after which the error is least, as far as one step of each mixture tells.
  std::size_t most_mending() const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < samples(); ++c) {
      double sum = 0;
      for (std::size_t s = 0; s < samples(); ++s) {
        const double own = after_step(s, sample(c));
        sum += images_.empty() ? own : std::min(own, after_step(s, &images_[c * dimension_]));
      }
      if (sum < least) best = c;
      least = std::min(least, sum);
    }
    return best;
  }

  CoverageOptions options_;
  std::size_t frames_ = 0, stride_ = 1, dimension_ = 0, frame_ = 0, picks_ = 0;
  double error_ = 0;
  bool covered_ = false;
  std::int32_t have_ = 0, want_ = 0;
  std::vector<JointSpread<double>> spreads_;
  std::vector<double> clip_, known_, images_;  // T x D; examples so far x D; samples x D
  std::vector<double> rest_, errors_;          // samples x D, samples
  std::vector<double> coverage_;
  std::vector<Ask> asks_;
  std::vector<Vec3<double>> nothing_, response_;
  std::vector<double> free_;
  WeightElimination<double> mixture_;
  Stage stage_ = Stage::done;
};

}  // namespace rigless::detail
