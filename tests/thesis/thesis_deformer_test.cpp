#include "rigless/thesis/thesis_deformer.h"

#include <doctest/doctest.h>

#include "rigless/deform/detail/volume_law.h"
#include "support/alloc_count.h"
#include "support/json.h"
#include "thesis/points.h"

using namespace rigless;
using namespace rigless::detail;
using test::largest_difference;
using test::Points;

namespace {

const double infinite = std::numeric_limits<double>::infinity();  // elastic scale of as-rigid-as-possible

// doctest's Approx adds 1 to the scale.
bool near(double a, double b, double relative) { return std::abs(a - b) <= relative * std::abs(b); }

struct Bar {
  explicit Bar(const char* name) : golden(json::parse_file(std::string(RIGLESS_TEST_DIR "golden/") + name + ".json")) {}

  json::Value golden;
  Points rest = golden["vertices"].vec3s<double>();
  std::vector<Face> faces = golden["faces"].faces();
  std::vector<std::int32_t> controls = golden["controls"].integers();
  Points targets = golden["targets"].vec3s<double>();
  OneRing ring = one_ring(faces, static_cast<std::int32_t>(rest.size()));

  std::vector<double> weight(const std::string& name) const {
    return name == "cotan" ? cotangent_weights<double>(rest, faces, ring) : uniform_weights<double>(ring);
  }

  template <class Constraint>
  ThesisDeformer<double, Constraint> bind(const std::string& weights, const Constraint& constraint, double mu) const {
    ThesisDeformer<double, Constraint> deformer;
    REQUIRE(deformer.bind(rest, ring, weight(weights), controls, constraint, {mu}).ok());
    deformer.set_targets(targets);
    return deformer;
  }

  // What the targets' misses cost.
  double misses(Span<const Vec3<double>> surface) const {
    double sum = 0;
    for (std::size_t c = 0; c < controls.size(); ++c) {
      sum += (surface[static_cast<std::size_t>(controls[c])] - targets[c]).squaredNorm();
    }
    return sum;
  }
};

template <class Constraint>
void check_iterates(const Bar& bar, const json::Value& run, const Constraint& constraint, double miss_cost) {
  const std::string weights = run["weights"].string();
  const auto energy = [&](const auto& deformer) {
    return deformer.energy() + miss_cost * bar.misses(deformer.shape());
  };
  auto arap = bar.bind(weights, constraint, infinite);
  arap.start();
  CHECK(largest_difference(arap.shape(), run["initial"].template vec3s<double>()) < 1e-7);
  CHECK(near(energy(arap), run["arap_energy"][0].number(), 1e-8));
  for (int it = 1; it <= 5; ++it) {
    arap.step(1);
    CHECK(near(energy(arap), run["arap_energy"][it].number(), 1e-8));
    if (it > 1 || !run.has("R_first")) continue;
    for (std::size_t i = 0; i < bar.rest.size(); ++i) {
      CHECK((arap.fits()[i].R - run["R_first"][i].template matrix<double>()).cwiseAbs().maxCoeff() < 1e-7);
    }
  }
  CHECK(largest_difference(arap.shape(), run["arap_5"].template vec3s<double>()) < 1e-7);
  if (run.has("converged")) {
    arap.step(run["converged_iters"].integer() + 200);
    CHECK(largest_difference(arap.shape(), run["converged"].template vec3s<double>()) < 1e-5);
    CHECK(near(energy(arap), run["converged_energy"].number(), 1e-8));
  }

  auto cartoon = bar.bind(weights, constraint, 0);
  cartoon.start();
  CHECK(near(energy(cartoon), run["cartoon_energy"][0].number(), 1e-8));
  for (int it = 1; it <= 5; ++it) {
    cartoon.step(1);
    CHECK(near(energy(cartoon), run["cartoon_energy"][it].number(), 1e-8));
    if (it == 1) {
      const auto s = run["cartoon_s_first"].numbers();
      REQUIRE(s.size() == bar.rest.size());
      for (std::size_t i = 0; i < s.size(); ++i) CHECK(cartoon.fits()[i].s == doctest::Approx(s[i]).epsilon(1e-7));
    }
    if (it == 2) CHECK(largest_difference(cartoon.shape(), run["cartoon_2"].template vec3s<double>()) < 1e-7);
  }
  CHECK(largest_difference(cartoon.shape(), run["cartoon_5"].template vec3s<double>()) < 1e-7);
}

template <class Constraint>
void check_pose(const Bar& bar, const json::Value& run, const Constraint& constraint) {
  auto cartoon = bar.bind(run["weights"].string(), constraint, 0);
  cartoon.start();
  cartoon.step(2);
  const Points shape(cartoon.shape().begin(), cartoon.shape().end());
  for (const std::string& lambda : run["pose"].keys()) {
    CAPTURE(lambda);
    cartoon.pose(LinearLaw<double>{std::atof(lambda.c_str())});
    CHECK(largest_difference(cartoon.positions(), run["pose"][lambda].template vec3s<double>()) < 1e-7);
    CHECK(largest_difference(cartoon.shape(), shape) == 0);  // the pose never feeds back
  }
  if (run.has("pose_power")) {
    cartoon.pose(PowerLaw<double>{3.0, 0.1, 10.0});
    CHECK(largest_difference(cartoon.positions(), run["pose_power"]["3.0"].template vec3s<double>()) < 1e-7);
  }
}

template <class Constraint>
void check_run(const Bar& bar, const json::Value& run, const Constraint& constraint, double miss_cost) {
  check_iterates(bar, run, constraint, miss_cost);
  check_pose(bar, run, constraint);
}

template <class Constraint>
int rises(const Bar& bar, const Constraint& constraint, double mu, double miss_cost, int iterations) {
  auto deformer = bar.bind("cotan", constraint, mu);
  deformer.start();
  int count = 0;
  double last = std::numeric_limits<double>::max();
  for (int it = 0; it < iterations; ++it) {
    deformer.step(1);
    const double next = deformer.energy() + miss_cost * bar.misses(deformer.shape());
    count += next > last * (1 + 1e-9);
    last = next;
  }
  return count;
}

}  // namespace

TEST_CASE("bend and stretch of the golden cases in all four modes: iterates, energies, minimum, pose") {
  for (const char* name : {"deform_bend", "deform_stretch"}) {
    const Bar bar(name);
    int runs = 0;
    for (const json::Value& run : bar.golden["runs"].array()) {
      const std::string mode = run["mode"].string();
      const double lambda = run["lam"].number();
      CAPTURE(name);
      CAPTURE(mode);
      if (mode == "row") check_run(bar, run, RowReplacement<double>{}, 0);
      if (mode == "col") check_run(bar, run, ColumnElimination<double>{}, 0);
      if (mode == "soft") check_run(bar, run, SoftDiagonal<double>{lambda}, lambda);
      if (mode == "ls") check_run(bar, run, SoftRows<double>{lambda}, lambda);
      ++runs;
    }
    CHECK(runs == 5);
  }
}

TEST_CASE("the energy never rises where the solve is its gradient, and does where it is least squares") {
  const Bar bar("deform_bend");
  for (const double mu : {0.0, 0.5, infinite}) {
    CAPTURE(mu);
    CHECK(rises(bar, RowReplacement<double>{}, mu, 0, 60) == 0);
    CHECK(rises(bar, SoftDiagonal<double>{20}, mu, 20, 60) == 0);
  }
  CHECK(rises(bar, ColumnElimination<double>{}, infinite, 0, 60) > 10);
}

TEST_CASE("a stretched cell is squeezed across its stretch, an unchanged one is not") {
  Cells<double> cells;
  cells.rest = {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  cells.ring = one_ring_from_pairs({{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}, {0, 6}}, 7);
  cells.weight = uniform_weights<double>(cells.ring);
  measure_cells(cells);
  const Mat3<double> R = Eigen::AngleAxisd(0.7, Vec3<double>(1, 2, 3).normalized()).toRotationMatrix();
  for (const double stretch : {1.0, 2.25, 0.5, 1e-3}) {
    CAPTURE(stretch);
    Points surface;
    for (const auto& v : cells.rest) surface.push_back(R * Vec3<double>(stretch * v.x(), v.y(), v.z()));
    const Mat3<double> V = volume_transform<double>(cells, surface, 0, R, LinearLaw<double>{});
    const double across = 1 / std::sqrt(std::max(stretch, 0.1));
    const Mat3<double> expected = R * Vec3<double>(1, across, across).asDiagonal() * R.transpose();
    CHECK((V - expected).cwiseAbs().maxCoeff() < 1e-12);
  }
}

TEST_CASE("the linear law is the thesis' and clamped") {
  const LinearLaw<double> law{3};
  CHECK(law(1) == 1);
  CHECK(law(1.5) == doctest::Approx(2.5));
  CHECK(law(0.5) == 0.1);
  CHECK(law(9) == 10);
}

TEST_CASE_TEMPLATE("rigidly moved targets give the rigidly moved mesh, without allocating", S, float, double) {
  const Bar bar("deform_stretch");
  std::vector<Vec3<S>> rest, moved, targets;
  const Mat3<S> R = Eigen::AngleAxis<S>(S(0.4), Vec3<S>(1, 2, -1).normalized()).toRotationMatrix();
  for (const auto& v : bar.rest) {
    rest.push_back(v.cast<S>());
    moved.push_back(R * rest.back() + Vec3<S>(1, -1, 2));
  }
  for (const std::int32_t c : bar.controls) targets.push_back(moved[static_cast<std::size_t>(c)]);
  ThesisDeformer<S, RowReplacement<S>> deformer;
  REQUIRE(
      deformer.bind(rest, bar.ring, cotangent_weights<S>(rest, bar.faces, bar.ring), bar.controls, {}, {S(0.5)}).ok());
  const auto before = test::allocation_count;
  deformer.set_targets(targets);
  deformer.start();
  deformer.step(300);
  deformer.pose(LinearLaw<S>{});
  CHECK(test::allocation_count == before);
  const S tolerance = sizeof(S) == 4 ? S(1e-4) : S(1e-9);
  for (std::size_t v = 0; v < rest.size(); ++v) {
    CHECK((deformer.shape()[v] - moved[v]).norm() < tolerance);
    CHECK((deformer.positions()[v] - moved[v]).norm() < tolerance);
  }
}

TEST_CASE("a binding that is refused leaves the present one") {
  const Bar bar("deform_bend");
  auto deformer = bar.bind("cotan", RowReplacement<double>{}, 0);
  deformer.start();
  deformer.step(1);
  const Points before(deformer.shape().begin(), deformer.shape().end());
  CHECK(deformer.bind(bar.rest, bar.ring, bar.weight("cotan"), {}).error == Error::no_controls);
  CHECK(largest_difference(deformer.shape(), before) == 0);
  deformer.step(1);
  CHECK(deformer.energy() < 2);
}
