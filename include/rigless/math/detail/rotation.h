// The rotation that best explains how one set of edges became another.
#pragma once

#include "rigless/math/detail/svd3.h"

namespace rigless::detail {

// The shortest arc from unit a to unit b; half a turn about any axis across when they are opposite. Eigen's
// FromTwoVectors would bring its general SVD into every build.
template <class S>
Mat3<S> shortest_arc(const Vec3<S>& a, const Vec3<S>& b) {
  const Vec3<S> half = a + b;
  const S length2 = half.squaredNorm();
  if (length2 < S(64) * std::numeric_limits<S>::epsilon() * std::numeric_limits<S>::epsilon()) {
    const Vec3<S> n = any_orthogonal(a);
    return S(2) * n * n.transpose() - Mat3<S>::Identity();
  }
  // Two half turns, about a and about the bisector, are one turn in their plane by the angle between a and b.
  const Vec3<S> h = half / std::sqrt(length2);
  const Mat3<S> about_half = S(2) * h * h.transpose() - Mat3<S>::Identity();
  return about_half * (S(2) * a * a.transpose() - Mat3<S>::Identity());
}

// The R with det R = +1 that maximises tr(R C), for C = sum w e e'^T (rest edges e, present edges e').
// Rank 2 (a flat one-ring) is unique by the determinant. Rank 1 leaves a free turn about one axis: the shortest arc
// is taken. C = 0 gives the identity. No allocation.
// Source: thesis Eq 2.10-2.11 and 3.4; Sorkine 2009, "Least-squares rigid motion using SVD".
template <class S>
Mat3<S> nearest_rotation(const Mat3<S>& C) {
  const Svd3<S> svd = svd3(C);
  const S tiny = svd.sigma[0] * std::numeric_limits<S>::epsilon() * S(8);
  if (svd.sigma[1] <= tiny) {
    if (!(svd.sigma[0] > S(0))) return Mat3<S>::Identity();
    return shortest_arc<S>(svd.U.col(0), svd.V.col(0));
  }
  Mat3<S> U = svd.U;
  if (U.determinant() < S(0)) U.col(2) = -U.col(2);  // V has determinant +1
  return svd.V * U.transpose();
}

}  // namespace rigless::detail
