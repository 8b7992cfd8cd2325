#include "rigless/scene/bake.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "scene/spot_walk.h"
#include "support/alloc_count.h"

using namespace rigless;

namespace {

// Baked vertices of a frame.
template <class S>
std::vector<Vec3<S>> baked(Bake<S>& bake, std::int32_t frame) {
  REQUIRE(bake.frame(frame).ok());
  return {bake.positions().begin(), bake.positions().end()};
}

}  // namespace

TEST_CASE_TEMPLATE("a walking cow stands on the floor and does not slide", S, float, double) {
  SpotWalk<S> spot;
  if (!spot.load()) {
    MESSAGE("skipped: no shared data");
    return;
  }
  Performance<S> performance;
  REQUIRE(spot.perform({}, performance).ok());
  Bake<S> bake;
  bake.bind(spot.body.deformer(), performance, S(1));

  const std::size_t controls = performance.control_count();
  std::vector<Vec3<S>> held;
  S deepest = 0, highest = 0, ratio_low = 1, ratio_high = 1;
  for (std::int32_t f = 0; f < performance.frames; ++f) {
    REQUIRE(bake.frame(f).ok());
    S lowest = bake.positions()[0].y();
    for (const Vec3<S>& p : bake.positions()) lowest = std::min(lowest, p.y());
    deepest = std::max(deepest, -lowest);
    highest = std::max(highest, lowest);
    const S ratio = spot.body.volume_ratio(bake.positions());
    ratio_low = std::min(ratio_low, ratio);
    ratio_high = std::max(ratio_high, ratio);
    for (const auto& control : spot.controls)
      held.push_back(bake.positions()[static_cast<std::size_t>(control.vertex)]);
  }
  const Slip<S> slip = measure_slip<S>(held, performance.contacts, static_cast<std::int32_t>(controls), S(30));
  MESSAGE("slip " << slip.mean / spot.height << " mean, " << slip.maximum / spot.height << " heights/s at most; before "
                  << performance.slip_before.mean / spot.height << "; deepest " << deepest << ", highest " << highest
                  << "; volume " << ratio_low << " to " << ratio_high << "; travel "
                  << std::hypot(performance.travel.back()[0], performance.travel.back()[1]));
  CHECK(std::count(performance.contacts.begin(), performance.contacts.end(), 1) > performance.frames);
  CHECK(slip.maximum <= S(0.001) * spot.height);
  CHECK(performance.slip_before.mean > S(0.01));
  CHECK(deepest <= S(1e-5));
  CHECK(highest <= S(1e-5));  // it walks: never in flight
  CHECK(ratio_low > S(0.8));
  CHECK(ratio_high < S(1.2));
  CHECK(std::hypot(performance.travel.back()[0], performance.travel.back()[1]) > S(0.5));
}

TEST_CASE_TEMPLATE("a frame depends on nothing that was made before it", S, float, double) {
  SpotWalk<S> spot;
  if (!spot.load()) {
    MESSAGE("skipped: no shared data");
    return;
  }
  Performance<S> performance;
  REQUIRE(spot.perform({}, performance).ok());
  performance.flights = {{8, 16}};
  Bake<S> played, alone;
  played.bind(spot.body.deformer(), performance, S(1));
  std::vector<Vec3<S>> in_flight, after;
  for (std::int32_t f = 0; f <= 20; ++f) {
    const auto vertices = baked(played, f);
    if (f == 12) in_flight = vertices;
    if (f == 20) after = vertices;
  }
  std::vector<Vec3<S>> targets(spot.body.rest_controls().begin(), spot.body.rest_controls().end());
  targets[4].y() += S(0.5);
  REQUIRE(spot.body.drag(targets, S(3), false).ok());
  alone.bind(spot.body.deformer(), performance, S(1));
  CHECK(baked(alone, 20) == after);
  CHECK(baked(alone, 12) == in_flight);
  CHECK(baked(played, 12) == in_flight);
}

TEST_CASE("a flight is a throw between the heights at its ends") {
  SpotWalk<double> spot;
  if (!spot.load()) {
    MESSAGE("skipped: no shared data");
    return;
  }
  Performance<double> performance;
  REQUIRE(spot.perform({}, performance).ok());
  performance.flights = {{10, 25}};
  Bake<double> bake;
  bake.bind(spot.body.deformer(), performance, 1.0);
  std::vector<double> height;
  for (std::int32_t f = 10; f <= 25; ++f) {
    REQUIRE(bake.frame(f).ok());
    height.push_back(bake.root().position.y());
  }
  for (std::size_t k = 1; k + 1 < height.size(); ++k) {
    CHECK(height[k + 1] - 2 * height[k] + height[k - 1] == doctest::Approx(-9.81 / 900).epsilon(1e-9));
  }
}

TEST_CASE("a flight never goes through the floor") {
  SpotWalk<double> spot;
  if (!spot.load()) {
    MESSAGE("skipped: no shared data");
    return;
  }
  Performance<double> performance;
  REQUIRE(spot.perform({}, performance).ok());
  performance.flights = {{10, 13}};  // hardly any time: legs that stretch reach the floor before the body falls
  const std::size_t controls = performance.control_count();
  for (std::size_t c = 0; c < 4; ++c) performance.controls[11 * controls + c].y() -= 0.3;
  Bake<double> bake;
  bake.bind(spot.body.deformer(), performance, 1.0);
  REQUIRE(bake.frame(11).ok());
  double lowest = 1;
  for (const auto& p : bake.positions()) lowest = std::min(lowest, p.y());
  CHECK(lowest == doctest::Approx(0).epsilon(1e-12));
}

TEST_CASE("a frame of a bake does not allocate") {
  SpotWalk<float> spot;
  if (!spot.load()) {
    MESSAGE("skipped: no shared data");
    return;
  }
  Performance<float> performance;
  REQUIRE(spot.perform({}, performance).ok());
  performance.flights = {{10, 25}};
  Bake<float> bake;
  bake.bind(spot.body.deformer(), performance, 1.0F);
  const std::int64_t before = test::allocation_count;
  const bool made = bake.frame(12).ok() && bake.frame(30).ok();
  CHECK(test::allocation_count == before);
  CHECK(made);
}

TEST_CASE("a bake names a frame that is not there") {
  Bake<double> bake;
  CHECK(bake.frame(0).error == Error::index_out_of_range);
}
