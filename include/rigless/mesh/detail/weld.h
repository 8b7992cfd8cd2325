// Files part a vertex wherever colour, normal or picture changes, or give every triangle its own three: what lies at
// one place is one vertex here.
#pragma once

#include <cstring>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"

namespace rigless::detail {

// For each of V vertices the first one at exactly its place. Allocates.
template <class S>
RIGLESS_COLD std::vector<std::int32_t> weld(Span<const Vec3<S>> vertices) {
  std::size_t slots = 16;
  while (slots < 2 * vertices.size()) slots *= 2;
  std::vector<std::int32_t> table(slots, -1), first(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Vec3<S> p = vertices[v] + Vec3<S>::Zero();  // -0 becomes 0
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &p[axis], sizeof(S));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    std::size_t slot = static_cast<std::size_t>(hash) & (slots - 1);
    while (table[slot] >= 0 && nth(vertices, table[slot]) != vertices[v]) slot = (slot + 1) & (slots - 1);
    if (table[slot] < 0) table[slot] = static_cast<std::int32_t>(v);
    first[v] = table[slot];
  }
  return first;
}

}  // namespace rigless::detail
