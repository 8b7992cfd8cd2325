// The limbs that leave the trunk of a solid.
#pragma once

#include <vector>

#include "rigless/mesh/detail/limb.h"
#include "rigless/retarget/detail/rests_on_ground.h"
#include "rigless/scene/detail/limb_nodes.h"

namespace rigless::detail {

// How long a limb is for its thickness: its squared length over its usual cross-section. 0 of a limb that is not known.
template <class S>
S slenderness(const Limb<S>& limb, S cell) {
  return limb.length > S(0) ? limb.length * limb.length / std::max(limb.girth * cell, S(1e-6)) : S(0);
}

// A limb that is hardly longer than it is thick has no bones.
template <class S>
bool is_stump(const Limb<S>& limb, S cell) {
  return limb.length > S(0) && slenderness(limb, cell) < S(2.5);
}

// Whether a limb stands: its tip is on the ground, almost as far below its base as it is away. floor: y of the lowest
// vertex at rest; height: of the mesh.
template <class S>
bool is_leg(const Limb<S>& limb, const Vec3<S>& tip, S floor, S height) {
  return limb.length > S(0) && rests_on_ground(tip, floor, height) &&
         limb.base.y() - tip.y() > S(0.8) * (limb.base - tip).norm();
}

// C: limbs that are known, but none that would tear at the body: of whose outer half more than a fifth has grown
// together with it. Legs may. Allocates.
template <class S>
RIGLESS_COLD std::vector<Limb<S>> known_limbs(const Solid<S>& solid, Span<const Control<S>> controls,
                                              Span<const Vec3<S>> rest, const TrunkShape<S>& trunk, S ground) {
  std::vector<Limb<S>> limbs(controls.size());
  std::vector<LimbBones<S>> bones;
  for (std::size_t c = 0; c < controls.size(); ++c) {
    const Control<S>& control = controls[c];
    if (!control.on_limb || nth(solid.element_of, control.vertex) < 0) continue;
    limbs[c].base = control.base;
    limbs[c].middle = control.bend;
    limbs[c].length = (control.bend - control.base).norm() + (rest[c] - control.bend).norm();
    bones.push_back(limb_bones(solid, limbs[c], controls, c, rest[c]));
  }
  const std::vector<S> grown = grown_together<S>(solid, bones, trunk);
  for (std::size_t k = 0; k < bones.size(); ++k)
    if (grown[k] > S(0.2) && bones[k].tip.y() > ground) nth(limbs, bones[k].control) = {};
  return limbs;
}

// Makes unlike limbs like each other whose tips are mirror images: the longer one is better seen, if it stays on its
// side.
template <class S>
RIGLESS_COLD void match_pairs(Span<const Vec3<S>> tips, S height, Span<Limb<S>> limbs) {
  const S near = S(0.1) * height;
  for (std::size_t a = 0; a < limbs.size(); ++a) {
    for (std::size_t b = 0; b < limbs.size(); ++b) {
      const Vec3<S> away = tips[a] - tips[b];
      const S middle = (tips[a].x() + tips[b].x()) / S(2);
      const bool alike = away.x() > S(4) * near && std::hypot(away.y(), away.z()) < near && std::abs(middle) < near;
      if (!alike || !(limbs[a].length > S(0) && limbs[b].length > S(0))) continue;
      const auto strays = [&](std::size_t c) { return (limbs[c].base.x() - middle) * (tips[c].x() - middle) <= S(0); };
      const bool first = strays(b) || (!strays(a) && limbs[a].length > limbs[b].length);
      const Limb<S>& better = first ? limbs[a] : limbs[b];
      const S unlike = std::min(limbs[a].length, limbs[b].length) / std::max(limbs[a].length, limbs[b].length);
      if (strays(first ? a : b) || (unlike > S(0.8) && !strays(first ? b : a))) continue;
      Limb<S> image = better;
      image.base.x() = S(2) * middle - better.base.x();
      image.middle.x() = S(2) * middle - better.middle.x();
      (first ? limbs[b] : limbs[a]) = image;
    }
  }
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
  S ground = std::numeric_limits<S>::max();
  for (const Vec3<S>& p : solid.rest) ground = std::min(ground, p.y());
  ground += S(0.15) * height;  // what is below stands
  const std::vector<Limb<S>> known = known_limbs(solid, controls, rest, trunk, ground);
  std::vector<Limb<S>> limbs(controls.size());
  for (std::size_t c = 0; c < controls.size(); ++c) {
    const std::int32_t element = nth(solid.element_of, controls[c].vertex);
    if (element < 0 || controls[c].slab) continue;
    const std::int32_t tip = nth(solid.element, element)[0];
    if (trunk.radius > S(0)) {
      constexpr S sudden = 4;  // a sleeve is less
      limbs[c] = find_limb(graph, tip, S(0.7) * height, sudden, [&](const Vec3<S>& p) { return trunk.holds(p); });
    }
    if (!(limbs[c].length > S(0))) limbs[c] = find_limb(graph, tip, S(0.7) * height);
  }
  match_pairs<S>(rest, height, limbs);
  for (std::size_t c = 0; c < controls.size(); ++c) {
    const bool is_seen = limbs[c].girth > S(0) && !is_stump(limbs[c], solid.cell);
    if (known[c].length > S(0) && !(is_seen && rest[c].y() <= ground)) limbs[c] = known[c];
  }
  return limbs;
}

}  // namespace rigless::detail
