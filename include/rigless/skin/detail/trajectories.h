// How vertices move, in few numbers: their ways from rest as coordinates of a subspace of all frames.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"

namespace rigless::detail {

using SkinMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

// n vertices over F frames; a column of 3F numbers is how one of them leaves its place at rest.
struct Trajectories {
  SkinMatrix basis;                // 3F x d, orthonormal
  SkinMatrix coordinates;          // d x n
  std::vector<double> energy;      // n, squared length of the whole column, what the subspace leaves out too
  std::vector<Vec3<double>> rest;  // n

  std::int32_t count() const { return count_of(rest); }
  std::int32_t frames() const { return static_cast<std::int32_t>(basis.rows() / 3); }

  // Appends vertices at `rest` whose columns are those of Y.
  void append(Span<const Vec3<double>> at, const SkinMatrix& Y) {
    const Eigen::Index before = coordinates.cols();
    coordinates.conservativeResize(basis.cols(), before + Y.cols());
    coordinates.rightCols(Y.cols()).noalias() = basis.transpose() * Y;
    for (Eigen::Index i = 0; i < Y.cols(); ++i) {
      energy.push_back(Y.col(i).squaredNorm());
      rest.push_back(at[i]);
    }
  }
};

// An orthonormal basis of at most d columns that holds nearly all of Y, 3F x n. Allocates.
// Source: Kavan, Sloan and O'Sullivan 2010, "Fast and efficient skinning of animated meshes", section 3; the columns by
// subspace iteration (Halko, Martinsson and Tropp 2011, algorithm 4.4).
inline SkinMatrix trajectory_basis(const SkinMatrix& Y, Eigen::Index d) {
  d = std::min(d, std::min(Y.rows(), Y.cols()));
  SkinMatrix B(Y.rows(), d);
  std::uint64_t random = 1;
  for (Eigen::Index k = 0; k < d; ++k) {
    for (Eigen::Index r = 0; r < B.rows(); ++r) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      B(r, k) = static_cast<double>(random >> 40) / 16777216.0 - 0.5;
    }
  }
  for (int sweep = 0; sweep < 3; ++sweep) {
    const SkinMatrix Z = Y.transpose() * B;
    B.noalias() = Y * Z;
    Eigen::Index kept = 0;
    double largest = 0;
    for (Eigen::Index k = 0; k < d; ++k) {
      Eigen::VectorXd column = B.col(k);
      for (int again = 0; again < 2; ++again) {
        for (Eigen::Index j = 0; j < kept; ++j) column -= B.col(j).dot(column) * B.col(j);
      }
      const double length = column.norm();
      largest = std::max(largest, length);
      if (!(length > 1e-14 * largest)) continue;
      B.col(kept++) = column / length;
    }
    d = kept;
    B.conservativeResize(Eigen::NoChange, d);
  }
  return B;
}

}  // namespace rigless::detail
