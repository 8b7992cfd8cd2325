// The local step: one pass over the cells fits rotation and scale to the present surface and spreads the residual of
// the global system, r_i = sum_j w_ij ((M_i + M_j) / 2 e_ij - e'_ij), so that neither covariances nor transforms are
// stored. Solving for the update from that residual keeps single precision at 3e-8 of the diagonal.
#pragma once

#include "rigless/deform/cell_slices.h"

namespace rigless {

namespace detail {

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
inline Gathered<S> gather_slice(CellSlices<S>& slices, std::size_t s, const simd::Quad<S>* x) {
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

// tr(R C), which is e'.e^r.
template <class S>
inline simd::Lanes<S> trace_of_product(const MatrixLanes<S>& R, const MatrixLanes<S>& C) {
  simd::Lanes<S> t[3];  // three short sums instead of a long one
  for (int i = 0; i < 3; ++i) t[i] = R.m[3 * i] * C.m[i] + R.m[3 * i + 1] * C.m[3 + i] + R.m[3 * i + 2] * C.m[6 + i];
  return t[0] + t[1] + t[2];
}

// (M e) of lanes.
template <class S>
inline PointLanes<S> product(const MatrixLanes<S>& M, simd::Lanes<S> x, simd::Lanes<S> y, simd::Lanes<S> z) {
  return {M.m[0] * x + M.m[1] * y + M.m[2] * z, M.m[3] * x + M.m[4] * y + M.m[5] * z,
          M.m[6] * x + M.m[7] * y + M.m[8] * z};
}

// Adds what this slice knows of the residual: to its own rows sum w (M e / 2 - e'), to each neighbour's - w M e / 2.
template <class S>
inline void spread_residual(const CellSlices<S>& slices, std::size_t s, MatrixLanes<S> M, const PointLanes<S>& pull,
                            simd::Quad<S>* r) {
  constexpr int width = simd::width<S>;
  for (auto& m : M.m) m *= S(-0.5);
  for (auto k = static_cast<std::size_t>(slices.first[s]); k < static_cast<std::size_t>(slices.first[s + 1]); ++k) {
    const auto& e = slices.slot[k];
    const PointLanes<S> t = product(M, e.wx, e.wy, e.wz);
    simd::scatter_add<S, width>(r, slices.other.data() + k * width, t.x, t.y, t.z);
  }
  const auto& b = slices.cell[s].pull;
  const PointLanes<S> t = product(M, b[0], b[1], b[2]);
  simd::scatter_add<S, width>(r, slices.row.data() + s * width, -t.x - pull.x, -t.y - pull.y, -t.z - pull.z);
}

// sum w |M e - e'|^2 over the edges of each lane's cell.
template <class S>
inline simd::Lanes<S> edge_energy(CellSlices<S>& slices, std::size_t s, const MatrixLanes<S>& M) {
  using L = simd::Lanes<S>;
  const L* edge = slices.edges_of(s);
  L energy = {};
  const L zero = {};
  for (auto k = static_cast<std::size_t>(slices.first[s]); k < static_cast<std::size_t>(slices.first[s + 1]); ++k) {
    const auto& e = slices.slot[k];
    const PointLanes<S> p = product(M, e.wx, e.wy, e.wz);
    const L tx = p.x - e.w * edge[0], ty = p.y - e.w * edge[1], tz = p.z - e.w * edge[2];
    edge += 3;
    energy += simd::select(e.w > zero, (tx * tx + ty * ty + tz * tz) / e.w, zero);
  }
  return energy;
}

// Largest eigenvalue of a symmetric positive semidefinite matrix (xx, xy, xz, yy, yz, zz) by Newton from above on its
// characteristic cubic, and its eigenvector from the adjugate.
template <class S>
inline PointLanes<S> top_eigenvector(const simd::Lanes<S> (&d)[6]) {
  using L = simd::Lanes<S>;
  const L trace = d[0] + d[3] + d[5];
  const L zero = {};
  const auto any = trace > zero;
  const L unit = S(1) / simd::select(any, trace, simd::splat<L>(S(1)));
  const L a = d[0] * unit, b = d[1] * unit, c = d[2] * unit, e = d[3] * unit, f = d[4] * unit, g = d[5] * unit;
  const L m2 = a * e + a * g + e * g - b * b - c * c - f * f;                    // second invariant, trace is 1
  const L m3 = a * (e * g - f * f) - b * (b * g - c * f) + c * (b * f - c * e);  // determinant
  L t = simd::splat<L>(S(1));                                                    // t^3 - t^2 + m2 t - m3 = 0
  for (int it = 0; it < (sizeof(S) == 4 ? 8 : 40); ++it) {
    const L p = ((t - S(1)) * t + m2) * t - m3;
    const L dp = (S(3) * t - S(2)) * t + m2;
    const auto safe = dp > S(1e-12);
    t -= simd::select(safe, p, zero) / simd::select(safe, dp, simd::splat<L>(S(1)));
  }
  const L aa = a - t, ee = e - t, gg = g - t;
  // columns of the adjugate of (D - t I); the longest is the steadiest
  const L x0 = ee * gg - f * f, y0 = c * f - b * gg, z0 = b * f - c * ee;
  const L y1 = aa * gg - c * c, z1 = b * c - aa * f, z2 = aa * ee - b * b;
  const L n0 = x0 * x0 + y0 * y0 + z0 * z0, n1 = y0 * y0 + y1 * y1 + z1 * z1, n2 = z0 * z0 + z1 * z1 + z2 * z2;
  const auto first = (n0 >= n1) & (n0 >= n2);
  const auto second = n1 >= n2;
  PointLanes<S> v;
  v.x = simd::select(first, x0, simd::select(second, y0, z0));
  v.y = simd::select(first, y0, simd::select(second, y1, z1));
  v.z = simd::select(first, z0, simd::select(second, z1, z2));
  L n = simd::select(first, n0, simd::select(second, n1, n2));
  const auto good = n > S(1e-30);
  n = simd::select(good, n, simd::splat<L>(S(1)));
  simd::sqrt_lanes<S, simd::width<S>>(n);
  v.x = simd::select(good, v.x / n, simd::splat<L>(S(1)));
  v.y = simd::select(good, v.y / n, zero);
  v.z = simd::select(good, v.z / n, zero);
  return v;
}

// V_i R_i of one slice after Eq 3.8-3.11 of the thesis; law maps stretch to s'.
template <class S, class Law>
inline MatrixLanes<S> volume_transforms(CellSlices<S>& slices, std::size_t s, const MatrixLanes<S>& R,
                                        const MatrixLanes<S>& C, const Law& law) {
  using L = simd::Lanes<S>;
  constexpr int width = simd::width<S>;
  const auto& cell = slices.cell[s];
  L D[6] = {};  // sum w d d^T, d = e' - R e
  const L* edge = slices.edges_of(s);
  for (auto k = static_cast<std::size_t>(slices.first[s]); k < static_cast<std::size_t>(slices.first[s + 1]); ++k) {
    const auto& e = slices.slot[k];
    const L zero = {};
    const L inverse = simd::select(e.w > zero, S(1) / e.w, zero);
    const L dx = e.w * edge[0] - (R.m[0] * e.wx + R.m[1] * e.wy + R.m[2] * e.wz);
    const L dy = e.w * edge[1] - (R.m[3] * e.wx + R.m[4] * e.wy + R.m[5] * e.wz);
    const L dz = e.w * edge[2] - (R.m[6] * e.wx + R.m[7] * e.wy + R.m[8] * e.wz);
    const L ux = inverse * dx, uy = inverse * dy, uz = inverse * dz;
    D[0] += ux * dx;
    D[1] += ux * dy;
    D[2] += ux * dz;
    D[3] += uy * dy;
    D[4] += uy * dz;
    D[5] += uz * dz;
    edge += 3;
  }
  const PointLanes<S> p = top_eigenvector<S>(D);
  // u = R^T p, the axis at rest; s = (u^T C p) / (u^T (sum w e e^T) u)
  const L ux = R.m[0] * p.x + R.m[3] * p.y + R.m[6] * p.z, uy = R.m[1] * p.x + R.m[4] * p.y + R.m[7] * p.z,
          uz = R.m[2] * p.x + R.m[5] * p.y + R.m[8] * p.z;
  const L above = ux * (C.m[0] * p.x + C.m[1] * p.y + C.m[2] * p.z) +
                  uy * (C.m[3] * p.x + C.m[4] * p.y + C.m[5] * p.z) + uz * (C.m[6] * p.x + C.m[7] * p.y + C.m[8] * p.z);
  const auto& m = cell.moment;
  const L below =
      ux * (m[0] * ux + S(2) * (m[1] * uy + m[2] * uz)) + uy * (m[3] * uy + S(2) * m[4] * uz) + m[5] * uz * uz;
  const L moved = D[0] + D[3] + D[5];
  L across = simd::splat<L>(S(1));  // s'^-1/2
  for (int k = 0; k < width; ++k) {
    if (moved[k] > S(1e-12) * cell.size[k] && below[k] > S(1e-12) * cell.size[k]) {
      across[k] = S(1) / std::sqrt(law(above[k] / below[k]));
    }
  }
  const L gain = S(1) - across;  // V R = across R + gain p u^T
  MatrixLanes<S> M;
  const L px = gain * p.x, py = gain * p.y, pz = gain * p.z;
  M.m[0] = across * R.m[0] + px * ux;
  M.m[1] = across * R.m[1] + px * uy;
  M.m[2] = across * R.m[2] + px * uz;
  M.m[3] = across * R.m[3] + py * ux;
  M.m[4] = across * R.m[4] + py * uy;
  M.m[5] = across * R.m[5] + py * uz;
  M.m[6] = across * R.m[6] + pz * ux;
  M.m[7] = across * R.m[7] + pz * uy;
  M.m[8] = across * R.m[8] + pz * uz;
  return M;
}

// The energy of one slice with transform s R: every edge from this end, plus the elastic term.
template <class S>
inline double slice_energy(CellSlices<S>& slices, std::size_t s, const MatrixLanes<S>& M, simd::Lanes<S> scale,
                           const ElasticScale<S>& elastic) {
  const simd::Lanes<S> edges = edge_energy(slices, s, M);
  double energy = 0;
  for (int k = 0; k < simd::width<S>; ++k) {
    energy += static_cast<double>(edges[k]);
    if (std::isfinite(elastic.mu)) {
      energy += static_cast<double>(elastic.mu * slices.cell[s].size[k] * (scale[k] - S(1)) * (scale[k] - S(1)));
    }
  }
  return energy;
}

// s R that fits C best, from the rotation q on; q is what R was then. `give` is 1 / (1 + mu).
template <class S>
inline MatrixLanes<S> fit_transform(const MatrixLanes<S>& C, simd::Lanes<S> inverse_size, S give, QuaternionLanes<S>& q,
                                    simd::Lanes<S>& scale) {
  fit_rotations(C, q);
  MatrixLanes<S> M = rotation_matrix(q);
  scale = S(1) + (trace_of_product(M, C) * inverse_size - S(1)) * give;
  for (auto& m : M.m) m *= scale;
  return M;
}

// Calls f(s, gathered) for every slice. What the next slice takes from the surface is fetched between `fit` and
// `spread`, so that the long chain of a fit hides behind it.
template <bool keep_edges, class S, class Fit, class Spread>
inline void for_each_slice(CellSlices<S>& slices, const simd::Quad<S>* x, const Fit& fit, const Spread& spread) {
  if (slices.size() == 0) return;
  Gathered<S> next = gather_slice<keep_edges>(slices, 0, x);
  for (std::size_t s = 0; s < slices.size(); ++s) {
    const Gathered<S> now = next;
    const auto fitted = fit(s, now.C);
    if (s + 1 < slices.size()) next = gather_slice<keep_edges>(slices, s + 1, x);
    spread(s, fitted, now);
  }
}

}  // namespace detail

// Fits R and s of every cell to the surface x (n + 1 rows) and adds the residual to r (n + 1 rows, zero before). Gives
// the energy at x, if asked; every edge counts from both its ends. Source: thesis Eq 3.3-3.7.
template <bool with_energy, class S>
double shape_step(CellSlices<S>& slices, const simd::Quad<S>* x, const ElasticScale<S>& elastic, simd::Quad<S>* r) {
  const S give = S(1) / (S(1) + elastic.mu);
  double energy = 0;
  detail::for_each_slice<with_energy>(
      slices, x,
      [&](std::size_t s, const MatrixLanes<S>& C) {
        auto& cell = slices.cell[s];
        return detail::fit_transform(C, cell.inverse_size, give, cell.q, cell.scale);
      },
      [&](std::size_t s, const MatrixLanes<S>& M, const detail::Gathered<S>& now) {
        if constexpr (with_energy) energy += detail::slice_energy(slices, s, M, slices.cell[s].scale, elastic);
        detail::spread_residual(slices, s, M, now.pull, r);
      });
  return energy;
}

// The same for the pose state; rotations are refitted but not kept. Source: thesis Eq 3.7-3.11.
template <class S, class Law>
void pose_step(CellSlices<S>& slices, const simd::Quad<S>* x, const Law& law, simd::Quad<S>* r) {
  detail::for_each_slice<true>(
      slices, x,
      [&](std::size_t s, const MatrixLanes<S>& C) {
        QuaternionLanes<S> q = slices.cell[s].q;
        fit_rotations(C, q);
        return detail::volume_transforms(slices, s, rotation_matrix(q), C, law);
      },
      [&](std::size_t s, const MatrixLanes<S>& M, const detail::Gathered<S>& now) {
        detail::spread_residual(slices, s, M, now.pull, r);
      });
}

// Shape energy of x with R and s refitted, summed in double; every edge counts from both its ends. Changes nothing.
template <class S>
double shape_energy(CellSlices<S>& slices, const simd::Quad<S>* x, const ElasticScale<S>& elastic) {
  const S give = S(1) / (S(1) + elastic.mu);
  double energy = 0;
  for (std::size_t s = 0; s < slices.size(); ++s) {
    const MatrixLanes<S> C = detail::gather_slice<true>(slices, s, x).C;
    QuaternionLanes<S> q = slices.cell[s].q;
    simd::Lanes<S> scale;
    const MatrixLanes<S> M = detail::fit_transform(C, slices.cell[s].inverse_size, give, q, scale);
    energy += detail::slice_energy(slices, s, M, scale, elastic);
  }
  return energy;
}

}  // namespace rigless
