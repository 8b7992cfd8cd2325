// A model as voxels of the size that gives as many nodes as are wanted.
#pragma once

#include "rigless/mesh/detail/parts.h"
#include "rigless/mesh/detail/voxel_fill.h"

namespace rigless::detail {

// The triangles of a model without those that are left out.
template <class S>
struct Triangles {
  Span<const Vec3<S>> vertices;
  Span<const Face> faces;
  const std::vector<char>& left_out;  // F, or empty
  Span<const std::int32_t> part;      // V, or empty: none

  bool has(std::size_t f) const { return left_out.empty() || !left_out[f]; }
  std::int32_t part_of(const Face& face) const {
    std::int32_t own = part.empty() ? any_part : no_part;
    if (!part.empty())
      for (const std::int32_t v : face) join_part(own, nth(part, v));
    return own;
  }
  std::array<Point, 3> local(const VoxelGrid& grid, std::size_t f) const {
    return {grid.local(nth(vertices, faces[f][0])), grid.local(nth(vertices, faces[f][1])),
            grid.local(nth(vertices, faces[f][2]))};
  }
};

struct Voxels {
  VoxelGrid grid;
  std::vector<Voxel> kind;         // of each voxel
  std::vector<std::int32_t> home;  // V: the voxel a vertex lies in, or -1

  bool solid(std::int32_t v) const { return nth(kind, v) != Voxel::outside; }
};

// Allocates.
template <class S>
RIGLESS_COLD void fill_voxels(const Triangles<S>& triangles, const VoxelGrid& grid, Voxels& out) {
  out.grid = grid;
  out.kind.assign(to_size(grid.size()), Voxel::inside);
  out.home.resize(triangles.vertices.size());
  for (std::size_t v = 0; v < out.home.size(); ++v) out.home[v] = grid.voxel(grid.local(triangles.vertices[v]));
  const auto mark = [&](std::int32_t voxel) {
    if (voxel >= 0) nth(out.kind, voxel) = Voxel::surface;
  };
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
    if (!triangles.has(f)) continue;
    const Face& face = triangles.faces[f];
    const std::int32_t a = nth(out.home, face[0]), b = nth(out.home, face[1]), c = nth(out.home, face[2]);
    if (a == b && b == c && a >= 0) {
      mark(a);
    } else {
      for (const std::int32_t home : {a, b, c}) mark(home);  // samples may miss a corner by a rounding
      for_each_sample(grid, triangles.local(grid, f), [&](const Point& p) { mark(grid.voxel(p)); });
    }
  }
  fill_inside(grid, out.kind);
}

// Corners of solid voxels. Allocates.
inline std::int32_t count_corners(const Voxels& voxels) {
  std::vector<char> corner(voxels.kind.size(), 0);
  const auto stride = voxels.grid.strides();
  std::int32_t count = 0;
  for (std::int32_t v = 0; v < voxels.grid.size(); ++v) {
    if (!voxels.solid(v)) continue;
    for (std::int32_t k = 0; k < 8; ++k) {
      char& mark = nth(corner, v + (k & 1) + (k >> 1 & 1) * stride[1] + (k >> 2 & 1) * stride[2]);
      count += mark == 0 ? 1 : 0;
      mark = 1;
    }
  }
  return count;
}

// The grid over `box` with voxels of that edge, or of the smallest larger one that 16 million of them hold.
inline VoxelGrid bounded_grid(const Box& box, double edge) {
  const auto cells = [&](double h) { return ((box.high - box.low) / h).array().floor() + 3; };
  while (!(cells(edge).prod() <= double{1 << 24})) edge *= 1.05;
  return {box, edge};
}

// Voxels with about so many corners: the size is tried until it fits, at most twelve times. Allocates.
template <class S>
RIGLESS_COLD Voxels fit_voxels(const Triangles<S>& triangles, const Box& box, double corners) {
  Voxels voxels, best;
  double edge = (box.high - box.low).maxCoeff() / 24, best_off = 1e300;
  for (int attempt = 0; attempt < 12; ++attempt) {
    fill_voxels(triangles, bounded_grid(box, edge), voxels);
    const double ratio = count_corners(voxels) / corners, off = std::max(ratio, 1 / ratio);
    const double last = edge;
    edge = voxels.grid.cell * std::clamp(std::sqrt(ratio), 0.4, 2.5);
    const bool as_before = last < voxels.grid.cell && edge < voxels.grid.cell;  // no smaller ones to be had
    if (off < best_off) {
      best_off = off;
      std::swap(best, voxels);
    }
    if (off < 1.05 || as_before) break;
  }
  return best;
}

}  // namespace rigless::detail
