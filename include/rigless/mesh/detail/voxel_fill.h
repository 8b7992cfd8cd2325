// What is inside of a surface that may have holes.
#pragma once

#include "rigless/mesh/detail/voxel_grid.h"

namespace rigless::detail {

enum class Voxel : std::uint8_t { inside, surface, outside };

// Marks all that hangs together over faces with `seeds` and may be entered; calls enter(voxel) once for each.
template <class May, class Enter>
void flood(const VoxelGrid& grid, std::vector<std::int32_t> seeds, const May& may, const Enter& enter) {
  const auto stride = grid.strides();
  while (!seeds.empty()) {
    const std::int32_t v = seeds.back();
    seeds.pop_back();
    const auto at = grid.coordinates(v);
    for (std::size_t a = 0; a < 3; ++a) {
      for (const int way : {-1, 1}) {
        if (at[a] + way < 0 || at[a] + way >= grid.n[a]) continue;
        const std::int32_t w = v + way * stride[a];
        if (!may(w)) continue;
        enter(w);
        seeds.push_back(w);
      }
    }
  }
}

// Calls visit(neighbour) for the 26 around a voxel that are in the grid.
template <class Visit>
void for_each_around(const VoxelGrid& grid, std::int32_t voxel, const Visit& visit) {
  const auto at = grid.coordinates(voxel);
  const auto stride = grid.strides();
  for (std::int32_t z = -1; z <= 1; ++z) {
    for (std::int32_t y = -1; y <= 1; ++y) {
      for (std::int32_t x = -1; x <= 1; ++x) {
        const std::array<std::int32_t, 3> d = {x, y, z};
        bool in = x != 0 || y != 0 || z != 0;
        for (std::size_t a = 0; a < 3; ++a) in = in && at[a] + d[a] >= 0 && at[a] + d[a] < grid.n[a];
        if (in) visit(voxel + x + y * stride[1] + z * stride[2]);
      }
    }
  }
}

// Surface voxels are given; what the outside reaches becomes outside. A hole that only a single voxel passes lets the
// outside into a room where one voxel stands free all around: such a room is inside. A room without one is a gap, and
// open. Allocates.
RIGLESS_COLD inline void fill_inside(const VoxelGrid& grid, std::vector<Voxel>& voxel) {
  constexpr char near = 1, wide = 2, seen = 4;
  std::vector<char> mark(voxel.size(), 0);
  const auto outside = [&](std::int32_t v) { return nth(voxel, v) == Voxel::outside; };
  nth(voxel, 0) = Voxel::outside;  // a corner of the outermost layer
  flood(
      grid, {0}, [&](std::int32_t v) { return nth(voxel, v) == Voxel::inside; },
      [&](std::int32_t v) { nth(voxel, v) = Voxel::outside; });
  for (std::int32_t v = 0; v < grid.size(); ++v) {
    if (nth(voxel, v) == Voxel::surface) for_each_around(grid, v, [&](std::int32_t w) { nth(mark, w) |= near; });
  }
  // the outermost layer is all outside, but its voxels may be near
  std::vector<std::int32_t> reached;
  const auto enter_wide = [&](std::int32_t v) {
    nth(mark, v) |= wide;
    reached.push_back(v);
  };
  std::vector<std::int32_t> seeds;
  for (std::int32_t v = 0; v < grid.size(); ++v) {
    const auto at = grid.coordinates(v);
    bool border = false;
    for (std::size_t a = 0; a < 3; ++a) border = border || at[a] == 0 || at[a] == grid.n[a] - 1;
    if (!border) continue;
    seeds.push_back(v);
    enter_wide(v);
  }
  flood(
      grid, seeds, [&](std::int32_t v) { return outside(v) && (nth(mark, v) & (near | wide)) == 0; }, enter_wide);
  for (const std::int32_t v : std::vector<std::int32_t>(std::move(reached))) {
    for_each_around(grid, v, [&](std::int32_t w) { nth(mark, w) |= wide; });
  }
  for (std::int32_t v = 0; v < grid.size(); ++v) {
    if (!outside(v) || (nth(mark, v) & (wide | seen)) != 0) continue;
    std::vector<std::int32_t> room = {v};
    nth(mark, v) |= seen;
    flood(
        grid, {v}, [&](std::int32_t w) { return outside(w) && (nth(mark, w) & (wide | seen)) == 0; },
        [&](std::int32_t w) {
          nth(mark, w) |= seen;
          room.push_back(w);
        });
    if (!std::any_of(room.begin(), room.end(), [&](std::int32_t w) { return (nth(mark, w) & near) == 0; })) continue;
    for (const std::int32_t w : room) nth(voxel, w) = Voxel::inside;
  }
}

}  // namespace rigless::detail
