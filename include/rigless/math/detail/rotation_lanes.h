// Best rotations of many cells at once, each from where it was a moment ago.
#pragma once

#include "rigless/math/detail/macros.h"
#include "rigless/math/detail/rotation.h"
#include "rigless/math/detail/simd.h"

namespace rigless::detail {

// Row-major 3x3 matrices and unit quaternions (w, x, y, z), one per lane.
template <class S>
struct MatrixLanes {
  simd::Lanes<S> m[9];
};
template <class S>
struct QuaternionLanes {
  simd::Lanes<S> w, x, y, z;
};

template <class S>
RIGLESS_INNER MatrixLanes<S> rotation_matrix(const QuaternionLanes<S>& q) {
  using L = simd::Lanes<S>;
  const L x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
  const L xx = q.x * x2, yy = q.y * y2, zz = q.z * z2, xy = q.x * y2, xz = q.x * z2, yz = q.y * z2;
  const L wx = q.w * x2, wy = q.w * y2, wz = q.w * z2;
  return {{S(1) - (yy + zz), xy - wz, xz + wy, xy + wz, S(1) - (xx + zz), yz - wx, xz - wy, yz + wx, S(1) - (xx + yy)}};
}

// One Newton step on SO(3) towards the maximum of tr(R C): with G = R C, solve (tr G I - sym G) omega = axial(G).
// Gives |omega|^2, or a negative number in lanes where the second derivative is not negative definite.
template <class S>
RIGLESS_INNER simd::Lanes<S> newton_step(const MatrixLanes<S>& C, QuaternionLanes<S>& q) {
  using L = simd::Lanes<S>;
  const MatrixLanes<S> R = rotation_matrix(q);
  L g[9];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      g[3 * i + j] = R.m[3 * i] * C.m[j] + R.m[3 * i + 1] * C.m[3 + j] + R.m[3 * i + 2] * C.m[6 + j];
    }
  }
  const L ax = g[5] - g[7], ay = g[6] - g[2], az = g[1] - g[3];
  const L h00 = g[4] + g[8], h11 = g[0] + g[8], h22 = g[0] + g[4];
  const L h01 = S(-0.5) * (g[1] + g[3]), h02 = S(-0.5) * (g[2] + g[6]), h12 = S(-0.5) * (g[5] + g[7]);
  const L c00 = h11 * h22 - h12 * h12, c01 = h02 * h12 - h01 * h22, c02 = h01 * h12 - h02 * h11;
  const L c11 = h00 * h22 - h02 * h02, c12 = h01 * h02 - h00 * h12, c22 = h00 * h11 - h01 * h01;
  const L det = h00 * c00 + h01 * c01 + h02 * c02;
  const L trace = h00 + h11 + h22;
  // rank one, or far from the maximum: not for Newton
  const auto fine = (det > S(1e-7) * trace * trace * trace) & (h00 > S(0)) & (c22 > S(0)) & (trace > S(0));
  const L inverse = S(1) / simd::select(fine, det, simd::splat<L>(S(1)));
  const L ox = inverse * (c00 * ax + c01 * ay + c02 * az), oy = inverse * (c01 * ax + c11 * ay + c12 * az),
          oz = inverse * (c02 * ax + c12 * ay + c22 * az);
  const L step2 = ox * ox + oy * oy + oz * oz;
  const auto take = fine & (step2 < S(1));
  // q becomes (1, omega / 2) q, whose squared length is this and near 1 before the last step: three terms of its
  // inverse root are enough, and do not wait for the product
  const L longer = (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z) * (S(1) + S(0.25) * step2) - S(1);
  const L r = S(1) + longer * (longer * (S(0.375) - S(0.3125) * longer) - S(0.5));
  const L hx = S(0.5) * ox, hy = S(0.5) * oy, hz = S(0.5) * oz;
  const QuaternionLanes<S> p = {q.w - hx * q.x - hy * q.y - hz * q.z, q.x + hx * q.w + hy * q.z - hz * q.y,
                                q.y + hy * q.w + hz * q.x - hx * q.z, q.z + hz * q.w + hx * q.y - hy * q.x};
  q.w = simd::select(take, r * p.w, q.w);
  q.x = simd::select(take, r * p.x, q.x);
  q.y = simd::select(take, r * p.y, q.y);
  q.z = simd::select(take, r * p.z, q.z);
  return simd::select(take, step2, simd::splat<L>(S(-1)));
}

template <class S>
void set_rotation(const Mat3<S>& R, int lane, QuaternionLanes<S>& q) {
  const Eigen::Quaternion<S> r(R);
  q.w[lane] = r.w();
  q.x[lane] = r.x();
  q.y[lane] = r.y();
  q.z[lane] = r.z();
}

// Lanes whose last step was too long, or none, by the singular value decomposition.
template <class S>
RIGLESS_COLD void settle_exactly(const MatrixLanes<S>& C, simd::Lanes<S> step2, S settled, QuaternionLanes<S>& q) {
  for (int k = 0; k < simd::width<S>; ++k) {
    if (step2[k] >= S(0) && step2[k] <= settled) continue;
    Mat3<S> c;
    for (int r = 0; r < 3; ++r) {
      for (int s = 0; s < 3; ++s) c(r, s) = C.m[3 * r + s][k];
    }
    set_rotation(nearest_rotation(c), k, q);
  }
}

// Turns each q to the rotation that maximises tr(R C) in its lane, starting from q. One step as a rule; lanes that
// Newton cannot bring there (rank <= 1, a jump) take the singular value decomposition. No allocation. Source: thesis
// Eq 3.4; Newton on SO(3) after Taylor and Kriegman 1994, "Minimization on the Lie group SO(3)".
template <class S>
RIGLESS_INNER void fit_rotations(const MatrixLanes<S>& C, QuaternionLanes<S>& q) {
  // squared step after which the next one would be below what S can show, or below what a later iteration repairs
  // anyway
  constexpr S settled = sizeof(S) == 4 ? S(1e-4) : S(1e-10);
  simd::Lanes<S> step2 = {};
  for (int attempt = 0; attempt < 4; ++attempt) {
    step2 = newton_step(C, q);
    if (!simd::any((step2 < S(0)) | ~(step2 <= settled))) return;
    if (simd::any(step2 < S(0))) break;
  }
  settle_exactly(C, step2, settled, q);
}

}  // namespace rigless::detail
