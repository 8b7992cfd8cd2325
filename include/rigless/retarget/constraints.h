// Hard constraints on control tracks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/types.h"

namespace rigless {

using AxisMask = std::array<bool, 3>;

// The track passes through `position` at `frame`, on the axes of the mask. Source: thesis Eq 3.27.
template <class S>
struct PositionConstraint {
  std::int32_t track = 0;
  std::int32_t frame = 0;
  Vec3<S> position = Vec3<S>::Zero();
  AxisMask axes = {true, true, true};
};

// The track moves by `velocity` from frame - 1 to frame (units per frame), on the axes of the mask.
// Source: thesis Eq 3.28.
template <class S>
struct VelocityConstraint {
  std::int32_t track = 0;
  std::int32_t frame = 1;
  Vec3<S> velocity = Vec3<S>::Zero();
  AxisMask axes = {true, true, true};
};

// y of `track` minus y of `other` is `difference` at `frame`, so that the anchor can change from one to the other. Give
// the difference of the two controls' rest heights above the sole. Source: thesis Fig 3.7.
template <class S>
struct HeightConstraint {
  std::int32_t track = 0;
  std::int32_t other = 0;
  std::int32_t frame = 0;
  S difference = 0;
};

// In the order in which they are counted.
enum class ConstraintKind : std::int32_t { position, velocity };

template <class S>
struct Constraints {
  std::vector<PositionConstraint<S>> positions;
  std::vector<VelocityConstraint<S>> velocities;
  std::vector<HeightConstraint<S>> heights;

  std::size_t size() const { return positions.size() + velocities.size() + heights.size(); }
};

}  // namespace rigless
