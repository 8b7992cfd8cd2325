// Nodes: the corners of elements, one where elements hang together.
#pragma once

#include "rigless/mesh/detail/voxel_elements.h"

namespace rigless::detail {

// Decides which elements of neighbouring voxels are joined, and unites the corners that these have in common.
class NodeJoiner {
 public:
  // part: of each element.
  NodeJoiner(const Voxels& voxels, const Pieces& pieces, const Elements& elements,
             const std::vector<std::int32_t>& part)
      : voxels_(voxels), pieces_(pieces), elements_(elements), part_(part), corners_(8 * elements.voxel.size()) {}

  // The node at each corner of each element, numbered as they come; gives their number. Allocates.
  RIGLESS_COLD std::int32_t join(std::vector<std::array<std::int32_t, 8>>& node) {
    join_over_triangles();
    for (std::int32_t e = 0; e < count_of(elements_.voxel); ++e) join_with_neighbours(e);
    std::int32_t nodes = 0;
    node.resize(elements_.voxel.size());
    for (std::size_t k = 0; k < 8 * node.size(); ++k) {
      const auto root = to_size(corners_.find(static_cast<std::int32_t>(k)));
      node[k / 8][k % 8] = root == k ? nodes++ : node[root / 8][root % 8];
    }
    return nodes;
  }

 private:
  static constexpr double same_place = 0.7;  // in cells: farther parts that meet, boots for example, are two

  // A triangle that is in both joins them.
  void join_over_triangles() {
    const auto& share = pieces_.share;
    for (std::size_t begin = 0, end = 0; begin < share.size(); begin = end) {
      while (end < share.size() && share[end].face == share[begin].face) ++end;
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t j = i + 1; j < end; ++j) unite(element_of(i), element_of(j));
      }
    }
  }
  std::int32_t element_of(std::size_t share) const { return nth(elements_.of_piece, pieces_.of_share[share]); }

  // With those in the 13 voxels that come later.
  void join_with_neighbours(std::int32_t e) {
    const auto stride = voxels_.grid.strides();
    for (std::int32_t d = 14; d < 27; ++d) {
      const std::array<std::int32_t, 3> by = {d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1};
      const std::int32_t v = nth(elements_.voxel, e) + by[0] + by[1] * stride[1] + by[2] * stride[2];
      if (!voxels_.solid(v)) continue;
      const bool over_face = by[0] * by[0] + by[1] * by[1] + by[2] * by[2] == 1;
      for (std::int32_t f = nth(elements_.first, v); f < elements_.first[to_size(v) + 1]; ++f) {
        if (!parted(nth(part_, e), nth(part_, f)) && joined(e, f, over_face, Point(by[0], by[1], by[2]))) unite(e, f);
      }
    }
  }

  bool joined(std::int32_t e, std::int32_t f, bool over_face, const Point& way) const {
    const Span<const std::int32_t> of_e = elements_.pieces_of(e), of_f = elements_.pieces_of(f);
    if (of_e.empty() && of_f.empty()) return over_face;
    if (of_e.empty()) return over_face && shows_away(f, of_f, -way);
    if (of_f.empty()) return over_face && shows_away(e, of_e, way);
    for (const std::int32_t p : of_e) {
      for (const std::int32_t q : of_f) {
        const Piece &a = nth(pieces_.piece, p), &b = nth(pieces_.piece, q);
        const Between what = between(a, b);
        if (a.shell == b.shell) {
          if (over_face && what == Between::material) return true;
        } else if (what != Between::gap && (a.middle - b.middle).norm() < same_place) {
          return true;
        }
      }
    }
    return false;
  }

  // A surface goes with an inside behind it; where nothing else is in its voxel, with any.
  bool shows_away(std::int32_t surface, Span<const std::int32_t> pieces, const Point& to_inside) const {
    return elements_.count_in(nth(elements_.voxel, surface)) == 1 || lies_behind(pieces_, pieces, to_inside);
  }

  // Unites common corners; voxels that are no neighbours have none.
  void unite(std::int32_t e, std::int32_t f) {
    if (e == f) return;
    const auto a = voxels_.grid.coordinates(nth(elements_.voxel, e));
    const auto b = voxels_.grid.coordinates(nth(elements_.voxel, f));
    std::array<std::int32_t, 3> by{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      by[axis] = b[axis] - a[axis];
      if (by[axis] < -1 || by[axis] > 1) return;
    }
    for (std::int32_t k = 0; k < 8; ++k) {
      std::int32_t other = 0;
      bool common = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int32_t bit = (k >> axis & 1) - by[axis];
        common = common && (bit == 0 || bit == 1);
        if (bit == 1) other |= 1 << axis;
      }
      if (common) corners_.unite(8 * e + k, 8 * f + other);
    }
  }

  const Voxels& voxels_;
  const Pieces& pieces_;
  const Elements& elements_;
  const std::vector<std::int32_t>& part_;
  DisjointSets corners_;
};

}  // namespace rigless::detail
