// Small dense systems by plain loops: what is left of a frame once its structure is used. Eigen's decompositions bring
// its blocked kernels: 60 kB of wasm for matrices of a dozen rows.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include "rigless/math/types.h"

namespace rigless {

// Cholesky factor of a positive definite matrix in its own lower triangle. Returns false when it is not positive
// definite. No allocation.
template <class Matrix>
bool cholesky_in_place(Matrix& A) {
  using S = typename Matrix::Scalar;
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    for (Eigen::Index i = j; i < A.rows(); ++i) {
      S sum = A(i, j);
      for (Eigen::Index k = 0; k < j; ++k) sum -= A(i, k) * A(j, k);
      if (i > j) {
        A(i, j) = sum / A(j, j);
      } else if (sum > S(0)) {
        A(j, j) = std::sqrt(sum);
      } else {
        return false;
      }
    }
  }
  return true;
}

// Columns of B become L^-1 B, and L^-T B, with L the lower triangle of A. No allocation.
template <class Matrix, class Right>
void solve_lower(const Matrix& A, Right& B) {
  for (Eigen::Index c = 0; c < B.cols(); ++c) {
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
      typename Matrix::Scalar sum = B(i, c);
      for (Eigen::Index k = 0; k < i; ++k) sum -= A(i, k) * B(k, c);
      B(i, c) = sum / A(i, i);
    }
  }
}
template <class Matrix, class Right>
void solve_lower_transposed(const Matrix& A, Right& B) {
  for (Eigen::Index c = 0; c < B.cols(); ++c) {
    for (Eigen::Index i = A.rows(); i-- > 0;) {
      typename Matrix::Scalar sum = B(i, c);
      for (Eigen::Index k = i + 1; k < A.rows(); ++k) sum -= A(k, i) * B(k, c);
      B(i, c) = sum / A(i, i);
    }
  }
}

// C -= A B. No allocation.
template <class A, class B, class C>
void subtract_product(const A& a, const B& b, C& c) {
  for (Eigen::Index j = 0; j < c.cols(); ++j) {
    for (Eigen::Index i = 0; i < c.rows(); ++i) {
      for (Eigen::Index k = 0; k < a.cols(); ++k) c(i, j) -= a(i, k) * b(k, j);
    }
  }
}

// LU factors of a square matrix in its own place, rows exchanged; `exchange` takes one index per row. No allocation.
template <class Matrix>
void lu_in_place(Matrix& A, std::int32_t* exchange) {
  using std::abs;
  const Eigen::Index n = A.rows();
  for (Eigen::Index j = 0; j < n; ++j) {
    Eigen::Index pivot = j;
    for (Eigen::Index i = j + 1; i < n; ++i) {
      if (abs(A(i, j)) > abs(A(pivot, j))) pivot = i;
    }
    exchange[j] = static_cast<std::int32_t>(pivot);
    for (Eigen::Index k = 0; k < n && pivot != j; ++k) std::swap(A(j, k), A(pivot, k));
    for (Eigen::Index i = j + 1; i < n; ++i) {
      A(i, j) /= A(j, j);
      for (Eigen::Index k = j + 1; k < n; ++k) A(i, k) -= A(i, j) * A(j, k);
    }
  }
}

// Columns of B become A^-1 B, from the factors. No allocation.
template <class Matrix, class Right>
void solve_lu(const Matrix& factors, const std::int32_t* exchange, Right& B) {
  const Eigen::Index n = factors.rows();
  for (Eigen::Index c = 0; c < B.cols(); ++c) {
    for (Eigen::Index i = 0; i < n; ++i) std::swap(B(i, c), B(exchange[i], c));
    for (Eigen::Index i = 1; i < n; ++i) {
      for (Eigen::Index k = 0; k < i; ++k) B(i, c) -= factors(i, k) * B(k, c);
    }
    for (Eigen::Index i = n; i-- > 0;) {
      for (Eigen::Index k = i + 1; k < n; ++k) B(i, c) -= factors(i, k) * B(k, c);
      B(i, c) /= factors(i, i);
    }
  }
}

}  // namespace rigless
