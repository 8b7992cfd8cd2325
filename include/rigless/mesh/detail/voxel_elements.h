// Elements: a voxel that sheets of different parts pass is there once for each, so that legs that nearly touch can
// part. Which of them hang together is said by how the surfaces in them face each other. Source: Nesme, Kry, Jerabkova
// and Faure 2009, "Preserving topology and elasticity for embedded deformable models".
#pragma once

#include "rigless/mesh/detail/voxel_pieces.h"

namespace rigless::detail {

enum class Between : std::uint8_t { gap, material, unclear };

// What lies between two pieces: a gap if both show at the other, material if both turn away.
inline Between between(const Piece& a, const Piece& b) {
  constexpr double clearly = 0.15;
  const Point d = b.middle - a.middle;
  const double length = d.norm();
  if (!(length > 1e-6)) return Between::unclear;
  const double from_a = a.normal.dot(d) / length, from_b = -b.normal.dot(d) / length;
  if (from_a > clearly && from_b > clearly) return Between::gap;
  if (from_a < -clearly && from_b < -clearly) return Between::material;
  return Between::unclear;
}

struct Elements {
  std::vector<std::int32_t> voxel;  // of each element, ascending
  std::vector<std::int32_t> first;  // grid voxels + 1: its elements
  std::vector<std::int32_t> of_piece;
  std::vector<std::int32_t> first_piece, piece_of;  // elements + 1, and the pieces of each

  Span<const std::int32_t> pieces_of(std::int32_t e) const {
    const auto from = to_size(nth(first_piece, e));
    return {piece_of.data() + from, to_size(first_piece[to_size(e) + 1]) - from};
  }
  std::int32_t count_in(std::int32_t v) const { return first[to_size(v) + 1] - nth(first, v); }
};

// Whether an inside that lies this way is behind one of some pieces, or there are none that could hide it.
inline bool lies_behind(const Pieces& pieces, Span<const std::int32_t> of, const Point& way) {
  bool is_behind = of.empty();
  for (const std::int32_t p : of) is_behind = is_behind || nth(pieces.piece, p).normal.dot(way) <= 0;
  return is_behind;
}

// Joins the pieces of one voxel, if not of two parts: of the same shell over material, of others unless there is a gap.
// Where there are more than 24, the small ones go with the nearest of the large.
inline void join_pieces(Span<const Piece> pieces, DisjointSets& sets) {
  constexpr std::size_t most = 24;
  sets.reset(pieces.size());
  std::vector<std::int32_t> order(pieces.size());
  std::iota(order.begin(), order.end(), 0);
  if (pieces.size() > most) {
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      return nth(pieces, a).area != nth(pieces, b).area ? nth(pieces, a).area > nth(pieces, b).area : a < b;
    });
  }
  const std::size_t large = std::min(most, order.size());
  for (std::size_t i = 0; i < large; ++i) {
    for (std::size_t j = i + 1; j < large; ++j) {
      const Piece &a = nth(pieces, order[i]), &b = nth(pieces, order[j]);
      if (parted(a.part, b.part)) continue;
      const Between what = between(a, b);
      if (a.shell == b.shell ? what == Between::material : what != Between::gap) sets.unite(order[i], order[j]);
    }
  }
  for (std::size_t i = large; i < order.size(); ++i) {
    const auto away = [&](std::size_t j) {
      return (nth(pieces, order[j]).middle - nth(pieces, order[i]).middle).squaredNorm();
    };
    std::size_t nearest = 0;
    for (std::size_t j = 1; j < large; ++j) nearest = away(j) < away(nearest) ? j : nearest;
    sets.unite(order[i], order[nearest]);
  }
}

// One element for each set of joined pieces, one for each voxel inside. Allocates.
RIGLESS_COLD inline Elements find_elements(const Voxels& voxels, const Pieces& pieces) {
  Elements out;
  out.of_piece.resize(pieces.piece.size());
  out.first.push_back(0);
  DisjointSets sets;
  std::size_t surface = 0;
  for (std::int32_t v = 0; v < voxels.grid.size(); ++v) {
    if (surface < pieces.voxel.size() && pieces.voxel[surface] == v) {
      const auto from = to_size(pieces.first[surface]), count = to_size(pieces.first[surface + 1]) - from;
      join_pieces({pieces.piece.data() + from, count}, sets);
      for (std::size_t k = 0; k < count; ++k) {
        const auto root = to_size(sets.find(static_cast<std::int32_t>(k)));
        if (root == k) {
          out.of_piece[from + k] = count_of(out.voxel);
          out.voxel.push_back(v);
        }
        out.of_piece[from + k] = out.of_piece[from + root];
      }
      ++surface;
    } else if (nth(voxels.kind, v) == Voxel::inside) {
      out.voxel.push_back(v);
    }
    out.first.push_back(count_of(out.voxel));
  }
  out.first_piece.assign(out.voxel.size() + 1, 0);
  for (const std::int32_t e : out.of_piece) out.first_piece[to_size(e) + 1]++;
  for (std::size_t e = 0; e < out.voxel.size(); ++e) out.first_piece[e + 1] += out.first_piece[e];
  std::vector<std::int32_t> next(out.first_piece.begin(), out.first_piece.end() - 1);
  out.piece_of.resize(out.of_piece.size());
  for (std::size_t p = 0; p < out.of_piece.size(); ++p) {
    nth(out.piece_of, nth(next, out.of_piece[p])++) = static_cast<std::int32_t>(p);
  }
  return out;
}

}  // namespace rigless::detail
