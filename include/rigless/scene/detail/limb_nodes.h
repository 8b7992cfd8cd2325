// Which nodes of a solid a limb turns, and how far from its tip each is.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "rigless/deform/detail/control.h"
#include "rigless/mesh/detail/geodesic.h"
#include "rigless/mesh/detail/limb.h"
#include "rigless/scene/detail/trunk_shape.h"

namespace rigless::detail {

// A limb as two bones.
template <class S>
struct LimbBones {
  std::int32_t control, node;  // at its tip
  Vec3<S> base, bend, tip;
  S thickness;  // half of it

  struct Place {
    S along;     // 0 at the tip and beyond, .5 at the bend, 1 at the base, more in the trunk
    S distance;  // from the bones
  };

  Place place(const Vec3<S>& p) const {
    const Place lower = on_bone(p, tip, bend, false), upper = on_bone(p, bend, base, true);
    return lower.distance <= upper.distance ? Place{lower.along / S(2), lower.distance}
                                            : Place{(S(1) + upper.along) / S(2), upper.distance};
  }

 private:
  // A share of the bone from a to b; one that goes on beyond b.
  static Place on_bone(const Vec3<S>& p, const Vec3<S>& a, const Vec3<S>& b, bool goes_on) {
    const Vec3<S> way = b - a;
    const S share = std::max((p - a).dot(way) / std::max(way.squaredNorm(), S(1e-12)), S(0));
    const S along = goes_on ? share : std::min(share, S(1));
    return {along, (p - a - along * way).norm()};
  }
};

template <class S>
struct LimbNode {
  std::int32_t node, limb;  // which of the bones
  S along;
};

// Half as thick as it mostly is: a quarter of what is in a rod is within half of its radius.
template <class S>
RIGLESS_COLD S limb_thickness(const Solid<S>& solid, const LimbBones<S>& bones) {
  const S length = (bones.tip - bones.bend).norm() + (bones.bend - bones.base).norm();
  std::vector<S> distances;
  for (const auto& [node, way] : vertices_within<S>(solid.rest, solid.ring, bones.node, length)) {
    const auto at = bones.place(nth(solid.rest, node));
    if (at.along > S(0.15) && at.along < S(0.85) && at.distance < length / S(2)) distances.push_back(at.distance);
  }
  if (distances.empty()) return solid.cell;
  const auto quarter = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 4);
  std::nth_element(distances.begin(), quarter, distances.end());
  return std::max(S(2) * *quarter, solid.cell);
}

// The bones of a limb at whose tip control c lies, which rests at `tip`. Allocates.
template <class S>
RIGLESS_COLD LimbBones<S> limb_bones(const Solid<S>& solid, const Limb<S>& limb, Span<const Control<S>> controls,
                                     std::size_t c, const Vec3<S>& tip) {
  const std::int32_t node = nth(solid.element, nth(solid.element_of, controls[c].vertex))[0];
  LimbBones<S> bones{static_cast<std::int32_t>(c), node, limb.base, limb.middle, tip, S(0)};
  bones.thickness = limb_thickness(solid, bones);
  return bones;
}

// How near, as it is thick, each of some bones is to a place: less than 3, or it is far from all.
template <class S>
struct NearestLimb {
  std::int32_t limb = -1;  // which of the bones; -1: the trunk, or none
  S near = S(3);
};

template <class S>
NearestLimb<S> nearest_limb(Span<const LimbBones<S>> limbs, const TrunkShape<S>& trunk, const Vec3<S>& p, S most,
                            std::int32_t without = -1) {
  NearestLimb<S> nearest;
  const S of_trunk = trunk.radius > S(0) ? trunk.distance(p) / trunk.radius : nearest.near;
  nearest.near = std::min(nearest.near, of_trunk * of_trunk);  // corners of an arm are farther out than it is thick
  for (std::int32_t k = 0; k < count_of(limbs); ++k) {
    const auto at = nth(limbs, k).place(p);
    const S near = at.distance / nth(limbs, k).thickness;
    if (k != without && at.along <= most && near < nearest.near) nearest = {k, near};
  }
  return nearest;
}

// N: the nearest limb of each node, or -1: among those that it can be of, if it is known to be of a part. Allocates.
template <class S>
RIGLESS_COLD std::vector<std::int32_t> nearest_limbs(const Solid<S>& solid, Span<const LimbBones<S>> limbs,
                                                     const TrunkShape<S>& trunk, S most) {
  std::vector<std::int32_t> nearest;
  for (std::int32_t i = 0; i < solid.nodes(); ++i) {
    const Vec3<S>& p = nth(solid.rest, i);
    std::int32_t own = nearest_limb(limbs, trunk, p, most).limb;
    const std::int32_t part = nth(solid.part, i);
    const auto part_of = [&](std::int32_t k) { return nth(solid.part, nth(limbs, k).node); };
    if (own >= 0 && part != any_part && part_of(own) > 0 && part_of(own) != std::abs(part)) own = -1;
    for (std::int32_t k = 0; k < count_of(limbs); ++k) {
      const auto at = nth(limbs, k).place(p);
      if (part > 0 && part == part_of(k) && at.along <= most && at.distance < S(3) * nth(limbs, k).thickness) own = k;
    }
    nearest.push_back(own);
  }
  return nearest;
}

// Nodes that hang together with a limb's tip and are nearer to it, as it is thick, than to any other and to the trunk;
// up to `most` along it. Allocates.
template <class S>
RIGLESS_COLD std::vector<LimbNode<S>> find_limb_nodes(const Solid<S>& solid, Span<const LimbBones<S>> limbs,
                                                      const TrunkShape<S>& trunk, S most) {
  std::vector<std::int32_t> owners = nearest_limbs(solid, limbs, trunk, most);
  std::vector<LimbNode<S>> nodes;
  std::vector<std::int32_t> queue;
  for (std::int32_t k = 0; k < count_of(limbs); ++k) {
    const LimbBones<S>& limb = nth(limbs, k);
    queue.assign(1, limb.node);
    nth(owners, limb.node) = -1;
    for (std::size_t q = 0; q < queue.size(); ++q) {
      nodes.push_back({queue[q], k, limb.place(nth(solid.rest, queue[q])).along});
      const auto i = to_size(queue[q]);
      for (std::int32_t e = solid.ring.first[i]; e < solid.ring.first[i + 1]; ++e) {
        const std::int32_t j = nth(solid.ring.neighbor, e);
        if (nth(owners, j) != k) continue;
        nth(owners, j) = -1;
        queue.push_back(j);
      }
    }
  }
  return nodes;
}

// L: of the outer half of each limb, the share that has grown together with the trunk or another limb: a hand with the
// thigh beside it. Allocates.
template <class S>
RIGLESS_COLD std::vector<S> grown_together(const Solid<S>& solid, Span<const LimbBones<S>> limbs,
                                           const TrunkShape<S>& trunk) {
  constexpr S most = S(1.15);
  std::vector<std::int32_t> owners(solid.rest.size(), -1);
  const std::vector<LimbNode<S>> nodes = find_limb_nodes(solid, limbs, trunk, most);
  for (const LimbNode<S>& one : nodes) nth(owners, one.node) = one.limb;
  std::vector<S> all(limbs.size(), S(0)), grown(limbs.size(), S(0));
  for (const auto& [node, limb, along] : nodes) {
    if (along > S(0.6)) continue;
    nth(all, limb) += S(1);
    const auto i = to_size(node);
    for (std::int32_t e = solid.ring.first[i]; e < solid.ring.first[i + 1]; ++e) {
      const std::int32_t j = nth(solid.ring.neighbor, e);
      if (nth(owners, j) == limb || nearest_limb(limbs, trunk, nth(solid.rest, j), most, limb).near > S(1.5)) continue;
      nth(grown, limb) += S(1);
      break;
    }
  }
  for (std::size_t k = 0; k < limbs.size(); ++k) grown[k] /= std::max(all[k], S(1));
  return grown;
}

}  // namespace rigless::detail
