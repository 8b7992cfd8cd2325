// Direct solver for systems that couple each frame with two frames before and two after it: what second differences
// of a track leave behind.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/detail/dense_solve.h"
#include "rigless/math/detail/macros.h"

namespace rigless::detail {

// Row f of D2'D2, the Gram matrix of second differences over T frames without rows for the first and the last frame:
// the entries at f-2 .. f+2, zero outside the clip. No allocation. Source: thesis Eq 3.24-3.26.
template <class S>
std::array<S, 5> second_difference_row(std::int32_t frames, std::int32_t f) {
  constexpr std::array<int, 3> stencil = {1, -2, 1};
  std::array<S, 5> row{};
  for (std::int32_t centre = f - 1; centre <= f + 1; ++centre) {
    if (centre < 1 || centre > frames - 2) continue;
    const int own = stencil[static_cast<std::size_t>(f - centre + 1)];
    for (std::int32_t g = centre - 1; g <= centre + 1; ++g)
      row[static_cast<std::size_t>(g - f + 2)] +=
          static_cast<S>(own * stencil[static_cast<std::size_t>(g - centre + 1)]);
  }
  return row;
}

// Block LU of a block-pentadiagonal matrix of B x B blocks, built one block row at a time, so that it can be
// interrupted. Rows are exchanged inside a block, never across blocks: every leading part of the matrix must be
// regular, as it is for identity + (positive semidefinite block diagonal)(positive semidefinite band).
template <class S, int B>
class BandSolver {
 public:
  using Block = Eigen::Matrix<S, B, B>;
  using Vector = Eigen::Matrix<S, B, 1>;
  using Row = std::array<Block, 5>;  // at f-2 .. f+2; those outside the clip must be zero

  // Makes room for T block rows and forgets the old ones. Allocates.
  void bind(std::int32_t frames) {
    rows_.resize(static_cast<std::size_t>(frames));
    next_ = 0;
  }

  // Eliminates the next block row. No allocation.
  void append(const Row& row) {
    RIGLESS_ASSERT(next_ < rows_.size());
    Factor& now = rows_[next_];
    now.lower2 = row[0];
    now.lower1 = row[1];
    now.diagonal = row[2];
    now.upper1 = row[3];
    now.upper2 = row[4];
    if (next_ >= 2) {
      const Factor& before = rows_[next_ - 2];
      subtract_product(now.lower2, before.upper1, now.lower1);
      subtract_product(now.lower2, before.upper2, now.diagonal);
    }
    if (next_ >= 1) {
      const Factor& before = rows_[next_ - 1];
      subtract_product(now.lower1, before.upper1, now.diagonal);
      subtract_product(now.lower1, before.upper2, now.upper1);
    }
    lu_in_place(now.diagonal, now.exchange.data());
    solve_lu(now.diagonal, now.exchange.data(), now.upper1);
    solve_lu(now.diagonal, now.exchange.data(), now.upper2);
    ++next_;
  }

  // Replaces the right-hand side x (T blocks) by the solution, once all rows are there. No allocation.
  void solve_in_place(std::vector<Vector>& x) const {
    RIGLESS_ASSERT(next_ == rows_.size() && x.size() == rows_.size());
    const std::size_t frames = rows_.size();
    for (std::size_t f = 0; f < frames; ++f) {
      Vector r = x[f];
      if (f >= 1) subtract_product(rows_[f].lower1, x[f - 1], r);
      if (f >= 2) subtract_product(rows_[f].lower2, x[f - 2], r);
      solve_lu(rows_[f].diagonal, rows_[f].exchange.data(), r);
      x[f] = r;
    }
    for (std::size_t f = frames; f-- > 0;) {
      if (f + 1 < frames) subtract_product(rows_[f].upper1, x[f + 1], x[f]);
      if (f + 2 < frames) subtract_product(rows_[f].upper2, x[f + 2], x[f]);
    }
  }

 private:
  struct Factor {
    Block diagonal;                        // LU factors, eliminated
    std::array<std::int32_t, B> exchange;  // their rows
    Block lower1, lower2;                  // at f-1 (eliminated) and f-2
    Block upper1, upper2;                  // lu^-1 times those at f+1 and f+2
  };
  std::vector<Factor> rows_;
  std::size_t next_ = 0;
};

}  // namespace rigless::detail
