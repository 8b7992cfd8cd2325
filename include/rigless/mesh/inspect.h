// What a mesh is like, before anyone solves on it: the facts that a user is told.
#pragma once

#include "rigless/mesh/detail/shells.h"

namespace rigless {

struct MeshTopology {
  std::int32_t boundary_edges = 0;      // used by one face
  std::int32_t non_manifold_edges = 0;  // used by three or more
  std::int32_t shells = 0;              // connected pieces with faces
  std::int32_t isolated_vertices = 0;   // used by no face
  std::int32_t degenerate_faces = 0;    // the same vertex twice

  bool closed() const { return boundary_edges == 0 && non_manifold_edges == 0; }
};

// Counts over faces whose indices were checked. Allocates.
RIGLESS_COLD inline MeshTopology inspect_mesh(Span<const Face> faces, std::int32_t vertices) {
  MeshTopology t;
  std::vector<std::array<std::int32_t, 2>> edges;
  edges.reserve(3 * faces.size());
  std::vector<char> used(to_size(vertices), 0);
  for (const Face& f : faces) {
    if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) {
      t.degenerate_faces++;
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      nth(used, f[k]) = 1;
      edges.push_back({std::min(f[k], f[(k + 1) % 3]), std::max(f[k], f[(k + 1) % 3])});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t k = 0, run = 0; k < edges.size(); k += run) {
    for (run = 1; k + run < edges.size() && edges[k + run] == edges[k];) ++run;
    if (run == 1) t.boundary_edges++;
    if (run > 2) t.non_manifold_edges++;
  }
  for (char u : used) t.isolated_vertices += u ? 0 : 1;
  t.shells = detail::find_shells(detail::one_ring(faces, vertices)).count - t.isolated_vertices;
  return t;
}

}  // namespace rigless
