// Who is next to whom: the one-rings of all vertices in one flat table.
#pragma once

#include <algorithm>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"

namespace rigless {

// Neighbours of vertex i are neighbor[first[i]] .. neighbor[first[i + 1] - 1], ascending, each once, never i itself.
// A slot of that table is a directed edge i -> j. Public through
// the weights of a Deformer.
struct OneRing {
  std::vector<std::int32_t> first;     // V + 1
  std::vector<std::int32_t> neighbor;  // directed edges

  std::int32_t vertices() const { return count_of(first) - 1; }
  std::int32_t edges() const { return count_of(neighbor); }

  // The slot of directed edge i -> j, or -1.
  std::int32_t slot(std::int32_t i, std::int32_t j) const {
    const auto begin = neighbor.begin() + nth(first, i);
    const auto end = neighbor.begin() + first[to_size(i) + 1];
    const auto it = std::lower_bound(begin, end, j);
    return it != end && *it == j ? static_cast<std::int32_t>(it - neighbor.begin()) : -1;
  }
};

}  // namespace rigless

namespace rigless::detail {

// The first face that names a vertex outside [0, vertices), or no error. Errors: no_faces; index_out_of_range (face).
inline Status check_faces(Span<const Face> faces, std::int32_t vertices) {
  if (faces.empty()) return {Error::no_faces, -1};
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::int32_t v : faces[f]) {
      if (v < 0 || v >= vertices) return {Error::index_out_of_range, f};
    }
  }
  return {};
}

// Builds the table from undirected pairs (each side may be given any number of times), by buckets: sorting all pairs at
// once took half of a binding. Allocates.
RIGLESS_COLD inline OneRing one_ring_from_pairs(const std::vector<std::array<std::int32_t, 2>>& pairs,
                                                std::int32_t vertices) {
  const auto n = to_size(vertices);
  std::vector<std::int32_t> begin(n + 1, 0);
  for (const auto& [a, b] : pairs) {
    begin[to_size(a) + 1]++;
    begin[to_size(b) + 1]++;
  }
  for (std::size_t i = 0; i < n; ++i) begin[i + 1] += begin[i];
  std::vector<std::int32_t> bucket(2 * pairs.size()), end(begin.begin(), begin.end() - 1);
  for (const auto& [a, b] : pairs) {
    nth(bucket, nth(end, a)++) = b;
    nth(bucket, nth(end, b)++) = a;
  }
  OneRing ring;
  ring.first.reserve(n + 1);
  ring.first.push_back(0);
  ring.neighbor.reserve(bucket.size() / 2);
  for (std::size_t i = 0; i < n; ++i) {
    std::sort(bucket.begin() + begin[i], bucket.begin() + end[i]);
    std::int32_t last = static_cast<std::int32_t>(i);  // never its own neighbour
    for (std::int32_t k = begin[i]; k < end[i]; ++k) {
      const std::int32_t j = nth(bucket, k);
      if (j != last && j != static_cast<std::int32_t>(i)) ring.neighbor.push_back(j);
      last = j;
    }
    ring.first.push_back(count_of(ring.neighbor));
  }
  return ring;
}

// Every edge of the faces (V x 3 indices already checked). Non-manifold edges and duplicate faces count once.
// Allocates.
RIGLESS_COLD inline OneRing one_ring(Span<const Face> faces, std::int32_t vertices) {
  std::vector<std::array<std::int32_t, 2>> pairs;
  pairs.reserve(3 * faces.size());
  for (const Face& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) pairs.push_back({f[k], f[(k + 1) % 3]});
  }
  return one_ring_from_pairs(pairs, vertices);
}

}  // namespace rigless::detail
