// Who is next to whom: the one-rings of all vertices in one flat table.
#pragma once

#include <algorithm>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"

namespace rigless {

// Neighbours of vertex i are neighbor[first[i]] .. neighbor[first[i + 1] - 1], ascending, each once, never i itself.
// A slot of that table is a directed edge i -> j.
struct OneRing {
  std::vector<std::int32_t> first;     // V + 1
  std::vector<std::int32_t> neighbor;  // directed edges

  std::int32_t vertices() const { return static_cast<std::int32_t>(first.size()) - 1; }
  std::int32_t edges() const { return static_cast<std::int32_t>(neighbor.size()); }

  // The slot of directed edge i -> j, or -1.
  std::int32_t slot(std::int32_t i, std::int32_t j) const {
    const auto begin = neighbor.begin() + first[static_cast<std::size_t>(i)];
    const auto end = neighbor.begin() + first[static_cast<std::size_t>(i) + 1];
    const auto it = std::lower_bound(begin, end, j);
    return it != end && *it == j ? static_cast<std::int32_t>(it - neighbor.begin()) : -1;
  }
};

// The first face that names a vertex outside [0, vertices), or no error. Errors: no_faces; index_out_of_range (face).
inline Status check_faces(Span<const Face> faces, std::int32_t vertices) {
  if (faces.empty()) return {Error::no_faces, -1};
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::int32_t v : faces[f]) {
      if (v < 0 || v >= vertices) return {Error::index_out_of_range, static_cast<std::int32_t>(f)};
    }
  }
  return {};
}

// Builds the table from undirected pairs (each side may be given any number of times). Allocates.
RIGLESS_ONCE inline OneRing one_ring_from_pairs(std::vector<std::array<std::int32_t, 2>> pairs, std::int32_t vertices) {
  const std::size_t count = pairs.size();
  pairs.reserve(2 * count);
  for (std::size_t k = 0; k < count; ++k) pairs.push_back({pairs[k][1], pairs[k][0]});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  OneRing ring;
  ring.first.assign(static_cast<std::size_t>(vertices) + 1, 0);
  ring.neighbor.reserve(pairs.size());
  for (const auto& [i, j] : pairs) {
    if (i == j) continue;
    ring.first[static_cast<std::size_t>(i) + 1]++;
    ring.neighbor.push_back(j);
  }
  for (std::size_t i = 1; i < ring.first.size(); ++i) ring.first[i] += ring.first[i - 1];
  return ring;
}

// Every edge of the faces (V x 3 indices already checked). Non-manifold edges and duplicate faces count once.
// Allocates.
RIGLESS_ONCE inline OneRing one_ring(Span<const Face> faces, std::int32_t vertices) {
  std::vector<std::array<std::int32_t, 2>> pairs;
  pairs.reserve(3 * faces.size());
  for (const Face& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) pairs.push_back({f[k], f[(k + 1) % 3]});
  }
  return one_ring_from_pairs(std::move(pairs), vertices);
}

}  // namespace rigless
