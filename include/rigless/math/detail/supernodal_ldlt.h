// LDL^T of a sparse symmetric positive definite matrix in dense pieces: neighbouring columns with the same rows form a
// supernode, so that a solve streams the factor once for x, y and z together, and a change of few rows re-does only the
// supernodes above them.
#pragma once

#include <vector>

#include "rigless/math/detail/bytes.h"
#include "rigless/math/detail/simd.h"
#include "rigless/math/detail/supernode_factor.h"
#include "rigless/math/detail/supernode_kernels.h"
#include "rigless/math/detail/supernode_tree.h"
#include "rigless/math/span.h"
#include "rigless/math/status.h"

namespace rigless::detail {

template <class S>
class SupernodalLdlt {
 public:
  using Quad = simd::Quad<S>;

  // Orders and analyses the pattern of a symmetric graph: neighbours of i are neighbor[first[i]] .. first[i + 1] - 1,
  // both directions listed, no diagonal. Allocates all that later calls need.
  RIGLESS_COLD void analyze(Span<const std::int32_t> first, Span<const std::int32_t> neighbor);

  // Factors A, with A_ii = diagonal[i] (n) and A_ij = coupling[slot of i -> j]; both in the graph's own numbering. On
  // failure the factor is unusable until the next success. No allocation.
  // Errors: factorization_failed (where: row); a common reason is a part of the mesh that no control holds.
  Status factorize(Span<const S> diagonal, Span<const S> coupling);

  // The same after only the rows and columns of `changed` vertices got new values: touches their ancestors alone.
  Status refactorize(Span<const S> diagonal, Span<const S> coupling, Span<const std::int32_t> changed);

  // Solves in place for n rows in elimination order. No allocation.
  void solve(Quad* x) const;

  // Elimination order: place[i] of vertex i, and vertex_at[place].
  const std::vector<std::int32_t>& place() const { return tree_.place; }
  const std::vector<std::int32_t>& vertex_at() const { return tree_.vertex_at; }

  std::int32_t rows() const { return static_cast<std::int32_t>(tree_.place.size()); }
  std::int64_t stored() const { return static_cast<std::int64_t>(values_.size()); }  // numbers, padding zeros included
  std::int64_t bytes() const;

 private:
  Status factor_supernode(std::int32_t s, Span<const S> diagonal, Span<const S> coupling);
  void assemble(std::int32_t s, Span<const S> diagonal, Span<const S> coupling);
  void subtract_descendants(std::int32_t s);
  std::int32_t eliminate(std::int32_t s);
  void store_blocks(std::int32_t s);

  SupernodeTree tree_;
  std::vector<std::int32_t> first_, neighbor_;  // the graph
  std::vector<simd::RowOffset> row_at_;         // of tree_.rows
  std::vector<S> values_;                       // block by block, row-major; 1 / D on the diagonal
  std::vector<S> panel_;                        // scratch: a supernode as w + m rows of w numbers
  std::vector<std::int32_t> local_row_;         // n: place -> row of the supernode at hand
  std::vector<S> scaled_;                       // scratch: D L^T of one segment
  std::vector<S> update_;                       // scratch: its product with the rows below
  std::vector<char> dirty_;                     // per supernode
};

template <class S>
void SupernodalLdlt<S>::analyze(Span<const std::int32_t> first, Span<const std::int32_t> neighbor) {
  first_.assign(first.begin(), first.end());
  neighbor_.assign(neighbor.begin(), neighbor.end());
  tree_ = build_supernode_tree(first, neighbor);
  values_.assign(static_cast<std::size_t>(tree_.values), S(0));
  row_at_.clear();
  row_at_.reserve(tree_.rows.size());
  for (const std::int32_t row : tree_.rows) row_at_.push_back(simd::row_offset<S>(row));
  local_row_.assign(tree_.place.size(), 0);
  dirty_.assign(tree_.nodes.size(), 0);
  std::size_t widest = 0, largest = 0, panel = 0;
  for (const Supernode& node : tree_.nodes) {
    panel =
        std::max(panel, static_cast<std::size_t>(node.width) * static_cast<std::size_t>(node.width + node.row_count));
  }
  panel_.assign(panel, S(0));
  for (const auto& link : tree_.links) {
    const Supernode& d = tree_.nodes[static_cast<std::size_t>(link.descendant)];
    const auto q = static_cast<std::size_t>(link.end - link.begin);
    const std::size_t stride = padded<simd::Lanes<S>, S>(q);
    widest = std::max(widest, stride * static_cast<std::size_t>(d.width));
    largest = std::max(largest, stride * (static_cast<std::size_t>(d.row_count - link.begin) + 3));
  }
  scaled_.assign(widest, S(0));
  update_.assign(largest, S(0));
}

template <class S>
Status SupernodalLdlt<S>::factorize(Span<const S> diagonal, Span<const S> coupling) {
  for (std::size_t s = 0; s < tree_.nodes.size(); ++s) {
    if (const Status st = factor_supernode(static_cast<std::int32_t>(s), diagonal, coupling); !st.ok()) return st;
  }
  return {};
}

template <class S>
Status SupernodalLdlt<S>::refactorize(Span<const S> diagonal, Span<const S> coupling,
                                      Span<const std::int32_t> changed) {
  std::fill(dirty_.begin(), dirty_.end(), 0);
  const auto mark = [&](std::int32_t vertex) {
    auto s = tree_.node_of[static_cast<std::size_t>(tree_.place[static_cast<std::size_t>(vertex)])];
    for (; s >= 0 && !dirty_[static_cast<std::size_t>(s)]; s = tree_.nodes[static_cast<std::size_t>(s)].parent) {
      dirty_[static_cast<std::size_t>(s)] = 1;
    }
  };
  for (const std::int32_t v : changed) {
    mark(v);
    for (std::int32_t k = first_[static_cast<std::size_t>(v)]; k < first_[static_cast<std::size_t>(v) + 1]; ++k) {
      mark(neighbor_[static_cast<std::size_t>(k)]);  // an entry is stored in the column that comes first
    }
  }
  for (std::size_t s = 0; s < tree_.nodes.size(); ++s) {
    if (!dirty_[s]) continue;
    if (const Status st = factor_supernode(static_cast<std::int32_t>(s), diagonal, coupling); !st.ok()) return st;
  }
  return {};
}

template <class S>
Status SupernodalLdlt<S>::factor_supernode(std::int32_t s, Span<const S> diagonal, Span<const S> coupling) {
  assemble(s, diagonal, coupling);
  subtract_descendants(s);
  const std::int32_t bad = eliminate(s);
  store_blocks(s);
  if (bad < 0) return {};
  const Supernode& node = tree_.nodes[static_cast<std::size_t>(s)];
  return {Error::factorization_failed, tree_.vertex_at[static_cast<std::size_t>(node.first + bad)]};
}

template <class S>
void SupernodalLdlt<S>::assemble(std::int32_t s, Span<const S> diagonal, Span<const S> coupling) {
  const Supernode& node = tree_.nodes[static_cast<std::size_t>(s)];
  const auto w = static_cast<std::size_t>(node.width);
  S* panel = panel_.data();
  std::fill(panel, panel + (w + static_cast<std::size_t>(node.row_count)) * w, S(0));
  for (std::int32_t k = 0; k < node.width; ++k) local_row_[static_cast<std::size_t>(node.first + k)] = k;
  for (std::int32_t r = 0; r < node.row_count; ++r) {
    local_row_[static_cast<std::size_t>(tree_.rows[static_cast<std::size_t>(node.rows + r)])] = node.width + r;
  }
  for (std::size_t k = 0; k < w; ++k) {
    const std::int32_t place = node.first + static_cast<std::int32_t>(k);
    const auto v = static_cast<std::size_t>(tree_.vertex_at[static_cast<std::size_t>(place)]);
    panel[k * w + k] = diagonal[v];
    for (auto slot = static_cast<std::size_t>(first_[v]); slot < static_cast<std::size_t>(first_[v + 1]); ++slot) {
      const std::int32_t other = tree_.place[static_cast<std::size_t>(neighbor_[slot])];
      if (other < place) continue;
      panel[static_cast<std::size_t>(local_row_[static_cast<std::size_t>(other)]) * w + k] = coupling[slot];
    }
  }
}

// Left-looking: every earlier supernode d with rows among the columns of s takes L_d D_d L_d^T off.
template <class S>
void SupernodalLdlt<S>::subtract_descendants(std::int32_t s) {
  const Supernode& node = tree_.nodes[static_cast<std::size_t>(s)];
  const auto w = static_cast<std::size_t>(node.width);
  for (std::int32_t l = node.links; l < node.links + node.link_count; ++l) {
    const SupernodeLink& link = tree_.links[static_cast<std::size_t>(l)];
    const Supernode& d = tree_.nodes[static_cast<std::size_t>(link.descendant)];
    const auto q = static_cast<std::size_t>(link.end - link.begin);
    const auto p = static_cast<std::size_t>(d.row_count - link.begin);
    const FactorRows<S> L = {values_.data(), &tree_.blocks[static_cast<std::size_t>(d.blocks)],
                             static_cast<std::size_t>(d.width), static_cast<std::size_t>(link.begin)};
    if (q <= 4) {
      outer_product<simd::Quad<S>>(L, p, q, scaled_.data(), update_.data());
    } else {
      outer_product<simd::Lanes<S>>(L, p, q, scaled_.data(), update_.data());
    }
    const std::size_t stride = padded<simd::Lanes<S>, S>(q);
    const std::int32_t* rows = tree_.rows.data() + d.rows + link.begin;
    for (std::size_t r = 0; r < p; ++r) {
      S* target = panel_.data() + static_cast<std::size_t>(local_row_[static_cast<std::size_t>(rows[r])]) * w;
      const S* update = update_.data() + r * stride;
      for (std::size_t c = 0; c < q && c <= r; ++c) target[rows[c] - node.first] -= update[c];
    }
  }
}

// Dense LDL^T of the square block, then the rows below it. Gives the first column without a positive pivot, or -1.
template <class S>
std::int32_t SupernodalLdlt<S>::eliminate(std::int32_t s) {
  const Supernode& node = tree_.nodes[static_cast<std::size_t>(s)];
  const auto w = static_cast<std::size_t>(node.width);
  const std::size_t total = w + static_cast<std::size_t>(node.row_count);
  S* panel = panel_.data();
  // the upper triangle of the square holds L^T while it lasts, so that inner loops run along rows
  for (std::size_t j = 0; j < w; ++j) {
    const S d = panel[j * w + j];
    if (!(d > S(0)) || !std::isfinite(d)) return static_cast<std::int32_t>(j);
    const S inverse = panel[j * w + j] = S(1) / d;
    S* transposed = panel + j * w;
    for (std::size_t k = j + 1; k < w; ++k) transposed[k] = panel[k * w + j] * inverse;
    for (std::size_t i = j + 1; i < w; ++i) {
      const S t = panel[i * w + j];
      for (std::size_t k = j + 1; k <= i; ++k) panel[i * w + k] -= t * transposed[k];
      panel[i * w + j] = t * inverse;
    }
  }
  for (std::size_t i = w; i < total; ++i) eliminate_row(panel, w, panel + i * w);
  return -1;
}

template <class S>
void SupernodalLdlt<S>::store_blocks(std::int32_t s) {
  const Supernode& node = tree_.nodes[static_cast<std::size_t>(s)];
  const auto w = static_cast<std::size_t>(node.width);
  const std::size_t total = w + static_cast<std::size_t>(node.row_count);
  for (std::size_t k = 0; k < w; k += ColumnBlock::widest) {
    const ColumnBlock& block = tree_.blocks[static_cast<std::size_t>(node.blocks) + k / ColumnBlock::widest];
    S* to = values_.data() + block.values;
    const auto n = static_cast<std::size_t>(block.width);
    for (std::size_t i = k; i < total; ++i, to += n) std::copy_n(panel_.data() + i * w + k, n, to);
  }
}

template <class S>
void SupernodalLdlt<S>::solve(Quad* x) const {
  const auto run = [&](const ColumnBlock& block, auto kernel) {
    with_width<ColumnBlock::widest>(static_cast<std::size_t>(block.width), [&](auto n) {
      kernel(n, values_.data() + block.values, static_cast<std::size_t>(block.row_count), row_at_.data() + block.rows,
             x + block.first);
    });
  };
  for (const ColumnBlock& block : tree_.blocks) {
    run(block, [x](auto n, const S* L, std::size_t m, const simd::RowOffset* rows, Quad* y) {
      forward_block<S, n>(L, m, rows, y, x);
    });
  }
  for (auto block = tree_.blocks.rbegin(); block != tree_.blocks.rend(); ++block) {
    run(*block, [x](auto n, const S* L, std::size_t m, const simd::RowOffset* rows, Quad* y) {
      backward_block<S, n>(L, m, rows, y, x);
    });
  }
}

template <class S>
std::int64_t SupernodalLdlt<S>::bytes() const {
  return bytes_of(first_, neighbor_, values_, panel_, row_at_, local_row_, scaled_, update_, dirty_, tree_.place,
                  tree_.vertex_at, tree_.node_of, tree_.nodes, tree_.blocks, tree_.rows, tree_.links);
}

}  // namespace rigless::detail
