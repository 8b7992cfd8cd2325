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

// How a frame weighs the examples.
template <class S>
struct WeightOptions {
  // mu: cost of the squared weight of an example, times its squared distance from the frame.
  S locality = S(0.002);
  // Cost of every squared weight, times the squared distance to the nearest example: between the examples, where a hand
  // that drags imprecisely does most harm, more of them share the weight; an example's own pose stays its own.
  S sharing = S(0.02);
  // Weight of the soft row "sum of weights = 1" of Eq 3.19; 0: the sum is 1 exactly, so that translations do not
  // matter.
  S soft_affine = 0;
  // Only that many nearest examples of each frame are used (the paper: 4, ties by index); 0: all.
  std::int32_t nearest = 0;
  // Cost of the squared weights: shares the weight among examples that nothing else tells apart. Never less than what
  // rounding demands.
  S tikhonov = S(1e-12);
};

// A frame that is worth an example.
struct Ask {
  std::int32_t frame = 0;
  double gain = 0;  // by how much the error of the whole clip would fall
};

// Where a control's limb leaves the trunk, and how long it is from there to the control.
template <class S>
struct ModelLimb {
  Vec3<S> base = Vec3<S>::Zero();  // at rest, mesh-local
  S length = 0;                    // 0: not known
  S swing = 1;                     // 1: it points where the human's does; less: so much from how it rests towards there
};

}  // namespace rigless
