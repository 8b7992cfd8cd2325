// The Laplacian of a mesh as a matrix, and the two ways to read L V' = delta: as many equations as unknowns, or least
// squares over all rows.
#pragma once

#include <cmath>

#include "rigless/math/detail/sparse_ldlt.h"
#include "rigless/mesh/detail/laplacian.h"

namespace rigless {

template <class S>
using SparseMatrix = typename detail::SparseLdlt<S>::Matrix;

// L, V x V: (L V)_i = sum_j w_ij (v_i - v_j). `weight` per directed edge of the ring, > 0. Allocates.
// Source: thesis Eq 2.1-2.2; weights 1 / |N(i)| give Eq 2.3.
template <class S>
SparseMatrix<S> laplacian_matrix(const OneRing& ring, Span<const S> weight) {
  std::vector<Eigen::Triplet<S, std::int32_t>> entries;
  entries.reserve(weight.size() + to_size(ring.vertices()));
  for (std::int32_t i = 0; i < ring.vertices(); ++i) {
    S sum = S(0);
    for (std::int32_t k = nth(ring.first, i); k < ring.first[to_size(i) + 1]; ++k) {
      const S w = nth(weight, k);
      entries.emplace_back(i, nth(ring.neighbor, k), -w);
      sum += w;
    }
    entries.emplace_back(i, i, sum);
  }
  SparseMatrix<S> L(ring.vertices(), ring.vertices());
  L.setFromTriplets(entries.begin(), entries.end());
  return L;
}

// Factors d_i > 0 with d_i w_ij = d_j w_ji: all 1 for symmetric weights, |N(i)| up to a common factor for 1 / |N(i)|.
// Weights for which there are none break the contract. Allocates.
template <class S>
std::vector<S> symmetrizing_factors(const OneRing& ring, Span<const S> weight) {
  std::vector<S> d(to_size(ring.vertices()), S(0));
  std::vector<std::int32_t> stack;
  for (std::int32_t seed = 0; seed < ring.vertices(); ++seed) {
    if (nth(d, seed) > S(0)) continue;
    nth(d, seed) = S(1);
    stack.push_back(seed);
    while (!stack.empty()) {
      const std::int32_t i = stack.back();
      const auto at = to_size(i);
      stack.pop_back();
      for (auto k = to_size(ring.first[at]); k < to_size(ring.first[at + 1]); ++k) {
        const std::int32_t j = ring.neighbor[k];
        S& other = nth(d, j);
        const S factor = d[at] * weight[k] / nth(weight, ring.slot(j, i));
        if (other > S(0)) {
          RIGLESS_ASSERT(std::abs(other - factor) <= S(1e-3) * factor);
          continue;
        }
        other = factor;
        stack.push_back(j);
      }
    }
  }
  return d;
}

// M V' = P delta with P diagonal and M = P L symmetric: every row of L is met as it stands.
template <class S>
class SquareEquations {
 public:
  // Gives M. Allocates.
  SparseMatrix<S> bind(const OneRing& ring, Span<const S> weight) {
    factor_ = symmetrizing_factors<S>(ring, weight);
    SparseMatrix<S> M = laplacian_matrix<S>(ring, weight);
    for (std::int32_t column = 0; column < M.cols(); ++column) {
      for (typename SparseMatrix<S>::InnerIterator it(M, column); it; ++it) {
        it.valueRef() *= nth(factor_, it.row());
      }
    }
    return M;
  }

  // P delta. No allocation.
  void right_side(Span<const Vec3<S>> delta, Span<detail::Rhs4<S>> out) const {
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] << factor_[i] * delta[i].array(), S(0);
    }
  }

  // P_ii: what row i was multiplied by.
  S row_factor(std::size_t i) const { return factor_[i]; }

 private:
  std::vector<S> factor_;  // V
};

// The normal equations of all V rows: P = L^T, M = L^T L. Source: thesis Eq 3.13.
template <class S>
class LeastSquaresEquations {
 public:
  // Gives M. Allocates.
  SparseMatrix<S> bind(const OneRing& ring, Span<const S> weight) {
    L_ = laplacian_matrix<S>(ring, weight);
    return SparseMatrix<S>(L_.transpose()) * L_;
  }

  // P delta. No allocation.
  void right_side(Span<const Vec3<S>> delta, Span<detail::Rhs4<S>> out) const {
    for (std::int32_t column = 0; column < L_.cols(); ++column) {
      Vec3<S> sum = Vec3<S>::Zero();
      for (typename SparseMatrix<S>::InnerIterator it(L_, column); it; ++it) {
        sum += it.value() * nth(delta, it.row());
      }
      nth(out, column) << sum.array(), S(0);
    }
  }

  // Rows that are added to the system are squared already.
  S row_factor(std::size_t) const { return S(1); }

 private:
  SparseMatrix<S> L_;
};

}  // namespace rigless
