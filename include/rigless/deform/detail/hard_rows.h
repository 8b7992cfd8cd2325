// The global system with hard rows: the Laplacian, in which held vertices are settled.
#pragma once

#include "rigless/deform/detail/discs.h"
#include "rigless/math/detail/bytes.h"
#include "rigless/math/detail/supernodal_ldlt.h"

namespace rigless::detail {

// A held vertex keeps a unit diagonal and no coupling, so that the pattern, and with it the elimination order, never
// changes; when other vertices are held, only what lies above them is factored again. Source: thesis Eq 2.8, 3.16.
template <class S>
class HardRows {
 public:
  // Orders and analyses. Nothing is held and nothing factored yet. Allocates.
  void bind(const Cells<S>& cells) {
    ldlt_ = {};
    ldlt_.analyze(cells.ring.first, cells.ring.neighbor);
    diagonal_.assign(cells.size(), S(0));
    coupling_.assign(to_size(cells.ring.edges()), S(0));
    factored_ = false;
  }

  // Holds the vertices of `to` where those of `from` were held. On failure `from` is held again.
  // Errors: factorization_failed.
  Status hold(const Cells<S>& cells, const Discs<S>& from, const Discs<S>& to) {
    refill(cells, from, to);
    const Status status =
        factored_ ? ldlt_.refactorize(diagonal_, coupling_, changed_) : ldlt_.factorize(diagonal_, coupling_);
    if (status.ok()) {
      factored_ = true;
    } else if (factored_) {
      refill(cells, to, from);
      factored_ = ldlt_.factorize(diagonal_, coupling_).ok();
    }
    return status;
  }

  // In place, n rows in elimination order; a held row must be 0 and stays so. No allocation.
  void solve(simd::Quad<S>* rows) const { ldlt_.solve(rows); }

  const std::vector<std::int32_t>& place() const { return ldlt_.place(); }
  const std::vector<std::int32_t>& vertex_at() const { return ldlt_.vertex_at(); }

  std::int64_t bytes() const { return ldlt_.bytes() + bytes_of(diagonal_, coupling_, changed_); }

 private:
  // Rewrites the rows of vertices that became held or free, and of their neighbours.
  void refill(const Cells<S>& cells, const Discs<S>& from, const Discs<S>& to) {
    changed_.clear();
    for (std::size_t v = 0; v < cells.size(); ++v) {
      if (!factored_) fill(cells, v, to);
      if (from.holds(v) != to.holds(v)) changed_.push_back(static_cast<std::int32_t>(v));
    }
    if (!factored_) return;
    for (const std::int32_t v : changed_) {
      fill(cells, to_size(v), to);
      for_each_edge(cells, to_size(v), [&](S, const Vec3<S>&, std::size_t j) { fill(cells, j, to); });
    }
  }

  void fill(const Cells<S>& cells, std::size_t i, const Discs<S>& discs) {
    S diagonal = S(0);
    for (auto k = to_size(cells.ring.first[i]); k < to_size(cells.ring.first[i + 1]); ++k) {
      diagonal += cells.weight[k];
      const bool coupled = !discs.holds(i) && !discs.holds(to_size(cells.ring.neighbor[k]));
      coupling_[k] = coupled ? -cells.weight[k] : S(0);
    }
    diagonal_[i] = discs.holds(i) ? S(1) : diagonal;
  }

  SupernodalLdlt<S> ldlt_;
  std::vector<S> diagonal_;            // V
  std::vector<S> coupling_;            // directed edges
  std::vector<std::int32_t> changed_;  // vertices that became held or free
  bool factored_ = false;
};

}  // namespace rigless::detail
