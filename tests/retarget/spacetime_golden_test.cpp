// The spacetime system against the reference implementation.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "rigless/retarget/detail/bounded_spacetime.h"
#include "support/json.h"

namespace {

namespace detail = rigless::detail;
using rigless::Vec3;

template <class S>
struct GoldenProblem {
  std::vector<std::vector<S>> features, example_features;
  std::vector<std::vector<Vec3<S>>> controls;
  std::vector<detail::TrackInput<S>> tracks;
  std::int32_t frames = 0;
  detail::SpacetimeOptions<S> options;
  rigless::Constraints<S> constraints;
};

template <class S>
std::vector<S> flat(const rigless::json::Value& rows, std::size_t count) {
  std::vector<S> out;
  for (std::size_t i = 0; i < count; ++i)
    for (const auto& x : rows[i].array()) out.push_back(static_cast<S>(x.number()));
  return out;
}

rigless::AxisMask mask(const rigless::json::Value& v) {
  rigless::AxisMask axes = {true, true, true};
  if (!v.is_null())
    for (std::size_t k = 0; k < 3; ++k) axes[k] = v[k].number() != 0;
  return axes;
}

template <class S>
void read_constraints(const rigless::json::Value& options, rigless::Constraints<S>& out) {
  for (const auto& p : options["pos"].array())
    out.push_back(rigless::position_constraint<S>(p[0].integer(), p[1].integer(), p[3].vec3<S>(), mask(p[2])));
  for (const auto& v : options["vel"].array())
    out.push_back(rigless::velocity_constraint<S>(v[0].integer(), v[1].integer(), v[3].vec3<S>(), mask(v[2])));
  for (const auto& e : options["eqy"].array())
    out.push_back(rigless::height_constraint<S>(e[0].integer(), e[1].integer(), e[2].integer(), S(0)));
}

// What the case adds to the diagonal: "reg r adds r * mean(diag H)", over the weights.
template <class S>
S mean_diagonal(const GoldenProblem<S>& p) {
  double sum = 0;
  std::size_t count = 0;
  const auto& w = p.options.weights;
  const auto& t = p.options.track;
  for (std::size_t k = 0; k < p.tracks.size(); ++k) {
    const std::size_t n = p.controls[k].size();
    for (std::int32_t f = 0; f < p.frames; ++f) {
      const double second = static_cast<double>(detail::second_difference_row<S>(p.frames, f)[2]);
      const double pull = static_cast<double>(t.acceleration * t.acceleration) * second;
      const Vec3<S> j(&p.features[k][static_cast<std::size_t>(f) * 3]);
      std::vector<std::pair<double, std::size_t>> nearest;
      for (std::size_t m = 0; m < n; ++m)
        nearest.emplace_back(static_cast<double>((j - Vec3<S>(&p.example_features[k][m * 3])).squaredNorm()), m);
      std::sort(nearest.begin(), nearest.end());
      if (w.nearest > 0 && nearest.size() > static_cast<std::size_t>(w.nearest))
        nearest.resize(static_cast<std::size_t>(w.nearest));
      for (const auto& [distance, m] : nearest) {
        const Vec3<S> example(&p.example_features[k][m * 3]);
        sum += static_cast<double>(example.squaredNorm() + w.soft_affine * w.soft_affine +
                                   w.locality * static_cast<S>(distance)) +
               pull * static_cast<double>(p.controls[k][m].squaredNorm());
        ++count;
      }
    }
  }
  return static_cast<S>(sum / static_cast<double>(count));
}

template <class S>
void read(const rigless::json::Value& all, const rigless::json::Value& c, GoldenProblem<S>& p) {
  const auto& options = c["options"];
  const std::size_t tracks = c["c"].size(), examples = c["weights"][0][0].size();
  for (std::size_t k = 0; k < tracks; ++k) {
    p.features.push_back(flat<S>(all["J"][k], all["J"][k].size()));
    p.example_features.push_back(flat<S>(all["JE"][k], examples));
    auto controls = all["CE"][k].vec3s<S>();
    controls.resize(examples);
    p.controls.push_back(controls);
  }
  p.frames = static_cast<std::int32_t>(all["J"][0].size());
  for (std::size_t k = 0; k < tracks; ++k) p.tracks.push_back({p.features[k], p.example_features[k], p.controls[k]});
  p.options.weights.locality = static_cast<S>(options["locality"].number());
  p.options.weights.sharing = 0;
  p.options.weights.soft_affine = options["affine_hard"].boolean() ? S(0) : S(1);
  const bool all_examples = c["options"].keys().end() != std::find(options.keys().begin(), options.keys().end(), "k");
  p.options.weights.nearest = all_examples ? 0 : 4;
  p.options.track.acceleration = static_cast<S>(options["lam_A"].number());
  p.options.track.offset_weight = static_cast<S>(options["offset"][0].number());
  p.options.track.offset_acceleration = static_cast<S>(options["offset"][1].number());
  p.options.compliance = 0;
  read_constraints(options, p.constraints);
  p.options.weights.tikhonov = static_cast<S>(options["reg"].number()) * mean_diagonal(p);
}

// 1/2 w'Hw - g'w with everything that H holds, as the case defines it.
template <class Solver>
double objective(const GoldenProblem<double>& p, const Solver& solver) {
  const auto& o = p.options;
  double sum = 0;
  for (std::size_t k = 0; k < p.tracks.size(); ++k) {
    const auto track = solver.track(static_cast<std::int32_t>(k));
    const auto weights = solver.weights(static_cast<std::int32_t>(k));
    const std::size_t n = p.controls[k].size();
    std::vector<Vec3<double>> offset;
    for (std::size_t f = 0; f < track.size(); ++f) {
      const Vec3<double> j(&p.features[k][f * 3]);
      Vec3<double> mapped(0, 0, 0), rest = track[f];
      double total = 0;
      for (std::size_t m = 0; m < n; ++m) {
        const double w = weights[f * n + m];
        const Vec3<double> example(&p.example_features[k][m * 3]);
        mapped += w * example;
        rest -= w * p.controls[k][m];
        total += w;
        sum += w * w * (o.weights.locality * (j - example).squaredNorm() + o.weights.tikhonov) / 2;
      }
      offset.push_back(rest);
      sum += mapped.squaredNorm() / 2 - mapped.dot(j);
      sum += o.weights.soft_affine * o.weights.soft_affine * (total * total / 2 - total);
      if (o.track.offset_weight > 0) sum += o.track.offset_weight * rest.squaredNorm() / 2;
    }
    for (std::size_t f = 1; f + 1 < track.size(); ++f) {
      sum +=
          o.track.acceleration * o.track.acceleration * (track[f - 1] - 2 * track[f] + track[f + 1]).squaredNorm() / 2;
      if (o.track.offset_weight > 0)
        sum += o.track.offset_acceleration * o.track.offset_acceleration *
               (offset[f - 1] - 2 * offset[f] + offset[f + 1]).squaredNorm() / 2;
    }
  }
  return sum;
}

template <class Solver>
double worst_track_error(const rigless::json::Value& c, const Solver& solver) {
  double worst = 0;
  for (std::size_t k = 0; k < c["c"].size(); ++k) {
    const auto track = solver.track(static_cast<std::int32_t>(k));
    for (std::size_t f = 0; f < track.size(); ++f)
      worst = std::max(worst, (track[f].template cast<double>() - c["c"][k][f].vec3<double>()).cwiseAbs().maxCoeff());
  }
  return worst;
}

template <class Solver>
double worst_weight_error(const rigless::json::Value& c, const Solver& solver) {
  double worst = 0;
  for (std::size_t k = 0; k < c["weights"].size(); ++k) {
    const auto weights = solver.weights(static_cast<std::int32_t>(k));
    const std::size_t n = c["weights"][0][0].size();
    for (std::size_t i = 0; i < weights.size(); ++i)
      worst = std::max(worst, std::abs(weights[i] - c["weights"][k][i / n][i % n].number()));
  }
  return worst;
}

const rigless::json::Value& golden() {
  static const auto file = rigless::json::parse_file(std::string(RIGLESS_TEST_DIR) + "golden/retarget.json");
  return file;
}

}  // namespace

TEST_CASE("spacetime: tracks, weights and objective of the reference") {
  std::size_t seen = 0;
  for (const auto& c : golden()["cases"].array()) {
    if (c["options"].has("bounds")) continue;
    CAPTURE(c["name"].string());
    GoldenProblem<double> p;
    read(golden(), c, p);
    detail::SpacetimeSolver<double> solver;
    REQUIRE(solver.begin(p.tracks, p.frames, p.constraints, p.options).ok());
    while (solver.advance(1)) {
    }
    REQUIRE(solver.finish().ok());
    const double tolerance = golden()["tol"]["kkt"].number();
    CHECK(worst_track_error(c, solver) <= tolerance);
    CHECK(objective(p, solver) == doctest::Approx(c["objective"].number()).epsilon(1e-9));
    if (c["reduced_hessian_min_eig"].number() > 1e-6) CHECK(worst_weight_error(c, solver) <= tolerance);
    for (const double residual : solver.residuals()) CHECK(residual <= tolerance);
    ++seen;
  }
  CHECK(seen == 14);
  CHECK(golden()["cases"].size() == 16);
}

TEST_CASE("spacetime: bounded weights of the reference") {
  std::size_t seen = 0;
  for (const auto& c : golden()["cases"].array()) {
    if (!c["options"].has("bounds")) continue;
    CAPTURE(c["name"].string());
    GoldenProblem<double> p;
    read(golden(), c, p);
    const double lower = c["options"]["bounds"][0].number(), upper = c["options"]["bounds"][1].number();
    detail::BoundedSpacetimeSolver<double> solver;
    solver.set_bounds(lower, upper);
    REQUIRE(solver.begin(p.tracks, p.frames, p.constraints, p.options).ok());
    while (solver.advance(1000)) {
    }
    REQUIRE(solver.finish().ok());
    // One weight of the reference stops 1.4e-5 before a bound at which the objective is lower by 3.5e-9.
    const bool short_of = c["name"].string() == "bounded + constraints";
    const double tolerance = (short_of ? 3 : 1) * golden()["tol"]["qp"].number();
    CHECK(worst_track_error(c, solver) <= tolerance);
    const double better = c["objective"].number() - objective(p, solver);
    CHECK(better > (short_of ? 1e-9 : -1e-10));
    CHECK(better < 1e-8);
    if (c["reduced_hessian_min_eig"].number() > 1e-6) CHECK(worst_weight_error(c, solver) <= tolerance);
    for (const double residual : solver.residuals()) CHECK(residual <= 1e-7);
    double least = 1, most = 0;
    for (std::size_t k = 0; k < p.tracks.size(); ++k) {
      for (const double w : solver.weights(static_cast<std::int32_t>(k))) {
        least = std::min(least, w);
        most = std::max(most, w);
      }
    }
    CHECK(least >= lower - 1e-7);
    CHECK(most <= upper + 1e-7);
    CHECK((least < lower + 1e-6 || most > upper - 1e-6));
    ++seen;
  }
  CHECK(seen == 2);
}

TEST_CASE("spacetime: bounds that nothing touches change nothing, and cost one system") {
  GoldenProblem<double> p;
  read(golden(), golden()["cases"][2], p);
  detail::SpacetimeSolver<double> free;
  detail::BoundedSpacetimeSolver<double> bounded;
  bounded.set_bounds(-100, 100);
  REQUIRE(free.begin(p.tracks, p.frames, p.constraints, p.options).ok());
  REQUIRE(bounded.begin(p.tracks, p.frames, p.constraints, p.options).ok());
  while (free.advance(100)) {
  }
  while (bounded.advance(100)) {
  }
  for (std::size_t f = 0; f < free.track(0).size(); ++f) CHECK(free.track(0)[f] == bounded.track(0)[f]);
}

TEST_CASE("spacetime: float stays near the reference") {
  for (const auto& c : golden()["cases"].array()) {
    if (c["options"].has("bounds")) continue;
    CAPTURE(c["name"].string());
    GoldenProblem<float> p;
    read(golden(), c, p);
    detail::SpacetimeSolver<float> solver;
    REQUIRE(solver.begin(p.tracks, p.frames, p.constraints, p.options).ok());
    while (solver.advance(1 << 20)) {
    }
    REQUIRE(solver.finish().ok());
    CHECK(worst_track_error(c, solver) <= 5e-3);
    for (const float residual : solver.residuals()) CHECK(residual <= 1e-3F);
  }
}
