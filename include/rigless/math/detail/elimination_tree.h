// In which order the columns of a sparse symmetric matrix are eliminated, and what that fills in. Source: Davis,
// "Direct Methods for Sparse Linear Systems", 2006, ch. 4 and 7.
#pragma once

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"

namespace rigless::detail {

struct Columns {
  std::vector<std::int32_t> parent;  // elimination tree
  std::vector<std::int64_t> begin;   // n + 1, into row
  std::vector<std::int32_t> row;     // below the diagonal, ascending
};

RIGLESS_COLD inline std::vector<std::int32_t> minimum_degree_order(Span<const std::int32_t> first,
                                                                   Span<const std::int32_t> neighbor) {
  const auto n = count_of(first) - 1;
  using Pattern = Eigen::SparseMatrix<float, Eigen::ColMajor, std::int32_t>;
  Pattern A(n, n);  // lower triangle; a column without a diagonal entry would be ordered last as if it were dense
  A.reserve(static_cast<Eigen::Index>(neighbor.size() / 2) + n);
  for (std::int32_t i = 0; i < n; ++i) {
    A.startVec(i);
    A.insertBack(i, i) = 1.0f;
    for (auto k = to_size(nth(first, i)); k < to_size(first[to_size(i) + 1]); ++k) {
      if (neighbor[k] > i) A.insertBack(neighbor[k], i) = 1.0f;
    }
  }
  A.finalize();
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t> order;
  Eigen::AMDOrdering<std::int32_t>()(A.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().data(), order.indices().data() + n};
}

// Elimination tree of the graph in the order vertex_at (place by place). Source: Liu 1986.
inline std::vector<std::int32_t> elimination_tree(Span<const std::int32_t> first, Span<const std::int32_t> neighbor,
                                                  const std::vector<std::int32_t>& vertex_at,
                                                  const std::vector<std::int32_t>& place) {
  const std::size_t n = vertex_at.size();
  std::vector<std::int32_t> parent(n, -1), ancestor(n, -1);
  for (std::size_t i = 0; i < n; ++i) {
    const auto v = to_size(vertex_at[i]);
    for (auto k = to_size(first[v]); k < to_size(first[v + 1]); ++k) {
      std::int32_t j = nth(place, neighbor[k]);
      while (j >= 0 && j < static_cast<std::int32_t>(i)) {
        const std::int32_t next = nth(ancestor, j);
        nth(ancestor, j) = static_cast<std::int32_t>(i);
        if (next < 0) nth(parent, j) = static_cast<std::int32_t>(i);
        j = next;
      }
    }
  }
  return parent;
}

inline std::vector<std::int32_t> postorder(const std::vector<std::int32_t>& parent) {
  const std::size_t n = parent.size();
  std::vector<std::int32_t> child(n, -1), sibling(n, -1), order, stack;
  for (std::size_t i = n; i-- > 0;) {
    if (parent[i] < 0) continue;
    sibling[i] = nth(child, parent[i]);
    nth(child, parent[i]) = static_cast<std::int32_t>(i);
  }
  order.reserve(n);
  for (std::size_t root = 0; root < n; ++root) {
    if (parent[root] >= 0) continue;
    stack.push_back(static_cast<std::int32_t>(root));
    while (!stack.empty()) {
      const auto i = to_size(stack.back());
      if (child[i] >= 0) {
        stack.push_back(child[i]);
        child[i] = nth(sibling, child[i]);
      } else {
        order.push_back(static_cast<std::int32_t>(i));
        stack.pop_back();
      }
    }
  }
  return order;
}

// Row structure of every column: row i reaches the columns on the tree paths from its neighbours up to i.
RIGLESS_COLD inline Columns column_structure(Span<const std::int32_t> first, Span<const std::int32_t> neighbor,
                                             const std::vector<std::int32_t>& vertex_at,
                                             const std::vector<std::int32_t>& place) {
  const std::size_t n = place.size();
  Columns c;
  c.parent = elimination_tree(first, neighbor, vertex_at, place);
  c.begin.assign(n + 1, 0);
  std::vector<std::int32_t> mark(n, -1);
  std::vector<std::int64_t> next;
  for (int pass = 0; pass < 2; ++pass) {  // count, then fill
    std::fill(mark.begin(), mark.end(), -1);
    for (std::size_t i = 0; i < n; ++i) {
      const auto v = to_size(vertex_at[i]);
      mark[i] = static_cast<std::int32_t>(i);
      for (auto k = to_size(first[v]); k < to_size(first[v + 1]); ++k) {
        auto j = to_size(nth(place, neighbor[k]));
        if (j > i) continue;
        for (; mark[j] != static_cast<std::int32_t>(i); j = to_size(c.parent[j])) {
          mark[j] = static_cast<std::int32_t>(i);
          if (pass == 0) {
            c.begin[j + 1]++;
          } else {
            nth(c.row, next[j]++) = static_cast<std::int32_t>(i);
          }
        }
      }
    }
    if (pass == 0) {
      for (std::size_t j = 0; j < n; ++j) c.begin[j + 1] += c.begin[j];
      c.row.resize(to_size(c.begin[n]));
      next.assign(c.begin.begin(), c.begin.end() - 1);
    }
  }
  return c;
}

}  // namespace rigless::detail
