// The inner loops of a supernodal factorisation.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "rigless/math/detail/simd.h"
#include "rigless/math/detail/supernode_tree.h"

namespace rigless::detail {

// Rows of a factored supernode's blocks: `width` columns, from the begin-th row below its triangle on.
template <class S>
struct FactorRows {
  const S* values;
  const ColumnBlock* blocks;
  std::size_t width, begin;
};

// A multiple of what a vector holds.
template <class V, class S>
inline std::size_t padded(std::size_t count) {
  constexpr std::size_t lanes = sizeof(V) / sizeof(S);
  return (count + lanes - 1) / lanes * lanes;
}

// out = L D L^T for p rows against the first q of them, in tiles of four rows and one vector V of columns that stay in
// registers for the whole length of a row. `scaled` takes width x padded(q) numbers, `out` (p + 3) x padded(q), both
// padded for the widest vector.
template <class V, class S>
void outer_product(const FactorRows<S>& L, std::size_t p, std::size_t q, S* scaled, S* out) {
  constexpr std::size_t lanes = sizeof(V) / sizeof(S), tile = 4;
  const std::size_t stride = padded<simd::Lanes<S>, S>(q), columns = padded<V, S>(q);
  // f(block's columns, their first, the rows) for each block
  const auto for_each_block = [&](const auto& f) {
    for (std::size_t k0 = 0; k0 < L.width; k0 += ColumnBlock::widest) {
      const ColumnBlock& block = L.blocks[k0 / ColumnBlock::widest];
      const auto n = static_cast<std::size_t>(block.width);
      const S* square = L.values + block.values;
      f(n, k0, square, square + n * (L.width - k0 + L.begin));
    }
  };
  for_each_block([&](std::size_t n, std::size_t k0, const S* square, const S* rows) {
    for (std::size_t k = 0; k < n; ++k) {
      const S d = S(1) / square[k * n + k];
      S* to = scaled + (k0 + k) * stride;
      for (std::size_t c = 0; c < q; ++c) to[c] = d * rows[c * n + k];
      std::fill(to + q, to + columns, S(0));
    }
  });
  for (std::size_t r = 0; r < p; r += tile) {
    const std::size_t last = std::min(tile, p - r) - 1;
    for (std::size_t c = 0; c < columns; c += lanes) {
      V sum[tile] = {};
      for_each_block([&](std::size_t n, std::size_t k0, const S*, const S* rows) {
        const S* row[tile];  // beyond the last row the last one again
        for (std::size_t i = 0; i < tile; ++i) row[i] = rows + (r + std::min(i, last)) * n;
        for (std::size_t k = 0; k < n; ++k) {
          V b;
          std::memcpy(&b, scaled + (k0 + k) * stride + c, sizeof b);
          for (std::size_t i = 0; i < tile; ++i) sum[i] += row[i][k] * b;
        }
      });
      for (std::size_t i = 0; i < tile; ++i) std::memcpy(out + (r + i) * stride + c, &sum[i], sizeof sum[i]);
    }
  }
}

// Takes a row of w numbers through a factored triangle: L^T above the diagonal of `square`, 1 / D on it. Four columns
// at a time, so that the rest of the row is read and written once for all of them.
template <class S>
void eliminate_row(const S* square, std::size_t w, S* row) {
  constexpr std::size_t group = 4;
  for (std::size_t j = 0; j < w; j += group) {
    const std::size_t end = std::min(j + group, w);
    S t[group] = {};
    for (std::size_t i = j; i < end; ++i) {
      t[i - j] = row[i];
      for (std::size_t k = i + 1; k < end; ++k) row[k] -= t[i - j] * square[i * w + k];
      row[i] = t[i - j] * square[i * w + i];
    }
    if (end == w) return;
    const S *a = square + j * w, *b = a + w, *c = b + w, *d = c + w;
    for (std::size_t k = end; k < w; ++k) row[k] -= t[0] * a[k] + t[1] * b[k] + (t[2] * c[k] + t[3] * d[k]);
  }
}

}  // namespace rigless::detail
