#include "rigless/scene/bake.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "scene/dancers.h"
#include "support/alloc_count.h"

using namespace rigless;
using namespace rigless::detail;
using test::Cactus;
using test::Dancer;
using test::SpotWalk;

namespace {

// Baked vertices of a frame.
template <class S>
std::vector<Vec3<S>> baked(Bake<S>& bake, std::int32_t frame) {
  REQUIRE(bake.frame(frame).ok());
  return {bake.positions().begin(), bake.positions().end()};
}

template <class S>
S lowest(Span<const Vec3<S>> vertices) {
  S low = vertices[0].y();
  for (const Vec3<S>& p : vertices) low = std::min(low, p.y());
  return low;
}

// What is true of every dance, measured on all of its vertices.
template <class S>
void check_dance(Dancer<S>& dancer, Performance<S>& performance) {
  REQUIRE(dancer.perform({}, performance).ok());
  Bake<S> bake;
  bake.bind(dancer.body, performance, S(1));

  const std::size_t controls = performance.control_count();
  std::vector<Vec3<S>> held;
  S deepest = 0, highest = 0, ratio_low = 1, ratio_high = 1;
  for (std::int32_t f = 0; f < performance.frames; ++f) {
    CAPTURE(f);
    REQUIRE(bake.frame(f).ok());
    const S low = lowest<S>(bake.positions());
    const auto over = [&](const Flight& flight) { return flight.take_off < f && f < flight.landing; };
    const bool flies = std::any_of(performance.flights.begin(), performance.flights.end(), over);
    deepest = std::max(deepest, -low);
    if (!flies) highest = std::max(highest, low);
    const S ratio = dancer.body.volume_ratio();
    ratio_low = std::min(ratio_low, ratio);
    ratio_high = std::max(ratio_high, ratio);
    for (const auto& control : dancer.controls)
      held.push_back(bake.positions()[static_cast<std::size_t>(control.vertex)]);
  }
  const Slip<S> slip = measure_slip<S>(held, performance.contacts, static_cast<std::int32_t>(controls), S(30));
  MESSAGE("slip " << slip.mean / dancer.height << " mean, " << slip.maximum / dancer.height
                  << " heights/s at most; before " << performance.slip_before.mean / dancer.height << "; deepest "
                  << deepest << ", highest " << highest << "; volume " << ratio_low << " to " << ratio_high);
  CHECK(std::count(performance.contacts.begin(), performance.contacts.end(), 1) > performance.frames);
  CHECK(slip.maximum <= S(0.001) * dancer.height);
  CHECK(performance.slip_before.mean > S(0.01));
  CHECK(deepest <= S(1e-5));
  CHECK(highest <= S(1e-5));  // what stands, stands on the floor
  CHECK(ratio_low > S(0.8));
  CHECK(ratio_high < S(1.2));
}

template <class S>
void check_frames_stand_alone(Dancer<S>& dancer) {
  Performance<S> performance;
  REQUIRE(dancer.perform({}, performance).ok());
  performance.flights = {{8, 16}};
  Bake<S> played, alone;
  played.bind(dancer.body, performance, S(1));
  std::vector<Vec3<S>> in_flight, after;
  for (std::int32_t f = 0; f <= 20; ++f) {
    const auto vertices = baked(played, f);
    if (f == 12) in_flight = vertices;
    if (f == 20) after = vertices;
  }
  std::vector<Vec3<S>> targets(dancer.body.rest_controls().begin(), dancer.body.rest_controls().end());
  targets[4].y() += S(0.5);
  REQUIRE(dancer.body.drag(targets, S(3), false).ok());
  alone.bind(dancer.body, performance, S(1));
  CHECK(baked(alone, 20) == after);
  CHECK(baked(alone, 12) == in_flight);
  CHECK(baked(played, 12) == in_flight);
}

template <class S>
S travelled(const Performance<S>& performance) {
  return std::hypot(performance.travel.back()[0], performance.travel.back()[1]);
}

}  // namespace

TEST_CASE_TEMPLATE("a hopping cactus leaves the floor, stands on it and does not slide", S, float, double) {
  Cactus<S> cactus("hop.bvh");
  Performance<S> performance;
  check_dance(cactus, performance);
  REQUIRE(performance.flights.size() > 0);
  Bake<S> bake;
  bake.bind(cactus.body, performance, S(1));
  const Flight& leap = performance.flights[0];
  REQUIRE(bake.frame((leap.take_off + leap.landing) / 2).ok());
  CHECK(lowest<S>(bake.positions()) > S(0.02));
}

TEST_CASE_TEMPLATE("a walking cow stands on the floor and does not slide" * test::needs_shared(), S, float, double) {
  SpotWalk<S> spot;
  Performance<S> performance;
  check_dance(spot, performance);
  CHECK(performance.flights.empty());
  CHECK(travelled(performance) > S(0.5));
}

TEST_CASE("a cactus walks away, or on the spot") {
  Cactus<double> cactus("walk.bvh");
  Performance<double> away, in_place;
  REQUIRE(cactus.perform({}, away).ok());
  CHECK(travelled(away) > 0.5);
  PerformanceSettings<double> settings;
  settings.in_place = true;
  REQUIRE(cactus.perform(settings, in_place).ok());
  Bake<double> bake;
  for (const Performance<double>* performance : {&away, &in_place}) {
    bake.bind(cactus.body, *performance, 1.0);
    double farthest = 0;
    for (std::int32_t f = 0; f < performance->frames; f += 10) {
      const auto vertices = baked(bake, f);
      Vec3<double> middle = Vec3<double>::Zero();
      for (const auto& p : vertices) middle += p / static_cast<double>(vertices.size());
      farthest = std::max(farthest, std::hypot(middle.x(), middle.z()));
    }
    CAPTURE(farthest);
    CHECK((farthest > 0.5) == (performance == &away));
  }
}

TEST_CASE_TEMPLATE("a frame depends on nothing that was made before it", S, float, double) {
  Cactus<S> cactus("hop.bvh");
  check_frames_stand_alone(cactus);
}

TEST_CASE_TEMPLATE("nor does one of a motion file and a mesh met elsewhere" * test::needs_shared(), S, float, double) {
  SpotWalk<S> spot;
  check_frames_stand_alone(spot);
}

TEST_CASE("a flight is a throw between the heights at its ends") {
  Cactus<double> cactus("hop.bvh");
  Performance<double> performance;
  REQUIRE(cactus.perform({}, performance).ok());
  performance.flights = {{10, 25}};
  Bake<double> bake;
  bake.bind(cactus.body, performance, 1.0);
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
  Cactus<double> cactus("hop.bvh");
  Performance<double> performance;
  REQUIRE(cactus.perform({}, performance).ok());
  performance.flights = {{10, 13}};  // hardly any time: a body that stretches reaches the floor before it falls
  const std::size_t controls = performance.control_count();
  for (std::size_t c = 3; c < 5; ++c) performance.controls[11 * controls + c].y() -= 0.3;  // its two edges
  Bake<double> bake;
  bake.bind(cactus.body, performance, 1.0);
  REQUIRE(bake.frame(11).ok());
  CHECK(lowest<double>(bake.positions()) == doctest::Approx(0).epsilon(1e-12));
}

TEST_CASE("a frame of a bake does not allocate") {
  Cactus<float> cactus("hop.bvh");
  Performance<float> performance;
  REQUIRE(cactus.perform({}, performance).ok());
  performance.flights = {{10, 25}};
  Bake<float> bake;
  bake.bind(cactus.body, performance, 1.0F);
  const std::int64_t before = test::allocation_count;
  const bool made = bake.frame(12).ok() && bake.frame(30).ok();
  CHECK(test::allocation_count == before);
  CHECK(made);
}

TEST_CASE("a bake names a frame that is not there") {
  Bake<double> bake;
  CHECK(bake.frame(0).error == Error::index_out_of_range);
}
