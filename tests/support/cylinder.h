// A body to bend: closed, regular, and easy to reason about.
#pragma once

#include <cmath>
#include <vector>

#include "rigless/deform/detail/discs.h"

namespace rigless::test {

// A closed cylinder along y: `rows` rings of `around` vertices and two caps.
struct Cylinder {
  std::vector<Vec3<double>> vertices;
  std::vector<Face> faces;
  std::vector<Control<double>> ends;

  Cylinder(int around, int rows) {
    const double turn = 2 * std::acos(-1.0) / around;
    for (int r = 0; r < rows; ++r) {
      for (int a = 0; a < around; ++a) {
        vertices.push_back({0.5 * std::cos(turn * a), 4.0 * r / (rows - 1), 0.5 * std::sin(turn * a)});
        if (r == 0 || r == rows - 1) ends.push_back({static_cast<std::int32_t>(vertices.size() - 1), 0.0});
      }
    }
    const auto at = [&](int r, int a) { return static_cast<std::int32_t>(r * around + a % around); };
    const auto low = static_cast<std::int32_t>(vertices.size()), high = low + 1;
    vertices.push_back({0, 0, 0});
    vertices.push_back({0, 4, 0});
    for (int a = 0; a < around; ++a) {
      for (int r = 0; r + 1 < rows; ++r) {
        faces.push_back({at(r, a), at(r + 1, a), at(r, a + 1)});
        faces.push_back({at(r, a + 1), at(r + 1, a), at(r + 1, a + 1)});
      }
      faces.push_back({low, at(0, a), at(0, a + 1)});
      faces.push_back({high, at(rows - 1, a + 1), at(rows - 1, a)});
    }
  }

  // Targets of the two ends, pulled apart along y.
  std::vector<Vec3<double>> stretched(double factor) const {
    std::vector<Vec3<double>> targets;
    for (const auto& h : ends) {
      Vec3<double> p = vertices[static_cast<std::size_t>(h.vertex)];
      p.y() *= factor;
      targets.push_back(p);
    }
    return targets;
  }
};

}  // namespace rigless::test
