// Distances along the edges of a surface.
#pragma once

#include <functional>
#include <limits>
#include <queue>

#include "rigless/mesh/detail/one_ring.h"

namespace rigless::detail {

template <class S>
struct GeodesicVertex {
  std::int32_t vertex;
  S distance;
};

// All vertices within `radius` of `source` along edges, nearest first; the source itself at distance 0. Allocates.
// Source: Dijkstra 1959; edge paths overestimate the true distance by some 10 %, which a disc does not mind.
template <class S>
RIGLESS_COLD std::vector<GeodesicVertex<S>> vertices_within(Span<const Vec3<S>> vertices, const OneRing& ring,
                                                            std::int32_t source, S radius) {
  struct Entry {
    S distance;
    std::int32_t vertex;
    bool operator>(const Entry& o) const { return distance != o.distance ? distance > o.distance : vertex > o.vertex; }
  };
  std::vector<S> best(vertices.size(), std::numeric_limits<S>::max());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<GeodesicVertex<S>> reached;
  nth(best, source) = S(0);
  queue.push({S(0), source});
  while (!queue.empty()) {
    const Entry e = queue.top();
    queue.pop();
    const auto i = to_size(e.vertex);
    if (e.distance > best[i]) continue;
    reached.push_back({e.vertex, e.distance});
    for (std::int32_t k = ring.first[i]; k < ring.first[i + 1]; ++k) {
      const std::int32_t j = nth(ring.neighbor, k);
      const S d = e.distance + (nth(vertices, j) - vertices[i]).norm();
      if (d <= radius && d < nth(best, j)) {
        nth(best, j) = d;
        queue.push({d, j});
      }
    }
  }
  return reached;
}

}  // namespace rigless::detail
