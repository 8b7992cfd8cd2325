// Where a shape ends: the tips of limbs, horns and tails, and its middle.
#pragma once

#include "rigless/mesh/detail/surface_graph.h"

namespace rigless::detail {

// A tip: `prominence` is how far one must come back towards the middle to reach a farther tip, as with mountains.
template <class S>
struct Extremity {
  std::int32_t node = -1;
  S prominence = S(0);
};

// How far each node lies from the rest of the surface on average: least in the middle of the body, most at its tips.
// From `sources` farthest-point samples, each for the surface that is nearest to it. Allocates.
// Source: Hilaga, Shinagawa, Kohmura, Kunii 2001, Topology Matching, eq. 3; sampled as in section 4.2.
template <class S>
std::vector<S> average_geodesic(const SurfaceGraph<S>& graph, std::size_t sources = 64) {
  const std::size_t n = graph.size();
  std::vector<S> nearest(n, std::numeric_limits<S>::max()), average(n, S(0));
  std::vector<std::size_t> owner(n, 0);
  std::vector<std::vector<S>> distances;
  std::size_t source = 0;
  while (distances.size() < std::min(sources, n)) {
    distances.push_back(node_distances(graph, static_cast<std::int32_t>(source)));
    for (std::size_t i = 0; i < n; ++i) {
      if (distances.back()[i] >= nearest[i]) continue;
      nearest[i] = distances.back()[i];
      owner[i] = distances.size() - 1;
    }
    source = to_size(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
  }
  std::vector<S> weight(distances.size(), S(0));
  S total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    weight[owner[i]] += graph.area[i];
    total += graph.area[i];
  }
  for (std::size_t s = 0; s < distances.size(); ++s) {
    const S share = total > S(0) ? weight[s] / total : S(1) / static_cast<S>(distances.size());
    for (std::size_t i = 0; i < n; ++i) average[i] += share * distances[s][i];
  }
  return average;
}

// Maxima of the average distance whose prominence is at least `least`, most prominent first; the farthest of all has
// come back to the middle. average: N. Allocates.
// Source: Zhang, Mischaikow, Turk 2005, Feature-based surface parameterization, section 4.1; prominence is the
// persistence of Edelsbrunner, Letscher, Zomorodian 2002.
template <class S>
std::vector<Extremity<S>> extremities(const SurfaceGraph<S>& graph, Span<const S> average, S least) {
  const std::size_t n = graph.size();
  std::vector<std::int32_t> order(n), root(n, -1);  // root: union-find, whose roots are the summits
  std::iota(order.begin(), order.end(), 0);
  const auto height = [&](std::int32_t i) { return nth(average, i); };
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return height(a) != height(b) ? height(a) > height(b) : a < b; });
  const auto summit = [&](std::int32_t i) {
    while (nth(root, i) != i) {
      auto& up = nth(root, i);
      i = up = nth(root, up);
    }
    return i;
  };
  std::vector<Extremity<S>> found;
  for (const std::int32_t i : order) {
    const auto at = to_size(i);
    root[at] = i;
    for (std::int32_t k = graph.ring.first[at]; k < graph.ring.first[at + 1]; ++k) {
      const std::int32_t other = nth(graph.ring.neighbor, k);
      if (nth(root, other) < 0) continue;
      std::int32_t high = summit(other), low = summit(i);
      if (high == low) continue;
      if (height(low) > height(high) || (height(low) == height(high) && low < high)) std::swap(high, low);
      nth(root, low) = high;
      if (height(low) - height(i) >= least) found.push_back({low, height(low) - height(i)});
    }
  }
  if (n > 0 && height(order.front()) - height(order.back()) >= least)
    found.push_back({order.front(), height(order.front()) - height(order.back())});
  std::sort(found.begin(), found.end(), [](const Extremity<S>& a, const Extremity<S>& b) {
    return a.prominence != b.prominence ? a.prominence > b.prominence : a.node < b.node;
  });
  return found;
}

}  // namespace rigless::detail
