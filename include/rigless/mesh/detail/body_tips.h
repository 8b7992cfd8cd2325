// The tips of a body, and which of them are each other's mirror images.
#pragma once

#include "rigless/mesh/detail/extremities.h"
#include "rigless/mesh/detail/standing_body.h"

namespace rigless::detail {

// Where a body ends: a tip of a limb, of an ear, of a tail.
template <class S>
struct Tip {
  std::int32_t node;
  std::int32_t partner;  // tip on the other side, or -1
  bool used;
};

// Makes two of them each other's.
template <class S>
void pair_up(std::vector<Tip<S>>& tips, std::size_t a, std::size_t b) {
  tips[a].partner = static_cast<std::int32_t>(b);
  tips[b].partner = static_cast<std::int32_t>(a);
}

// Both on the ground, on one side, and no farther apart than a foot of a human is long for his height.
template <class S>
bool same_foot(const StandingBody<S>& body, std::int32_t a, std::int32_t b) {
  const Vec3<S>&p = body.place(a), &q = body.place(b);
  return std::max(p.y(), q.y()) < S(0.12) && p.x() * q.x() > S(0) && (p - q).norm() < S(0.24);
}

// Extremities that are no crumbs and not at the same place, and which of them are mirror images.
template <class S>
RIGLESS_COLD std::vector<Tip<S>> find_tips(const StandingBody<S>& body, Span<const S> average) {
  const SurfaceGraph<S>& graph = body.graph;
  std::vector<Tip<S>> tips;
  S area = 0;
  for (const S a : graph.area) area += a;
  for (const Extremity<S>& e : extremities(graph, average, S(0.02) * body.tall)) {
    if (nth(graph.shell_area, e.node) < S(0.01) * area) continue;
    // Two hooves side by side are two; toes and heel of a foot are one.
    const bool near = std::any_of(tips.begin(), tips.end(), [&](const Tip<S>& t) {
      const bool twins = body.place(t.node).x() * body.place(e.node).x() < S(0) &&
                         (body.flipped(t.node) - body.place(e.node)).norm() < S(0.05) &&
                         body.apart(t.node, e.node) > S(0.03);
      return !twins && (body.apart(t.node, e.node) < S(0.12) || same_foot(body, t.node, e.node));
    });
    if (!near && tips.size() < 24) tips.push_back({e.node, -1, false});
  }
  for (std::size_t a = 0; a < tips.size(); ++a) {
    if (tips[a].partner >= 0) continue;
    S nearest = body.side(tips[a].node) == 0 ? S(0.05) : S(0.2);
    for (std::size_t b = a + 1; b < tips.size(); ++b) {
      const S off = (body.flipped(tips[a].node) - body.place(tips[b].node)).norm();
      const bool across = body.place(tips[a].node).x() * body.place(tips[b].node).x() < S(0);
      if (tips[b].partner >= 0 || !across || off >= nearest) continue;
      nearest = off;
      tips[a].partner = static_cast<std::int32_t>(b);
    }
    if (tips[a].partner >= 0) nth(tips, tips[a].partner).partner = static_cast<std::int32_t>(a);
  }
  return tips;
}

}  // namespace rigless::detail
