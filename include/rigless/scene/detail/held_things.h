// What hangs on a limb and on nothing else: a sword in a hand, a bell of a sleeve, the toe of a long shoe.
#pragma once

#include <algorithm>
#include <vector>

#include "rigless/scene/detail/limb_nodes.h"

namespace rigless::detail {

// Nodes that no limb is near and whose way to the trunk leads over one limb alone, or that are known to be of its part,
// each as far along that limb as the nearest place where they hang on it. None where the trunk is not known. Allocates.
template <class S>
RIGLESS_COLD std::vector<LimbNode<S>> find_held_things(const Solid<S>& solid, Span<const LimbBones<S>> limbs,
                                                       const TrunkShape<S>& trunk, S most) {
  std::vector<LimbNode<S>> held;
  if (!(trunk.radius > S(0)) || limbs.empty()) return held;
  const std::vector<std::int32_t> owners = nearest_limbs(solid, limbs, trunk, most);
  const auto known = [&](std::int32_t node) {  // which limb's part a node is of, or -1
    const std::int32_t part = nth(solid.part, node);
    for (std::int32_t k = 0; k < count_of(limbs); ++k)
      if (part > 0 && part != any_part && nth(solid.part, nth(limbs, k).node) == part) return k;
    return std::int32_t{-1};
  };
  std::vector<char> seen(solid.rest.size(), 0);
  std::vector<std::int32_t> piece;
  for (std::int32_t start = 0; start < count_of(solid.rest); ++start) {
    if (nth(owners, start) >= 0 || nth(seen, start) != 0) continue;
    piece.assign(1, start);
    nth(seen, start) = 1;
    const std::int32_t part = known(start);
    std::int32_t on = part;
    S along = most;
    bool free = true;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      free = free && (part >= 0 || !trunk.holds(nth(solid.rest, piece[k])));
      const auto i = to_size(piece[k]);
      for (std::int32_t e = solid.ring.first[i]; e < solid.ring.first[i + 1]; ++e) {
        const std::int32_t j = nth(solid.ring.neighbor, e), owner = nth(owners, j);
        if (owner >= 0 && (part < 0 || part == owner)) {
          free = free && (on < 0 || on == owner);
          on = owner;
          along = std::min(along, nth(limbs, owner).place(nth(solid.rest, j)).along);
        } else if (owner < 0 && nth(seen, j) == 0 && known(j) == part) {
          nth(seen, j) = 1;
          piece.push_back(j);
        }
      }
    }
    if (!free || on < 0) continue;
    for (const std::int32_t node : piece) held.push_back({node, on, along});
  }
  return held;
}

}  // namespace rigless::detail
