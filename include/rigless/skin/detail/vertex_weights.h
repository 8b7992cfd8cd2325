// The weights of one vertex: which joints, and how much of each.
#pragma once

#include <algorithm>
#include <limits>

#include "rigless/math/span.h"
#include "rigless/mesh/detail/one_ring.h"
#include "rigless/skin/detail/influences.h"
#include "rigless/skin/detail/simplex_fit.h"
#include "rigless/skin/detail/trajectories.h"

namespace rigless::detail {

// Weights that are alike where the motion does not say: `pull` is what a difference of one costs, in squared lengths
// summed over frames.
struct Neighbors {
  const OneRing* ring = nullptr;
  double pull = 0;
};

// For joints that stay as they are.
class VertexWeights {
 public:
  VertexWeights(const std::vector<JointMotion>& joints, const SkinMatrix& basis)
      : joints_(count_of(joints)), seen_(4 * joints_, basis.cols()), product_(to_size(joints_ * joints_)) {
    for (std::int32_t j = 0; j < joints_; ++j) {
      seen_.middleRows<4>(4 * j).noalias() = nth(joints, j).transpose() * basis;
      for (std::int32_t k = 0; k <= j; ++k) {
        nth(product_, j * joints_ + k).noalias() = nth(joints, j).transpose().lazyProduct(nth(joints, k));
        if (k < j) nth(product_, k * joints_ + j) = nth(product_, j * joints_ + k).transpose();
      }
    }
  }

  // 4J x d: the joints' motions in the subspace.
  const SkinMatrix& seen() const { return seen_; }

  // Weighs vertex i anew; its squared error. along: 4J, `seen` times its coordinates.
  double fit(std::int32_t i, const Trajectories& motion, const double* along, const Neighbors& neighbors,
             std::vector<Influences>& all) const {
    const Vec4d p = lifted(nth(motion.rest, i));
    std::array<double, 256> wanted;  // per joint, the mean of the neighbours
    if (neighbors.ring) neighbors_mean(i, *neighbors.ring, all, wanted);
    const double* mean = neighbors.ring ? wanted.data() : nullptr;
    Candidates of = candidates(p, along, mean, nth(all, i));
    for (int a = 0; a < of.fit.size; ++a) {
      const std::int32_t j = nth(of.joint, a);
      const double pulled = p.dot(Eigen::Map<const Vec4d>(along + 4 * j));
      nth(of.cost, a) = pulled;
      for (int c = 0; c <= a; ++c) {
        const Mat4d& P = nth(product_, j * joints_ + nth(of.joint, c));
        of.fit.E[a][c] = of.fit.E[c][a] = p.dot(P * p) - pulled - nth(of.cost, c) + nth(motion.energy, i);
      }
      of.fit.b[a] = 0;
      if (mean) {
        of.fit.E[a][a] += neighbors.pull;
        of.fit.b[a] = neighbors.pull * mean[j];
      }
    }
    of.fit.solve();
    nth(all, i) = of.keep_heaviest();
    double error = of.fit.value();
    for (int a = 0; mean && a < of.fit.size; ++a) {
      error += of.fit.w[a] * (2 * of.fit.b[a] - neighbors.pull * of.fit.w[a]);
    }
    return std::max(0.0, error);
  }

 private:
  using Mat4d = Eigen::Matrix<double, 4, 4>;
  static constexpr int most = 10;

  struct Candidates {
    SimplexFit<most> fit;
    std::array<std::int32_t, most> joint;
    std::array<double, most> cost;

    void offer(std::int32_t j, double c) {
      if (fit.size == most && !(c < cost[most - 1])) return;
      int at = fit.size == most ? most - 1 : fit.size++;
      for (; at > 0 && c < nth(cost, at - 1); --at) {
        nth(cost, at) = nth(cost, at - 1);
        nth(joint, at) = nth(joint, at - 1);
      }
      nth(cost, at) = c;
      nth(joint, at) = j;
    }

    // Weighs the heaviest alone, if there are more than a vertex may have.
    Influences keep_heaviest() {
      std::array<int, most> order;
      int used = 0;
      for (int c = 0; c < fit.size; ++c) {
        if (fit.w[c] > 1e-4) nth(order, used++) = c;
      }
      const auto heavier = [&](int a, int b) { return fit.w[a] != fit.w[b] ? fit.w[a] > fit.w[b] : a < b; };
      std::sort(order.begin(), order.begin() + used, heavier);
      used = std::min(used, skin_influences);
      std::sort(order.begin(), order.begin() + used);  // so that no entry is overwritten before it is moved
      for (int a = 0; a < used; ++a) {
        nth(joint, a) = nth(joint, nth(order, a));
        fit.b[a] = fit.b[nth(order, a)];
        for (int c = 0; c < used; ++c) fit.E[a][c] = fit.E[nth(order, a)][nth(order, c)];
      }
      fit.size = used;
      fit.solve();
      Influences out;
      int n = 0;
      for (int a = 0; a < used; ++a) {
        if (!(fit.w[a] > 0)) continue;
        nth(out.joint, n) = nth(joint, a);
        nth(out.weight, n++) = fit.w[a];
      }
      return out;
    }
  };

  // Those that it has, those of its neighbours, and those that would carry it best alone.
  Candidates candidates(const Vec4d& p, const double* along, const double* mean, const Influences& had) const {
    Candidates out;
    for (std::int32_t j = 0; j < joints_; ++j) {
      double cost = p.dot(nth(product_, j * joints_ + j) * p) - 2 * p.dot(Eigen::Map<const Vec4d>(along + 4 * j));
      for (int a = 0; a < had.used(); ++a) {
        if (nth(had.joint, a) == j) cost = -std::numeric_limits<double>::max();
      }
      if (mean && mean[j] > 0.05) cost = -std::numeric_limits<double>::max();
      out.offer(j, cost);
    }
    return out;
  }

  void neighbors_mean(std::int32_t i, const OneRing& ring, const std::vector<Influences>& all,
                      std::array<double, 256>& mean) const {
    std::fill(mean.begin(), mean.begin() + joints_, 0.0);
    const std::int32_t from = nth(ring.first, i), to = nth(ring.first, i + 1);
    for (std::int32_t s = from; s < to; ++s) {
      const Influences& of = nth(all, nth(ring.neighbor, s));
      for (int a = 0; a < of.used(); ++a) nth(mean, nth(of.joint, a)) += nth(of.weight, a) / (to - from);
    }
  }

  std::int32_t joints_;
  SkinMatrix seen_;
  std::vector<Mat4d> product_;  // J x J: products of two joints' motions
};

}  // namespace rigless::detail
