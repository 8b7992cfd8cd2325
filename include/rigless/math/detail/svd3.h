// Singular value decomposition of one 3x3 matrix, without Eigen's general machinery.
#pragma once

#include <cmath>
#include <limits>

#include "rigless/math/types.h"

namespace rigless::detail {

// A = U diag(sigma) V^T.
template <class S>
struct Svd3 {
  Mat3<S> U;      // orthonormal; determinant +1 or -1
  Vec3<S> sigma;  // >= 0, in descending order
  Mat3<S> V;      // orthonormal, determinant +1
};

// Decomposes A. Never fails on finite input; columns of U that belong to vanishing singular values complete an
// orthonormal basis. No allocation.
// Source: one-sided Jacobi (Hestenes 1958; de Rijk's ordering is not needed for three columns).
template <class S>
Svd3<S> svd3(const Mat3<S>& A);

// Turns columns p and q of B (and V along) until they are orthogonal. Says whether it had to.
template <class S>
bool orthogonalize_columns(Mat3<S>& B, Mat3<S>& V, int p, int q) {
  const S alpha = B.col(p).squaredNorm();
  const S beta = B.col(q).squaredNorm();
  const S gamma = B.col(p).dot(B.col(q));
  const S eps = std::numeric_limits<S>::epsilon();
  if (gamma * gamma <= eps * eps * alpha * beta || gamma == S(0)) return false;
  const S zeta = (beta - alpha) / (S(2) * gamma);
  const S t = (zeta >= S(0) ? S(1) : S(-1)) / (std::abs(zeta) + std::sqrt(S(1) + zeta * zeta));
  const S c = S(1) / std::sqrt(S(1) + t * t);
  const S s = c * t;
  for (Mat3<S>* M : {&B, &V}) {
    const Vec3<S> old = M->col(p);
    M->col(p) = c * old - s * M->col(q);
    M->col(q) = s * old + c * M->col(q);
  }
  return true;
}

// Any unit vector orthogonal to the unit vector a.
template <class S>
Vec3<S> any_orthogonal(const Vec3<S>& a) {
  int k = 0;
  a.cwiseAbs().minCoeff(&k);
  return a.cross(Vec3<S>::Unit(k)).normalized();
}

template <class S>
Svd3<S> svd3(const Mat3<S>& A) {
  Svd3<S> out;
  const S scale = A.cwiseAbs().maxCoeff();
  if (!(scale > S(0))) {
    out.U = out.V = Mat3<S>::Identity();
    out.sigma.setZero();
    return out;
  }
  Mat3<S> B = A / scale;  // so that squares neither overflow nor vanish
  Mat3<S> V = Mat3<S>::Identity();
  for (int sweep = 0; sweep < 30; ++sweep) {
    bool turned = orthogonalize_columns(B, V, 0, 1);
    turned |= orthogonalize_columns(B, V, 0, 2);
    turned |= orthogonalize_columns(B, V, 1, 2);
    if (!turned) break;
  }
  Vec3<S> sigma = B.colwise().norm().transpose();
  int order[3] = {0, 1, 2};
  if (sigma[order[0]] < sigma[order[1]]) std::swap(order[0], order[1]);
  if (sigma[order[1]] < sigma[order[2]]) std::swap(order[1], order[2]);
  if (sigma[order[0]] < sigma[order[1]]) std::swap(order[0], order[1]);
  for (int k = 0; k < 3; ++k) {
    out.V.col(k) = V.col(order[k]);
    out.sigma[k] = sigma[order[k]];
    out.U.col(k) = B.col(order[k]);
  }
  if (out.V.determinant() < S(0)) {  // a permutation may have flipped V
    out.V.col(2) = -out.V.col(2);
    out.U.col(2) = -out.U.col(2);
  }
  const S tiny = out.sigma[0] * std::numeric_limits<S>::epsilon() * S(4);
  out.U.col(0) /= out.sigma[0];
  if (out.sigma[1] > tiny) {
    out.U.col(1) /= out.sigma[1];
  } else {
    out.U.col(1) = any_orthogonal<S>(out.U.col(0));
  }
  if (out.sigma[2] > tiny) {
    out.U.col(2) /= out.sigma[2];
  } else {
    out.U.col(2) = out.U.col(0).cross(out.U.col(1));
  }
  out.sigma *= scale;
  return out;
}

}  // namespace rigless::detail
