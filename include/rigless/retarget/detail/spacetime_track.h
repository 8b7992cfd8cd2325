// One control track of the spacetime system: T frames, coupled by their accelerations only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/band_solver.h"
#include "rigless/retarget/detail/weight_elimination.h"

namespace rigless::detail {

// lambda_A and the offset track. Per frame^2: a clip at another rate needs other values.
template <class S>
struct TrackOptions {
  S acceleration = S(0.3);    // lambda_A of Eq 3.26; the cost has its square
  S offset_weight = 0;        // cost of the squared offset; 0: no offset track
  S offset_acceleration = 3;  // like lambda_A, for the offset
};

// With the weights eliminated, c_f = position_f - compliance_f u_f + o_f, where u = lambda_A^2 D2'D2 c + force is what
// accelerations and constraints pull at the control, and the offset o obeys K o = -u with
// K = offset_weight + offset_acceleration^2 D2'D2. So c solves a block-pentadiagonal system of 3 x 3 blocks, or c and o
// one of 6 x 6 blocks, in time linear in T.
template <class S>
class SpacetimeTrack {
 public:
  // Makes room for T frames of N weights, 0: which are not kept. Allocates.
  void bind(std::int32_t frames, std::size_t examples, const TrackOptions<S>& options) {
    const auto count = to_size(frames);
    options_ = options;
    examples_ = examples;
    next_ = 0;
    position_.resize(count);
    compliance_.resize(count);
    free_.resize(count * examples);
    response_.resize(count * examples);
    if (has_offset()) {
      both_.bind(frames);
      both_right_.resize(count);
    } else {
      plain_.bind(frames);
      plain_right_.resize(count);
    }
  }

  // Takes in the next frame, features j (D). Returns false when its weights are not determined. No allocation.
  bool append(WeightElimination<S>& weights, const S* j, const WeightCost<S>& cost) {
    const std::size_t f = next_;
    S* const free = examples_ > 0 ? &free_[f * examples_] : nullptr;
    Vec3<S>* const response = examples_ > 0 ? &response_[f * examples_] : nullptr;
    if (!weights.eliminate(j, cost, position_[f], compliance_[f], free, response)) return false;
    if (has_offset()) {
      append_both(f);
    } else {
      append_plain(f);
    }
    ++next_;
    return true;
  }

  // The track (T) under the constraint forces (T); with `free` false only what the forces change. No allocation.
  void solve(Span<const Vec3<S>> force, bool free, Span<Vec3<S>> track) {
    if (has_offset()) {
      for (std::size_t f = 0; f < next_; ++f) {
        both_right_[f].template head<3>() = pulled(f, force[f], free);
        both_right_[f].template tail<3>() = -force[f];
      }
      both_.solve_in_place(both_right_);
      for (std::size_t f = 0; f < next_; ++f) track[f] = both_right_[f].template head<3>();
    } else {
      for (std::size_t f = 0; f < next_; ++f) plain_right_[f] = pulled(f, force[f], free);
      plain_.solve_in_place(plain_right_);
      for (std::size_t f = 0; f < next_; ++f) track[f] = plain_right_[f];
    }
  }

  // The weights (T x N) that belong to a track and the forces that gave it. No allocation.
  void recover_weights(Span<const Vec3<S>> force, Span<const Vec3<S>> track, Span<S> weights) const {
    for (std::size_t f = 0; f < next_; ++f) {
      const auto row = acceleration_row(f);
      Vec3<S> pull = force[f];
      for (std::size_t g = 0; g < 5; ++g)
        if (row[g] != S(0)) pull += row[g] * track[f + g - 2];
      for (std::size_t m = f * examples_; m < (f + 1) * examples_; ++m) weights[m] = free_[m] - response_[m].dot(pull);
    }
  }

 private:
  bool has_offset() const { return options_.offset_weight > S(0); }

  std::array<S, 5> acceleration_row(std::size_t f) const {
    auto row = second_difference_row<S>(count_of(position_), static_cast<std::int32_t>(f));
    for (S& x : row) x *= options_.acceleration * options_.acceleration;
    return row;
  }

  Vec3<S> pulled(std::size_t f, const Vec3<S>& force, bool free) const {
    Vec3<S> c = -(compliance_[f] * force);
    if (free) c += position_[f];
    return c;
  }

  void append_plain(std::size_t f) {
    const auto acceleration = acceleration_row(f);
    typename BandSolver<S, 3>::Row row;
    for (std::size_t g = 0; g < 5; ++g) row[g] = acceleration[g] * compliance_[f];
    row[2].diagonal().array() += S(1);
    plain_.append(row);
  }

  void append_both(std::size_t f) {
    const auto acceleration = acceleration_row(f);
    const auto second = second_difference_row<S>(count_of(position_), static_cast<std::int32_t>(f));
    const S stiffness = options_.offset_acceleration * options_.offset_acceleration;
    typename BandSolver<S, 6>::Row row;
    for (std::size_t g = 0; g < 5; ++g) {
      row[g].setZero();
      row[g].template topLeftCorner<3, 3>() = acceleration[g] * compliance_[f];
      row[g].template bottomLeftCorner<3, 3>().diagonal().setConstant(acceleration[g]);
      row[g].template bottomRightCorner<3, 3>().diagonal().setConstant(stiffness * second[g]);
    }
    row[2].template topLeftCorner<3, 3>().diagonal().array() += S(1);
    row[2].template topRightCorner<3, 3>().diagonal().setConstant(S(-1));
    row[2].template bottomRightCorner<3, 3>().diagonal().array() += options_.offset_weight;
    both_.append(row);
  }

  TrackOptions<S> options_;
  std::size_t examples_ = 0;         // N
  std::size_t next_ = 0;             // frames so far
  std::vector<Vec3<S>> position_;    // T
  std::vector<Mat3<S>> compliance_;  // T
  std::vector<S> free_;              // T x N
  std::vector<Vec3<S>> response_;    // T x N
  BandSolver<S, 3> plain_;
  BandSolver<S, 6> both_;
  std::vector<Eigen::Matrix<S, 3, 1>> plain_right_;
  std::vector<Eigen::Matrix<S, 6, 1>> both_right_;
};

}  // namespace rigless::detail
