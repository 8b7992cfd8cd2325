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

TEST_CASE_TEMPLATE("a parabola has its acceleration everywhere, a line none", S, float, double) {
  std::vector<S> fall;
  for (int f = 0; f < 60; ++f)
    fall.push_back(static_cast<S>(3 + 2 * (f / 120.0) - 9.81 / 2 * (f / 120.0) * (f / 120.0)));
  for (const std::int32_t half : {1, 6}) {
    const double tolerance = std::is_same_v<S, float> ? (half == 1 ? 2e-2 : 1e-3) : 1e-9;
    for (const S a : parabola_acceleration(fall, half, S(120))) CHECK(a == doctest::Approx(-9.81).epsilon(tolerance));
  }
  for (const S a : parabola_acceleration(std::vector<S>{1, 2, 3, 4}, 1, S(30))) CHECK(a == 0);
  for (const S a : parabola_acceleration(std::vector<S>{1, 5}, 1, S(30))) CHECK(a == 0);
}

TEST_CASE("running_mean keeps a constant and the ends") {
  for (const double m : running_mean(std::vector<double>(9, 2.5), 3)) CHECK(m == 2.5);
  CHECK(running_mean(std::vector<double>{0, 3, 0}, 1)[0] == 1);
  CHECK(half_window(0.05, 120.0) == 3);
  CHECK(half_window(1.4, 30.0) == 21);
}
