// What touches the ground at rest.
#pragma once

#include "rigless/math/types.h"

namespace rigless::detail {

// Whether a point rests on the ground as a foot does. floor: y of the lowest vertex; height: of the mesh.
template <class S>
bool rests_on_ground(const Vec3<S>& rest, S floor, S height) {
  return rest.y() - floor < S(0.08) * height;
}

}  // namespace rigless::detail
