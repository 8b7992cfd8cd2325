// Small dense systems by plain loops: what is left of a frame once its structure is used. Eigen's decompositions bring
// its blocked kernels (60 kB of wasm for matrices of a dozen rows), and its element access costs ten times the work
// where the compiler optimises for size. So each kernel runs over plain columns.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include "rigless/math/types.h"

namespace rigless::detail {

// Column-major arrays of n rows without gaps.
namespace columns {

template <class S>
bool cholesky(S* a, std::int32_t n) {
  for (std::int32_t j = 0; j < n; ++j) {
    S* const own = a + j * n;
    std::int32_t k = 0;
    for (; k + 4 <= j; k += 4) {  // four columns at once, one after the other for each row: no bit differs
      const S *const b0 = a + k * n, *const b1 = b0 + n, *const b2 = b1 + n, *const b3 = b2 + n;
      const S f0 = b0[j], f1 = b1[j], f2 = b2[j], f3 = b3[j];
      for (std::int32_t i = j; i < n; ++i) own[i] = own[i] - b0[i] * f0 - b1[i] * f1 - b2[i] * f2 - b3[i] * f3;
    }
    for (; k < j; ++k) {
      const S* const before = a + k * n;
      const S factor = before[j];
      for (std::int32_t i = j; i < n; ++i) own[i] -= before[i] * factor;
    }
    if (!(own[j] > S(0))) return false;
    const S root = std::sqrt(own[j]);
    for (std::int32_t i = j; i < n; ++i) own[i] /= root;
  }
  return true;
}

template <class S>
void lower(const S* a, std::int32_t n, S* b, std::int32_t count) {
  for (const S* const end = b + n * count; b != end; b += n) {
    for (std::int32_t k = 0; k < n; ++k) {
      const S* const column = a + k * n;
      const S x = b[k] /= column[k];
      for (std::int32_t i = k + 1; i < n; ++i) b[i] -= column[i] * x;
    }
  }
}

template <class S>
void lower_transposed(const S* a, std::int32_t n, S* b, std::int32_t count) {
  for (const S* const end = b + n * count; b != end; b += n) {
    for (std::int32_t i = n; i-- > 0;) {
      const S* const column = a + i * n;
      S sum = b[i];
      for (std::int32_t k = i + 1; k < n; ++k) sum -= column[k] * b[k];
      b[i] = sum / column[i];
    }
  }
}

template <class S>
void subtract(const S* a, std::int32_t n, std::int32_t inner, const S* b, S* c, std::int32_t count) {
  for (std::int32_t j = 0; j < count; ++j, b += inner, c += n) {
    for (std::int32_t k = 0; k < inner; ++k) {
      const S x = b[k];
      for (std::int32_t i = 0; i < n; ++i) c[i] -= a[k * n + i] * x;
    }
  }
}

template <class S>
void lu(S* a, std::int32_t n, std::int32_t* exchange) {
  for (std::int32_t j = 0; j < n; ++j) {
    S* const own = a + j * n;
    std::int32_t pivot = j;
    for (std::int32_t i = j + 1; i < n; ++i)
      if (std::abs(own[i]) > std::abs(own[pivot])) pivot = i;
    exchange[j] = pivot;
    for (std::int32_t k = 0; k < n && pivot != j; ++k) std::swap(a[k * n + j], a[k * n + pivot]);
    for (std::int32_t i = j + 1; i < n; ++i) own[i] /= own[j];
    for (std::int32_t k = j + 1; k < n; ++k) {
      S* const other = a + k * n;
      for (std::int32_t i = j + 1; i < n; ++i) other[i] -= own[i] * other[j];
    }
  }
}

template <class S>
void lu_solve(const S* a, std::int32_t n, const std::int32_t* exchange, S* b, std::int32_t count) {
  for (const S* const end = b + n * count; b != end; b += n) {
    for (std::int32_t i = 0; i < n; ++i) std::swap(b[i], b[exchange[i]]);
    for (std::int32_t k = 0; k < n; ++k)
      for (std::int32_t i = k + 1; i < n; ++i) b[i] -= a[k * n + i] * b[k];
    for (std::int32_t k = n; k-- > 0;) {
      b[k] /= a[k * n + k];
      for (std::int32_t i = 0; i < k; ++i) b[i] -= a[k * n + i] * b[k];
    }
  }
}

}  // namespace columns

// Cholesky factor of a positive definite matrix in its own lower triangle. Returns false when it is not positive
// definite. No allocation.
template <class Matrix>
bool cholesky_in_place(Matrix& A) {
  return columns::cholesky(A.data(), static_cast<std::int32_t>(A.rows()));
}

// Columns of B become L^-1 B, and L^-T B, with L the lower triangle of A. No allocation.
template <class Matrix, class Right>
void solve_lower(const Matrix& A, Right& B) {
  columns::lower(A.data(), static_cast<std::int32_t>(A.rows()), B.data(), static_cast<std::int32_t>(B.cols()));
}
template <class Matrix, class Right>
void solve_lower_transposed(const Matrix& A, Right& B) {
  columns::lower_transposed(A.data(), static_cast<std::int32_t>(A.rows()), B.data(),
                            static_cast<std::int32_t>(B.cols()));
}

// C -= A B. No allocation.
template <class A, class B, class C>
void subtract_product(const A& a, const B& b, C& c) {
  columns::subtract(a.data(), static_cast<std::int32_t>(a.rows()), static_cast<std::int32_t>(a.cols()), b.data(),
                    c.data(), static_cast<std::int32_t>(c.cols()));
}

// LU factors of a square matrix in its own place, rows exchanged; `exchange` takes one index per row. No allocation.
template <class Matrix>
void lu_in_place(Matrix& A, std::int32_t* exchange) {
  columns::lu(A.data(), static_cast<std::int32_t>(A.rows()), exchange);
}

// Columns of B become A^-1 B, from the factors. No allocation.
template <class Matrix, class Right>
void solve_lu(const Matrix& factors, const std::int32_t* exchange, Right& B) {
  columns::lu_solve(factors.data(), static_cast<std::int32_t>(factors.rows()), exchange, B.data(),
                    static_cast<std::int32_t>(B.cols()));
}

}  // namespace rigless::detail
