// Bodies built of blocks: a closed surface of unit squares, two triangles each.
#pragma once

#include <array>
#include <map>
#include <set>
#include <vector>

#include "rigless/math/types.h"

namespace rigless {

using Cell = std::array<int, 3>;

struct Block {
  Cell low, high;  // whole numbers, high left out
};

template <class S>
struct BlockBody {
  std::vector<Vec3<S>> vertices;
  std::vector<Face> faces;
};

// The surface of the union of blocks.
template <class S>
BlockBody<S> build_blocks(const std::vector<Block>& blocks) {
  std::set<Cell> solid;
  for (const Block& b : blocks)
    for (int x = b.low[0]; x < b.high[0]; ++x)
      for (int y = b.low[1]; y < b.high[1]; ++y)
        for (int z = b.low[2]; z < b.high[2]; ++z) solid.insert({x, y, z});
  BlockBody<S> body;
  std::map<Cell, std::int32_t> corner_of;
  const auto corner = [&](const Cell& c) {
    const auto [it, fresh] = corner_of.insert({c, static_cast<std::int32_t>(body.vertices.size())});
    if (fresh) body.vertices.push_back(Vec3<S>(S(c[0]), S(c[1]), S(c[2])));
    return it->second;
  };
  for (const Cell& cell : solid) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const int end : {0, 1}) {
        Cell beside = cell;
        beside[k] += end == 1 ? 1 : -1;
        if (solid.count(beside) != 0) continue;
        const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
        Cell a = cell, b, c, d;
        a[k] += end;
        b = c = d = a;
        b[u]++;
        c[u]++;
        c[v]++;
        d[v]++;
        if (end == 0) std::swap(b, d);
        body.faces.push_back({corner(a), corner(b), corner(c)});
        body.faces.push_back({corner(a), corner(c), corner(d)});
      }
    }
  }
  return body;
}

// Seen in the product's axes: y up, facing +z, left at +x.
inline const std::vector<Block> block_human = {
    {{-4, 0, -1}, {-1, 2, 5}},    {{1, 0, -1}, {4, 2, 5}},  // feet, whose toes are in front
    {{-4, 2, -1}, {-1, 16, 2}},   {{1, 2, -1}, {4, 16, 2}},   {{-4, 16, -2}, {4, 30, 2}}, {{4, 27, -1}, {16, 30, 2}},
    {{-16, 27, -1}, {-4, 30, 2}}, {{-1, 30, -1}, {1, 33, 1}}, {{-3, 33, -3}, {3, 40, 4}}};

inline const std::vector<Block> block_dog = {{{-5, 0, 10}, {-2, 12, 13}},   {{2, 0, 10}, {5, 12, 13}},
                                             {{-5, 0, -13}, {-2, 12, -10}}, {{2, 0, -13}, {5, 12, -10}},
                                             {{-5, 12, -13}, {5, 21, 13}},  {{-2, 19, 13}, {2, 27, 17}},
                                             {{-3, 24, 14}, {3, 31, 24}},   {{-1, 18, -25}, {1, 20, -13}}};

}  // namespace rigless
