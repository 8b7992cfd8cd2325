// What controls hold of a solid: a ball of nodes around a point of the model, or a slab across its trunk.
#pragma once

#include <algorithm>
#include <limits>

#include "rigless/deform/detail/control.h"
#include "rigless/deform/detail/discs.h"
#include "rigless/mesh/solid.h"

namespace rigless::detail {

// Fewer cells than this, and a control would bend the cell that carries its own vertex.
inline constexpr double cells_of_ball = 2;
// A slab ends this many radii from its control: it goes through the trunk, not along an arm that hangs beside it.
inline constexpr double radii_of_slab = 4;

// Errors: no_controls; index_out_of_range (where: control, also for a vertex that no element carries).
template <class S>
Status check_controls(const Solid<S>& solid, Span<const Control<S>> controls) {
  if (controls.empty()) return {Error::no_controls, -1};
  for (std::size_t c = 0; c < controls.size(); ++c) {
    const std::int32_t v = controls[c].vertex;
    if (v < 0 || to_size(v) >= solid.element_of.size() || nth(solid.element_of, v) < 0)
      return {Error::index_out_of_range, c};
  }
  return {};
}

// Nodes that are connected with the control's element inside its ball or slab; y is up. A node belongs to the nearest
// control. rest: V, the model's vertices; controls: checked; on_limb: N, not 0 for nodes that no slab takes; in_hand:
// N, a control that holds a node wherever it is, or -1. Allocates.
template <class S>
RIGLESS_COLD Discs<S> make_solid_pieces(const Solid<S>& solid, Span<const Vec3<S>> rest,
                                        Span<const Control<S>> controls, Span<const char> on_limb,
                                        Span<const std::int32_t> in_hand) {
  Discs<S> discs;
  discs.owner.assign(solid.rest.size(), -1);
  std::vector<S> nearest(solid.rest.size(), std::numeric_limits<S>::max());
  std::vector<std::int32_t> seen(solid.rest.size(), -1), queue;
  for (std::size_t c = 0; c < controls.size(); ++c) {
    const auto self = static_cast<std::int32_t>(c);
    const Vec3<S> center = nth(rest, controls[c].vertex);
    discs.center.push_back(center);
    const S radius = std::max(controls[c].radius, static_cast<S>(cells_of_ball) * solid.cell);
    const auto holds = [&](const Vec3<S>& p) {
      const Vec3<S> away = p - center;
      if (!controls[c].slab) return away.squaredNorm() <= radius * radius;
      return std::abs(away.y()) <= radius && away.norm() <= static_cast<S>(radii_of_slab) * radius;
    };
    const auto take = [&](std::int32_t node, S distance) {
      if (nth(seen, node) == self) return;
      nth(seen, node) = self;
      queue.push_back(node);
      if (distance >= nth(nearest, node)) return;
      nth(nearest, node) = distance;
      nth(discs.owner, node) = self;
    };
    queue.clear();
    // its own element first: what carries the control's vertex is held whole
    for (const std::int32_t node : nth(solid.element, nth(solid.element_of, controls[c].vertex))) take(node, S(0));
    for (std::size_t k = 0; k < queue.size(); ++k) {
      const auto i = to_size(queue[k]);
      for (std::int32_t e = solid.ring.first[i]; e < solid.ring.first[i + 1]; ++e) {
        const std::int32_t j = nth(solid.ring.neighbor, e);
        const Vec3<S>& p = nth(solid.rest, j);
        if (nth(in_hand, j) == self) take(j, S(0));
        if (holds(p) && !(controls[c].slab && nth(on_limb, j) != 0)) take(j, (p - center).norm());
      }
    }
  }
  list_members(discs);
  return discs;
}

}  // namespace rigless::detail
