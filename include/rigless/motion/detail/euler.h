// Rotations as motion files write them: a list of turns about single axes.
#pragma once

#include <cmath>
#include <cstdint>

#include "rigless/math/types.h"

namespace rigless::detail {

constexpr double radians_per_degree = 3.14159265358979323846 / 180.0;

// R becomes R times a turn by `angle` (radians) about axis 0, 1 or 2. Does not allocate.
inline void turn_about_axis(std::int32_t axis, double angle, Mat3<double>& rotation) {
  const std::int32_t a = (axis + 1) % 3;
  const std::int32_t b = (axis + 2) % 3;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  double* const first = rotation.data() + 3 * a;  // plain columns: Eigen's cost ten times as much where built for size
  double* const second = rotation.data() + 3 * b;
  for (int k = 0; k < 3; ++k) {
    const double x = first[k], y = second[k];
    first[k] = c * x + s * y;
    second[k] = c * y - s * x;
  }
}

// A b, by plain loops for the same reason. Does not allocate.
inline Mat3<double> turned_by(const Mat3<double>& a, const Mat3<double>& b) {
  Mat3<double> product;
  for (int k = 0; k < 9; ++k) {
    const double* const row = a.data() + k % 3;
    const double* const column = b.data() + k / 3 * 3;
    product.data()[k] = row[0] * column[0] + (row[3] * column[1] + row[6] * column[2]);
  }
  return product;
}

}  // namespace rigless::detail
