#include "rigless/retarget/detail/root_motion.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "rigless/retarget/detail/flight.h"
#include "rigless/retarget/detail/foot_lock.h"
#include "rigless/scene/detail/slip.h"
#include "support/json.h"

namespace detail = rigless::detail;
using rigless::Vec3;

namespace {

rigless::json::Value golden(const char* name) {
  return rigless::json::parse_file(std::string(RIGLESS_TEST_DIR) + "golden/" + name);
}

template <class S>
struct Walk {
  std::vector<Vec3<S>> tracks;
  std::vector<std::uint8_t> labels;
};

template <class S>
Walk<S> walk(const rigless::json::Value& file) {
  Walk<S> out;
  for (const auto& row : file["C"].array())
    for (const auto& p : row.array()) out.tracks.push_back(p.vec3<S>());
  for (const auto& row : file["labels"].array())
    for (const auto& label : row.array()) out.labels.push_back(label.boolean() ? 1 : 0);
  return out;
}

template <class S>
double worst(const std::vector<Vec3<S>>& mine, const rigless::json::Value& rows) {
  const auto reference = rows.vec3s<S>();
  REQUIRE(mine.size() == reference.size());
  double error = 0;
  for (std::size_t i = 0; i < mine.size(); ++i)
    error = std::max(error, static_cast<double>((mine[i] - reference[i]).cwiseAbs().maxCoeff()));
  return error;
}

}  // namespace

TEST_CASE_TEMPLATE("root motion: from contacts", S, double, float) {
  const auto file = golden("footlock.json");
  const auto in = walk<S>(file);
  std::vector<Vec3<S>> root;
  REQUIRE(detail::root_from_contacts<S>(in.tracks, in.labels, std::vector<S>(2), {}, {}, root).ok());
  CHECK(worst(root, file["root"]) <= (std::is_same_v<S, double> ? 1e-8 : 1e-5));
}

TEST_CASE("root motion: a treadmill gives its speed at any rate, soles stand on the ground") {
  for (const double fps : {15.0, 30.0, 60.0, 120.0}) {
    CAPTURE(fps);
    const auto frames = static_cast<std::size_t>(fps) + 1;
    std::vector<Vec3<double>> tracks, root;
    for (std::size_t f = 0; f < frames; ++f) {
      const double t = static_cast<double>(f) / fps;
      tracks.push_back({0.1, -0.75, -1.5 * t});
      tracks.push_back({-0.1, -0.7, -1.5 * t});
    }
    detail::RootMotionOptions<double> options;
    options.fps = fps;
    const std::vector<double> ground = {0.05, 0.2};
    REQUIRE(detail::root_from_contacts<double>(tracks, std::vector<std::uint8_t>(tracks.size(), 1), ground, {}, options,
                                               root)
                .ok());
    CHECK(root.back().z() - root.front().z() == doctest::Approx(1.5).epsilon(0.06));
    CHECK(root.back().y() == doctest::Approx(0.9));
  }
}

TEST_CASE("root motion: legs that swing aslant do not lead a body astray") {
  std::vector<Vec3<double>> tracks, ahead, still, root;
  for (int f = 0; f <= 90; ++f) {
    tracks.push_back({-0.01 * f, 0, -0.03 * f});
    ahead.push_back({0, 1, 0.04 * f});
    still.push_back({0, 1, 0.001 * f});
  }
  const std::vector<std::uint8_t> labels(tracks.size(), 1);
  const std::vector<double> ground = {0};
  REQUIRE(detail::root_from_contacts<double>(tracks, labels, ground, {ahead, 1}, {}, root).ok());
  CHECK(std::abs(root.back().x()) < 0.02);
  CHECK(root.back().z() == doctest::Approx(90 * std::hypot(0.01, 0.03)).epsilon(0.03));
  REQUIRE(detail::root_from_contacts<double>(tracks, labels, ground, {still, 1}, {}, root).ok());
  CHECK(root.back().x() == doctest::Approx(0.9).epsilon(0.05));
}

TEST_CASE("root motion: bad input is refused") {
  std::vector<Vec3<double>> tracks(4, Vec3<double>::Zero()), root(1, Vec3<double>::Ones());
  const std::vector<std::uint8_t> labels(3);
  const std::vector<double> ground(2);
  CHECK(detail::root_from_contacts<double>(tracks, labels, ground, {}, {}, root).error ==
        rigless::Error::size_mismatch);
  CHECK(detail::root_from_contacts<double>(tracks, labels, {}, {}, {}, root).error == rigless::Error::no_controls);
  CHECK(root.size() == 1);
}

TEST_CASE("flight: Eq 3.31 lands exactly") {
  const auto file = golden("global.json");
  const auto& flight = file["flight"];
  const double g = detail::gravity_per_frame(file["fps"].number());
  CHECK(g == doctest::Approx(file["g_per_frame2"].number()).epsilon(1e-12));
  CHECK(detail::flight_velocity(flight["dx"].number(), flight["dF"].integer(), g) ==
        doctest::Approx(flight["v0"].number()).epsilon(1e-9));
  std::vector<double> path;
  detail::flight_heights(0.0, flight["dx"].number(), flight["dF"].integer(), g, path);
  REQUIRE(path.size() == flight["path"].size());
  for (std::size_t f = 0; f < path.size(); ++f) CHECK(std::abs(path[f] - flight["path"][f].number()) <= 1e-9);

  const std::int32_t first = file["flights"][0][0].integer(), last = file["flights"][0][1].integer();
  const auto height = [&](std::int32_t f) { return file["root_flight"][f][1].number(); };
  detail::flight_heights(height(first), height(last), last - first, g, path);
  for (std::int32_t f = first; f <= last; ++f)
    CHECK(std::abs(path[static_cast<std::size_t>(f - first)] - height(f)) <= 1e-9);
}

TEST_CASE_TEMPLATE("foot lock: standing feet do not slide", S, double, float) {
  const auto file = golden("footlock.json");
  auto in = walk<S>(file);
  std::vector<Vec3<S>> root;
  REQUIRE(detail::root_from_contacts<S>(in.tracks, in.labels, std::vector<S>(2), {}, {}, root).ok());
  for (std::size_t i = 0; i < in.tracks.size(); ++i) in.tracks[i] += Vec3<S>(root[i / 2].x(), 0, root[i / 2].z());
  const auto before = detail::measure_slip<S>(in.tracks, in.labels, 2, S(30));
  detail::FootLockOptions<S> options;
  options.height_smoothness = options.smoothness;  // as in the golden case
  const std::vector<S> ground(2, S(0));
  REQUIRE(detail::lock_feet<S>(in.tracks, in.labels, {}, ground, options).ok());
  std::vector<Vec3<S>> reference;
  for (const auto& row : file["locked"].array())
    for (const auto& p : row.array()) reference.push_back(p.vec3<S>());
  double error = 0;
  for (std::size_t i = 0; i < reference.size(); ++i)
    error = std::max(
        error, static_cast<double>(
                   (in.tracks[i] - Vec3<S>(root[i / 2].x(), 0, root[i / 2].z()) - reference[i]).cwiseAbs().maxCoeff()));
  CHECK(error <= (std::is_same_v<S, double> ? 1e-8 : 1e-4));
  const auto after = detail::measure_slip<S>(in.tracks, in.labels, 2, S(30));
  CHECK(before.mean > S(0.01));
  CHECK(before.maximum >= before.mean);
  CHECK(after.maximum <= S(std::is_same_v<S, double> ? 1e-12 : 1e-4));
}

TEST_CASE("foot lock: without contacts nothing changes, ground heights are kept") {
  auto in = walk<double>(golden("footlock.json"));
  const auto original = in.tracks;
  const std::vector<double> ground = {0.07, 0.02};
  REQUIRE(detail::lock_feet<double>(in.tracks, std::vector<std::uint8_t>(in.labels.size(), 0), {}, ground, {}).ok());
  CHECK(in.tracks == original);
  REQUIRE(detail::lock_feet<double>(in.tracks, in.labels, {}, ground, {}).ok());
  for (std::size_t i = 0; i < in.tracks.size(); ++i)
    if (in.labels[i] != 0) CHECK(std::abs(in.tracks[i].y() - ground[i % 2]) < 1e-12);
}

TEST_CASE("slip: pairs of labelled frames only, horizontally, per second") {
  const std::vector<Vec3<double>> tracks = {{0, 0, 0}, {0.3, 9, 0.4}, {5, 0, 0}, {5, 0, 0.1}};
  const std::vector<std::uint8_t> labels = {1, 1, 0, 1};
  const auto slip = detail::measure_slip<double>(tracks, labels, 1, 10.0);
  CHECK(slip.mean == doctest::Approx(5));
  CHECK(slip.maximum == doctest::Approx(5));
}
