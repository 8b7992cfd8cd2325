// The few types that every layer shares. Right-handed, Y up, metres, seconds, radians, counter-clockwise faces.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>

namespace rigless {

template <class S>
using Vec3 = Eigen::Matrix<S, 3, 1>;

template <class S>
using Mat3 = Eigen::Matrix<S, 3, 3>;

// Vertex indices of one triangle, counter-clockwise seen from outside.
using Face = std::array<std::int32_t, 3>;

}  // namespace rigless
