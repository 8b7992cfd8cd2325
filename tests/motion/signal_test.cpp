#include "rigless/motion/detail/signal.h"

#include <doctest/doctest.h>

#include <random>

using namespace rigless;
using namespace rigless::detail;

TEST_CASE_TEMPLATE("running_minimum is the minimum of each window", S, float, double) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> value(0, 20);
  for (const std::size_t size : {std::size_t{1}, std::size_t{2}, std::size_t{50}}) {
    for (const std::int32_t half : {0, 1, 7, 100}) {
      std::vector<S> x;
      for (std::size_t i = 0; i < size; ++i) x.push_back(static_cast<S>(value(random)));
      const std::vector<S> minimum = running_minimum(x, half);
      for (std::size_t i = 0; i < size; ++i) {
        S expected = x[i];
        for (std::size_t k = 0; k < size; ++k) {
          if (k + static_cast<std::size_t>(half) >= i && k <= i + static_cast<std::size_t>(half)) {
            expected = std::min(expected, x[k]);
          }
        }
        CHECK(minimum[i] == expected);
      }
    }
  }
}

TEST_CASE_TEMPLATE("a parabola has its acceleration in every window, a line none", S, float, double) {
  std::vector<S> fall;
  for (int f = 0; f < 60; ++f)
    fall.push_back(static_cast<S>(3 + 2 * (f / 120.0) - 9.81 / 2 * (f / 120.0) * (f / 120.0)));
  for (const std::size_t last : {std::size_t{6}, std::size_t{9}, std::size_t{59}}) {
    const double tolerance = !std::is_same_v<S, float> ? 1e-9 : last == 6 ? 2e-2 : 1e-3;
    CHECK(parabola_acceleration(fall, 4, last, S(120)) == doctest::Approx(-9.81).epsilon(tolerance));
  }
  CHECK(parabola_acceleration(std::vector<S>{1, 2, 3, 4}, 0, 3, S(30)) == 0);
  CHECK(parabola_acceleration(std::vector<S>{1, 2, 4, 8}, 1, 3, S(1)) == doctest::Approx(2));
}

TEST_CASE("a window of seconds is halved to whole frames") {
  CHECK(half_window(0.05, 120.0) == 3);
  CHECK(half_window(1.4, 30.0) == 21);
}
