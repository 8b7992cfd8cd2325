// The local step of the shape state: rotation and scale of every cell.
#pragma once

#include "rigless/deform/detail/cell_sweep.h"

namespace rigless::detail {

// tr(R C), which is e'.e^r.
template <class S>
RIGLESS_INNER simd::Lanes<S> trace_of_product(const MatrixLanes<S>& R, const MatrixLanes<S>& C) {
  simd::Lanes<S> t[3];  // three short sums instead of a long one
  for (int i = 0; i < 3; ++i) t[i] = R.m[3 * i] * C.m[i] + R.m[3 * i + 1] * C.m[3 + i] + R.m[3 * i + 2] * C.m[6 + i];
  return t[0] + t[1] + t[2];
}

// s R that fits C best, from the rotation q on; q is what R was then. `give` is 1 / (1 + mu).
template <class S>
RIGLESS_INNER MatrixLanes<S> fit_transform(const MatrixLanes<S>& C, simd::Lanes<S> inverse_size, S give,
                                           QuaternionLanes<S>& q, simd::Lanes<S>& scale) {
  fit_rotations(C, q);
  MatrixLanes<S> M = rotation_matrix(q);
  scale = S(1) + (trace_of_product(M, C) * inverse_size - S(1)) * give;
  for (auto& m : M.m) m *= scale;
  return M;
}

// Adds up lanes, with the elastic term of each.
template <class S>
inline double slice_energy(const typename CellSlices<S>::Cell& cell, simd::Lanes<S> edges, simd::Lanes<S> scale,
                           const ElasticScale<S>& elastic) {
  if (std::isfinite(elastic.mu)) edges += elastic.mu * cell.size * (scale - S(1)) * (scale - S(1));
  double energy = 0;
  for (int k = 0; k < simd::width<S>; ++k) energy += static_cast<double>(edges[k]);
  return energy;
}

// Fits R and s of every cell to the surface x (n + 1 rows) and adds the residual to r (n + 1 rows, zero before). Gives
// the energy at x, if asked; every edge counts from both its ends. Source: thesis Eq 3.3-3.7.
template <bool with_energy, class S>
double shape_step(CellSlices<S>& slices, const simd::Quad<S>* x, const ElasticScale<S>& elastic, simd::Quad<S>* r) {
  const S give = S(1) / (S(1) + elastic.mu);
  double energy = 0;
  for_each_slice<with_energy>(
      slices, x,
      [&](std::size_t s, const MatrixLanes<S>& C) {
        auto& cell = slices.cell[s];
        return fit_transform(C, cell.inverse_size, give, cell.q, cell.scale);
      },
      [&](std::size_t s, const MatrixLanes<S>& M, const Gathered<S>& now) {
        const auto edges = spread_residual<true, with_energy>(slices, s, M, now.pull, r);
        const auto& cell = slices.cell[s];
        if constexpr (with_energy) energy += slice_energy<S>(cell, edges, cell.scale, elastic);
      });
  return energy;
}

// The same with the rotations that the cells have, none scaled.
template <class S>
void turned_step(CellSlices<S>& slices, const simd::Quad<S>* x, simd::Quad<S>* r) {
  for_each_slice<false>(
      slices, x, [&](std::size_t s, const MatrixLanes<S>&) { return rotation_matrix(slices.cell[s].q); },
      [&](std::size_t s, const MatrixLanes<S>& M, const Gathered<S>& now) {
        spread_residual<true, false>(slices, s, M, now.pull, r);
      });
}

// Shape energy of x with R and s refitted, summed in double; every edge counts from both its ends. Changes nothing.
template <class S>
double shape_energy(CellSlices<S>& slices, const simd::Quad<S>* x, const ElasticScale<S>& elastic) {
  const S give = S(1) / (S(1) + elastic.mu);
  double energy = 0;
  for (std::size_t s = 0; s < slices.size(); ++s) {
    const Gathered<S> now = gather_slice<true>(slices, s, x);
    QuaternionLanes<S> q = slices.cell[s].q;
    simd::Lanes<S> scale;
    const MatrixLanes<S> M = fit_transform(now.C, slices.cell[s].inverse_size, give, q, scale);
    const auto edges = spread_residual<false, true>(slices, s, M, now.pull, static_cast<simd::Quad<S>*>(nullptr));
    energy += slice_energy<S>(slices.cell[s], edges, scale, elastic);
  }
  return energy;
}

}  // namespace rigless::detail
