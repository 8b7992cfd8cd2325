// The pieces of surface in each voxel: a voxel between two legs holds a piece of each.
#pragma once

#include "rigless/mesh/detail/sheets.h"
#include "rigless/mesh/detail/voxels.h"

namespace rigless::detail {

// A triangle's share in a voxel: area and middle, in cells.
struct Share {
  std::int32_t voxel, face;
  float area;
  std::array<float, 3> middle;
};

// Triangles that hang together inside a voxel.
struct Piece {
  Point middle = Point::Zero();
  Point normal = Point::Zero();  // of length 1, outwards; 0 where nobody knows
  double area = 0;
  std::int32_t shell = -1;
  std::int32_t part = no_part;
};

struct Pieces {
  std::vector<std::int32_t> voxel;     // of each surface voxel: its number in the grid, ascending
  std::vector<std::int32_t> first;     // surface voxels + 1: into piece
  std::vector<Piece> piece;            // voxel by voxel
  std::vector<Share> share;            // triangle by triangle
  std::vector<std::int32_t> of_share;  // piece
};

// Allocates.
template <class S>
RIGLESS_COLD std::vector<Share> collect_shares(const Triangles<S>& triangles, const Voxels& voxels) {
  std::vector<Share> shares;
  shares.reserve(triangles.faces.size() + triangles.faces.size() / 4);
  std::vector<std::pair<std::int32_t, Point>> hits;
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
    if (!triangles.has(f)) continue;
    const std::array<Point, 3> t = triangles.local(voxels.grid, f);
    const double area = (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
    const auto add = [&](std::int32_t voxel, double part, const Point& p) {
      shares.push_back({voxel,
                        static_cast<std::int32_t>(f),
                        static_cast<float>(part),
                        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())}});
    };
    const Face& face = triangles.faces[f];
    const std::int32_t home = nth(voxels.home, face[0]);
    if (home >= 0 && home == nth(voxels.home, face[1]) && home == nth(voxels.home, face[2])) {
      add(home, area, (t[0] + t[1] + t[2]) / 3);
      continue;
    }
    hits.clear();
    const auto hit = [&](std::int32_t voxel, const Point& p) {
      if (voxel >= 0) hits.emplace_back(voxel, p);
    };
    for (std::size_t k = 0; k < 3; ++k) hit(nth(voxels.home, face[k]), t[k]);
    for_each_sample(voxels.grid, t, [&](const Point& p) { hit(voxels.grid.voxel(p), p); });
    std::stable_sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < hits.size();) {
      const std::size_t begin = k;
      Point sum = Point::Zero();
      for (; k < hits.size() && hits[k].first == hits[begin].first; ++k) sum += hits[k].second;
      const auto count = static_cast<double>(k - begin);
      add(hits[begin].first, area * count / static_cast<double>(hits.size()), sum / count);
    }
  }
  return shares;
}

// Whether the edge a b, given in cells, passes the voxel whose low corner is `low`, or nearly.
inline bool passes(const Point& a, const Point& b, const Point& low) {
  constexpr double slack = 0.02;
  double from = 0, to = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = b[axis] - a[axis], near = low[axis] - slack - a[axis], far = low[axis] + 1 + slack - a[axis];
    if (d == 0) {
      if (near > 0 || far < 0) return false;
      continue;
    }
    from = std::max(from, std::min(near / d, far / d));
    to = std::min(to, std::max(near / d, far / d));
  }
  return from <= to;
}

// Finds the pieces, voxel by voxel.
template <class S>
class PieceFinder {
 public:
  // Allocates.
  PieceFinder(const Triangles<S>& triangles, const Sheets& sheets, const Voxels& voxels)
      : triangles_(triangles),
        sheets_(sheets),
        voxels_(voxels),
        seen_in_(triangles.vertices.size(), -1),
        seen_by_(triangles.vertices.size()) {}

  RIGLESS_COLD Pieces find() {
    Pieces out;
    out.share = collect_shares(triangles_, voxels_);
    out.of_share.resize(out.share.size());
    std::vector<std::int32_t> begin(voxels_.kind.size() + 1, 0), order(out.share.size());
    for (const Share& s : out.share) begin[to_size(s.voxel) + 1]++;
    for (std::size_t v = 0; v < voxels_.kind.size(); ++v) begin[v + 1] += begin[v];
    for (std::size_t k = out.share.size(); k-- > 0;) {
      nth(order, --begin[to_size(out.share[k].voxel) + 1]) = static_cast<std::int32_t>(k);
    }
    out.first.push_back(0);
    for (std::size_t v = 0; v < voxels_.kind.size(); ++v) {  // begin[v + 1] is now where v begins
      const auto from = to_size(begin[v + 1]), to = v + 2 < begin.size() ? to_size(begin[v + 2]) : order.size();
      if (from == to) continue;
      out.voxel.push_back(static_cast<std::int32_t>(v));
      connect(static_cast<std::int32_t>(v), {order.data() + from, to - from}, out);
      add_pieces({order.data() + from, to - from}, out);
      out.first.push_back(count_of(out.piece));
    }
    return out;
  }

 private:
  // Over vertices that lie in the voxel, and over edges that pass it.
  void connect(std::int32_t voxel, Span<const std::int32_t> order, const Pieces& out) {
    sets_.reset(order.size());
    edges_.clear();
    const auto at = voxels_.grid.coordinates(voxel);
    for (std::size_t k = 0; k < order.size(); ++k) {
      const auto f = to_size(nth(out.share, order[k]).face);
      const Face& face = triangles_.faces[f];
      const auto own = static_cast<std::int32_t>(k);
      std::array<bool, 3> in{};
      for (std::size_t c = 0; c < 3; ++c) {
        in[c] = nth(voxels_.home, face[c]) == voxel;
        if (!in[c]) continue;
        const auto v = to_size(nth(sheets_.at, face[c]));
        if (seen_in_[v] == voxel) sets_.unite(seen_by_[v], own);
        seen_in_[v] = voxel;
        seen_by_[v] = own;
      }
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t d = (c + 1) % 3;
        if (in[c] || in[d]) continue;
        const Point low(at[0], at[1], at[2]);
        if (!passes(voxels_.grid.local(nth(triangles_.vertices, face[c])),
                    voxels_.grid.local(nth(triangles_.vertices, face[d])), low))
          continue;
        const std::int32_t a = nth(sheets_.at, face[c]), b = nth(sheets_.at, face[d]);
        edges_.push_back({std::min(a, b), std::max(a, b), own});
      }
    }
    std::sort(edges_.begin(), edges_.end());
    for (std::size_t k = 1; k < edges_.size(); ++k) {
      if (edges_[k][0] == edges_[k - 1][0] && edges_[k][1] == edges_[k - 1][1])
        sets_.unite(edges_[k][2], edges_[k - 1][2]);
    }
  }

  void add_pieces(Span<const std::int32_t> order, Pieces& out) {
    const auto first = out.piece.size();
    for (std::size_t k = 0; k < order.size(); ++k) {
      const Share& share = nth(out.share, order[k]);
      const std::int32_t root = sets_.find(static_cast<std::int32_t>(k));
      if (to_size(root) == k) {
        nth(out.of_share, order[k]) = count_of(out.piece);
        out.piece.emplace_back();
      }
      nth(out.of_share, order[k]) = nth(out.of_share, order[root]);
      Piece& piece = nth(out.piece, nth(out.of_share, order[k]));
      const double area = static_cast<double>(share.area) + 1e-12;  // so that needles have a middle
      piece.area += area;
      piece.middle += area * Point(share.middle[0], share.middle[1], share.middle[2]);
      piece.shell = nth(sheets_.shell_of, share.face);
      const auto f = to_size(share.face);
      join_part(piece.part, triangles_.part_of(triangles_.faces[f]));
      const std::array<Point, 3> t = triangles_.local(voxels_.grid, f);
      const Point normal = (t[1] - t[0]).cross(t[2] - t[0]);
      const double length = normal.norm();
      if (length > 0) piece.normal += (area * sheets_.side[f] / length) * normal;
    }
    for (std::size_t k = first; k < out.piece.size(); ++k) {
      Piece& piece = out.piece[k];
      piece.middle /= piece.area;
      const double length = piece.normal.norm();
      if (length > 0.05 * piece.area) {
        piece.normal /= length;
      } else {
        piece.normal.setZero();
      }
    }
  }

  const Triangles<S>& triangles_;
  const Sheets& sheets_;
  const Voxels& voxels_;
  DisjointSets sets_;
  std::vector<std::int32_t> seen_in_, seen_by_;  // V: the last voxel a vertex was seen in, and by which triangle there
  std::vector<std::array<std::int32_t, 3>> edges_;
};

}  // namespace rigless::detail
