// In which order the columns of a sparse symmetric matrix are eliminated, and what that fills in. Source: Davis,
// "Direct Methods for Sparse Linear Systems", 2006, ch. 4 and 7.
#pragma once

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"

namespace rigless {

namespace detail {

struct Columns {
  std::vector<std::int32_t> parent;  // elimination tree
  std::vector<std::int64_t> begin;   // n + 1, into row
  std::vector<std::int32_t> row;     // below the diagonal, ascending
};

RIGLESS_COLD inline std::vector<std::int32_t> minimum_degree_order(Span<const std::int32_t> first,
                                                                   Span<const std::int32_t> neighbor) {
  const auto n = static_cast<std::int32_t>(first.size()) - 1;
  using Pattern = Eigen::SparseMatrix<float, Eigen::ColMajor, std::int32_t>;
  Pattern A(n, n);  // lower triangle; a column without a diagonal entry would be ordered last as if it were dense
  A.reserve(static_cast<Eigen::Index>(neighbor.size() / 2) + n);
  for (std::int32_t i = 0; i < n; ++i) {
    A.startVec(i);
    A.insertBack(i, i) = 1.0f;
    for (auto k = static_cast<std::size_t>(first[static_cast<std::size_t>(i)]);
         k < static_cast<std::size_t>(first[static_cast<std::size_t>(i) + 1]); ++k) {
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
    const auto v = static_cast<std::size_t>(vertex_at[i]);
    for (auto k = static_cast<std::size_t>(first[v]); k < static_cast<std::size_t>(first[v + 1]); ++k) {
      std::int32_t j = place[static_cast<std::size_t>(neighbor[k])];
      while (j >= 0 && j < static_cast<std::int32_t>(i)) {
        const std::int32_t next = ancestor[static_cast<std::size_t>(j)];
        ancestor[static_cast<std::size_t>(j)] = static_cast<std::int32_t>(i);
        if (next < 0) parent[static_cast<std::size_t>(j)] = static_cast<std::int32_t>(i);
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
    sibling[i] = child[static_cast<std::size_t>(parent[i])];
    child[static_cast<std::size_t>(parent[i])] = static_cast<std::int32_t>(i);
  }
  order.reserve(n);
  for (std::size_t root = 0; root < n; ++root) {
    if (parent[root] >= 0) continue;
    stack.push_back(static_cast<std::int32_t>(root));
    while (!stack.empty()) {
      const auto i = static_cast<std::size_t>(stack.back());
      if (child[i] >= 0) {
        stack.push_back(child[i]);
        child[i] = sibling[static_cast<std::size_t>(child[i])];
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
      const auto v = static_cast<std::size_t>(vertex_at[i]);
      mark[i] = static_cast<std::int32_t>(i);
      for (auto k = static_cast<std::size_t>(first[v]); k < static_cast<std::size_t>(first[v + 1]); ++k) {
        auto j = static_cast<std::size_t>(place[static_cast<std::size_t>(neighbor[k])]);
        if (j > i) continue;
        for (; mark[j] != static_cast<std::int32_t>(i); j = static_cast<std::size_t>(c.parent[j])) {
          mark[j] = static_cast<std::int32_t>(i);
          if (pass == 0) {
            c.begin[j + 1]++;
          } else {
            c.row[static_cast<std::size_t>(next[j]++)] = static_cast<std::int32_t>(i);
          }
        }
      }
    }
    if (pass == 0) {
      for (std::size_t j = 0; j < n; ++j) c.begin[j + 1] += c.begin[j];
      c.row.resize(static_cast<std::size_t>(c.begin[n]));
      next.assign(c.begin.begin(), c.begin.end() - 1);
    }
  }
  return c;
}

}  // namespace detail

}  // namespace rigless
