// Rigid joints that carry vertices by weights, fitted to how they move: the alternation.
#pragma once

#include "rigless/math/detail/rotation.h"
#include "rigless/skin/detail/influences.h"
#include "rigless/skin/detail/trajectories.h"
#include "rigless/skin/detail/vertex_weights.h"

namespace rigless::detail {

// sum w p (p, 1)^T and what it is taken to: where the points that a joint carries lie, in 4 x 4 numbers.
using Mat4d = Eigen::Matrix<double, 4, 4>;

// The rigid motions that take what `own` sums up (sum w^2 p p^T) nearest to X = sum w q p^T, 3 rows for each frame.
// Where `own` is nothing D stays. Source: Kabsch 1976, with weights.
inline void place_joint(const JointMotion& X, const Mat4d& own, JointMotion& D) {
  const double all = own(3, 3);
  if (!(all > 1e-12)) return;
  const Vec3<double> centre = own.block<3, 1>(0, 3) / all;
  const Mat3<double> spread = own.topLeftCorner<3, 3>() - all * centre * centre.transpose();
  for (Eigen::Index row = 0; row < X.rows(); row += 3) {
    const Vec3<double> shift = X.block<3, 1>(row, 3) / all;  // of the centre
    const Mat3<double> C = X.block<3, 3>(row, 0) - all * shift * centre.transpose() + spread;
    const Mat3<double> R = nearest_rotation<double>(C.transpose());
    D.block<3, 3>(row, 0) = R - Mat3<double>::Identity();
    D.block<3, 1>(row, 3) = shift + centre - R * centre;
  }
}

// sum over vertices of w_j w_k p p^T, by pairs of joints.
class SharedWeights {
 public:
  explicit SharedWeights(std::int32_t joints) : joints_(joints), sum_(to_size(joints * joints), Mat4d::Zero()) {}

  void add(const Influences& of, const Vec4d& p, double importance) {
    const Mat4d pp = importance * p * p.transpose();
    for (int a = 0; a < of.used(); ++a) {
      for (int c = 0; c < of.used(); ++c) {
        nth(sum_, nth(of.joint, a) * joints_ + nth(of.joint, c)) += nth(of.weight, a) * nth(of.weight, c) * pp;
      }
    }
  }

  const Mat4d& own(std::int32_t j) const { return nth(sum_, j * joints_ + j); }

  // Each joint once, the others as they are. pull(j): sum w_j A p^T of the frames that D holds.
  template <class Pull>
  void place(const Pull& pull, std::vector<JointMotion>& D) const {
    for (std::int32_t j = 0; j < joints_; ++j) {
      JointMotion X = pull(j);
      for (std::int32_t k = 0; k < joints_; ++k) {
        const Mat4d& both = nth(sum_, j * joints_ + k);
        if (k != j && both(3, 3) > 0) X.noalias() -= nth(D, k).lazyProduct(both);
      }
      place_joint(X, own(j), nth(D, j));
    }
  }

 private:
  std::int32_t joints_;
  std::vector<Mat4d> sum_;
};

// J joints and the weights of n vertices.
// Source: Le and Deng 2012, "Smooth skinning decomposition with rigid bones". Both of its least squares problems need
// nothing but products of the joints' motions with each other and with the subspace: a step costs no more for more
// frames.
class JointFit {
 public:
  const Trajectories* motion = nullptr;
  std::vector<JointMotion> joints;     // J
  std::vector<Influences> influences;  // n
  std::vector<double> error;           // n: squared, summed over frames
  std::vector<double> importance;      // n

  // Forgets the vertices, and keeps the joints.
  void begin(const Trajectories& of) {
    motion = &of;
    influences.assign(of.rest.size(), {});
    error = of.energy;
    importance.assign(of.rest.size(), 1.0);
  }

  void fit_weights(const Neighbors& neighbors = {}) {
    const std::int32_t n = motion->count(), block = 64;
    const VertexWeights weigh(joints, motion->basis);
    SkinMatrix along;
    for (std::int32_t from = 0; from < n; from += block) {
      const std::int32_t many = std::min(block, n - from);
      along.noalias() = weigh.seen() * motion->coordinates.middleCols(from, many);
      for (std::int32_t i = from; i < from + many; ++i) {
        nth(error, i) = weigh.fit(i, *motion, &along(0, i - from), neighbors, influences);
      }
    }
  }

  void fit_joints() {
    const std::int32_t n = motion->count(), J = count_of(joints);
    SharedWeights shared(J);
    std::vector<JointMotion> pull(to_size(J), JointMotion::Zero(motion->basis.cols(), 4));
    for (std::int32_t i = 0; i < n; ++i) {
      const Influences& of = nth(influences, i);
      const Vec4d p = nth(importance, i) * lifted(nth(motion->rest, i));
      shared.add(of, lifted(nth(motion->rest, i)), nth(importance, i));
      for (int a = 0; a < of.used(); ++a) {
        nth(pull, nth(of.joint, a)).noalias() +=
            motion->coordinates.col(i).lazyProduct((nth(of.weight, a) * p).transpose());
      }
    }
    shared.place([&](std::int32_t j) -> JointMotion { return motion->basis * nth(pull, j); }, joints);
  }

  // A new joint that moves as a group of vertices does.
  void add_joint(const std::vector<std::int32_t>& group) {
    JointMotion pull = JointMotion::Zero(motion->basis.cols(), 4);
    Mat4d own = Mat4d::Zero();
    for (const std::int32_t i : group) {
      const Vec4d p = lifted(nth(motion->rest, i));
      pull += motion->coordinates.col(i).lazyProduct(p.transpose());
      own += p * p.transpose();
    }
    joints.push_back(JointMotion::Zero(motion->basis.rows(), 4));
    place_joint(motion->basis * pull, own, joints.back());
  }
};

}  // namespace rigless::detail
