// A solid: cubes that are solved in the place of a model, and how a node of it moves.
#pragma once

#include "rigless/mesh/detail/one_ring.h"

namespace rigless {

// N nodes, the corners of E elements, which are cubes at rest. Elements share nodes where they hang together; where two
// sheets of a model nearly touch, each has elements of its own at the same place.
template <class S>
struct Solid {
  S cell = S(0);              // edge of an element
  std::vector<Vec3<S>> rest;  // N
  // E: the node at corner k, which lies (k & 1, k >> 1 & 1, k >> 2 & 1) cells from the corner 0
  std::vector<std::array<std::int32_t, 8>> element;
  std::vector<char> inside;              // E: 1 where no triangle passes
  std::vector<std::int32_t> element_of;  // V: the element that carries a vertex, or -1: it stays where it is
  // The graph that is solved: edges of elements with weight 1, and bridges to parts that float.
  OneRing ring;
  std::vector<S> weight;           // of directed edges, symmetric, above 0
  std::vector<std::int32_t> part;  // N: as SolidOptions have it for vertices, or detail::any_part

  static constexpr S bridge = S(0.02);  // weight of a bridge to what is not near

  std::int32_t nodes() const { return count_of(rest); }
  std::int32_t elements() const { return count_of(element); }
};

// How a node and what is around it have moved: a point near node i goes to p + A (point - rest_i). 12 numbers, A column
// by column and then p, and nothing else.
template <class S>
struct NodeTransform {
  Mat3<S> A;
  Vec3<S> p;
};
static_assert(sizeof(NodeTransform<float>) == 12 * sizeof(float));

}  // namespace rigless
