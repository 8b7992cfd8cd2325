// Vectors of a few numbers, by the compilers' own vector extensions: the only place that knows their width.
// An arithmetic operator acts on all lanes; a comparison gives lanes of all ones or zero.
#pragma once

#if !defined(__GNUC__) && !defined(__clang__)
#error "Rigless needs the vector extensions of GCC and Clang: compile it by g++, clang++ (clang-cl on Windows) or em++."
#endif

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace rigless::detail::simd {

template <class S, int N>
struct VectorOf {
  typedef S type __attribute__((vector_size(N * sizeof(S))));
};

// Width-N vector of S. Aligned to its size.
template <class S, int N>
using Vector = typename VectorOf<S, N>::type;

// x, y, z and padding of one vertex or right-hand side.
template <class S>
using Quad = Vector<S, 4>;

// Where a row of quads lies, in bytes from the first row: reached by one instruction less than by its number.
using RowOffset = std::uint32_t;

template <class S>
inline RowOffset row_offset(std::int32_t row) {
  return static_cast<RowOffset>(static_cast<std::size_t>(row) * sizeof(Quad<S>));
}

template <class S>
inline Quad<S>& row_at(Quad<S>* rows, RowOffset offset) {
  return *reinterpret_cast<Quad<S>*>(reinterpret_cast<char*>(rows) + offset);
}

template <class S>
inline const Quad<S>& row_at(const Quad<S>* rows, RowOffset offset) {
  return *reinterpret_cast<const Quad<S>*>(reinterpret_cast<const char*>(rows) + offset);
}

// Lanes for work on many cells at once: what one register holds. Wider vectors on plain SSE2 cost 1.7x.
#if defined(__AVX__)
template <class S>
inline constexpr int width = 32 / sizeof(S);
#else
template <class S>
inline constexpr int width = sizeof(S) == 4 ? 4 : 2;
#endif

template <class S>
using Lanes = Vector<S, width<S>>;

template <class V, class S>
inline V splat(S value) {
  return V{} + value;
}

// 1 / sqrt(v) of each lane, finite for 0; v >= 0. Compilers take std::sqrt lane by lane, since it may set errno.
// One step is right to 2e-3, two to 5e-6; by default all that S can show.
// Source: a guess from the exponent, after Lomont 2003, then Newton.
template <class S, int N, int steps = sizeof(S) == 4 ? 3 : 4>
inline Vector<S, N> inverse_root(Vector<S, N> v) {
  using Bits = std::conditional_t<sizeof(S) == 4, std::int32_t, std::int64_t>;
  Vector<Bits, N> bits;
  std::memcpy(&bits, &v, sizeof(v));
  bits = static_cast<Bits>(sizeof(S) == 4 ? 0x5f375a86 : 0x5fe6eb50c7b537a9) - (bits >> 1);
  Vector<S, N> r;
  std::memcpy(&r, &bits, sizeof(v));
  const Vector<S, N> half = S(-0.5) * v;
  for (int it = 0; it < steps; ++it) r *= S(1.5) + half * r * r;
  return r;
}

// Lane by lane: mask ? a : b. The mask comes from a comparison of vectors of the same shape.
template <class V, class M>
inline V select(M mask, V a, V b) {
  return mask ? a : b;
}

// Whether a comparison holds in any lane.
template <class M>
inline bool any(M mask) {
  std::uint64_t words[sizeof(M) / 8], all = 0;
  std::memcpy(words, &mask, sizeof(M));
  for (const std::uint64_t w : words) all |= w;
  return all != 0;
}

// Rows of N quads, picked by their offsets, as three vectors of N x, y and z.
template <class S, int N>
inline void gather(const Quad<S>* rows, const RowOffset* at, Vector<S, N>& x, Vector<S, N>& y, Vector<S, N>& z) {
  if constexpr (N == 2) {
    const Quad<S> a = row_at<S>(rows, at[0]), b = row_at<S>(rows, at[1]);
    x = Vector<S, N>{a[0], b[0]};
    y = Vector<S, N>{a[1], b[1]};
    z = Vector<S, N>{a[2], b[2]};
  } else if constexpr (N == 4) {
    const Quad<S> a = row_at<S>(rows, at[0]), b = row_at<S>(rows, at[1]), c = row_at<S>(rows, at[2]),
                  d = row_at<S>(rows, at[3]);
    const Quad<S> ab_xy = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd_xy = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const Quad<S> ab_z = __builtin_shufflevector(a, b, 2, 6, 3, 7), cd_z = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    x = __builtin_shufflevector(ab_xy, cd_xy, 0, 1, 4, 5);
    y = __builtin_shufflevector(ab_xy, cd_xy, 2, 3, 6, 7);
    z = __builtin_shufflevector(ab_z, cd_z, 0, 1, 4, 5);
  } else {
    static_assert(N == 8);
    const auto pair = [&](int k) {
      return __builtin_shufflevector(row_at<S>(rows, at[k]), row_at<S>(rows, at[k + 4]), 0, 1, 2, 3, 4, 5, 6, 7);
    };
    const Vector<S, 8> a = pair(0), b = pair(1), c = pair(2), d = pair(3);
    const Vector<S, 8> ab_xy = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    const Vector<S, 8> cd_xy = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
    const Vector<S, 8> ab_z = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Vector<S, 8> cd_z = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    x = __builtin_shufflevector(ab_xy, cd_xy, 0, 1, 8, 9, 4, 5, 12, 13);
    y = __builtin_shufflevector(ab_xy, cd_xy, 2, 3, 10, 11, 6, 7, 14, 15);
    z = __builtin_shufflevector(ab_z, cd_z, 0, 1, 8, 9, 4, 5, 12, 13);
  }
}

// Adds (x, y, z)[k] to the k-th row for each lane in turn, so that equal rows add up.
template <class S, int N>
inline void scatter_add(Quad<S>* rows, const RowOffset* at, Vector<S, N> x, Vector<S, N> y, Vector<S, N> z) {
  if constexpr (N == 4) {
    const Quad<S> zero = {};
    const Quad<S> xy_low = __builtin_shufflevector(x, y, 0, 4, 1, 5),
                  xy_high = __builtin_shufflevector(x, y, 2, 6, 3, 7);
    const Quad<S> z_low = __builtin_shufflevector(z, zero, 0, 4, 1, 5),
                  z_high = __builtin_shufflevector(z, zero, 2, 6, 3, 7);
    row_at<S>(rows, at[0]) += __builtin_shufflevector(xy_low, z_low, 0, 1, 4, 5);
    row_at<S>(rows, at[1]) += __builtin_shufflevector(xy_low, z_low, 2, 3, 6, 7);
    row_at<S>(rows, at[2]) += __builtin_shufflevector(xy_high, z_high, 0, 1, 4, 5);
    row_at<S>(rows, at[3]) += __builtin_shufflevector(xy_high, z_high, 2, 3, 6, 7);
  } else if constexpr (N == 8) {
    const Vector<S, 8> zero = {};
    const Vector<S, 8> xy_low = __builtin_shufflevector(x, y, 0, 8, 1, 9, 4, 12, 5, 13),
                       xy_high = __builtin_shufflevector(x, y, 2, 10, 3, 11, 6, 14, 7, 15);
    const Vector<S, 8> z_low = __builtin_shufflevector(z, zero, 0, 8, 1, 9, 4, 12, 5, 13),
                       z_high = __builtin_shufflevector(z, zero, 2, 10, 3, 11, 6, 14, 7, 15);
    const auto pair = [&](int k, Vector<S, 8> both) {
      row_at<S>(rows, at[k]) += __builtin_shufflevector(both, both, 0, 1, 2, 3);
      row_at<S>(rows, at[k + 4]) += __builtin_shufflevector(both, both, 4, 5, 6, 7);
    };
    pair(0, __builtin_shufflevector(xy_low, z_low, 0, 1, 8, 9, 4, 5, 12, 13));
    pair(1, __builtin_shufflevector(xy_low, z_low, 2, 3, 10, 11, 6, 7, 14, 15));
    pair(2, __builtin_shufflevector(xy_high, z_high, 0, 1, 8, 9, 4, 5, 12, 13));
    pair(3, __builtin_shufflevector(xy_high, z_high, 2, 3, 10, 11, 6, 7, 14, 15));
  } else {
    for (int k = 0; k < N; ++k) row_at<S>(rows, at[k]) += Quad<S>{x[k], y[k], z[k], S(0)};
  }
}

}  // namespace rigless::detail::simd
