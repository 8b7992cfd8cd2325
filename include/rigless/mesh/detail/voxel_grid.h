// Cubes side by side, and which of them a triangle passes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "rigless/math/span.h"
#include "rigless/math/types.h"

namespace rigless::detail {

using Point = Vec3<double>;

struct Box {
  Point low = Point::Zero(), high = Point::Zero();
};

// A voxel is named by its number; what lies outside of all by -1. The outermost layer holds nothing of the box.
struct VoxelGrid {
  Point low = Point::Zero();
  double cell = 1;
  std::array<std::int32_t, 3> n = {0, 0, 0};

  VoxelGrid() = default;
  // What is flat lies in the middle of a layer.
  VoxelGrid(const Box& box, double edge) : cell(edge) {
    for (std::size_t a = 0; a < 3; ++a) {
      const auto axis = static_cast<int>(a);
      n[a] = static_cast<std::int32_t>((box.high[axis] - box.low[axis]) / cell) + 3;
      low[axis] = (box.low[axis] + box.high[axis]) / 2 - n[a] * cell / 2;
    }
  }

  std::int32_t size() const { return n[0] * n[1] * n[2]; }
  std::array<std::int32_t, 3> strides() const { return {1, n[0], n[0] * n[1]}; }

  template <class S>
  Point local(const Vec3<S>& p) const {
    return (p.template cast<double>() - low) / cell;
  }
  std::int32_t voxel(const Point& local) const {
    for (int a = 0; a < 3; ++a) {
      if (!(local[a] >= 1 && local[a] < nth(n, a) - 1)) return -1;
    }
    return static_cast<std::int32_t>(local.x()) +
           n[0] * (static_cast<std::int32_t>(local.y()) + n[1] * static_cast<std::int32_t>(local.z()));
  }
  std::array<std::int32_t, 3> coordinates(std::int32_t voxel) const {
    return {voxel % n[0], voxel / n[0] % n[1], voxel / n[0] / n[1]};
  }
};

constexpr double sample_distance = 0.35;  // in cells

inline double longest_edge(const std::array<Point, 3>& t) {
  return std::sqrt(std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()}));
}

// Calls visit(point) all over a triangle given in cells, corners included, at most sample_distance apart. Large ones
// are halved and what leaves the grid is dropped, so that a triangle as long as numbers go ends as well.
template <class Visit>
void for_each_sample(const VoxelGrid& grid, const std::array<Point, 3>& t, const Visit& visit) {
  for (int a = 0; a < 3; ++a) {
    if (std::max({t[0][a], t[1][a], t[2][a]}) < 1 || std::min({t[0][a], t[1][a], t[2][a]}) > nth(grid.n, a) - 1) return;
  }
  const double longest = longest_edge(t);
  if (longest > 32) {
    std::size_t k = 0;
    while (k < 2 && (t[(k + 1) % 3] - t[k]).norm() < longest) ++k;
    const Point middle = t[k] / 2 + t[(k + 1) % 3] / 2;
    for_each_sample(grid, {t[k], middle, t[(k + 2) % 3]}, visit);
    for_each_sample(grid, {middle, t[(k + 1) % 3], t[(k + 2) % 3]}, visit);
    return;
  }
  const int steps = std::max(1, static_cast<int>(std::ceil(longest / sample_distance)));
  const Point u = (t[1] - t[0]) / steps, v = (t[2] - t[0]) / steps;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) visit(Point(t[0] + i * u + j * v));
  }
}

}  // namespace rigless::detail
