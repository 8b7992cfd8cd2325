// The local step of the pose state: what the shape state stretched along one axis is squeezed across it.
#pragma once

#include "rigless/deform/detail/cell_sweep.h"

namespace rigless::detail {

// An eigenvector, of any length, of the largest eigenvalue of a symmetric positive semidefinite matrix (xx, xy, xz, yy,
// yz, zz); x where no axis stands out. With trace 1, eigenvalues are 1/3 + 2 sqrt(p) cos(phi), and cos(3 phi) follows
// from the determinant: a polynomial gives the cosine to 1e-4, Newton on the characteristic cubic the rest; the vector
// is a column of the adjugate. Source: Smith 1961, "Eigenvalues of a symmetric 3 x 3 matrix".
template <class S>
RIGLESS_INNER PointLanes<S> top_eigenvector(const simd::Lanes<S> (&d)[6]) {
  using L = simd::Lanes<S>;
  constexpr int width = simd::width<S>;
  const L zero = {}, one = simd::splat<L>(S(1));
  const L trace = d[0] + d[3] + d[5];
  const L unit = S(1) / simd::select(trace > zero, trace, one);
  const L third = simd::splat<L>(S(1) / S(3));
  const L a = d[0] * unit - third, e = d[3] * unit - third, g = d[5] * unit - third;
  const L b = d[1] * unit, c = d[2] * unit, f = d[4] * unit;
  const L p = (a * a + e * e + g * g + S(2) * (b * b + c * c + f * f)) * S(1.0 / 6);
  const L det = a * (e * g - f * f) - b * (b * g - c * f) + c * (b * f - c * e);
  const L inverse = simd::inverse_root<S, width, 2>(p + S(1e-20));
  const L r = S(0.5) * det * inverse * inverse * inverse;  // cos(3 phi)
  const L cosine2 = simd::select(r < one, simd::select(r > -one, S(0.5) * (one + r), zero), one);
  const L s = cosine2 * simd::inverse_root<S, width, 1>(cosine2);
  const L cosine = S(0.50007832) + s * (S(0.57464308) + s * (S(0.02098070) * s - S(0.09564044)));  // of acos(s) 2 / 3
  L t = S(2) * p * inverse * cosine;
  for (int it = 0; it < (sizeof(S) == 4 ? 1 : 8); ++it) {  // t^3 - 3 p t = det
    const L slope = S(3) * (t * t - p);
    t -= ((t * t - S(3) * p) * t - det) / simd::select(slope > S(1e-6) * p, slope, one);
  }
  const L aa = a - t, ee = e - t, gg = g - t;
  // columns of the adjugate; the longest is the steadiest
  const L x0 = ee * gg - f * f, y0 = c * f - b * gg, z0 = b * f - c * ee;
  const L y1 = aa * gg - c * c, z1 = b * c - aa * f, z2 = aa * ee - b * b;
  const auto first = (x0 >= y1) & (x0 >= z2);  // of a matrix of rank one the longest has the largest diagonal
  const auto second = y1 >= z2;
  const L x = simd::select(first, x0, simd::select(second, y0, z0)),
          y = simd::select(first, y0, simd::select(second, y1, z1)),
          z = simd::select(first, z0, simd::select(second, z1, z2));
  const auto good = x * x + y * y + z * z > S(1e-30);
  return {simd::select(good, x, one), simd::select(good, y, zero), simd::select(good, z, zero)};
}

// V_i R_i of one slice after Eq 3.8-3.11 of the thesis; law maps stretch to s'.
template <class S, class Law>
RIGLESS_INNER MatrixLanes<S> volume_transforms(CellSlices<S>& slices, std::size_t s, const MatrixLanes<S>& R,
                                               const MatrixLanes<S>& C, const Law& law) {
  using L = simd::Lanes<S>;
  constexpr int width = simd::width<S>;
  const auto& cell = slices.cell[s];
  L D[6] = {};  // sum w d d^T, d = e' - R e
  const L* edge = slices.edges_of(s);
  for (auto k = static_cast<std::size_t>(slices.first[s]); k < static_cast<std::size_t>(slices.first[s + 1]); ++k) {
    const auto& e = slices.slot[k];
    const L& inverse = slices.inverse_weight[k];
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
  const L length2 = p.x * p.x + p.y * p.y + p.z * p.z;
  // where hardly anything moved there is no axis
  const L least = S(1e-12) * cell.size, one = simd::splat<L>(S(1));
  const auto stretched = (D[0] + D[3] + D[5] > least) & (below > least * length2);
  L across = above / simd::select(stretched, below, one);
  for (int k = 0; k < width; ++k) across[k] = law(across[k]);
  across = simd::select(stretched, simd::inverse_root<S, width>(across), one);  // s'^-1/2
  const L gain = (S(1) - across) / length2;                                     // V R = across R + gain p u^T
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

// Adds to r (n + 1 rows, zero before) the residual of the pose state over the shape x (n + 1 rows). Rotations are
// refitted but not kept. Source: thesis Eq 3.7-3.11.
template <class S, class Law>
void pose_step(CellSlices<S>& slices, const simd::Quad<S>* x, const Law& law, simd::Quad<S>* r) {
  for_each_slice<true>(
      slices, x,
      [&](std::size_t s, const MatrixLanes<S>& C) {
        QuaternionLanes<S> q = slices.cell[s].q;
        fit_rotations(C, q);
        return volume_transforms(slices, s, rotation_matrix(q), C, law);
      },
      [&](std::size_t s, const MatrixLanes<S>& M, const Gathered<S>& now) {
        spread_residual<true, false>(slices, s, M, now.pull, r);
      });
}

}  // namespace rigless::detail
