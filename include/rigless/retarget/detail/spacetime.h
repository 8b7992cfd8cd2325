// The spacetime system: all frames of all control tracks at once, under hard constraints.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/retarget/constraints.h"
#include "rigless/retarget/detail/constraint_forces.h"
#include "rigless/retarget/detail/spacetime_input.h"
#include "rigless/retarget/detail/spacetime_track.h"
#include "rigless/retarget/detail/weight_elimination.h"

namespace rigless::detail {

// Solves the spacetime system of thesis Eq 3.29 for C tracks of T frames. The frames of a track are coupled through its
// three coordinates only, so each frame's weights are eliminated first, then each track is one band system, and the
// constraints are what remains (a Schur complement over all tracks). Linear in T.
//
// begin(), then advance() until it returns false, then finish(). The arrays given to begin() must live until then.
template <class S>
class SpacetimeSolver {
 public:
  // Allocates. Errors: no_frames; no_examples; size_mismatch (lengths that do not fit; where: track); not_finite
  // (where: track); bad_constraint. On failure the previous solution is kept.
  Status begin(Span<const TrackInput<S>> tracks, std::int32_t frames, const Constraints<S>& constraints,
               const SpacetimeOptions<S>& options) {
    if (frames <= 0) return {Error::no_frames, -1};
    for (std::size_t t = 0; t < tracks.size(); ++t) {
      const Error error = check_track(tracks[t], to_size(frames));
      if (error != Error::none) return {error, t};
    }
    const Status status = constraint_rows(constraints, frames, count_of(tracks), rows_);
    if (!status.ok()) return status;
    options_ = options;
    frames_ = to_size(frames);
    inputs_.assign(tracks.begin(), tracks.end());
    prepare(constraints.size());
    return {};
  }

  // Works on for about that many frames; a constraint equation counts as T frames. Returns true while work is left.
  // Allocates only when it comes to another track.
  bool advance(std::int32_t budget) {
    while (budget > 0 && stage_ != Stage::done) {
      switch (stage_) {
        case Stage::frames:
          budget -= 1;
          next_frame();
          break;
        case Stage::rows:
          budget -= static_cast<std::int32_t>(frames_);
          next_row();
          break;
        case Stage::tracks:
          budget -= static_cast<std::int32_t>(frames_);
          next_constrained_track();
          break;
        case Stage::done:
          break;
      }
    }
    return stage_ != Stage::done;
  }

  // Errors: factorization_failed (the weights of a frame are not determined; where: frame).
  Status finish() {
    RIGLESS_ASSERT(stage_ == Stage::done);
    return status_;
  }

  // 0 to 1.
  double progress() const {
    const double per_track = static_cast<double>(frames_ + 1), all = static_cast<double>(inputs_.size()) * per_track;
    const double done = static_cast<double>(track_) * per_track + static_cast<double>(frame_);
    if (stage_ != Stage::frames) return stage_ == Stage::done ? 1 : 0.95;
    return all > 0 ? 0.9 * done / all : 0;
  }

  // T positions of one track, and its T x N weights where they are kept.
  Span<const Vec3<S>> track(std::int32_t index) const { return nth(solution_, index); }
  Span<const S> weights(std::int32_t index) const { return nth(weights_, index); }

  // How far each constraint is missed at worst; and which other one
  // stands most in its way, or -1: constraints that repeat each other do not.
  Span<const S> residuals() const { return forces_.residuals(); }
  Span<const std::int32_t> opponents() const { return forces_.opponents(); }

 private:
  enum class Stage { frames, rows, tracks, done };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // Tracks with a constraint keep their factors until the constraint forces are known; the others share one workspace.
  void prepare(std::size_t constraints) {
    const std::size_t tracks = inputs_.size();
    workspace_.assign(tracks, none);
    std::size_t constrained = 0;
    for (const auto& row : rows_)
      for (const auto& term : row.terms) {
        std::size_t& own = nth(workspace_, term.track);
        if (own == none) own = ++constrained;
      }
    systems_.resize(constrained + 1);
    solution_.resize(tracks);
    weights_.resize(tracks);
    force_.assign(frames_, Vec3<S>::Zero());
    change_.resize(frames_);
    forces_.bind(rows_.size(), constraints);
    status_ = {};
    track_ = frame_ = row_ = 0;
    stage_ = tracks > 0 ? Stage::frames : Stage::done;
  }

  bool constrained(std::size_t track) const { return workspace_[track] != none; }
  SpacetimeTrack<S>& system(std::size_t track) { return systems_[constrained(track) ? workspace_[track] : 0]; }

  void next_frame() {
    const TrackInput<S>& in = inputs_[track_];
    if (frame_ == 0) {
      TrackOptions<S> options = options_.track;
      if (!constrained(track_)) options.offset_weight = 0;
      const std::size_t kept = options_.keep_weights ? in.example_controls.size() : 0;
      system(track_).bind(static_cast<std::int32_t>(frames_), kept, options);
      elimination_.bind(in.example_features, in.example_controls, options_.weights);
    }
    WeightCost<S> cost;
    const std::size_t first = frame_ * in.example_controls.size();
    if (!in.stiffness.empty()) cost = {&in.stiffness[first], &in.pull[first]};
    if (!system(track_).append(elimination_, features_of(in), cost)) {
      status_ = {Error::factorization_failed, frame_};
      stage_ = Stage::done;
      return;
    }
    if (++frame_ < frames_) return;
    solve_track(track_);
    frame_ = 0;
    if (++track_ < inputs_.size()) return;
    track_ = 0;
    stage_ = rows_.empty() ? Stage::done : Stage::rows;
  }

  // Those of the next frame.
  const S* features_of(const TrackInput<S>& in) {
    const std::size_t own = in.features.size() / frames_, all = in.dimension(frames_);
    const S* const first = in.features.data() + frame_ * own;
    if (own == all) return first;
    const S* const shared = in.shared.data() + frame_ * (all - own);
    feature_.resize(all);
    for (std::size_t d = 0; d < all; ++d) feature_[d] = d < own ? first[d] : in.share * shared[d - own];
    return feature_.data();
  }

  // Solves one track under force_, and recovers its weights.
  void solve_track(std::size_t track) {
    const std::size_t examples = options_.keep_weights ? inputs_[track].example_controls.size() : 0;
    solution_[track].resize(frames_);
    weights_[track].resize(frames_ * examples);
    system(track).solve(force_, true, solution_[track]);
    if (examples > 0) system(track).recover_weights(force_, solution_[track], weights_[track]);
  }

  void add_force(std::size_t track, const ConstraintRow<S>& row, S multiplier) {
    for (const auto& term : row.terms)
      if (to_size(term.track) == track) nth(force_, term.frame)[term.axis] += term.factor * multiplier;
  }

  // One column of the Schur complement: how a unit force along this row moves all rows.
  void next_row() {
    const ConstraintRow<S>& row = rows_[row_];
    for (std::size_t k = 0; k < 2; ++k) {
      const std::int32_t track = row.terms[k].track;
      if (k == 1 && track == row.terms[0].track) break;
      std::fill(force_.begin(), force_.end(), Vec3<S>::Zero());
      add_force(to_size(track), row, S(1));
      system(to_size(track)).solve(force_, false, change_);
      for (std::size_t r = 0; r < rows_.size(); ++r)
        for (const auto& term : rows_[r].terms)
          if (term.track == track) forces_.response(r, row_) -= term.factor * nth(change_, term.frame)[term.axis];
    }
    if (++row_ < rows_.size()) return;
    forces_.solve(rows_, solution_, options_.compliance);
    stage_ = Stage::tracks;
  }

  void next_constrained_track() {
    while (track_ < inputs_.size() && !constrained(track_)) ++track_;
    if (track_ < inputs_.size()) {
      std::fill(force_.begin(), force_.end(), Vec3<S>::Zero());
      for (std::size_t r = 0; r < rows_.size(); ++r) add_force(track_, rows_[r], forces_.multiplier(r));
      solve_track(track_++);
      return;
    }
    forces_.measure(rows_, solution_);
    stage_ = Stage::done;
  }

  SpacetimeOptions<S> options_;
  std::vector<TrackInput<S>> inputs_;  // C
  std::size_t frames_ = 0;             // T
  std::vector<ConstraintRow<S>> rows_;

  Stage stage_ = Stage::done;
  Status status_;
  std::size_t track_ = 0, frame_ = 0, row_ = 0;  // what comes next
  WeightElimination<S> elimination_;
  std::vector<S> feature_;                  // D
  std::vector<SpacetimeTrack<S>> systems_;  // 0: shared by the tracks without constraints
  std::vector<std::size_t> workspace_;      // C, into systems_
  std::vector<Vec3<S>> force_, change_;     // T
  ConstraintForces<S> forces_;

  std::vector<std::vector<Vec3<S>>> solution_;  // C x T
  std::vector<std::vector<S>> weights_;         // C x T x N
};

}  // namespace rigless::detail
