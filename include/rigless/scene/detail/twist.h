// Controls that turn beyond what surrounds them: a hand that is twisted, a head that looks aside.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "rigless/scene/detail/drag.h"

namespace rigless::detail {

// Less is not worth a solve, radians.
inline constexpr double least_twist = 1e-3;

// From a shape that has met its targets: each of C controls (or none) turns by its rotation vector beyond how it is
// turned, and what surrounds it follows. Free discs are free again. No allocation.
template <class S>
RIGLESS_COLD void twist_controls(Deformer<S>& deformer, Span<const Vec3<S>> turns, S volume) {
  bool any = false;
  for (std::size_t c = 0; c < turns.size(); ++c) {
    const S angle = turns[c].norm();
    if (!(angle > static_cast<S>(least_twist))) continue;
    const Mat3<S> turn = Eigen::AngleAxis<S>(angle, turns[c] / angle).toRotationMatrix();
    deformer.turn(static_cast<std::int32_t>(c), turn * deformer.disc_rotations()[c]);
    any = true;
  }
  if (!any) return;
  deformer.relax(iterations_from_rest);
  deformer.pose(volume);
  for (std::int32_t c = 0; c < deformer.controls(); ++c) deformer.free_turn(c);
}

}  // namespace rigless::detail
