// Whether a body falls freely: what its centre of mass does, and not what one limb does in one frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/motion/clip.h"
#include "rigless/motion/detail/body_parts.h"

namespace rigless::detail {

// T, height of the centre of mass; parts without a joint lie at the root. Allocates the result. Source: masses
// of Winter, Biomechanics and Motor Control of Human Movement, each half at either end of its bone.
template <class S>
std::vector<S> mass_heights(const Clip<S>& clip, const JointRoles& roles) {
  std::vector<S> heights;
  for (std::int32_t f = 0; f < clip.frames; ++f) {
    const auto at = [&](std::int32_t joint) { return clip.at(f, joint < 0 ? roles.root : joint).y(); };
    const LimbRoles &l = roles.left, &r = roles.right;
    heights.push_back(S(0.36) * at(roles.root) + S(0.28) * at(roles.head) + S(0.09) * (at(l.knee) + at(r.knee)) +
                      S(0.04) * (at(l.ankle) + at(r.ankle)) + S(0.03) * (at(l.elbow) + at(r.elbow)) +
                      S(0.02) * (at(l.hand) + at(r.hand)));
  }
  return heights;
}

}  // namespace rigless::detail
