// A mesh that moves as few shapes that are mixed, for squash that joints cannot hold: the principal components of its
// frames.
#pragma once

#include <algorithm>
#include <cmath>

#include "rigless/skin/detail/moving_points.h"
#include "rigless/skin/detail/rigid_pose.h"
#include "rigless/skin/detail/trajectories.h"

namespace rigless::detail {

// Lengths are in diagonals of the box around the mesh at rest.
struct MorphOptions {
  std::int32_t targets = 32;  // at most
  double rms = 0.0013;        // of all vertices in all frames: the fewest targets that reach this
  double worst = 0.008;       // and this
};

// V vertices, F frames, K targets. In frame f vertex v is at root[f] (rest[v] + sum_k weight[f K + k] way[k V + v]);
// of each target the largest weight is 1 or -1.
template <class S>
struct Morphs {
  std::vector<Vec3<S>> way;        // K x V
  std::vector<S> weight;           // F x K
  std::vector<RigidPose<S>> root;  // F, about the origin: the whole body's rigid motion
  std::int32_t targets = 0;
  double rms = 0, worst = 0;  // as in MorphOptions
};

// begin(), add_frame() for each frame of all motions, then advance() until it returns false.
// Source: Alexa and Mueller 2000, "Representing animations by principal components", about rest instead of the mean.
template <class S>
class MorphBuilder {
 public:
  // Copies what it needs. Allocates. Errors: empty_input; not_finite (vertex).
  Status begin(Span<const Vec3<S>> rest, const MorphOptions& options = {}) {
    MovingPoints<S> points;
    if (const Status s = points.begin(rest, {}); !s.ok()) return s;
    *this = MorphBuilder();
    options_ = options;
    points_ = std::move(points);
    return {};
  }

  // V positions; `whole`: the body's rigid motion is the root's. Allocates. Errors: size_mismatch; not_finite (vertex).
  Status add_frame(Span<const Vec3<S>> positions, bool whole = true) { return points_.add_frame(positions, whole); }

  // Works on; true while work is left. Without frames there is none. Allocates.
  bool advance() {
    if (points_.roots.empty() || done_) return false;
    if (curves_.size() == 0) {
      find_curves();
    } else if (fitted_ < points_.count()) {
      fit_block();
    } else {
      done_ = finish();
    }
    return !done_;
  }

  // 0 to 1, about.
  double progress() const {
    return done_ ? 1 : curves_.size() == 0 ? 0 : 0.3 + 0.7 * fitted_ / std::max(points_.count(), 1);
  }

  // What came out, after the last advance().
  const Morphs<S>& morphs() const { return morphs_; }

 private:
  static constexpr std::int32_t block = 1024;
  static constexpr Eigen::Index sampled = 3'000'000;  // numbers that say which curves there are

  // F x 3 many: how points leave their places at rest.
  SkinMatrix ways(std::int32_t from, std::int32_t to, std::int32_t step) const {
    const auto many = static_cast<Eigen::Index>((to - from + step - 1) / step);
    SkinMatrix Y(static_cast<Eigen::Index>(points_.roots.size()), 3 * many);
    for (std::size_t f = 0; f < points_.roots.size(); ++f) {
      for (Eigen::Index i = 0; i < many; ++i) {
        const std::int32_t point = from + static_cast<std::int32_t>(i) * step;
        Y.template block<1, 3>(static_cast<Eigen::Index>(f), 3 * i) =
            (points_.now(f, point) - nth(points_.rest, point)).transpose();
      }
    }
    return Y;
  }

  // F x K, orthonormal, the strongest first: of a sample of the points, which the fewest that reach the goal describe.
  void find_curves() {
    points_.gather(static_cast<std::int32_t>(points_.roots.size()));
    const auto F = static_cast<Eigen::Index>(points_.roots.size());
    const auto most = static_cast<std::int32_t>(std::max<Eigen::Index>(sampled / (3 * F), 100));
    const SkinMatrix Y = ways(0, points_.count(), (points_.count() + most - 1) / most);
    all_ = trajectory_basis(Y, options_.targets);
    const SkinMatrix coordinates = all_.transpose() * Y;
    SkinMatrix left = Y;
    const auto points = static_cast<double>(Y.cols() / 3);
    Eigen::Index K = 0;
    const double diagonal = points_.diagonal;
    const auto is_enough = [&] {
      double worst = 0;
      for (Eigen::Index i = 0; i + 2 < left.cols(); i += 3)
        worst = std::max(worst, left.middleCols<3>(i).rowwise().squaredNorm().maxCoeff());
      return std::sqrt(left.squaredNorm() / (points * static_cast<double>(F))) <= 0.95 * options_.rms * diagonal &&
             std::sqrt(worst) <= 0.9 * options_.worst * diagonal;
    };
    for (; K < all_.cols() && !is_enough(); ++K) left.noalias() -= all_.col(K) * coordinates.row(K);
    begin_fit(std::max<Eigen::Index>(K, 1));
  }

  void begin_fit(Eigen::Index K) {
    curves_ = all_.leftCols(std::min(K, all_.cols()));
    if (curves_.cols() == 0) curves_ = SkinMatrix::Zero(all_.rows(), 1);  // nothing moves but as a whole
    fitted_ = 0;
    sum_ = worst_ = 0;
    targets_.resize(curves_.cols(), 3 * static_cast<Eigen::Index>(points_.count()));
  }

  void fit_block() {
    const std::int32_t to = std::min(fitted_ + block, points_.count());
    SkinMatrix Y = ways(fitted_, to, 1);
    auto own = targets_.middleCols(3 * static_cast<Eigen::Index>(fitted_), Y.cols());
    own.noalias() = curves_.transpose() * Y;
    Y.noalias() -= curves_ * own;
    sum_ += Y.squaredNorm();
    for (Eigen::Index i = 0; i + 2 < Y.cols(); i += 3)
      worst_ = std::max(worst_, Y.template middleCols<3>(i).rowwise().squaredNorm().maxCoeff());
    fitted_ = to;
  }

  // False when more targets are worth a try: what the sample said was not true of all.
  bool finish() {
    const double d = points_.diagonal, all = static_cast<double>(points_.roots.size()) * points_.count();
    morphs_.rms = d > 0 ? std::sqrt(sum_ / all) / d : 0;
    morphs_.worst = d > 0 ? std::sqrt(worst_) / d : 0;
    const bool reached = morphs_.rms <= options_.rms && morphs_.worst <= options_.worst;
    if (!reached && curves_.cols() < all_.cols()) {
      begin_fit(curves_.cols() + std::max<Eigen::Index>(curves_.cols() / 8, 1));
      return false;
    }
    morphs_.targets = static_cast<std::int32_t>(curves_.cols());
    morphs_.root.clear();
    for (const RigidMotion& root : points_.roots) add_pose(morphs_.root, 1, root.R, root.t);
    morphs_.way.clear();
    for (Eigen::Index k = 0; k < curves_.cols(); ++k) {
      const double most = curves_.col(k).cwiseAbs().maxCoeff();
      targets_.row(k) *= most;
      if (most > 0) curves_.col(k) /= most;
      for (const std::int32_t point : points_.of_vertex) {
        const Eigen::Index at = 3 * static_cast<Eigen::Index>(point);
        morphs_.way.push_back(targets_.template block<1, 3>(k, at).transpose().template cast<S>());
      }
    }
    morphs_.weight.clear();
    for (Eigen::Index f = 0; f < curves_.rows(); ++f)
      for (Eigen::Index k = 0; k < curves_.cols(); ++k) morphs_.weight.push_back(static_cast<S>(curves_(f, k)));
    return true;
  }

  MorphOptions options_;
  MovingPoints<S> points_;
  SkinMatrix all_, curves_, targets_;  // F x at most, F x K, K x 3 points
  std::int32_t fitted_ = 0;            // points
  double sum_ = 0, worst_ = 0;
  bool done_ = false;
  Morphs<S> morphs_;
};

}  // namespace rigless::detail
