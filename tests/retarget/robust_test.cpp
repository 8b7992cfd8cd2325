// The product's defaults on real motions with a noisy hand, against the reference figures.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "rigless/retarget/detail/spacetime.h"
#include "support/json.h"

namespace detail = rigless::detail;
using rigless::Vec3;

namespace {

std::vector<double> flat(const rigless::json::Value& rows) {
  std::vector<double> out;
  for (const auto& row : rows.array())
    for (const auto& x : row.array()) out.push_back(x.number());
  return out;
}

struct Figures {
  double rmse = 0;
  double largest_weight = 0;
};

Figures run(const rigless::json::Value& item, const detail::SpacetimeOptions<double>& options) {
  const std::size_t tracks = item["J"].size(), frames = item["J"][0].size();
  std::vector<std::vector<double>> features, examples;
  std::vector<std::vector<Vec3<double>>> controls;
  for (std::size_t k = 0; k < tracks; ++k) {
    features.push_back(flat(item["J"][k]));
    examples.push_back(flat(item["JE"][k]));
    controls.push_back(item["CE_noisy"][k].vec3s<double>());
  }
  std::vector<detail::TrackInput<double>> inputs;
  for (std::size_t k = 0; k < tracks; ++k) inputs.push_back({features[k], examples[k], controls[k]});
  detail::SpacetimeSolver<double> solver;
  REQUIRE(solver.begin(inputs, static_cast<std::int32_t>(frames), {}, options).ok());
  while (solver.advance(100)) {
  }
  REQUIRE(solver.finish().ok());
  Figures out;
  for (std::size_t k = 0; k < tracks; ++k) {
    for (std::size_t f = 0; f < frames; ++f)
      out.rmse += (solver.track(static_cast<std::int32_t>(k))[f] - item["truth"][k][f].vec3<double>()).squaredNorm();
    for (const double w : solver.weights(static_cast<std::int32_t>(k)))
      out.largest_weight = std::max(out.largest_weight, std::abs(w));
  }
  out.rmse = std::sqrt(out.rmse / static_cast<double>(tracks * frames));
  return out;
}

}  // namespace

TEST_CASE("spacetime: the defaults do better than the reference on walk, jump and hop") {
  const auto file = rigless::json::parse_file(std::string(RIGLESS_TEST_DIR) + "golden/robust.json");
  CHECK(file["items"].size() == 3);
  for (const auto& item : file["items"].array()) {
    CAPTURE(item["name"].string());
    const auto& reference = item["reference"];
    for (const auto& [name, locality] :
         {std::pair{"all_examples_locality_.03", 0.03}, {"all_examples_locality_.01", 0.01}}) {
      detail::SpacetimeOptions<double> options;
      options.weights.locality = locality;
      options.weights.sharing = 0;
      const Figures same = run(item, options);
      CHECK(same.rmse == doctest::Approx(reference[name]["rmse"].number()).epsilon(0.02));
      CHECK(same.largest_weight == doctest::Approx(reference[name]["max_abs_weight"].number()).epsilon(0.02));
    }
    const Figures standard = run(item, {});
    CHECK(standard.rmse <= 0.97 * reference["all_examples_locality_.03"]["rmse"].number());
    CHECK(standard.largest_weight < 2);

    const Figures paper = run(item, detail::SpacetimeOptions<double>::thesis());
    CHECK(paper.rmse == doctest::Approx(reference["thesis"]["rmse"].number()).epsilon(0.02));
    MESSAGE(item["name"].string() << ": rmse " << standard.rmse << ", the paper's settings " << paper.rmse);
  }
}
