// A control along a line on the surface: the vertices between a few knots follow a smooth curve through them.
#pragma once

#include <algorithm>

#include "rigless/deform/detail/control.h"
#include "rigless/deform/detail/discs.h"

namespace rigless {

// K knots drive P path vertices. Each path vertex moves by a fixed blend of what its knots move, so that targets cost a
// few multiplications; the blend is a cubic through the knots, in the path's own arc length.
// Source: curves as controls, the thesis' future work, after Zhou et al. 2005; Catmull and Rom 1974, non-uniform.
template <class S>
class CurveControl {
 public:
  // Runs the path through the knots (K >= 2 vertices, in order) along the edges of `cells`. Allocates. On failure the
  // old path stays. Errors: no_controls (fewer than 2 knots); index_out_of_range (knot);
  // infeasible (knot k cannot be reached from the one before it, or is the same vertex).
  Status bind(const Cells<S>& cells, Span<const std::int32_t> knots);

  // One control for each path vertex, of that vertex alone: to be given to the deformer among its others. Allocates.
  std::vector<Control<S>> controls() const;

  // Where the path goes when the knots go to `knots` (K): P targets in the order of controls(). No allocation.
  void targets(Span<const Vec3<S>> knots, Span<Vec3<S>> out) const;

  std::size_t knot_count() const { return knot_rest_.size(); }
  std::size_t size() const { return path_.size(); }
  const std::vector<std::int32_t>& path() const { return path_; }

 private:
  struct Blend {
    std::int32_t first = 0;  // knot
    S weight[4] = {};        // of knots first .. first + 3, clipped to those that exist
  };

  std::vector<std::int32_t> path_;  // P vertices
  std::vector<Vec3<S>> rest_;       // P
  std::vector<Vec3<S>> knot_rest_;  // K
  std::vector<Blend> blend_;        // P
};

namespace detail {

// Vertices of the shortest edge path from a to b, both included; empty when there is none. Source: Dijkstra 1959.
template <class S>
std::vector<std::int32_t> shortest_path(const Cells<S>& cells, std::int32_t a, std::int32_t b) {
  const auto reached = vertices_within<S>(cells.rest, cells.ring, b, std::numeric_limits<S>::max());
  std::vector<S> distance(cells.size(), std::numeric_limits<S>::max());
  for (const auto& g : reached) nth(distance, g.vertex) = g.distance;
  if (!(nth(distance, a) < std::numeric_limits<S>::max())) return {};
  std::vector<std::int32_t> path = {a};
  while (path.back() != b) {  // downhill; every step is an edge of a shortest path
    const auto i = to_size(path.back());
    std::int32_t best = -1;
    S shortest = std::numeric_limits<S>::max();
    for_each_edge(cells, i, [&](S, const Vec3<S>& e, std::size_t j) {
      const S through = distance[j] + e.norm();
      if (distance[j] < distance[i] && through < shortest) {
        shortest = through;
        best = static_cast<std::int32_t>(j);
      }
    });
    if (best < 0) return {};
    path.push_back(best);
  }
  return path;
}

}  // namespace detail

template <class S>
Status CurveControl<S>::bind(const Cells<S>& cells, Span<const std::int32_t> knots) {
  if (knots.size() < 2) return {Error::no_controls, -1};
  std::vector<std::int32_t> path;
  std::vector<S> knot_at(knots.size(), S(0)), at;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    if (knots[k] < 0 || to_size(knots[k]) >= cells.size()) {
      return {Error::index_out_of_range, k};
    }
    if (k == 0) {
      path.push_back(knots[0]);
      at.push_back(S(0));
      continue;
    }
    const auto piece = detail::shortest_path(cells, knots[k - 1], knots[k]);
    if (piece.size() < 2) return {Error::infeasible, k};
    for (std::size_t p = 1; p < piece.size(); ++p) {
      const S length = (nth(cells.rest, piece[p]) - nth(cells.rest, path.back())).norm();
      at.push_back(at.back() + length);
      path.push_back(piece[p]);
    }
    knot_at[k] = at.back();
  }

  std::vector<Blend> blends;
  std::size_t segment = 0;
  const auto last = knots.size() - 1;
  for (std::size_t p = 0; p < path.size(); ++p) {
    while (segment + 1 < last && at[p] > knot_at[segment + 1]) ++segment;
    const S h = knot_at[segment + 1] - knot_at[segment];
    const S u = h > S(0) ? (at[p] - knot_at[segment]) / h : S(0);
    const S u2 = u * u, u3 = u2 * u;
    Blend b;
    b.first = static_cast<std::int32_t>(segment) - 1;
    b.weight[1] = S(2) * u3 - S(3) * u2 + S(1);
    b.weight[2] = S(3) * u2 - S(2) * u3;
    // tangents: the slope between the neighbours, one-sided at the ends
    const auto tangent = [&](std::size_t knot, S factor) {
      const std::size_t before = knot == 0 ? 0 : knot - 1, after = std::min(knot + 1, last);
      const S slope = factor * h / (knot_at[after] - knot_at[before]);
      b.weight[after + 1 - segment] += slope;
      b.weight[before + 1 - segment] -= slope;
    };
    tangent(segment, u3 - S(2) * u2 + u);
    tangent(segment + 1, u3 - u2);
    blends.push_back(b);
  }
  path_ = std::move(path);
  blend_ = std::move(blends);
  rest_.clear();
  knot_rest_.clear();
  for (const std::int32_t v : path_) rest_.push_back(nth(cells.rest, v));
  for (const std::int32_t v : knots) knot_rest_.push_back(nth(cells.rest, v));
  return {};
}

template <class S>
std::vector<Control<S>> CurveControl<S>::controls() const {
  std::vector<Control<S>> out;
  for (const std::int32_t v : path_) out.push_back({v, S(0)});
  return out;
}

template <class S>
void CurveControl<S>::targets(Span<const Vec3<S>> knots, Span<Vec3<S>> out) const {
  RIGLESS_ASSERT(knots.size() == knot_rest_.size() && out.size() == path_.size());
  for (std::size_t p = 0; p < path_.size(); ++p) {
    out[p] = rest_[p];
    for (int k = 0; k < 4; ++k) {
      const std::int32_t knot = blend_[p].first + k;
      if (blend_[p].weight[k] == S(0)) continue;
      out[p] += blend_[p].weight[k] * (nth(knots, knot) - nth(knot_rest_, knot));
    }
  }
}

}  // namespace rigless
