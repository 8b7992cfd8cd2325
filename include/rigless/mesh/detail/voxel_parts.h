// Parts of a model that must not grow together where they touch or cross: an arm and the trunk beside which it hangs.
#pragma once

#include "rigless/mesh/detail/voxel_elements.h"

namespace rigless::detail {

// The part of each element: that of its surface, and of an inside that of the surface which it is first met behind, by
// steps over faces. Allocates.
RIGLESS_COLD inline std::vector<std::int32_t> find_parts(const Voxels& voxels, const Pieces& pieces,
                                                         const Elements& elements) {
  std::vector<std::int32_t> part(elements.voxel.size(), no_part), front, next;
  for (std::int32_t e = 0; e < count_of(elements.voxel); ++e) {
    for (const std::int32_t p : elements.pieces_of(e)) join_part(nth(part, e), nth(pieces.piece, p).part);
    if (nth(part, e) != no_part) front.push_back(e);
  }
  const auto stride = voxels.grid.strides();
  for (; !front.empty(); front.swap(next)) {
    next.clear();
    for (const std::int32_t e : front) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {-1, 1}) {
          const std::int32_t v = nth(elements.voxel, e) + sign * nth(stride, axis);
          if (nth(voxels.kind, v) != Voxel::inside) continue;
          std::int32_t& inside = nth(part, nth(elements.first, v));
          if (inside != no_part || !lies_behind(pieces, elements.pieces_of(e), sign * Point::Unit(axis))) continue;
          inside = nth(part, e);
          next.push_back(nth(elements.first, v));
        }
      }
    }
  }
  for (std::int32_t& own : part) own = own == no_part ? any_part : own;
  return part;
}

}  // namespace rigless::detail
