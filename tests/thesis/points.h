// How far two lists of points are apart.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"

namespace rigless::test {

using Points = std::vector<Vec3<double>>;

inline double largest_difference(Span<const Vec3<double>> a, const Points& b) {
  REQUIRE(a.size() == b.size());
  double w = 0;
  for (std::size_t i = 0; i < a.size(); ++i) w = std::max(w, (a[i] - b[i]).cwiseAbs().maxCoeff());
  return w;
}

}  // namespace rigless::test
