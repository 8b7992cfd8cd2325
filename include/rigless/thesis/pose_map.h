// The paper's first tries: a control from its joint, one frame at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "rigless/math/detail/dense_solve.h"
#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"

namespace rigless {

// The `count` examples nearest to j, nearest first, ties by index. Allocates.
template <class S>
std::vector<std::size_t> nearest_examples(Span<const Vec3<S>> joints, const Vec3<S>& j, std::size_t count) {
  std::vector<std::size_t> order(joints.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return (joints[a] - j).squaredNorm() < (joints[b] - j).squaredNorm();
  });
  order.resize(std::min(count, order.size()));
  return order;
}

// Weights whose mixture of the N joints is nearest to j, the smallest such: w = J'(JJ')^-1 j. Allocates. Source: thesis
// Eq 3.17.
template <class S>
std::vector<S> linear_weights(Span<const Vec3<S>> joints, const Vec3<S>& j) {
  Mat3<S> gram = Mat3<S>::Zero();
  for (const Vec3<S>& p : joints) gram += p * p.transpose();
  gram.diagonal().array() += S(1e-12) * gram.trace() + std::numeric_limits<S>::min();
  Vec3<S> x = j;
  detail::cholesky_in_place(gram);
  detail::solve_lower(gram, x);
  detail::solve_lower_transposed(gram, x);
  std::vector<S> weights;
  for (const Vec3<S>& p : joints) weights.push_back(p.dot(x));
  return weights;
}

// Weights that sum to 1, each in [lower, upper], whose mixture of the N joints is nearest to j; of several such, nearly
// the smallest. An active set method: bounds are taken on one at a time and let go when they push the wrong way. Needs
// N lower <= 1 <= N upper. Allocates. Source: thesis Eq 3.19.
template <class S>
std::vector<S> affine_weights(Span<const Vec3<S>> joints, const Vec3<S>& j, S lower, S upper) {
  const std::size_t n = joints.size();
  RIGLESS_ASSERT(n > 0 && static_cast<S>(n) * lower <= S(1) && static_cast<S>(n) * upper >= S(1));
  const auto size = static_cast<Eigen::Index>(n);
  using Matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix hessian(size, size);
  S largest = 0;
  for (Eigen::Index a = 0; a < size; ++a)
    for (Eigen::Index b = 0; b < size; ++b) hessian(a, b) = (nth(joints, a) - j).dot(nth(joints, b) - j);
  largest = std::max(hessian.trace(), S(1));
  hessian.diagonal().array() += S(32) * std::numeric_limits<S>::epsilon() * largest;

  std::vector<S> w(n, S(1) / static_cast<S>(n));
  std::vector<int> bound(n, 0);  // -1: at the lower, 1: at the upper
  std::vector<std::int32_t> exchange(n + 1);
  for (std::size_t iteration = 0; iteration < 50 * (n + 1); ++iteration) {
    // The minimum with the bounds that are taken on: [H 1; 1' 0] over the free weights, identity rows for the others.
    Matrix system = Matrix::Zero(size + 1, size + 1);
    Eigen::Matrix<S, Eigen::Dynamic, 1> right = Eigen::Matrix<S, Eigen::Dynamic, 1>::Zero(size + 1);
    for (Eigen::Index a = 0; a < size; ++a) {
      const auto i = to_size(a);
      system(size, a) = 1;
      if (bound[i] != 0) {
        system(a, a) = 1;
        right[a] = w[i];
        continue;
      }
      system.row(a).head(size) = hessian.row(a);
      system(a, size) = 1;
    }
    right[size] = 1;
    if (std::all_of(bound.begin(), bound.end(), [](int side) { return side != 0; })) {
      system.row(size).setZero();  // the sum is what it is: only the multiplier is open
      system(size, size) = 1;
      right[size] = 0;
    }
    detail::lu_in_place(system, exchange.data());
    detail::solve_lu(system, exchange.data(), right);

    S step = 1;
    std::size_t first = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (bound[i] != 0) continue;
      const S move = right[static_cast<Eigen::Index>(i)] - w[i];
      const S room = move < S(0) ? (lower - w[i]) / move : move > S(0) ? (upper - w[i]) / move : S(2);
      if (room < step) {
        step = std::max(room, S(0));
        first = i;
      }
    }
    for (std::size_t i = 0; i < n; ++i)
      if (bound[i] == 0) w[i] += step * (right[static_cast<Eigen::Index>(i)] - w[i]);
    if (first < n) {
      bound[first] = right[static_cast<Eigen::Index>(first)] < w[first] ? -1 : 1;
      w[first] = bound[first] < 0 ? lower : upper;
      continue;
    }
    // A bound may go when the weight wants to leave it.
    S worst = S(64) * std::numeric_limits<S>::epsilon() * largest;
    for (std::size_t i = 0; i < n; ++i) {
      if (bound[i] == 0) continue;
      S slope = right[size];
      for (std::size_t m = 0; m < n; ++m)
        slope += hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(m)) * w[m];
      const S push = bound[i] < 0 ? -slope : slope;
      if (push <= worst) continue;
      worst = push;
      first = i;
    }
    if (first == n) break;
    bound[first] = 0;
  }
  return w;
}

// The mixture of controls that weights make. Source: thesis Eq 3.18.
template <class S>
Vec3<S> mixture(Span<const Vec3<S>> controls, const std::vector<S>& weights) {
  RIGLESS_ASSERT(controls.size() == weights.size());
  Vec3<S> sum = Vec3<S>::Zero();
  for (std::size_t m = 0; m < weights.size(); ++m) sum += weights[m] * controls[m];
  return sum;
}

}  // namespace rigless
