// As-rigid-as-possible deformation as papers and tutorials write it: one general singular value decomposition per
// vertex, stored rotations, a general sparse factor, everything in double. What the deformer is measured against.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "rigless/deform/detail/cells.h"

namespace rigless_bench {

// Source: Sorkine and Alexa 2007, "As-rigid-as-possible surface modeling".
class TextbookArap {
 public:
  // The cells must outlive this. Controls are single vertices.
  TextbookArap(const rigless::Cells<double>& cells, const std::vector<std::int32_t>& controls)
      : cells_(cells), controls_(controls), unknown_(cells.size(), 0), rotation_(cells.size()), x_(cells.rest) {
    for (const std::int32_t v : controls) unknown_[static_cast<std::size_t>(v)] = -1;
    int free = 0;
    for (int& u : unknown_) u = u < 0 ? -1 : free++;
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (unknown_[i] < 0) continue;
      double diagonal = 0;
      rigless::detail::for_each_edge(cells, i, [&](double w, const Eigen::Vector3d&, std::size_t j) {
        diagonal += w;
        if (unknown_[j] >= 0) entries.emplace_back(unknown_[i], unknown_[j], -w);
      });
      entries.emplace_back(unknown_[i], unknown_[i], diagonal);
    }
    Eigen::SparseMatrix<double> L(free, free);
    L.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(L);
    b_.resize(free, 3);
  }

  bool ok() const { return solver_.info() == Eigen::Success; }

  void set_targets(const std::vector<Eigen::Vector3d>& targets) { targets_ = targets; }

  void set_shape(const std::vector<Eigen::Vector3d>& shape) { x_ = shape; }

  void step() {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
      rigless::detail::for_each_edge(cells_, i, [&](double w, const Eigen::Vector3d& e, std::size_t j) {
        C += w * e * (x_[i] - x_[j]).transpose();
      });
      const Eigen::JacobiSVD<Eigen::Matrix3d> svd(C, Eigen::ComputeFullU | Eigen::ComputeFullV);
      Eigen::Matrix3d U = svd.matrixU();
      if (U.determinant() * svd.matrixV().determinant() < 0) U.col(2) *= -1;
      rotation_[i] = svd.matrixV() * U.transpose();
    }
    for (std::size_t c = 0; c < controls_.size(); ++c) x_[static_cast<std::size_t>(controls_[c])] = targets_[c];
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (unknown_[i] < 0) continue;
      Eigen::Vector3d b = Eigen::Vector3d::Zero();
      rigless::detail::for_each_edge(cells_, i, [&](double w, const Eigen::Vector3d& e, std::size_t j) {
        b += 0.5 * w * (rotation_[i] + rotation_[j]) * e;
        if (unknown_[j] < 0) b += w * x_[j];
      });
      b_.row(unknown_[i]) = b.transpose();
    }
    const Eigen::MatrixX3d solved = solver_.solve(b_);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (unknown_[i] >= 0) x_[i] = solved.row(unknown_[i]).transpose();
    }
  }

  const std::vector<Eigen::Vector3d>& shape() const { return x_; }

 private:
  const rigless::Cells<double>& cells_;
  std::vector<std::int32_t> controls_;
  std::vector<int> unknown_;  // V: row of the system, or -1 for controls
  std::vector<Eigen::Matrix3d> rotation_;
  std::vector<Eigen::Vector3d> x_, targets_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  Eigen::MatrixX3d b_;
};

// The deformer's own cells in double: same weights, same rest.
template <class S>
rigless::Cells<double> in_double(const rigless::Cells<S>& cells) {
  rigless::Cells<double> out;
  out.ring = cells.ring;
  out.weight.assign(cells.weight.begin(), cells.weight.end());
  for (const auto& p : cells.rest) out.rest.push_back(p.template cast<double>());
  rigless::detail::measure_cells(out);
  return out;
}

template <class S>
std::vector<Eigen::Vector3d> in_double(rigless::Span<const rigless::Vec3<S>> points) {
  std::vector<Eigen::Vector3d> out;
  for (const auto& p : points) out.push_back(p.template cast<double>());
  return out;
}

}  // namespace rigless_bench
