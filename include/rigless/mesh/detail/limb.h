// A limb of a body: where it leaves the trunk, and how it runs from there to its tip.
#pragma once

#include <algorithm>
#include <vector>

#include "rigless/mesh/detail/surface_graph.h"

namespace rigless::detail {

template <class S>
struct Limb {
  Vec3<S> base = Vec3<S>::Zero();    // middle of the cross section at which it leaves the trunk
  Vec3<S> middle = Vec3<S>::Zero();  // half way along it
  S length = 0;                      // from there along the middles of its cross sections; 0: there is no limb
  S girth = 0;                       // usual length around it
  S reach = 0;                       // from its tip to its base over the nodes, along edges
};

// Follows the surface from `tip`, a node, over as much as lies within `most` of it: what is as far away as each step
// goes around the limb, until the middle of that is in the trunk, or it is much longer than it has been, where the
// trunk begins; so near to the tip that is the hand after a finger. is_trunk: of a position; sudden: how many times as
// long is much longer. Allocates. Source: level sets of the distance from a tip as cross sections, Verroust and Lazarus
// 2000, Extracting skeletal curves from 3D scattered data.
template <class S, class IsTrunk>
RIGLESS_COLD Limb<S> find_limb(const SurfaceGraph<S>& graph, std::int32_t tip, S most, S sudden,
                               const IsTrunk& is_trunk) {
  constexpr std::size_t steps = 24;
  const S step = most / S(steps);
  std::vector<Vec3<S>> middle(steps, Vec3<S>::Zero());
  std::vector<S> area(steps, S(0));
  for (const auto& [node, distance] : vertices_within<S>(graph.position, graph.ring, tip, most)) {
    const auto k = std::min(steps - 1, static_cast<std::size_t>(distance / step));
    const S own = std::max(nth(graph.area, node), std::numeric_limits<S>::min());
    middle[k] += own * nth(graph.position, node);
    area[k] += own;
  }
  Limb<S> limb;
  std::vector<Vec3<S>> path = {nth(graph.position, tip)};
  std::vector<S> around;
  for (std::size_t k = 0; k < steps; ++k) {
    if (!(area[k] > S(0))) continue;
    const S girth = area[k] / step;
    if (is_trunk(Vec3<S>(middle[k] / area[k]))) break;
    if (around.size() >= 3) {
      std::vector<S> sorted = around;
      std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
      limb.girth = sorted[sorted.size() / 2];
      if (girth > sudden * limb.girth) {
        if (S(k) * step > S(0.3) * most) break;
        around.clear();
      }
    }
    around.push_back(girth);
    path.push_back(middle[k] / area[k]);
    limb.reach = (S(k) + S(0.5)) * step;
  }
  limb.base = path.back();
  for (std::size_t k = 1; k < path.size(); ++k) limb.length += (path[k] - path[k - 1]).norm();
  S left = limb.length / S(2);
  for (std::size_t k = path.size() - 1; k > 0; --k) {
    const S way = (path[k] - path[k - 1]).norm();
    limb.middle = path[k] + (way > S(0) ? std::min(S(1), left / way) : S(0)) * (path[k - 1] - path[k]);
    if (way >= left) break;
    left -= way;
  }
  return limb;
}

// The same where no trunk is known.
template <class S>
Limb<S> find_limb(const SurfaceGraph<S>& graph, std::int32_t tip, S most) {
  return find_limb(graph, tip, most, S(1.8), [](const Vec3<S>&) { return false; });
}

}  // namespace rigless::detail
