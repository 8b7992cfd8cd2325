// Which element carries each vertex.
#pragma once

#include "rigless/mesh/detail/voxel_elements.h"

namespace rigless::detail {

// The nearest element to every voxel of the grid, by steps over faces; the first of a voxel's. Allocates.
RIGLESS_COLD inline std::vector<std::int32_t> nearest_elements(const VoxelGrid& grid, const Elements& elements) {
  std::vector<std::int32_t> nearest(to_size(grid.size()), -1), front, next;
  for (std::int32_t v = 0; v < grid.size(); ++v) {
    if (elements.count_in(v) == 0) continue;
    nth(nearest, v) = nth(elements.first, v);
    front.push_back(v);
  }
  const auto stride = grid.strides();
  for (; !front.empty(); front.swap(next)) {
    next.clear();
    for (const std::int32_t v : front) {
      const auto at = grid.coordinates(v);
      for (std::size_t a = 0; a < 3; ++a) {
        for (const int way : {-1, 1}) {
          if (at[a] + way < 0 || at[a] + way >= grid.n[a]) continue;
          const std::int32_t w = v + way * stride[a];
          if (nth(nearest, w) >= 0) continue;
          nth(nearest, w) = nth(nearest, v);
          next.push_back(w);
        }
      }
    }
  }
  return nearest;
}

// The element of each vertex: that of its triangles, at one place the same for all. Vertices of no triangle go with
// what is nearest, those that lie outside of the grid and hang on nothing in it stay (-1), as what is left out does.
// Allocates.
template <class S>
RIGLESS_COLD std::vector<std::int32_t> find_carriers(const Triangles<S>& triangles, const Sheets& sheets,
                                                     const Voxels& voxels, const Pieces& pieces,
                                                     const Elements& elements) {
  constexpr std::int32_t stays = -1, unknown = -2;
  const auto count = triangles.vertices.size();
  std::vector<std::int32_t> of(count, unknown);
  std::vector<char> shell_in(to_size(sheets.shells), 0);
  for (std::size_t k = 0; k < pieces.share.size(); ++k) {
    const Share& share = pieces.share[k];
    nth(shell_in, nth(sheets.shell_of, share.face)) = 1;
    for (const std::int32_t v : nth(triangles.faces, share.face)) {
      if (nth(voxels.home, v) == share.voxel) nth(of, nth(sheets.at, v)) = nth(elements.of_piece, pieces.of_share[k]);
    }
  }
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
    for (const std::int32_t v : triangles.faces[f]) {
      std::int32_t& e = nth(of, nth(sheets.at, v));
      if (e == unknown && (!triangles.has(f) || !nth(shell_in, sheets.shell_of[f]))) e = stays;
    }
  }
  std::vector<std::int32_t> nearest;
  const VoxelGrid& grid = voxels.grid;
  for (std::size_t v = 0; v < count; ++v) {
    const auto at = to_size(sheets.at[v]);
    if (of[at] == unknown) {
      if (nearest.empty()) nearest = nearest_elements(grid, elements);
      Point p = grid.local(triangles.vertices[v]);
      bool far = false;
      for (int a = 0; a < 3; ++a) {
        far = far || !(p[a] > -nth(grid.n, a) && p[a] < 2 * nth(grid.n, a));
        p[a] = std::clamp(p[a], 1.0, nth(grid.n, a) - 1.5);
      }
      of[at] = far ? stays : nth(nearest, grid.voxel(p));
    }
    of[v] = of[at];
  }
  return of;
}

}  // namespace rigless::detail
