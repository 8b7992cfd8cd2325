// The shape of a sparse factor before any number is known: elimination order, elimination tree, supernodes and who
// updates whom.
#pragma once

#include "rigless/math/detail/elimination_tree.h"

namespace rigless::detail {

// Columns first .. first + width - 1 of the factor; below their triangle they share row_count rows.
struct Supernode {
  std::int32_t first = 0;
  std::int32_t width = 0;
  std::int32_t rows = 0;  // into SupernodeTree::rows; the columns themselves stand just before
  std::int32_t row_count = 0;
  std::int32_t parent = -1;  // supernode that holds the first of those rows
  std::int32_t links = 0;    // into SupernodeTree::links
  std::int32_t link_count = 0;
  std::int32_t blocks = 0;  // into SupernodeTree::blocks
};

// A few neighbouring columns of one supernode and all rows below them, as a solve reads them: a square, of which the
// lower triangle counts, then row_count rows of `width` numbers.
struct ColumnBlock {
  static constexpr std::int32_t widest = 4;

  std::int32_t first = 0;
  std::int32_t width = 0;
  std::int32_t rows = 0;  // into SupernodeTree::rows
  std::int32_t row_count = 0;
  std::int64_t values = 0;  // into the factor's numbers
};

// Rows begin .. end - 1 of an earlier supernode lie among the columns of this one.
struct SupernodeLink {
  std::int32_t descendant;
  std::int32_t begin, end;
};

struct SupernodeTree {
  std::vector<std::int32_t> place;      // n: vertex -> place in elimination order
  std::vector<std::int32_t> vertex_at;  // n: place -> vertex
  std::vector<std::int32_t> node_of;    // n: place -> supernode
  std::vector<Supernode> nodes;
  std::vector<ColumnBlock> blocks;   // supernode by supernode
  std::vector<std::int32_t> rows;    // places, ascending within a supernode
  std::vector<SupernodeLink> links;  // grouped by the supernode that is updated
  std::int64_t values = 0;           // numbers in all blocks
};

// Orders by approximate minimum degree and merges columns into supernodes, also where a few zeros must be stored for
// it. Allocates. Source: Davis, "Direct Methods for Sparse Linear Systems", 2006, ch. 4 and 7; Ashcraft and Grimes 1989
// for the relaxed merging.
RIGLESS_COLD SupernodeTree build_supernode_tree(Span<const std::int32_t> first, Span<const std::int32_t> neighbor);

// Last column of each supernode. Neighbouring columns join when their rows agree, or nearly: a stored zero costs less
// than a supernode of its own.
RIGLESS_COLD inline std::vector<std::int32_t> supernode_ends(const Columns& columns) {
  struct Draft {
    std::int64_t first, last, zeros;
  };
  constexpr std::int64_t widest = 64;  // wider ones gain nothing and would make a partial refactorisation coarse
  const auto n = static_cast<std::int64_t>(columns.parent.size());
  const auto below = [&](std::int64_t j) { return columns.begin[to_size(j) + 1] - nth(columns.begin, j); };
  std::vector<Draft> drafts;
  for (std::int64_t j = 0; j < n; ++j) {
    drafts.push_back({j, j, 0});
    while (drafts.size() > 1) {
      const Draft& s = drafts[drafts.size() - 2];
      const Draft& p = drafts.back();
      const std::int64_t parent = nth(columns.parent, s.last);
      if (parent < p.first || parent > p.last) break;
      const std::int64_t ws = s.last - s.first + 1, wp = p.last - p.first + 1, w = ws + wp;
      if (w > widest) break;
      const std::int64_t zeros = s.zeros + p.zeros + ws * (wp + below(p.last) - below(s.last));
      const std::int64_t size = w * (w + 1) / 2 + w * below(p.last);
      const double share = static_cast<double>(zeros) / static_cast<double>(size);
      if (share > (w <= 4 ? 0.5 : w <= 12 ? 0.15 : 0.05)) break;
      const Draft merged{s.first, p.last, zeros};
      drafts.pop_back();
      drafts.back() = merged;
    }
  }
  std::vector<std::int32_t> ends;
  for (const Draft& d : drafts) ends.push_back(static_cast<std::int32_t>(d.last));
  return ends;
}

// Cuts a supernode into blocks.
inline void append_blocks(SupernodeTree& tree, Supernode& node) {
  node.blocks = count_of(tree.blocks);
  for (std::int32_t k = 0; k < node.width; k += ColumnBlock::widest) {
    ColumnBlock block;
    block.first = node.first + k;
    block.width = std::min(ColumnBlock::widest, node.width - k);
    block.rows = node.rows - node.width + k + block.width;
    block.row_count = node.row_count + node.width - k - block.width;
    block.values = tree.values;
    tree.values += static_cast<std::int64_t>(block.width) * (block.width + block.row_count);
    tree.blocks.push_back(block);
  }
}

RIGLESS_COLD inline void link_supernodes(SupernodeTree& tree) {
  std::vector<SupernodeLink> links;
  std::vector<std::int32_t> target;
  for (std::size_t d = 0; d < tree.nodes.size(); ++d) {
    const Supernode& node = tree.nodes[d];
    for (std::int32_t b = 0; b < node.row_count;) {
      const auto at = [&](std::int32_t r) { return nth(tree.node_of, nth(tree.rows, node.rows + r)); };
      std::int32_t e = b + 1;
      while (e < node.row_count && at(e) == at(b)) ++e;
      links.push_back({static_cast<std::int32_t>(d), b, e});
      target.push_back(at(b));
      nth(tree.nodes, at(b)).link_count++;
      b = e;
    }
  }
  std::int32_t sum = 0;
  for (Supernode& node : tree.nodes) {
    node.links = sum;
    sum += node.link_count;
  }
  std::vector<std::int32_t> next;
  for (const Supernode& node : tree.nodes) next.push_back(node.links);
  tree.links.resize(links.size());
  for (std::size_t l = 0; l < links.size(); ++l) {
    nth(tree.links, nth(next, target[l])++) = links[l];
  }
}

inline SupernodeTree build_supernode_tree(Span<const std::int32_t> first, Span<const std::int32_t> neighbor) {
  SupernodeTree tree;
  const auto invert = [&] {
    tree.place.resize(tree.vertex_at.size());
    for (std::size_t i = 0; i < tree.vertex_at.size(); ++i) {
      nth(tree.place, tree.vertex_at[i]) = static_cast<std::int32_t>(i);
    }
  };
  tree.vertex_at = minimum_degree_order(first, neighbor);
  invert();
  const auto order = postorder(elimination_tree(first, neighbor, tree.vertex_at, tree.place));
  std::vector<std::int32_t> vertex_at;
  vertex_at.reserve(order.size());
  for (const std::int32_t i : order) vertex_at.push_back(nth(tree.vertex_at, i));
  tree.vertex_at = std::move(vertex_at);
  invert();

  const Columns columns = column_structure(first, neighbor, tree.vertex_at, tree.place);
  tree.node_of.resize(tree.place.size());
  std::int32_t start = 0;
  for (const std::int32_t end : supernode_ends(columns)) {
    Supernode node;
    node.first = start;
    node.width = end - start + 1;
    for (std::int32_t k = start; k <= end; ++k) tree.rows.push_back(k);
    node.rows = count_of(tree.rows);
    const auto from = columns.row.begin() + static_cast<std::ptrdiff_t>(nth(columns.begin, end));
    const auto to = columns.row.begin() + static_cast<std::ptrdiff_t>(columns.begin[to_size(end) + 1]);
    tree.rows.insert(tree.rows.end(), from, to);
    node.row_count = static_cast<std::int32_t>(to - from);
    append_blocks(tree, node);
    for (std::int32_t k = start; k <= end; ++k) {
      nth(tree.node_of, k) = count_of(tree.nodes);
    }
    tree.nodes.push_back(node);
    start = end + 1;
  }
  for (Supernode& node : tree.nodes) {
    if (node.row_count > 0) {
      node.parent = nth(tree.node_of, nth(tree.rows, node.rows));
    }
  }
  link_supernodes(tree);
  return tree;
}

}  // namespace rigless::detail
