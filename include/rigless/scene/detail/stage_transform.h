// Between a mesh's own units and axes and the stage.
#pragma once

#include <algorithm>
#include <cmath>

#include "rigless/mesh/detail/measure.h"
#include "rigless/mesh/detail/posture.h"
#include "rigless/scene/performance.h"

namespace rigless::detail {

// The stage: metres, Y up, facing +Z, on y = 0 around x = z = 0.
template <class S>
struct StageTransform {
  Posture<double> posture;
  double scale = 1;  // metres per unit of the mesh
  Vec3<double> offset = Vec3<double>::Zero();

  Vec3<S> to_stage(const Vec3<S>& p) const {
    return (scale * posture.see(p.template cast<double>()) + offset).template cast<S>();
  }

  Vec3<S> from_stage(const Vec3<S>& p) const {
    const Vec3<double> q = (p.template cast<double>() - offset) / scale;
    return (q.x() * posture.left + q.y() * posture.up + q.z() * posture.front).template cast<S>();
  }
};

// How much of its width counts as height, so that a wide mesh fits beside a human.
inline constexpr double width_share = 0.6;

// Makes V finite vertices stage_height tall. No allocation.
template <class S>
StageTransform<S> stage_transform(Span<const Vec3<S>> vertices, const Posture<S>& posture) {
  StageTransform<S> stage;
  stage.posture = {posture.left.template cast<double>(), posture.up.template cast<double>(),
                   posture.front.template cast<double>()};
  const Bounds<S> box = bounds(vertices);
  const Vec3<double> a = stage.posture.see(box.low.template cast<double>());
  const Vec3<double> b = stage.posture.see(box.high.template cast<double>());
  const Vec3<double> extent = (a - b).cwiseAbs();
  const double size = std::max(extent.y(), width_share * std::max(extent.x(), extent.z()));
  if (size > 0 && std::isfinite(size)) stage.scale = stage_height / size;
  stage.offset = -stage.scale * Vec3<double>((a.x() + b.x()) / 2, std::min(a.y(), b.y()), (a.z() + b.z()) / 2);
  return stage;
}

}  // namespace rigless::detail
