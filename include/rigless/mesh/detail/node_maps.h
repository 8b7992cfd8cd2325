// How the nodes of a solid move, as a graphics card takes it: without their places at rest.
#pragma once

#include <array>

#include "rigless/mesh/detail/solid_parts.h"

namespace rigless::detail {

// Rows of (B | b): what is near a node goes from x to B x + b.
template <class S>
using NodeMap = std::array<S, 12>;

// Of all N nodes, each then turned and moved. No allocation.
template <class S>
void node_maps(const Solid<S>& solid, Span<const NodeTransform<S>> transforms, const Mat3<S>& turn, const Vec3<S>& move,
               Span<NodeMap<S>> out) {
  RIGLESS_ASSERT(transforms.size() == solid.rest.size() && out.size() == transforms.size());
  for (std::size_t n = 0; n < out.size(); ++n) {
    const Mat3<S> B = turn * transforms[n].A;
    const Vec3<S> b = turn * transforms[n].p + move - B * solid.rest[n];
    for (std::size_t row = 0; row < 3; ++row) {
      const auto r = static_cast<Eigen::Index>(row);
      for (std::size_t column = 0; column < 3; ++column)
        out[n][4 * row + column] = B(r, static_cast<Eigen::Index>(column));
      out[n][4 * row + 3] = b[r];
    }
  }
}

}  // namespace rigless::detail
