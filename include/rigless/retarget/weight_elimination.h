// The per-frame half of the spacetime system: the weights of one frame, eliminated.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "rigless/math/dense_solve.h"
#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"

namespace rigless {

template <class S>
struct WeightOptions {
  // mu: cost of the squared weight of an example, times its squared distance from the frame.
  S locality = S(0.03);
  // Weight of the soft row "sum of weights = 1" of Eq 3.19; 0: the sum is 1 exactly, so that translations do not
  // matter.
  S soft_affine = 0;
  // Only that many nearest examples of each frame are used (the paper: 4, ties by index); 0: all.
  std::int32_t nearest = 0;
  // Cost of the squared weights: shares the weight among examples that nothing else tells apart. Never less than what
  // rounding demands.
  S tikhonov = S(1e-12);
};

// A further cost 1/2 stiffness w^2 - pull w of every weight of a frame (N of each), or none.
template <class S>
struct WeightCost {
  const S* stiffness = nullptr;
  const S* pull = nullptr;
};

// For the features j of one frame, the weights minimise
//   1/2 |J w - j|^2 + 1/2 mu sum_m w_m^2 |j - j_m|^2 + 1/2 tikhonov |w|^2 + u.(C w),  sum w = 1 (or its soft row)
// when u pulls at the control: w = free - response u, so the control is C w = position - compliance u.
template <class S>
class WeightElimination {
 public:
  using Matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;

  // The examples of one track: N x D features and N control positions, which must outlive this object's use.
  // Allocates.
  void bind(Span<const S> features, Span<const Vec3<S>> controls, const WeightOptions<S>& options) {
    RIGLESS_ASSERT(!controls.empty() && features.size() % controls.size() == 0);
    options_ = options;
    features_ = features;
    controls_ = controls;
    const auto count = static_cast<Eigen::Index>(controls.size());
    const Eigen::Map<const Matrix> columns(features.data(), static_cast<Eigen::Index>(dimension()), count);
    gram_ = columns.transpose().lazyProduct(columns);
    const S scale = gram_.trace() / static_cast<S>(count);
    ridge_ = std::max(options.tikhonov, S(8) * std::numeric_limits<S>::epsilon() * std::max(scale, S(1e-3)));
    projection_.resize(count);
    distance_.resize(controls.size());
    order_.resize(controls.size());
    used_ = options.nearest > 0 ? std::min(count, static_cast<Eigen::Index>(options.nearest)) : count;
    const Eigen::Index unknowns = hard() ? used_ - 1 : used_;
    system_.resize(unknowns, unknowns);
    right_.resize(unknowns, 4);
  }

  // Eliminates the frame with features j (D). free: N weights; response: N x 3. No allocation.
  // Returns false when the weights are not determined.
  bool eliminate(const S* j, const WeightCost<S>& cost, Vec3<S>& position, Mat3<S>& compliance, S* free,
                 Vec3<S>* response) {
    cost_ = cost;
    measure(j);
    choose_base();
    if (!factorise()) return false;
    // right_ holds [C' b] and becomes L^-1 [C' b], whose products are symmetric to the last bit.
    solve_lower(system_, right_);
    const auto forces = right_.template leftCols<3>();
    position = base_control() + forces.transpose().lazyProduct(right_.col(3));
    compliance = forces.transpose().lazyProduct(forces);
    solve_lower_transposed(system_, right_);
    write_weights(free, response);
    return true;
  }

 private:
  bool hard() const { return options_.soft_affine == S(0); }
  std::size_t dimension() const { return features_.size() / controls_.size(); }
  Vec3<S> base_control() const { return hard() ? controls_[order_[0]] : Vec3<S>::Zero().eval(); }

  // Distances from j to the examples, J'j, and the examples in use: all by index, or the nearest, nearest first.
  void measure(const S* j) {
    const auto size = static_cast<Eigen::Index>(dimension());
    const Eigen::Map<const Eigen::Matrix<S, Eigen::Dynamic, 1>> frame(j, size);
    for (std::size_t m = 0; m < controls_.size(); ++m) {
      const Eigen::Map<const Eigen::Matrix<S, Eigen::Dynamic, 1>> example(features_.data() + m * dimension(), size);
      projection_[static_cast<Eigen::Index>(m)] = example.dot(frame);
      distance_[m] = (example - frame).squaredNorm();
      order_[m] = m;
    }
    if (used_ == static_cast<Eigen::Index>(controls_.size())) return;
    std::partial_sort(order_.begin(), order_.begin() + used_, order_.end(), [&](std::size_t a, std::size_t b) {
      return distance_[a] < distance_[b] || (distance_[a] == distance_[b] && a < b);
    });
  }

  // Everything passes through the base, so it must not be the stiffest.
  void choose_base() {
    if (cost_.stiffness == nullptr) return;
    const auto softer = [&](std::size_t a, std::size_t b) { return cost_.stiffness[a] < cost_.stiffness[b]; };
    std::iter_swap(order_.begin(), std::min_element(order_.begin(), order_.begin() + used_, softer));
  }

  S own_cost(std::size_t m) const {
    const S own = options_.locality * distance_[m] + ridge_;
    return cost_.stiffness != nullptr ? own + cost_.stiffness[m] : own;
  }
  S pull(std::size_t m) const { return cost_.pull != nullptr ? cost_.pull[m] : S(0); }

  // With the sum held at 1, the first example in use is the base, w_base = 1 - sum of the others: only differences of
  // examples are left, and a single example needs no system at all.
  bool factorise() {
    const Eigen::Index first = hard() ? 1 : 0;
    const std::size_t base = order_[0];
    const auto k = static_cast<Eigen::Index>(base);
    const S shared = hard() ? own_cost(base) : options_.soft_affine * options_.soft_affine;
    const Vec3<S> origin = base_control();
    for (Eigen::Index col = 0; col < system_.cols(); ++col) {
      const std::size_t m = order_[static_cast<std::size_t>(col + first)];
      const auto a = static_cast<Eigen::Index>(m);
      for (Eigen::Index row = col; row < system_.rows(); ++row) {
        const auto b = static_cast<Eigen::Index>(order_[static_cast<std::size_t>(row + first)]);
        system_(row, col) = gram_(a, b) + shared;
        if (hard()) system_(row, col) += gram_(k, k) - gram_(a, k) - gram_(b, k);
      }
      system_(col, col) += own_cost(m);
      S target = projection_[a] + shared + pull(m);
      if (hard()) target += gram_(k, k) - gram_(a, k) - projection_[k] - pull(base);
      right_.row(col).template head<3>() = (controls_[m] - origin).transpose();
      right_(col, 3) = target;
    }
    if (system_.size() == 0) return true;
    return cholesky_in_place(system_);
  }

  void write_weights(S* free, Vec3<S>* response) const {
    std::fill(free, free + controls_.size(), S(0));
    std::fill(response, response + controls_.size(), Vec3<S>::Zero());
    const std::size_t first = hard() ? 1 : 0;
    if (hard()) free[order_[0]] = 1;
    for (Eigen::Index row = 0; row < right_.rows(); ++row) {
      const std::size_t m = order_[static_cast<std::size_t>(row) + first];
      free[m] = right_(row, 3);
      response[m] = right_.row(row).template head<3>().transpose();
      if (!hard()) continue;
      free[order_[0]] -= free[m];
      response[order_[0]] -= response[m];
    }
  }

  WeightOptions<S> options_;
  Span<const S> features_;        // N x D
  Span<const Vec3<S>> controls_;  // N
  Matrix gram_;                   // N x N, J'J
  S ridge_ = 0;
  WeightCost<S> cost_;
  Eigen::Index used_ = 0;                           // examples in use per frame
  Eigen::Matrix<S, Eigen::Dynamic, 1> projection_;  // N, J'j
  std::vector<S> distance_;                         // N, squared
  std::vector<std::size_t> order_;                  // N, those in use first
  Matrix system_;                                   // its lower triangle; becomes the Cholesky factor
  Eigen::Matrix<S, Eigen::Dynamic, 4> right_;
};

}  // namespace rigless
