// The joints of a single frame, exactly: from all vertices instead of the subspace.
#pragma once

#include "rigless/skin/detail/joint_fit.h"

namespace rigless::detail {

// The rigid motion that takes n points nearest to n others. Source: Kabsch 1976.
struct RigidMotion {
  Mat3<double> R = Mat3<double>::Identity();
  Vec3<double> t = Vec3<double>::Zero();

  Vec3<double> operator()(const Vec3<double>& p) const { return R * p + t; }
  Vec3<double> back(const Vec3<double>& q) const { return R.transpose() * (q - t); }
};

// at(i) for i < n. No allocation.
template <class From, class To>
RigidMotion nearest_rigid_motion(std::int32_t n, const From& from, const To& to) {
  Vec3<double> a = Vec3<double>::Zero(), b = a;
  for (std::int32_t i = 0; i < n; ++i) {
    a += from(i) / n;
    b += to(i) / n;
  }
  Mat3<double> C = Mat3<double>::Zero();
  for (std::int32_t i = 0; i < n; ++i) C += (from(i) - a) * (to(i) - b).transpose();
  const Mat3<double> R = nearest_rotation<double>(C);
  return {R, b - R * a};
}

// With weights that stay, frame by frame.
class FramePoses {
 public:
  void begin(const std::vector<Vec3<double>>& rest, const std::vector<Influences>& influences, std::int32_t joints) {
    rest_ = &rest;
    influences_ = &influences;
    shared_ = SharedWeights(joints);
    for (std::size_t i = 0; i < rest.size(); ++i) shared_.add(influences[i], lifted(rest[i]), 1);
    pose.assign(to_size(joints), JointMotion::Zero(3, 4));
  }

  // J: starts from what it holds. now(i): where vertex i is, before the root moves it.
  template <class Now>
  void fit(const Now& now) {
    std::vector<JointMotion> pull(pose.size(), JointMotion::Zero(3, 4));
    for (std::size_t i = 0; i < rest_->size(); ++i) {
      const Influences& of = (*influences_)[i];
      const Vec3<double> way = now(i) - (*rest_)[i];
      for (int a = 0; a < of.used(); ++a) {
        nth(pull, nth(of.joint, a)) += way.lazyProduct((nth(of.weight, a) * lifted((*rest_)[i])).transpose());
      }
    }
    for (int sweep = 0; sweep < 4; ++sweep) {
      shared_.place([&](std::int32_t j) -> JointMotion { return nth(pull, j); }, pose);
    }
  }

  Vec3<double> carried(std::size_t i) const {
    Vec3<double> p = (*rest_)[i];
    const Influences& of = (*influences_)[i];
    for (int a = 0; a < of.used(); ++a) {
      p += nth(of.weight, a) * (nth(pose, nth(of.joint, a)) * lifted((*rest_)[i]));
    }
    return p;
  }

  std::vector<JointMotion> pose;  // J, 3 x 4 each

 private:
  const std::vector<Vec3<double>>* rest_ = nullptr;
  const std::vector<Influences>* influences_ = nullptr;
  SharedWeights shared_{0};
};

}  // namespace rigless::detail
