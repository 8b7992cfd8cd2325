// The maps of a solid's nodes as a graphics card takes them.
#pragma once

#include <array>

#include "rigless/mesh/solid.h"

namespace rigless::detail {

// Rows of (B | b): a point x that the node takes along goes to B x + b.
template <class S>
using NodeMap = std::array<S, 12>;

// The map of a node that rests at `rest`, then turned and moved. No allocation.
template <class S>
NodeMap<S> node_map(const NodeTransform<S>& t, const Vec3<S>& rest, const Mat3<S>& turn, const Vec3<S>& move) {
  const Mat3<S> B = turn * t.A;
  const Vec3<S> b = turn * t.p + move - B * rest;
  NodeMap<S> map;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) nth(map, 4 * row + column) = B(row, column);
    nth(map, 4 * row + 3) = b[row];
  }
  return map;
}

// Of all N nodes. No allocation.
template <class S>
void node_maps(const Solid<S>& solid, Span<const NodeTransform<S>> transforms, const Mat3<S>& turn,
               const Vec3<S>& move, Span<NodeMap<S>> out) {
  for (std::size_t n = 0; n < out.size(); ++n) out[n] = node_map<S>(transforms[n], solid.rest[n], turn, move);
}

}  // namespace rigless::detail
