// A mesh thinned to a few thousand places that are joined as its surface is: what looks at the whole shape looks at
// this.
#pragma once

#include <limits>

#include "rigless/mesh/detail/geodesic.h"
#include "rigless/mesh/detail/measure.h"
#include "rigless/mesh/detail/shells.h"

namespace rigless::detail {

// N nodes. The graph hangs together: shells are tied to what is nearest.
template <class S>
struct SurfaceGraph {
  std::vector<std::int32_t> vertex;   // N, of the mesh
  std::vector<Vec3<S>> position;      // N
  std::vector<S> area;                // N, of the surface that a node stands for
  std::vector<S> shell_area;          // N, of the shell that it is on and all that touch
  std::vector<std::int32_t> node_of;  // V, -1 for vertices that no face uses
  OneRing ring;                       // over nodes

  std::size_t size() const { return vertex.size(); }
};

// One thinning: nodes are taken in order and swallow the neighbours that nobody has; a third or a quarter remains.
template <class S>
RIGLESS_COLD SurfaceGraph<S> thin(const SurfaceGraph<S>& fine) {
  SurfaceGraph<S> coarse;
  std::vector<std::int32_t> taker(fine.size(), -1);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    if (taker[i] >= 0) continue;
    taker[i] = count_of(coarse);
    for (std::int32_t k = fine.ring.first[i]; k < fine.ring.first[i + 1]; ++k) {
      std::int32_t& other = nth(taker, nth(fine.ring.neighbor, k));
      if (other < 0) other = taker[i];
    }
    coarse.vertex.push_back(fine.vertex[i]);
    coarse.position.push_back(fine.position[i]);
    coarse.shell_area.push_back(fine.shell_area[i]);
  }
  coarse.area.assign(coarse.size(), S(0));
  std::vector<std::array<std::int32_t, 2>> pairs;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    nth(coarse.area, taker[i]) += fine.area[i];
    for (std::int32_t k = fine.ring.first[i]; k < fine.ring.first[i + 1]; ++k) {
      const std::int32_t other = nth(taker, nth(fine.ring.neighbor, k));
      if (taker[i] < other) pairs.push_back({taker[i], other});
    }
  }
  coarse.ring = one_ring_from_pairs(pairs, count_of(coarse));
  for (const std::int32_t node : fine.node_of) coarse.node_of.push_back(node < 0 ? -1 : nth(taker, node));
  return coarse;
}

// Thins V vertices under F faces, whose indices were checked, until at most `most` nodes are left or no more can be
// joined. Vertices that no face uses are left out. Allocates.
template <class S>
RIGLESS_COLD SurfaceGraph<S> surface_graph(Span<const Vec3<S>> vertices, Span<const Face> faces,
                                           std::size_t most = 4000) {
  SurfaceGraph<S> graph;
  graph.node_of.assign(vertices.size(), -1);
  for (const Face& f : faces) {
    for (const std::int32_t v : f) nth(graph.node_of, v) = 0;
  }
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (graph.node_of[v] < 0) continue;
    graph.node_of[v] = count_of(graph);
    graph.vertex.push_back(static_cast<std::int32_t>(v));
    graph.position.push_back(vertices[v]);
  }
  graph.area.assign(graph.size(), S(0));
  std::vector<std::array<std::int32_t, 2>> pairs;
  for (const Face& f : faces) {
    std::array<std::size_t, 3> n;
    for (std::size_t k = 0; k < 3; ++k) n[k] = to_size(nth(graph.node_of, f[k]));
    const Vec3<S>& a = graph.position[n[0]];
    const S area = (graph.position[n[1]] - a).cross(graph.position[n[2]] - a).norm() / S(6);
    for (std::size_t k = 0; k < 3; ++k) {
      graph.area[n[k]] += area;
      pairs.push_back({static_cast<std::int32_t>(n[k]), static_cast<std::int32_t>(n[(k + 1) % 3])});
    }
  }
  const auto count = count_of(graph);
  graph.ring = one_ring_from_pairs(pairs, count);
  const auto ties = tie_shells<S>(graph.position, graph.ring, 2);
  // What touches belongs together, a hand to its arm; crumbs that float do not.
  auto joined = pairs;
  const S touch = S(0.01) * bounds<S>(graph.position).diagonal();
  for (const auto& [a, b] : ties)
    if ((nth(graph.position, a) - nth(graph.position, b)).norm() < touch) joined.push_back({a, b});
  const Shells shells = find_shells(one_ring_from_pairs(joined, count));
  std::vector<S> shell_area(to_size(shells.count), S(0));
  for (std::size_t i = 0; i < graph.size(); ++i) nth(shell_area, shells.of_vertex[i]) += graph.area[i];
  for (const std::int32_t shell : shells.of_vertex) graph.shell_area.push_back(nth(shell_area, shell));
  if (!ties.empty()) {
    pairs.insert(pairs.end(), ties.begin(), ties.end());
    graph.ring = one_ring_from_pairs(pairs, count);
  }
  while (graph.size() > most) {
    SurfaceGraph<S> thinner = thin(graph);
    if (10 * thinner.size() > 9 * graph.size()) break;
    graph = std::move(thinner);
  }
  return graph;
}

// Distance of every node from one of them along the graph. Allocates.
template <class S>
std::vector<S> node_distances(const SurfaceGraph<S>& graph, std::int32_t source) {
  std::vector<S> distances(graph.size(), std::numeric_limits<S>::max());
  const S everywhere = std::numeric_limits<S>::max();
  for (const auto& [node, distance] : vertices_within<S>(graph.position, graph.ring, source, everywhere))
    nth(distances, node) = distance;
  return distances;
}

}  // namespace rigless::detail
