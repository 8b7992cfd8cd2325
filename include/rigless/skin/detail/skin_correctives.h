// Morph targets for what joints cannot hold: they act at rest, before the joints do.
// Source: Kry, James and Pai 2002, "EigenSkin: real time large deformation character skinning in hardware".
#pragma once

#include <vector>

#include "rigless/skin/detail/frame_pose.h"
#include "rigless/skin/detail/morph_builder.h"

namespace rigless::detail {

// What the joints of a frame do to a point.
struct BlendedMotion {
  Mat3<double> A = Mat3<double>::Zero();
  Vec3<double> b = Vec3<double>::Zero();
};

// pose: J of a frame.
template <class S>
BlendedMotion blended(const Influences& of, const std::vector<Vec3<S>>& centre, const RigidPose<S>* pose) {
  BlendedMotion out;
  for (int a = 0; a < of.used(); ++a) {
    const auto j = to_size(nth(of.joint, a));
    const Mat3<double> R = pose[j].turn.toRotationMatrix().template cast<double>();
    out.A += nth(of.weight, a) * R;
    out.b += nth(of.weight, a) * (pose[j].place.template cast<double>() - R * centre[j].template cast<double>());
  }
  return out;
}

// Where a point has to be at rest so that its joints take it to p; where these squeeze it flat, as near as that.
inline Vec3<double> before(const BlendedMotion& motion, const Vec3<double>& p) {
  constexpr double flat = 0.05;
  const Vec3<double> q = p - motion.b;
  return (motion.A.transpose() * motion.A + flat * flat * Mat3<double>::Identity())
      .ldlt()
      .solve(motion.A.transpose() * q);
}

// What a skin still misses, as morph targets.
template <class S>
class SkinCorrectives {
 public:
  // Works on; true while work is left. The skin gets targets if it is not as like as `options` want without them and
  // more like with them; its likeness is then measured anew. Allocates.
  template <class Options, class Skin>
  bool advance(const MovingPoints<S>& points, const std::vector<Influences>& influences, const Options& options,
               Skin& skin) {
    if (options.targets == 0 || (skin.rms <= options.rms && skin.worst <= options.worst)) return false;
    if (asked_ < points.roots.size()) return ask(points, influences, options, skin);
    if (builder_.advance()) return true;
    take(points, influences, skin);
    return false;
  }

  // 0 to 1, about.
  double progress() const { return builder_.progress(); }

 private:
  // Where the points of the next frame have to be at rest; false if that is no number.
  template <class Options, class Skin>
  bool ask(const MovingPoints<S>& points, const std::vector<Influences>& influences, const Options& options,
           const Skin& skin) {
    std::vector<Vec3<S>> wanted;
    if (asked_ == 0) {
      for (const Vec3<double>& p : points.rest) wanted.push_back(p.template cast<S>());
      if (!builder_.begin(wanted, {options.targets, options.rms, options.worst}).ok()) return false;
      wanted.clear();
    }
    for (std::int32_t i = 0; i < points.count(); ++i) {
      const BlendedMotion motion = blended(nth(influences, i), skin.centre, poses(skin, asked_));
      wanted.push_back(before(motion, points.now(asked_, i)).template cast<S>());
    }
    return builder_.add_frame(wanted, false).ok() && ++asked_ > 0;
  }

  template <class Skin>
  void take(const MovingPoints<S>& points, const std::vector<Influences>& influences, Skin& skin) const {
    const Morphs<S>& morphs = builder_.morphs();
    const auto count = to_size(points.count()), K = to_size(morphs.targets);
    double sum = 0, worst = 0;
    for (std::size_t f = 0; f < points.roots.size(); ++f) {
      for (std::size_t i = 0; i < count; ++i) {
        Vec3<double> p = points.rest[i];
        for (std::size_t k = 0; k < K; ++k)
          p += static_cast<double>(morphs.weight[f * K + k]) * morphs.way[k * count + i].template cast<double>();
        const BlendedMotion motion = blended(influences[i], skin.centre, poses(skin, f));
        const double missed = (motion.A * p + motion.b - points.now(f, static_cast<std::int32_t>(i))).squaredNorm();
        sum += missed;
        worst = std::max(worst, missed);
      }
    }
    const double rms = std::sqrt(sum / static_cast<double>(points.roots.size() * count)) / points.diagonal;
    if (rms > skin.rms) return;  // joints squeeze flat what they should move
    skin.rms = rms;
    skin.worst = std::sqrt(worst) / points.diagonal;
    skin.targets = morphs.targets;
    skin.mix = morphs.weight;
    for (std::size_t k = 0; k < K; ++k)
      for (const std::int32_t point : points.of_vertex) skin.way.push_back(morphs.way[k * count + to_size(point)]);
  }

  template <class Skin>
  static const RigidPose<S>* poses(const Skin& skin, std::size_t f) {
    return skin.pose.data() + f * skin.centre.size();
  }

  MorphBuilder<S> builder_;
  std::size_t asked_ = 0;  // frames
};

}  // namespace rigless::detail
