// What the triangles of a file form: shells, and which side of each triangle is out.
#pragma once

#include <algorithm>
#include <cmath>

#include "rigless/mesh/detail/disjoint_sets.h"
#include "rigless/mesh/detail/weld.h"

namespace rigless::detail {

struct Sheets {
  std::vector<std::int32_t> at;        // V: the vertex that speaks for all at its place
  std::vector<std::int32_t> shell_of;  // F
  std::int32_t shells = 0;
  std::vector<std::int8_t> side;  // F: 1 where the winding shows outwards, -1 where inwards, 0 where nobody knows
};

// Triangles over one edge are wound alike, or turned so; then each patch shows outwards if its volume about its own
// middle is positive. Flat patches have no outside.
class Winding {
 public:
  explicit Winding(std::size_t faces) : sets_(faces) {}

  // Edges of two triangles join; where more meet nobody says who belongs to whom. Allocates.
  RIGLESS_COLD void join_over_edges(Span<const Face> faces, const std::vector<std::int32_t>& at) {
    std::vector<std::int32_t> begin(at.size() + 1, 0);
    const auto each_edge = [&](const auto& visit) {
      for (std::size_t f = 0; f < faces.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
          const std::int32_t a = nth(at, faces[f][k]), b = nth(at, faces[f][(k + 1) % 3]);
          if (a != b) visit(std::min(a, b), std::max(a, b), static_cast<std::int32_t>(f), a < b);
        }
      }
    };
    each_edge([&](std::int32_t low, std::int32_t, std::int32_t, bool) { begin[to_size(low) + 1]++; });
    for (std::size_t v = 0; v < at.size(); ++v) begin[v + 1] += begin[v];
    struct Half {
      std::int32_t high, face;
      bool upwards;
    };
    std::vector<Half> half(to_size(begin.back()));
    std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
    each_edge([&](std::int32_t low, std::int32_t high, std::int32_t f, bool upwards) {
      nth(half, nth(next, low)++) = {high, f, upwards};
    });
    for (std::size_t v = 0; v < at.size(); ++v) {
      const auto end = half.begin() + begin[v + 1];
      std::sort(half.begin() + begin[v], end,
                [](const Half& a, const Half& b) { return a.high != b.high ? a.high < b.high : a.face < b.face; });
      for (auto h = half.begin() + begin[v]; h != end;) {
        auto stop = h;
        while (stop != end && stop->high == h->high) ++stop;
        if (stop - h == 2) sets_.unite(h->face, h[1].face, h->upwards == h[1].upwards);
        h = stop;
      }
    }
  }

  // 1, -1 or 0 for each face. Allocates.
  template <class S>
  RIGLESS_COLD std::vector<std::int8_t> sides(Span<const Vec3<S>> vertices, Span<const Face> faces) {
    struct Patch {
      Vec3<double> area = Vec3<double>::Zero(), middle = Vec3<double>::Zero();
      double size = 0, volume = 0;
    };
    std::vector<std::int32_t> patch_of(faces.size());
    std::vector<std::int8_t> side(faces.size());
    std::vector<Patch> patches;
    const Vec3<double> origin = nth(vertices, faces[0][0]).template cast<double>();
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto [root, turned] = sets_.find(static_cast<std::int32_t>(f));
      if (to_size(root) == f) {
        patch_of[f] = count_of(patches);
        patches.emplace_back();
      }
      patch_of[f] = nth(patch_of, root);  // roots come first
      side[f] = turned ? std::int8_t{-1} : std::int8_t{1};
      Vec3<double> corner[3];
      for (std::size_t k = 0; k < 3; ++k) corner[k] = nth(vertices, faces[f][k]).template cast<double>() - origin;
      const Vec3<double> normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
      Patch& patch = nth(patches, patch_of[f]);
      patch.area += side[f] * normal;
      patch.middle += normal.norm() * (corner[0] + corner[1] + corner[2]);
      patch.size += normal.norm();
      patch.volume += side[f] * corner[0].dot(normal);
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const Patch& patch = nth(patches, patch_of[f]);
      if (!(patch.size > 0)) {
        side[f] = 0;
        continue;
      }
      const double six = patch.volume - patch.area.dot(patch.middle) / (3 * patch.size);
      const double round = patch.size * std::sqrt(patch.size);  // a ball has .1 of it
      if (std::abs(six) < 0.002 * round) side[f] = 0;
      if (six < 0) side[f] = static_cast<std::int8_t>(-side[f]);
    }
    return side;
  }

 private:
  TurnedSets sets_;
};

// Allocates.
template <class S>
RIGLESS_COLD Sheets find_sheets(Span<const Vec3<S>> vertices, Span<const Face> faces) {
  Sheets sheets;
  sheets.at = weld(vertices);
  DisjointSets shells(vertices.size());
  for (const Face& f : faces) {
    shells.unite(nth(sheets.at, f[0]), nth(sheets.at, f[1]));
    shells.unite(nth(sheets.at, f[0]), nth(sheets.at, f[2]));
  }
  sheets.shell_of.reserve(faces.size());
  std::vector<std::int32_t> number(vertices.size(), -1);
  for (const Face& f : faces) {
    std::int32_t& shell = nth(number, shells.find(nth(sheets.at, f[0])));
    if (shell < 0) shell = sheets.shells++;
    sheets.shell_of.push_back(shell);
  }
  Winding winding(faces.size());
  winding.join_over_edges(faces, sheets.at);
  sheets.side = winding.sides(vertices, faces);
  return sheets;
}

}  // namespace rigless::detail
