// One pass over the cells: what each takes from the surface, a fit of its own, and what it spreads into the residual of
// the global system, r_i = sum_j w_ij ((M_i + M_j) / 2 e_ij - e'_ij), so that neither covariances nor transforms are
// stored. Solving for the update from that residual keeps single precision at 3e-8 of the diagonal.
#pragma once

#include "rigless/deform/detail/cell_slices.h"

namespace rigless::detail {

template <class S>
struct PointLanes {
  simd::Lanes<S> x, y, z;
};

// What one slice takes from the surface.
template <class S>
struct Gathered {
  MatrixLanes<S> C;    // sum w e e'^T
  PointLanes<S> pull;  // sum w e'
};

// Edges e' are kept in slices.edges_of(s) if asked.
template <bool keep_edges, class S>
RIGLESS_INNER Gathered<S> gather_slice(CellSlices<S>& slices, std::size_t s, const simd::Quad<S>* x) {
  using L = simd::Lanes<S>;
  constexpr int width = simd::width<S>;
  PointLanes<S> at;
  simd::gather<S, width>(x, slices.row.data() + s * width, at.x, at.y, at.z);
  Gathered<S> g = {};
  auto& C = g.C;
  L* edge = slices.edges_of(s);
  for (auto k = static_cast<std::size_t>(slices.first[s]); k < static_cast<std::size_t>(slices.first[s + 1]); ++k) {
    PointLanes<S> to;
    simd::gather<S, width>(x, slices.other.data() + k * width, to.x, to.y, to.z);
    const L ex = at.x - to.x, ey = at.y - to.y, ez = at.z - to.z;
    const auto& slot = slices.slot[k];
    C.m[0] += slot.wx * ex;
    C.m[1] += slot.wx * ey;
    C.m[2] += slot.wx * ez;
    C.m[3] += slot.wy * ex;
    C.m[4] += slot.wy * ey;
    C.m[5] += slot.wy * ez;
    C.m[6] += slot.wz * ex;
    C.m[7] += slot.wz * ey;
    C.m[8] += slot.wz * ez;
    g.pull.x += slot.w * ex;
    g.pull.y += slot.w * ey;
    g.pull.z += slot.w * ez;
    if constexpr (keep_edges) {
      edge[0] = ex;
      edge[1] = ey;
      edge[2] = ez;
      edge += 3;
    }
  }
  const L idle = slices.cell[s].idle;
  C.m[0] += idle;
  C.m[4] += idle;
  C.m[8] += idle;
  return g;
}

// (M e) of lanes.
template <class S>
RIGLESS_INNER PointLanes<S> product(const MatrixLanes<S>& M, simd::Lanes<S> x, simd::Lanes<S> y, simd::Lanes<S> z) {
  return {M.m[0] * x + M.m[1] * y + M.m[2] * z, M.m[3] * x + M.m[4] * y + M.m[5] * z,
          M.m[6] * x + M.m[7] * y + M.m[8] * z};
}

// Adds what this slice knows of the residual: to its own rows sum w (M e / 2 - e'), to each neighbour's - w M e / 2.
// Gives sum w |M e - e'|^2 of each lane's cell. Either only if asked.
template <bool spread, bool with_energy, class S>
RIGLESS_INNER simd::Lanes<S> spread_residual(CellSlices<S>& slices, std::size_t s, MatrixLanes<S> M,
                                             const PointLanes<S>& pull, simd::Quad<S>* r) {
  constexpr int width = simd::width<S>;
  for (auto& m : M.m) m *= S(-0.5);
  const simd::Lanes<S>* edge = slices.edges_of(s);
  simd::Lanes<S> energy = {};
  for (auto k = static_cast<std::size_t>(slices.first[s]); k < static_cast<std::size_t>(slices.first[s + 1]); ++k) {
    const auto& e = slices.slot[k];
    const PointLanes<S> t = product(M, e.wx, e.wy, e.wz);
    if constexpr (spread) simd::scatter_add<S, width>(r, slices.other.data() + k * width, t.x, t.y, t.z);
    if constexpr (with_energy) {
      const simd::Lanes<S> half = S(0.5) * e.w;
      const simd::Lanes<S> x = t.x + half * edge[0], y = t.y + half * edge[1], z = t.z + half * edge[2];
      energy += slices.inverse_weight[k] * (x * x + y * y + z * z);
      edge += 3;
    }
  }
  if constexpr (spread) {
    const auto& b = slices.cell[s].pull;
    const PointLanes<S> t = product(M, b[0], b[1], b[2]);
    simd::scatter_add<S, width>(r, slices.row.data() + s * width, -t.x - pull.x, -t.y - pull.y, -t.z - pull.z);
  }
  return S(4) * energy;
}

// For every slice s: fit(s, C), then spread(s, what fit gave, what was gathered). What the next slice takes from the
// surface is fetched between the two, so that the long chain of a fit hides behind it.
template <bool keep_edges, class S, class Fit, class Spread>
RIGLESS_INNER void for_each_slice(CellSlices<S>& slices, const simd::Quad<S>* x, const Fit& fit, const Spread& spread) {
  if (slices.size() == 0) return;
  Gathered<S> next = gather_slice<keep_edges>(slices, 0, x);
  for (std::size_t s = 0; s < slices.size(); ++s) {
    const Gathered<S> now = next;
    const auto fitted = fit(s, now.C);
    if (s + 1 < slices.size()) next = gather_slice<keep_edges>(slices, s + 1, x);
    spread(s, fitted, now);
  }
}

}  // namespace rigless::detail
