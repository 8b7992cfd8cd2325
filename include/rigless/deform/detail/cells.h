// The overlapping cells that cover a surface, one per vertex with its one-ring.
#pragma once

#include "rigless/mesh/detail/laplacian.h"

namespace rigless {

// Edge i -> j at rest is e_ij = rest_i - rest_j. Public through Deformer::cells().
template <class S>
struct Cells {
  OneRing ring;
  std::vector<S> weight;         // per directed edge, symmetric, > 0
  std::vector<Vec3<S>> rest;     // V
  std::vector<S> weighted_size;  // V: sum_j w_ij |e_ij|^2

  std::size_t size() const { return rest.size(); }
};

}  // namespace rigless

namespace rigless::detail {

// Calls f(w_ij, e_ij, j) for every neighbour j of i.
template <class S, class F>
void for_each_edge(const Cells<S>& cells, std::size_t i, const F& f) {
  const auto begin = to_size(cells.ring.first[i]);
  const auto end = to_size(cells.ring.first[i + 1]);
  for (std::size_t k = begin; k < end; ++k) {
    const auto j = to_size(cells.ring.neighbor[k]);
    f(cells.weight[k], Vec3<S>(cells.rest[i] - cells.rest[j]), j);
  }
}

// Fills weighted_size from the rest. Allocates.
template <class S>
void measure_cells(Cells<S>& cells) {
  cells.weighted_size.assign(cells.size(), S(0));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for_each_edge(cells, i, [&](S w, const Vec3<S>& e, std::size_t) { cells.weighted_size[i] += w * e.squaredNorm(); });
  }
}

// How freely a cell of the scaled shape state changes its size: the energy gains mu |e_i|^2 (s_i - 1)^2. mu = 0 is the
// thesis, where any similarity is free and stretched bodies inflate; infinity is as-rigid-as-possible.
template <class S>
struct ElasticScale {
  S mu = S(0.5);

  // Source: thesis Eq 3.6 with the elastic term; `ratio` is e'.e^r / e^r.e^r.
  S operator()(S ratio) const { return S(1) + (ratio - S(1)) / (S(1) + mu); }
};

}  // namespace rigless::detail
