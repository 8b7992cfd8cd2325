#include "rigless/thesis/anchor.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "support/json.h"

using rigless::Vec3;

namespace {

rigless::json::Value golden(const char* name) {
  return rigless::json::parse_file(std::string(RIGLESS_TEST_DIR) + "golden/" + name);
}

template <class S>
std::vector<Vec3<S>> walk(const rigless::json::Value& file) {
  std::vector<Vec3<S>> tracks;
  for (const auto& row : file["C"].array())
    for (const auto& p : row.array()) tracks.push_back(p.vec3<S>());
  return tracks;
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

TEST_CASE_TEMPLATE("root motion: the lowest control is the anchor", S, double, float) {
  const auto file = golden("global.json");
  const double tolerance = std::is_same_v<S, double> ? file["tol"].number() : 1e-5;
  const auto tracks = walk<S>(file);
  const S g = rigless::detail::gravity_per_frame(static_cast<S>(file["fps"].number()));
  std::vector<Vec3<S>> root;
  std::vector<std::int32_t> anchors;
  REQUIRE(rigless::root_from_anchor<S>(tracks, 2, {}, g, root, anchors).ok());
  CHECK(anchors == file["anchor_walk"].integers());
  CHECK(worst(root, file["root_walk"]) <= tolerance);

  std::vector<rigless::Flight> flights;
  for (const auto& f : file["flights"].array()) flights.push_back({f[0].integer(), f[1].integer()});
  REQUIRE(rigless::root_from_anchor<S>(tracks, 2, flights, g, root, anchors).ok());
  CHECK(anchors == file["anchor_flight"].integers());
  // x and z of a flight, and of what comes after it, depend on how the take-off's velocity is averaged; before,
  // nothing.
  const auto reference = file["root_flight"].vec3s<S>();
  const auto take_off = static_cast<std::size_t>(flights[0].take_off),
             landing = static_cast<std::size_t>(flights[0].landing);
  double height = 0, before = 0, after = 0;
  for (std::size_t f = 0; f < root.size(); ++f) {
    height = std::max(height, static_cast<double>(std::abs(root[f].y() - reference[f].y())));
    const Vec3<S> error = root[f] - reference[f];
    if (f <= take_off) before = std::max(before, static_cast<double>(error.norm()));
    if (f > landing)
      after = std::max(after, static_cast<double>((error - (root[landing] - reference[landing])).norm()));
  }
  CHECK(height <= tolerance);
  CHECK(before <= tolerance);
  CHECK(after <= 2 * tolerance);
  CHECK((root[landing] - reference[landing]).norm() < S(0.5));
}

TEST_CASE("root motion: where the anchor changes, the soles shall be level") {
  const std::vector<std::int32_t> anchors = {0, 0, 1, 1, -1, -1, 0, 1};
  const std::vector<double> ground = {0.05, 0.02};
  const auto constraints = rigless::anchor_constraints<double>(anchors, ground);
  REQUIRE(constraints.size() == 2);
  CHECK((constraints[0].at.track == 1 && constraints[0].from->track == 0 && constraints[0].at.frame == 2));
  CHECK(constraints[0].value.y() == doctest::Approx(-0.03));
  CHECK(constraints[1].at.frame == 7);
}
