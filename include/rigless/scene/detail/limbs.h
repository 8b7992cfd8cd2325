// The limbs that leave the trunk of a solid.
#pragma once

#include <vector>

#include "rigless/mesh/detail/limb.h"
#include "rigless/scene/detail/trunk_shape.h"

namespace rigless::detail {

// A limb that is not several times as long as it is thick.
template <class S>
bool is_stump(const Limb<S>& limb, S cell) {
  return limb.length > S(0) && limb.length * limb.length < S(6) * limb.girth * cell;
}

// C: the limb at whose tip each control lies, whatever shells it is made of; none where a slab is. height: of the body,
// in the mesh's units. Allocates.
template <class S>
RIGLESS_COLD std::vector<Limb<S>> find_limbs(const Solid<S>& solid, Span<const Control<S>> controls,
                                             Span<const Vec3<S>> rest, S height) {
  SurfaceGraph<S> graph;
  graph.position = solid.rest;
  graph.ring = solid.ring;
  graph.area.assign(solid.rest.size(), solid.cell * solid.cell);
  const TrunkShape<S> trunk = find_trunk(solid, controls, rest);
  std::vector<Limb<S>> limbs;
  for (const Control<S>& control : controls) {
    const std::int32_t element = nth(solid.element_of, control.vertex);
    limbs.emplace_back();
    if (element < 0 || control.slab) continue;
    const std::int32_t tip = nth(solid.element, element)[0];
    if (trunk.radius > S(0)) {
      constexpr S sudden = 4;  // a sleeve is less
      limbs.back() = find_limb(graph, tip, S(0.7) * height, sudden, [&](const Vec3<S>& p) { return trunk.holds(p); });
    }
    if (!(limbs.back().length > S(0))) limbs.back() = find_limb(graph, tip, S(0.7) * height);
  }
  return limbs;
}

}  // namespace rigless::detail
