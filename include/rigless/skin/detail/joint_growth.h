// Joints one after the other, each where the present ones carry worst, until they are enough.
#pragma once

#include <algorithm>
#include <numeric>

#include "rigless/skin/detail/joint_fit.h"

namespace rigless::detail {

// How far vertices are from where they should be; lengths.
struct SkinError {
  double rms = 0;
  double worst = 0;

  bool within(const SkinError& most) const { return rms <= most.rms && worst <= most.worst; }
};

class JointGrowth {
 public:
  JointFit fit;

  // Y: 3F x n, the columns of `motion`; both must live on.
  void begin(const Trajectories& motion, const SkinMatrix& Y) {
    Y_ = &Y;
    fit.begin(motion);
    std::vector<std::int32_t> all(motion.rest.size());
    std::iota(all.begin(), all.end(), 0);
    fit.joints.clear();
    fit.add_joint(all);
    fit.fit_weights();
    measure();
  }

  const SkinError& error() const { return error_; }

  // More joints, and the fit again; true when they are enough.
  bool grow(const SkinError& most, std::int32_t joints) {
    // Far from the goal several at once cost no quality.
    const std::int32_t have = count_of(fit.joints), step = error_.rms > 2 * most.rms ? 1 + have / 12 : 1 + have / 32;
    std::vector<std::uint8_t> taken(fit.error.size(), 0);
    for (std::int32_t k = 0; k < step && have + k < joints; ++k) seed(taken);
    refine(6);
    // One joint less is worth a few steps more.
    for (int more = 0; more < 3 && close(most) && !error_.within(most); ++more) refine(2);
    return enough(most, joints);
  }

  bool enough(const SkinError& most, std::int32_t joints) const {
    return error_.within(most) || count_of(fit.joints) >= joints;
  }

  void refine(int steps) {
    for (int k = 0; k < steps; ++k) {
      fit.fit_joints();
      fit.fit_weights();
    }
    measure();
  }

 private:
  bool close(const SkinError& most) const { return error_.rms < 1.15 * most.rms && error_.worst < 1.15 * most.worst; }

  // A joint for those around the place where most is missed.
  void seed(std::vector<std::uint8_t>& taken) {
    constexpr std::int32_t tries = 24, group = 24;
    const std::int32_t n = fit.motion->count();
    const auto missed = [&](std::int32_t i) { return nth(taken, i) ? 0 : nth(fit.importance, i) * nth(fit.error, i); };
    std::vector<std::int32_t> order(to_size(n));
    std::iota(order.begin(), order.end(), 0);
    const auto bad = order.begin() + std::min(n, tries);
    std::partial_sort(order.begin(), bad, order.end(), [&](std::int32_t a, std::int32_t b) {
      return missed(a) != missed(b) ? missed(a) > missed(b) : a < b;
    });
    const std::vector<std::int32_t> places(order.begin(), bad);
    std::vector<std::int32_t> best;
    double most = -1;
    for (const std::int32_t place : places) {
      std::vector<std::int32_t> near = nearest(place, std::min(n, group));
      double sum = 0;
      for (const std::int32_t i : near) sum += missed(i);
      if (!(sum > most)) continue;
      most = sum;
      best = std::move(near);
    }
    for (const std::int32_t i : best) nth(taken, i) = 1;
    fit.add_joint(best);
  }

  std::vector<std::int32_t> nearest(std::int32_t place, std::int32_t many) const {
    const std::vector<Vec3<double>>& rest = fit.motion->rest;
    std::vector<std::pair<double, std::int32_t>> all(rest.size());
    for (std::int32_t i = 0; i < count_of(rest); ++i)
      nth(all, i) = {(nth(rest, i) - nth(rest, place)).squaredNorm(), i};
    std::nth_element(all.begin(), all.begin() + (many - 1), all.end());
    std::vector<std::int32_t> out;
    for (std::int32_t k = 0; k < many; ++k) out.push_back(nth(all, k).second);
    std::sort(out.begin(), out.end());
    return out;
  }

  // The error, and how much each vertex counts from now on: those with a bad frame more.
  void measure() {
    const std::int32_t n = fit.motion->count();
    std::vector<double> peak(to_size(n));
    double sum = 0, worst = 0, mean = 0;
    Eigen::VectorXd left;
    for (std::int32_t i = 0; i < n; ++i) {
      left = -Y_->col(i);
      const Influences& of = nth(fit.influences, i);
      for (int a = 0; a < of.used(); ++a) {
        left += nth(fit.joints, nth(of.joint, a)).lazyProduct(nth(of.weight, a) * lifted(nth(fit.motion->rest, i)));
      }
      double most = 0;
      for (Eigen::Index row = 0; row < left.size(); row += 3) most = std::max(most, left.segment<3>(row).squaredNorm());
      nth(peak, i) = most;
      sum += left.squaredNorm();
      worst = std::max(worst, most);
      mean += most / n;
    }
    error_ = {std::sqrt(sum / (static_cast<double>(n) * fit.motion->frames())), std::sqrt(worst)};
    if (!(mean > 0)) return;
    for (std::int32_t i = 0; i < n; ++i) nth(fit.importance, i) = std::sqrt((nth(peak, i) + mean) / mean);
  }

  const SkinMatrix* Y_ = nullptr;
  SkinError error_;
};

}  // namespace rigless::detail
