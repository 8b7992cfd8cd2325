// How like a skin is to what it was made from.
#pragma once

#include <cmath>

#include "rigless/skin/detail/frame_pose.h"

namespace rigless::detail {

// One frame after the other.
class SkinMeasure {
 public:
  SkinMeasure() = default;
  // `influences` must live on.
  SkinMeasure(const std::vector<Vec3<double>>& rest, const std::vector<Influences>& influences, std::vector<Face> faces)
      : influences_(&influences), faces_(std::move(faces)), normal_at_rest_(normals(rest)) {}

  void add(const FramePoses& poses, const std::vector<Vec3<double>>& now) {
    const std::vector<Vec3<double>> wanted = normals(now);
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double missed = (poses.carried(i) - now[i]).squaredNorm();
      sum_ += missed;
      worst_ = std::max(worst_, missed);
      ++count_;
      Vec3<double> normal = normal_at_rest_[i];
      const Influences& of = (*influences_)[i];
      for (int a = 0; a < of.used(); ++a) {
        normal += nth(of.weight, a) * (nth(poses.pose, nth(of.joint, a)).leftCols<3>() * normal_at_rest_[i]);
      }
      const double size = normal.norm() * wanted[i].norm();
      if (!(size > 0)) continue;
      const double angle = std::acos(std::min(1.0, std::max(-1.0, normal.dot(wanted[i]) / size)));
      turned_ += angle * angle;
      ++lit_;
    }
  }

  double rms() const { return count_ > 0 ? std::sqrt(sum_ / static_cast<double>(count_)) : 0; }
  double worst() const { return std::sqrt(worst_); }
  double normals_rms() const { return lit_ > 0 ? std::sqrt(turned_ / static_cast<double>(lit_)) : 0; }

 private:
  // Weighted by area; zeros where no face has any.
  std::vector<Vec3<double>> normals(const std::vector<Vec3<double>>& at) const {
    std::vector<Vec3<double>> out(at.size(), Vec3<double>::Zero());
    for (const Face& f : faces_) {
      const Vec3<double> n = (nth(at, f[1]) - nth(at, f[0])).cross(nth(at, f[2]) - nth(at, f[0]));
      for (const std::int32_t v : f) nth(out, v) += n;
    }
    for (Vec3<double>& n : out) n.normalize();
    return out;
  }

  const std::vector<Influences>* influences_ = nullptr;
  std::vector<Face> faces_;
  std::vector<Vec3<double>> normal_at_rest_;
  double sum_ = 0, worst_ = 0, turned_ = 0;
  std::int64_t count_ = 0, lit_ = 0;
};

}  // namespace rigless::detail
