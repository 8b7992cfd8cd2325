#include "rigless/math/detail/simd.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace rigless;
using namespace rigless::detail;

TEST_CASE_TEMPLATE("inverse_root agrees with the library over all magnitudes, and is finite for 0", S, float, double) {
  constexpr int width = simd::width<S>;
  const int low = sizeof(S) == 4 ? -120 : -1000;
  for (int exponent = low; exponent < -low; exponent += 3) {
    simd::Lanes<S> v;
    for (int k = 0; k < width; ++k) v[k] = std::ldexp(S(1) + S(k) / S(width), exponent);
    const simd::Lanes<S> r = simd::inverse_root<S, width>(v), one = simd::inverse_root<S, width, 1>(v),
                         two = simd::inverse_root<S, width, 2>(v);
    for (int k = 0; k < width; ++k) {
      const S root = std::sqrt(v[k]);
      CHECK(std::abs(r[k] * root - S(1)) < (sizeof(S) == 4 ? S(4e-7) : S(1e-15)));
      CHECK(std::abs(one[k] * root - S(1)) < S(2e-3));
      CHECK(std::abs(two[k] * root - S(1)) < S(6e-6));
    }
  }
  const simd::Lanes<S> of_zero = simd::inverse_root<S, width>(simd::Lanes<S>{});
  for (int k = 0; k < width; ++k) CHECK(std::isfinite(of_zero[k]));
}

TEST_CASE_TEMPLATE("gather and scatter_add reach rows by their offsets; equal rows add up", S, float, double) {
  constexpr int width = simd::width<S>;
  std::array<simd::Quad<S>, 12> rows{}, sums{};
  simd::RowOffset at[width];
  for (int i = 0; i < 12; ++i) rows[static_cast<std::size_t>(i)] = simd::Quad<S>{S(i), S(10 + i), S(20 + i), S(-1)};
  for (int k = 0; k < width; ++k) at[k] = simd::row_offset<S>(k == 1 ? 11 : 7 - k / 3);
  simd::Lanes<S> x, y, z;
  simd::gather<S, width>(rows.data(), at, x, y, z);
  simd::scatter_add<S, width>(sums.data(), at, x, y, z);
  for (std::int32_t i = 0; i < 12; ++i) {
    int times = 0;
    for (int k = 0; k < width; ++k) {
      if (at[k] != simd::row_offset<S>(i)) continue;
      ++times;
      CHECK((x[k] == S(i)));
      CHECK((y[k] == S(10 + i)));
      CHECK((z[k] == S(20 + i)));
    }
    CHECK((sums[static_cast<std::size_t>(i)][0] == S(times * i)));
    CHECK((sums[static_cast<std::size_t>(i)][2] == S(times * (20 + i))));
    CHECK((sums[static_cast<std::size_t>(i)][3] == S(0)));
  }
}

TEST_CASE("any sees one lane") {
  for (int k = 0; k < simd::width<float>; ++k) {
    simd::Lanes<float> v = {};
    CHECK(!simd::any(v > 0.0f));
    v[k] = 1;
    CHECK(simd::any(v > 0.0f));
  }
}
