// The inner loops of a supernodal solve, for three right-hand sides (and padding) at once.
#pragma once

#include <cstddef>
#include <type_traits>

#include "rigless/math/detail/simd.h"

namespace rigless::detail {

// Calls f with w as a compile-time constant, 1 <= w <= Most, so that its loops unroll and its sums stay in registers.
template <std::size_t Most, class F>
inline void with_width(std::size_t w, const F& f) {
  if constexpr (Most > 1) {
    if (w < Most) return with_width<Most - 1>(w, f);
  }
  f(std::integral_constant<std::size_t, Most>{});
}

// Solves with the triangle of a block of N columns, whose diagonal holds 1 / D, takes what follows off the rows below,
// and leaves y divided by D.
template <class S, std::size_t N>
inline void forward_block(const S* L, std::size_t m, const simd::RowOffset* rows, simd::Quad<S>* y, simd::Quad<S>* x) {
  simd::Quad<S> held[N];
  for (std::size_t i = 0; i < N; ++i) {
    held[i] = y[i];
    for (std::size_t k = 0; k < i; ++k) held[i] -= L[i * N + k] * held[k];
    y[i] = L[i * N + i] * held[i];
  }
  L += N * N;
  for (std::size_t r = 0; r < m; ++r, L += N) {
    simd::Quad<S>& row = simd::row_at<S>(x, rows[r]);
    simd::Quad<S> acc = row;
    for (std::size_t k = 0; k < N; ++k) acc -= L[k] * held[k];
    row = acc;
  }
}

// Back-substitution of the same block. Starts with the farthest row: the nearest ones have only just been computed.
template <class S, std::size_t N>
inline void backward_block(const S* L, std::size_t m, const simd::RowOffset* rows, simd::Quad<S>* y,
                           const simd::Quad<S>* x) {
  simd::Quad<S> acc[N];
  for (std::size_t k = 0; k < N; ++k) acc[k] = y[k];
  const S* row = L + (N + m) * N;
  for (std::size_t r = m; r-- > 0;) {
    row -= N;
    const simd::Quad<S> known = simd::row_at<S>(x, rows[r]);
    for (std::size_t k = 0; k < N; ++k) acc[k] -= row[k] * known;
  }
  for (std::size_t i = N; i-- > 0;) {
    for (std::size_t j = 0; j < i; ++j) acc[j] -= L[i * N + j] * acc[i];
    y[i] = acc[i];
  }
}

}  // namespace rigless::detail
