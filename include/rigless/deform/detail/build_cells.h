// From a mesh as people have it to cells that hang together: what a deformer binds.
#pragma once

#include "rigless/deform/detail/cells.h"
#include "rigless/mesh/detail/shells.h"

namespace rigless::detail {

// Errors: size_mismatch; not_finite (where: vertex).
template <class S>
Status check_rest(Span<const Vec3<S>> rest, Span<const S> rigidity) {
  if (!rigidity.empty() && rigidity.size() != rest.size()) return {Error::size_mismatch, -1};
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const bool stiff = rigidity.empty() || (rigidity[v] > S(0) && std::isfinite(rigidity[v]));
    if (!rest[v].allFinite() || !stiff) return {Error::not_finite, v};
  }
  return {};
}

// An edge gets the smaller of its ends' rigidities (V numbers or none).
template <class S>
void stiffen(Span<const S> rigidity, Cells<S>& cells) {
  for (std::size_t i = 0; i < rigidity.size(); ++i) {
    for (auto k = to_size(cells.ring.first[i]); k < to_size(cells.ring.first[i + 1]); ++k) {
      cells.weight[k] *= std::min(rigidity[i], nth(rigidity, cells.ring.neighbor[k]));
    }
  }
}

// Cells of a graph of V nodes with a weight per directed edge. Allocates. On failure `out` stays as it was. Errors:
// not_finite (node, also for a rigidity that is not above 0); size_mismatch (ring, weight, rigidity).
template <class S>
RIGLESS_COLD Status graph_cells(Span<const Vec3<S>> rest, const OneRing& ring, Span<const S> weight,
                                Span<const S> rigidity, Cells<S>& out) {
  if (ring.vertices() != count_of(rest) || weight.size() != ring.neighbor.size()) return {Error::size_mismatch, -1};
  if (const Status s = check_rest(rest, rigidity); !s.ok()) return s;
  Cells<S> cells;
  cells.rest.assign(rest.begin(), rest.end());
  cells.ring = ring;
  cells.weight.assign(weight.begin(), weight.end());
  stiffen(rigidity, cells);
  measure_cells(cells);
  out = std::move(cells);
  return {};
}

// Cells of V rest vertices and F faces; shells and isolated vertices are tied to what is nearest. `rigidity` is V
// numbers or none: an edge gets the smaller of its ends'. Allocates. On failure `out` stays as it was. Errors:
// no_faces; index_out_of_range (face); not_finite (vertex, also for a rigidity that is not above 0); size_mismatch
// (rigidity).
template <class Weights, class S>
RIGLESS_COLD Status build_cells(Span<const Vec3<S>> rest, Span<const Face> faces, Span<const S> rigidity,
                                Cells<S>& out) {
  const auto count = count_of(rest);
  if (const Status s = check_faces(faces, count); !s.ok()) return s;
  if (const Status s = check_rest(rest, rigidity); !s.ok()) return s;
  Cells<S> cells;
  cells.rest.assign(rest.begin(), rest.end());
  cells.ring = one_ring(faces, count);
  const auto ties = tie_shells<S>(rest, cells.ring);
  if (!ties.empty()) {
    std::vector<std::array<std::int32_t, 2>> pairs = ties;
    for (const Face& f : faces) {
      for (std::size_t k = 0; k < 3; ++k) pairs.push_back({f[k], f[(k + 1) % 3]});
    }
    cells.ring = one_ring_from_pairs(pairs, count);
  }
  cells.weight = Weights::template of<S>(rest, faces, cells.ring);
  for (const auto& [a, b] : ties) {
    nth(cells.weight, cells.ring.slot(a, b)) = S(1);
    nth(cells.weight, cells.ring.slot(b, a)) = S(1);
  }
  stiffen(rigidity, cells);
  measure_cells(cells);
  out = std::move(cells);
  return {};
}

}  // namespace rigless::detail
