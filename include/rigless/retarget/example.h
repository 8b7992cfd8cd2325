// Example poses: "when the human does this, my model does that".
#pragma once

#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"

namespace rigless {

// N examples as views. Joints are body-local metres, controls mesh-local. What an example does not know is NaN.
template <class S>
struct Examples {
  Span<const Vec3<S>> joints;    // N x J
  Span<const Vec3<S>> controls;  // N x C
};

// Examples that own their positions.
template <class S>
struct ExampleStorage {
  std::vector<Vec3<S>> joints;    // N x J
  std::vector<Vec3<S>> controls;  // N x C

  Examples<S> view() const { return {joints, controls}; }
};

// A frame that is worth an example.
struct Ask {
  std::int32_t frame = 0;
  double gain = 0;  // by how much the error of the whole clip would fall
};

}  // namespace rigless
