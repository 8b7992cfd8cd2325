// Whether a body falls freely: what its centre of mass does, and not what one limb does in one frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/motion/clip.h"
#include "rigless/motion/detail/body_parts.h"

namespace rigless::detail {

// T, height of the centre of mass, as far as joints tell; there is always a root. Allocates the result. Source: masses
// of Winter, Biomechanics and Motor Control of Human Movement, each half at either end of its bone.
template <class S>
std::vector<S> mass_heights(const Clip<S>& clip, const JointRoles& roles) {
  struct Part {
    std::int32_t joint;
    S mass;
  };
  const LimbRoles &l = roles.left, &r = roles.right;
  const Part parts[] = {{roles.root, S(0.36)}, {roles.head, S(0.28)}, {l.knee, S(0.09)},  {r.knee, S(0.09)},
                        {l.ankle, S(0.04)},    {r.ankle, S(0.04)},    {l.elbow, S(0.03)}, {r.elbow, S(0.03)},
                        {l.hand, S(0.02)},     {r.hand, S(0.02)}};
  std::vector<S> heights;
  for (std::int32_t f = 0; f < clip.frames; ++f) {
    S mass = 0, moment = 0;
    for (const Part& part : parts) {
      if (part.joint < 0) continue;
      mass += part.mass;
      moment += part.mass * clip.at(f, part.joint).y();
    }
    heights.push_back(moment / mass);
  }
  return heights;
}

}  // namespace rigless::detail
