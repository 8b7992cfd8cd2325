// What carries a vertex.
#pragma once

#include <Eigen/Core>
#include <array>

#include "rigless/math/detail/index.h"
#include "rigless/math/types.h"

namespace rigless::detail {

inline constexpr int skin_influences = 4;

using Vec4d = Eigen::Matrix<double, 4, 1>;

// How a joint moves points: p goes to p + D (p, 1), with (R - I | t) of F frames below each other. 3F x 4.
using JointMotion = Eigen::Matrix<double, Eigen::Dynamic, 4>;

inline Vec4d lifted(const Vec3<double>& p) { return {p.x(), p.y(), p.z(), 1}; }

// Joints by index, -1 behind the last. The weights sum to one.
struct Influences {
  std::array<std::int32_t, skin_influences> joint{-1, -1, -1, -1};
  std::array<double, skin_influences> weight{};

  int used() const {
    int n = 0;
    while (n < skin_influences && nth(joint, n) >= 0) ++n;
    return n;
  }
};

}  // namespace rigless::detail
