// How a body's controls act out a motion: what a deformer needs to make any frame of it.
#pragma once

#include <array>
#include <vector>

#include "rigless/math/types.h"

namespace rigless {

inline constexpr double performance_fps = 30;

// Mean and greatest horizontal speed of standing controls, heights per second, over pairs of frames in both of which a
// control stands.
template <class S>
struct Slip {
  S mean = 0;
  S greatest = 0;
};

// T frames of C controls at 30 fps.
template <class S>
struct Performance {
  std::int32_t frames = 0;                           // T
  std::vector<Vec3<S>> controls;                     // T x C, body-local stage metres
  std::vector<std::uint8_t> contacts;                // T x C, 1 while the control stands on the ground
  std::vector<std::array<std::int32_t, 2>> flights;  // [last supported frame, first supported frame after it]
  std::vector<S> yaw;                                // T, put back after deforming
  std::vector<std::array<S, 2>> travel;              // T, x and z of the body's origin
  Slip<S> slip_before, slip_after;                   // without and with the foot lock

  std::size_t control_count() const { return frames > 0 ? controls.size() / static_cast<std::size_t>(frames) : 0; }
};

}  // namespace rigless
