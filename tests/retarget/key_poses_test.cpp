#include "rigless/retarget/detail/key_poses.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/json.h"

namespace detail = rigless::detail;

TEST_CASE_TEMPLATE("key poses: farthest points of the reference", S, double, float) {
  const auto file = rigless::json::parse_file(std::string(RIGLESS_TEST_DIR) + "golden/keyposes.json");
  std::vector<S> features;
  for (const auto& row : file["X"].array())
    for (const auto& x : row.array()) features.push_back(static_cast<S>(x.number()));
  const auto keys = detail::farthest_poses<S>(features, static_cast<std::int32_t>(file["X"].size()),
                                              static_cast<std::int32_t>(file["indices"].size()));
  REQUIRE(keys.size() == file["indices"].size());
  for (std::size_t k = 0; k < keys.size(); ++k) {
    CHECK(keys[k].frame == file["indices"][k].integer());
    CHECK(std::abs(keys[k].radius - file["radii"][k].number()) <= (std::is_same_v<S, double> ? 1e-9 : 1e-5));
  }
}

TEST_CASE("key poses: a clip that repeats itself has no more key poses than poses") {
  const std::vector<double> features = {0, 1, 0, 1, 0, 1, 5};
  const auto keys = detail::farthest_poses<double>(features, 7, 6);
  REQUIRE(keys.size() == 3);
  CHECK(keys.back().radius == 0);
  CHECK(detail::farthest_poses<double>(features, 7, 0).empty());
}
