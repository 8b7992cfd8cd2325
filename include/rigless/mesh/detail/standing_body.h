// A body as it stands: its nodes in heights, left, up from the ground and forward.
#pragma once

#include "rigless/mesh/detail/geodesic.h"
#include "rigless/mesh/detail/limb.h"
#include "rigless/mesh/detail/posture.h"
#include "rigless/mesh/detail/surface_graph.h"

namespace rigless::detail {

template <class S>
struct StandingBody {
  const SurfaceGraph<S>& graph;
  SymmetryPlane<S> plane;
  Posture<S> posture;
  Vec3<S> ground = Vec3<S>::Zero();                       // in the file, seen as the body stands: below its middle
  S tall = S(1);                                          // in the file's units
  S middle = S(0);                                        // as far from the plane is still the middle
  std::vector<Vec3<S>> places;                            // N
  Vec3<S> low = Vec3<S>::Zero(), high = Vec3<S>::Zero();  // of places

  // Keeps the graph. Allocates.
  StandingBody(const SurfaceGraph<S>& of, const Posture<S>& as, const SymmetryPlane<S>& about)
      : graph(of), plane(about), posture(as) {
    for (const Vec3<S>& p : graph.position) places.push_back(posture.see(p));
    const Bounds<S> box = bounds<S>(places);
    tall = std::max(box.height(), S(0.3) * box.diagonal());
    if (!(tall > S(0))) tall = S(1);
    ground = Vec3<S>((box.low.x() + box.high.x()) / S(2), box.low.y(), (box.low.z() + box.high.z()) / S(2));
    for (std::size_t i = 0; i < graph.size(); ++i) places[i] = stand(graph.position[i]);
    middle = std::max(S(0.06) * box.extent().x() / tall, S(0.035));
    low = bounds<S>(places).low;
    high = bounds<S>(places).high;
  }

  // Whether it is longer than high, as what runs on four legs, swims or crawls.
  bool lies() const { return high.z() - low.z() > S(1.2) * (high.y() - low.y()); }

  // Of a place in the file.
  Vec3<S> stand(const Vec3<S>& in_file) const {
    Vec3<S> p = posture.see(in_file) - ground;
    if (symmetric()) p.x() = (posture.see(plane.normal).x() < S(0) ? S(-1) : S(1)) * plane.side(in_file);
    return p / tall;
  }

  bool symmetric() const { return is_symmetric(plane); }
  std::size_t index(const Vec3<S>& p) const { return to_size(&p - places.data()); }
  const Vec3<S>& place(std::int32_t node) const { return nth(places, node); }
  S apart(std::int32_t a, std::int32_t b) const { return (place(a) - place(b)).norm(); }
  std::int32_t side(std::int32_t node) const {
    const S x = place(node).x();
    return std::abs(x) < middle ? 0 : x > S(0) ? 1 : -1;
  }

  Vec3<S> flipped(std::int32_t node) const { return {-place(node).x(), place(node).y(), place(node).z()}; }

  template <class Score>
  std::int32_t best_node(const Score& score) const {
    std::int32_t best = -1;
    S highest = -std::numeric_limits<S>::max();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const S s = score(places[i]);
      if (s <= highest) continue;
      highest = s;
      best = static_cast<std::int32_t>(i);
    }
    return best;
  }

  // The best node in the middle; of a lopsided body, the best at all.
  template <class Score>
  std::int32_t best_middle(const Score& score) const {
    return best_node(
        [&](const Vec3<S>& p) { return score(p) - (symmetric() && std::abs(p.x()) > middle ? S(10) : S(0)); });
  }

  std::int32_t nearest_node(const Vec3<S>& position) const {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < graph.size(); ++i)
      if ((graph.position[i] - position).squaredNorm() < (graph.position[nearest] - position).squaredNorm())
        nearest = i;
    return static_cast<std::int32_t>(nearest);
  }

  // That which ends at a node, up to seven tenths of the body's height long. Allocates.
  Limb<S> limb(std::int32_t node) const { return find_limb(graph, node, S(0.7) * tall); }

  // How far a limb reaches before it is a tube: there what lies within a distance grows no faster than it.
  S thickness(std::int32_t node) const {
    S area = 0;
    std::size_t seen = 0;
    const auto reached = vertices_within<S>(graph.position, graph.ring, node, S(0.3) * tall);
    for (const auto& [other, distance] : reached) {
      area += nth(graph.area, other);
      if (++seen > 12 && S(6.2832) * distance * distance > S(2.6) * area) return distance;
    }
    return S(0.3) * tall;
  }
};

}  // namespace rigless::detail
