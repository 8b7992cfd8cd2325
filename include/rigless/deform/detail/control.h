// A control point: what a user holds a body by. Public through Deformer and Body.
#pragma once

#include <cstdint>

#include "rigless/math/types.h"

namespace rigless {

// Where a control sits and how far what it holds reaches: a disc along a surface (radius 0 holds the vertex alone), a
// ball of a solid, or a level slab of it, as thick as two radii: a trunk does not spin about a slab.
template <class S>
struct Control {
  std::int32_t vertex = -1;
  S radius = S(0);
  bool slab = false;
  bool on_limb = false;            // of a solid: it is known to be at the tip of a limb
  Vec3<S> base{S(0), S(0), S(0)};  // where that limb leaves the trunk
  Vec3<S> bend{S(0), S(0), S(0)};  // where it bends at rest
};

}  // namespace rigless
