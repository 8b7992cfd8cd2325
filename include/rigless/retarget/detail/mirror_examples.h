// Every example teaches its mirror image too.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/example.h"

namespace rigless::detail {

// Partners in the mirror. The human's plane is x = 0 of the body-local frame; the mesh has its own.
template <class S>
struct MirrorTables {
  Span<const std::int32_t> joints;    // J: the joint on the other side, or itself
  Span<const std::int32_t> controls;  // C: the control on the other side, itself on the plane, -1: none
  Vec3<S> normal = Vec3<S>::UnitX();  // of the mesh's plane, length 1
};

// p on the other side of the plane through the origin with that normal.
template <class S>
Vec3<S> reflected(const Vec3<S>& p, const Vec3<S>& normal) {
  return p - S(2) * p.dot(normal) * normal;
}

// Appends the mirror image of each example. A control moves from its place at rest as its partner does in the example,
// so that a mesh may be somewhat uneven; a control without a partner is NaN: the image says nothing about it. rest: C.
// Allocates.
template <class S>
RIGLESS_COLD void add_mirror_images(const MirrorTables<S>& mirror, Span<const Vec3<S>> rest,
                                    ExampleStorage<S>& examples) {
  const std::size_t joints = mirror.joints.size(), controls = mirror.controls.size();
  const std::size_t count = examples.controls.size() / controls;
  for (std::size_t n = 0; n < count; ++n) {
    for (std::size_t j = 0; j < joints; ++j) {
      const Vec3<S> other = examples.joints[n * joints + to_size(mirror.joints[j])];
      examples.joints.push_back({-other.x(), other.y(), other.z()});
    }
    for (std::size_t c = 0; c < controls; ++c) {
      Vec3<S> place = Vec3<S>::Constant(std::numeric_limits<S>::quiet_NaN());
      if (mirror.controls[c] >= 0) {
        const auto other = to_size(mirror.controls[c]);
        const Vec3<S> moved = examples.controls[n * controls + other] - rest[other];
        place = rest[c] + reflected<S>(moved, mirror.normal);
      }
      examples.controls.push_back(place);
    }
  }
}

}  // namespace rigless::detail
