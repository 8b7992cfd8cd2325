// Which side of a body is its left.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/body_tree.h"

namespace rigless::detail {

// From the right limb to the left one, mean over the poses.
inline Vec3<double> from_right_to_left(const Poses& poses, std::int32_t left, std::int32_t right) {
  return poses.mean([&](std::size_t f) { return Vec3<double>(poses.at(f, left) - poses.at(f, right)); });
}

// Whether what is called left is left of the way that the body looks: where the toes point, or else to where the knees
// bend, or else +Z. Needs hips, knees, ankles and shoulders.
inline bool is_left_left(const Poses& poses, const JointRoles& roles) {
  double sum = 0;
  for (std::size_t f = 0; f < poses.count(); ++f) {
    const auto at = [&](std::int32_t joint) -> const Vec3<double>& { return poses.at(f, joint); };
    const LimbRoles &l = roles.left, &r = roles.right;
    const Vec3<double> middle = (at(l.hip) + at(r.hip)) / 2;
    const Vec3<double> up = ((at(l.shoulder) + at(r.shoulder)) / 2 - middle).stableNormalized();
    Vec3<double> toes = Vec3<double>::Zero();
    Vec3<double> knees = Vec3<double>::Zero();
    double foot = 0;
    double leg = 0;
    for (const LimbRoles* limb : {&l, &r}) {
      knees += at(limb->knee) - (at(limb->hip) + at(limb->ankle)) / 2;
      leg += (at(limb->hip) - at(limb->ankle)).norm();
      if (limb->toe < 0) continue;
      toes += at(limb->toe) - at(limb->ankle);
      foot += (at(limb->toe) - at(limb->ankle)).norm();
    }
    const auto level = [&](const Vec3<double>& v) { return Vec3<double>(v - v.dot(up) * up); };
    Vec3<double> forward = Vec3<double>::UnitZ();
    if (level(toes).norm() > 0.4 * foot && foot > 0) {
      forward = level(toes);
    } else if (level(knees).norm() > 0.05 * leg) {
      forward = level(knees);
    }
    sum += up.cross(forward.stableNormalized()).dot(at(l.hip) - at(r.hip));
  }
  return sum >= 0;
}

}  // namespace rigless::detail
