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

// C = sum w e e'^T of one slice; keeps the present edges e' in slices.edges.
template <class S>
inline MatrixLanes<S> slice_covariance(CellSlices<S>& slices, std::size_t s, const simd::Quad<S>* x) {
  using L = simd::Lanes<S>;
  constexpr int width = simd::width<S>;
  PointLanes<S> at;
  simd::gather<S, width>(x, slices.place.data() + s * width, at.x, at.y, at.z);
  MatrixLanes<S> C = {};
  L* edge = slices.edges.data();
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
    edge[0] = ex;
    edge[1] = ey;
    edge[2] = ez;
    edge += 3;
  }
  const L idle = slices.cell[s].idle;
  C.m[0] += idle;
  C.m[4] += idle;
  C.m[8] += idle;
  return C;
}

// tr(R C), which is e'.e^r.
template <class S>
inline simd::Lanes<S> trace_of_product(const MatrixLanes<S>& R, const MatrixLanes<S>& C) {
  simd::Lanes<S> t = {};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) t += R.m[3 * i + j] * C.m[3 * j + i];
  }
  return t;
}

// Spreads half of w (M e - e') to both ends of every edge of the slice, and gives sum w |M e - e'|^2 if asked.
template <class S, bool with_energy>
inline simd::Lanes<S> spread_residual(CellSlices<S>& slices, std::size_t s, const MatrixLanes<S>& M, simd::Quad<S>* r) {
  using L = simd::Lanes<S>;
  constexpr int width = simd::width<S>;
  const L* edge = slices.edges.data();
  PointLanes<S> sum = {};
  L energy = {};
  const L half = simd::splat<L>(S(0.5));
  for (auto k = static_cast<std::size_t>(slices.first[s]); k < static_cast<std::size_t>(slices.first[s + 1]); ++k) {
    const auto& e = slices.slot[k];
    const L tx = half * (M.m[0] * e.wx + M.m[1] * e.wy + M.m[2] * e.wz - e.w * edge[0]);
    const L ty = half * (M.m[3] * e.wx + M.m[4] * e.wy + M.m[5] * e.wz - e.w * edge[1]);
    const L tz = half * (M.m[6] * e.wx + M.m[7] * e.wy + M.m[8] * e.wz - e.w * edge[2]);
    edge += 3;
    if constexpr (with_energy) {
      const L zero = {};
      energy += simd::select(e.w > zero, S(4) * (tx * tx + ty * ty + tz * tz) / e.w, zero);
    }
    if (r == nullptr) continue;
    sum.x += tx;
    sum.y += ty;
    sum.z += tz;
    simd::scatter_add<S, width>(r, slices.other.data() + k * width, -tx, -ty, -tz);
  }
  if (r != nullptr) simd::scatter_add<S, width>(r, slices.place.data() + s * width, sum.x, sum.y, sum.z);
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
inline MatrixLanes<S> volume_transforms(const CellSlices<S>& slices, std::size_t s, const MatrixLanes<S>& R,
                                        const MatrixLanes<S>& C, const Law& law) {
  using L = simd::Lanes<S>;
  constexpr int width = simd::width<S>;
  const auto& cell = slices.cell[s];
  L D[6] = {};  // sum w d d^T, d = e' - R e
  const L* edge = slices.edges.data();
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

template <class S>
inline void scale_matrix(MatrixLanes<S>& M, simd::Lanes<S> s) {
  for (auto& m : M.m) m *= s;
}

// The energy of one slice with transform s R: every edge from this end, plus the elastic term.
template <class S>
inline double slice_energy(const typename CellSlices<S>::Cell& cell, simd::Lanes<S> edges, simd::Lanes<S> scale,
                           const ElasticScale<S>& elastic) {
  double energy = 0;
  for (int k = 0; k < simd::width<S>; ++k) {
    energy += static_cast<double>(edges[k]);
    if (std::isfinite(elastic.mu)) {
      energy += static_cast<double>(elastic.mu * cell.size[k] * (scale[k] - S(1)) * (scale[k] - S(1)));
    }
  }
  return energy;
}

}  // namespace detail

// Fits R and s of every cell to the surface x (n + 1 rows) and adds the residual to r (n + 1 rows, zero before). Gives
// the energy at x, if asked; every edge counts from both its ends. Source: thesis Eq 3.3-3.7.
template <bool with_energy, class S>
double shape_step(CellSlices<S>& slices, const simd::Quad<S>* x, const ElasticScale<S>& elastic, simd::Quad<S>* r) {
  const S give = S(1) / (S(1) + elastic.mu);
  double energy = 0;
  for (std::size_t s = 0; s < slices.size(); ++s) {
    const MatrixLanes<S> C = detail::slice_covariance(slices, s, x);
    auto& cell = slices.cell[s];
    fit_rotations(C, cell.q);
    MatrixLanes<S> M = rotation_matrix(cell.q);
    cell.scale = S(1) + (detail::trace_of_product(M, C) * cell.inverse_size - S(1)) * give;
    detail::scale_matrix<S>(M, cell.scale);
    const simd::Lanes<S> edges = detail::spread_residual<S, with_energy>(slices, s, M, r);
    if constexpr (with_energy) energy += detail::slice_energy<S>(cell, edges, cell.scale, elastic);
  }
  return energy;
}

// The same for the pose state; rotations are refitted but not kept. Source: thesis Eq 3.7-3.11.
template <class S, class Law>
void pose_step(CellSlices<S>& slices, const simd::Quad<S>* x, const Law& law, simd::Quad<S>* r) {
  for (std::size_t s = 0; s < slices.size(); ++s) {
    const MatrixLanes<S> C = detail::slice_covariance(slices, s, x);
    QuaternionLanes<S> q = slices.cell[s].q;
    fit_rotations(C, q);
    const MatrixLanes<S> R = rotation_matrix(q);
    detail::spread_residual<S, false>(slices, s, detail::volume_transforms(slices, s, R, C, law), r);
  }
}

// Shape energy of x with R and s refitted, summed in double; every edge counts from both its ends. Changes nothing.
template <class S>
double shape_energy(CellSlices<S>& slices, const simd::Quad<S>* x, const ElasticScale<S>& elastic) {
  const S give = S(1) / (S(1) + elastic.mu);
  double energy = 0;
  for (std::size_t s = 0; s < slices.size(); ++s) {
    const MatrixLanes<S> C = detail::slice_covariance(slices, s, x);
    const auto& cell = slices.cell[s];
    QuaternionLanes<S> q = cell.q;
    fit_rotations(C, q);
    MatrixLanes<S> M = rotation_matrix(q);
    const simd::Lanes<S> scale = S(1) + (detail::trace_of_product(M, C) * cell.inverse_size - S(1)) * give;
    detail::scale_matrix<S>(M, scale);
    const simd::Lanes<S> edges = detail::spread_residual<S, true>(slices, s, M, nullptr);
    energy += detail::slice_energy<S>(cell, edges, scale, elastic);
  }
  return energy;
}

}  // namespace rigless
