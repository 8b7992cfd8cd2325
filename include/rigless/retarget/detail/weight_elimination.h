// The per-frame half of the spacetime system: the weights of one frame, eliminated.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "rigless/math/detail/dense_solve.h"
#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/example.h"

namespace rigless::detail {

// A further cost 1/2 stiffness w^2 - pull w of every weight of a frame (N of each), or none.
template <class S>
struct WeightCost {
  const S* stiffness = nullptr;
  const S* pull = nullptr;
};

// For the features j of one frame, the weights minimise
//   1/2 |J w - j|^2 + 1/2 sum_m w_m^2 (mu |j - j_m|^2 + sharing min_k |j - j_k|^2 + tikhonov) + u.(C w),  sum w = 1 (or
//   its soft row)
// when u pulls at the control: w = free - response u, so the control is C w = position - compliance u.
template <class S>
class WeightElimination {
 public:
  // The examples of one track: N x D features and N control positions, which must outlive this object's use.
  // Allocates.
  void bind(Span<const S> features, Span<const Vec3<S>> controls, const WeightOptions<S>& options) {
    RIGLESS_ASSERT(!controls.empty() && features.size() % controls.size() == 0);
    options_ = options;
    features_ = features;
    controls_ = controls;
    const std::size_t count = controls.size(), size = features.size() / count;
    dimension_ = size;
    gram_.resize(count * count);
    S trace = 0;
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = 0; b <= a; ++b)
        gram_[a * count + b] = gram_[b * count + a] = dot(&features[a * size], &features[b * size]);
      trace += gram_[a * count + a];
    }
    ridge_ = std::max(options.tikhonov,
                      S(8) * std::numeric_limits<S>::epsilon() * std::max(trace / static_cast<S>(count), S(1e-3)));
    projection_.resize(count);
    distance_.resize(count);
    order_.resize(count);
    used_ = options.nearest > 0 ? std::min(count, static_cast<std::size_t>(options.nearest)) : count;
    unknowns_ = hard() ? used_ - 1 : used_;
    system_.resize(unknowns_ * unknowns_);
    right_.resize(unknowns_ * 4);
  }

  // Eliminates the frame with features j (D). free: N weights; response: N x 3; or both null. No allocation.
  // Returns false when the weights are not determined.
  bool eliminate(const S* j, const WeightCost<S>& cost, Vec3<S>& position, Mat3<S>& compliance, S* free,
                 Vec3<S>* response) {
    cost_ = cost;
    measure(j);
    choose_base();
    set_up();
    const auto n = static_cast<std::int32_t>(unknowns_);
    if (!columns::cholesky(system_.data(), n)) return false;
    // right_ holds [C' b] and becomes L^-1 [C' b], whose products are symmetric to the last bit.
    columns::lower(system_.data(), n, right_.data(), 4);
    for (int a = 0; a < 3; ++a) {
      position[a] = (hard() ? controls_[order_[0]][a] : S(0)) + product(a, 3);
      for (int b = 0; b <= a; ++b) compliance(a, b) = compliance(b, a) = product(a, b);
    }
    if (free == nullptr) return true;
    columns::lower_transposed(system_.data(), n, right_.data(), 4);
    write_weights(free, response);
    return true;
  }

 private:
  bool hard() const { return options_.soft_affine == S(0); }

  S dot(const S* a, const S* b) const {
    S sum = 0;
    for (std::size_t d = 0; d < dimension_; ++d) sum += a[d] * b[d];
    return sum;
  }

  // Of two columns of the right side.
  S product(int a, int b) const {
    const S* const x = right_.data() + static_cast<std::size_t>(a) * unknowns_;
    const S* const y = right_.data() + static_cast<std::size_t>(b) * unknowns_;
    S sum = 0;
    for (std::size_t i = 0; i < unknowns_; ++i) sum += x[i] * y[i];
    return sum;
  }

  // Distances from j to the examples, J'j, and the examples in use: all by index, or the nearest, nearest first.
  void measure(const S* j) {
    const std::size_t count = controls_.size();
    for (std::size_t m = 0; m < count; ++m) {
      const S* const example = features_.data() + m * dimension_;
      S sum = 0, along = 0;
      for (std::size_t d = 0; d < dimension_; ++d) {
        const S away = example[d] - j[d];
        along += example[d] * j[d];
        sum += away * away;
      }
      projection_[m] = along;
      distance_[m] = sum;
      order_[m] = m;
      shared_ = m == 0 ? sum : std::min(shared_, sum);
    }
    shared_ *= options_.sharing;
    if (used_ == count) return;
    for (std::size_t k = 0; k < used_; ++k) {
      std::size_t best = k;
      for (std::size_t m = k + 1; m < count; ++m) {
        const std::size_t a = order_[m], b = order_[best];
        if (distance_[a] < distance_[b] || (distance_[a] == distance_[b] && a < b)) best = m;
      }
      std::swap(order_[k], order_[best]);
    }
  }

  // Everything passes through the base, so it must not be the stiffest.
  void choose_base() {
    if (cost_.stiffness == nullptr) return;
    for (std::size_t k = 1; k < used_; ++k)
      if (cost_.stiffness[order_[k]] < cost_.stiffness[order_[0]]) std::swap(order_[k], order_[0]);
  }

  S own_cost(std::size_t m) const {
    const S own = options_.locality * distance_[m] + shared_ + ridge_;
    return cost_.stiffness != nullptr ? own + cost_.stiffness[m] : own;
  }
  S pull(std::size_t m) const { return cost_.pull != nullptr ? cost_.pull[m] : S(0); }

  // With the sum held at 1, the first example in use is the base, w_base = 1 - sum of the others: only differences of
  // examples are left, and a single example needs no system at all.
  void set_up() {
    const std::size_t count = controls_.size(), first = hard() ? 1 : 0, base = order_[0];
    const S* const base_gram = &gram_[base * count];
    const S shared = hard() ? own_cost(base) : options_.soft_affine * options_.soft_affine;
    for (std::size_t col = 0; col < unknowns_; ++col) {
      const std::size_t a = order_[col + first];
      S* const column = system_.data() + col * unknowns_;
      for (std::size_t row = col; row < unknowns_; ++row) {
        const std::size_t b = order_[row + first];
        column[row] = gram_[a * count + b] + shared;
        if (hard()) column[row] += base_gram[base] - base_gram[a] - base_gram[b];
      }
      column[col] += own_cost(a);
      S target = projection_[a] + shared + pull(a);
      if (hard()) target += base_gram[base] - base_gram[a] - projection_[base] - pull(base);
      for (int axis = 0; axis < 3; ++axis)
        right_[static_cast<std::size_t>(axis) * unknowns_ + col] =
            controls_[a][axis] - (hard() ? controls_[base][axis] : S(0));
      right_[3 * unknowns_ + col] = target;
    }
  }

  void write_weights(S* free, Vec3<S>* response) const {
    const std::size_t first = hard() ? 1 : 0, base = order_[0];
    for (std::size_t m = 0; m < controls_.size(); ++m) {
      free[m] = 0;
      response[m] = Vec3<S>::Zero();
    }
    if (hard()) free[base] = 1;
    for (std::size_t row = 0; row < unknowns_; ++row) {
      const std::size_t m = order_[row + first];
      free[m] = right_[3 * unknowns_ + row];
      if (hard()) free[base] -= free[m];
      for (int axis = 0; axis < 3; ++axis) {
        response[m][axis] = right_[static_cast<std::size_t>(axis) * unknowns_ + row];
        if (hard()) response[base][axis] -= response[m][axis];
      }
    }
  }

  WeightOptions<S> options_;
  Span<const S> features_;        // N x D
  Span<const Vec3<S>> controls_;  // N
  std::size_t dimension_ = 0;     // D
  std::vector<S> gram_;           // N x N, J'J
  S ridge_ = 0, shared_ = 0;
  WeightCost<S> cost_;
  std::size_t used_ = 0, unknowns_ = 0;  // examples in use per frame; weights that are open
  std::vector<S> projection_;            // N, J'j
  std::vector<S> distance_;              // N, squared
  std::vector<std::size_t> order_;       // N, those in use first
  std::vector<S> system_;                // its lower triangle; becomes the Cholesky factor
  std::vector<S> right_;                 // four columns
};

}  // namespace rigless::detail
