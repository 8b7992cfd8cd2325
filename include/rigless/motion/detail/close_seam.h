// A motion whose end is its beginning again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "rigless/math/detail/index.h"
#include "rigless/math/detail/smooth_step.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/body_frame.h"

namespace rigless::detail {

// Leads the end to the first pose and to its height above the ground; what travels or turns goes on from there. yaw: T.
// Does not allocate.
template <class S>
void close_seam(const std::vector<S>& yaw, Clip<S>& clip) {
  constexpr std::int32_t most = 15;  // frames
  const std::int32_t last = clip.frames - 1, lead = std::min(most, last / 2);
  for (std::int32_t j = clip.joints(); j-- > 0;) {  // the root last: the others are seen from it
    Vec3<S> gap = to_body<S>(clip.at(0, j), clip.at(0, 0), yaw.front()) -
                  to_body<S>(clip.at(last, j), clip.at(last, 0), yaw.back());
    gap.y() += clip.at(0, 0).y() - clip.at(last, 0).y();
    for (std::int32_t f = last - lead + 1; f <= last; ++f) {
      const S share = smooth_step(static_cast<S>(f - last + lead) / static_cast<S>(lead));
      clip.positions[to_size(f * clip.joints() + j)] += from_body<S>(share * gap, Vec3<S>::Zero(), nth(yaw, f));
    }
  }
}

}  // namespace rigless::detail
