// The inner loops of a supernodal solve, for three right-hand sides (and padding) at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "rigless/math/simd.h"

namespace rigless {

namespace detail {

// Calls f with w as a compile-time constant, 1 <= w <= Most, so that its loops unroll and its sums stay in registers.
template <std::size_t Most, class F>
inline void with_width(std::size_t w, const F& f) {
  if constexpr (Most > 1) {
    if (w < Most) return with_width<Most - 1>(w, f);
  }
  f(std::integral_constant<std::size_t, Most>{});
}

// acc[k] -= sum over rows of L(row, k) y(row), for N columns at once.
template <class S, std::size_t N>
inline void back_columns(const S* L, std::size_t w, std::size_t m, const std::int32_t* rows, const simd::Quad<S>* x,
                         simd::Quad<S>* out) {
  simd::Quad<S> acc[N];
  for (std::size_t k = 0; k < N; ++k) acc[k] = out[k];
  for (std::size_t r = 0; r < m; ++r, L += w) {
    const simd::Quad<S> y = x[rows[r]];
    for (std::size_t k = 0; k < N; ++k) acc[k] -= L[k] * y;
  }
  for (std::size_t k = 0; k < N; ++k) out[k] = acc[k];
}

// x(row) -= sum_k L(row, k) y(k) over a supernode of N columns.
template <class S, std::size_t N>
inline void forward_rows(const S* L, std::size_t m, const std::int32_t* rows, const simd::Quad<S>* y,
                         simd::Quad<S>* x) {
  simd::Quad<S> held[N];
  for (std::size_t k = 0; k < N; ++k) held[k] = y[k];
  for (std::size_t r = 0; r < m; ++r, L += N) {
    simd::Quad<S> acc = x[rows[r]];
    for (std::size_t k = 0; k < N; ++k) acc -= L[k] * held[k];
    x[rows[r]] = acc;
  }
}

template <class S>
inline void forward_any(const S* L, std::size_t w, std::size_t m, const std::int32_t* rows, const simd::Quad<S>* y,
                        simd::Quad<S>* x) {
  std::size_t r = 0;
  for (; r + 2 <= m; r += 2) {
    const S *a = L + r * w, *b = a + w;
    simd::Quad<S> acc_a = x[rows[r]], acc_b = x[rows[r + 1]];
    for (std::size_t k = 0; k < w; ++k) {
      acc_a -= a[k] * y[k];
      acc_b -= b[k] * y[k];
    }
    x[rows[r]] = acc_a;
    x[rows[r + 1]] = acc_b;
  }
  for (; r < m; ++r) {
    simd::Quad<S> acc = x[rows[r]];
    for (std::size_t k = 0; k < w; ++k) acc -= L[r * w + k] * y[k];
    x[rows[r]] = acc;
  }
}

}  // namespace detail

}  // namespace rigless
