// The rotation that best explains how one set of edges became another.
#pragma once

#include <Eigen/Geometry>

#include "rigless/math/svd3.h"

namespace rigless {

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
    return Eigen::Quaternion<S>::FromTwoVectors(svd.U.col(0), svd.V.col(0)).toRotationMatrix();
  }
  Mat3<S> U = svd.U;
  if (U.determinant() < S(0)) U.col(2) = -U.col(2);  // V has determinant +1
  return svd.V * U.transpose();
}

}  // namespace rigless
