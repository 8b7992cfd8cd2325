#include "rigless/deform/deformer.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <limits>

#include "rigless/mesh/detail/measure.h"
#include "rigless/thesis/thesis_deformer.h"
#include "support/alloc_count.h"
#include "support/cylinder.h"
#include "support/json.h"

using namespace rigless;
using namespace rigless::detail;
using test::Cylinder;

namespace {

const double infinite = std::numeric_limits<double>::infinity();  // elastic scale of plain ARAP

using Points = std::vector<Vec3<double>>;

double worst(Span<const Vec3<double>> a, const Points& b) {
  double w = 0;
  for (std::size_t i = 0; i < a.size(); ++i) w = std::max(w, (a[i] - b[i]).cwiseAbs().maxCoeff());
  return w;
}

template <class Weights>
Deformer<double, Weights> bind_case(const json::Value& golden, double elastic) {
  Deformer<double, Weights> deformer;
  REQUIRE(deformer.bind(golden["vertices"].vec3s<double>(), golden["faces"].faces(), {elastic}).ok());
  std::vector<Control<double>> controls;
  for (const std::int32_t v : golden["controls"].integers()) controls.push_back({v, 0.0});
  REQUIRE(deformer.set_controls(controls).ok());
  deformer.set_targets(golden["targets"].vec3s<double>());
  return deformer;
}

template <class Weights>
void check_run(const json::Value& golden, const json::Value& run) {
  const Points initial = run["initial"].vec3s<double>();

  auto arap = bind_case<Weights>(golden, infinite);
  arap.set_shape(initial);
  CHECK(arap.energy() == doctest::Approx(run["arap_energy"][0].number()).epsilon(1e-8));
  for (int it = 1; it <= 5; ++it) {
    arap.step(1);
    CHECK(arap.energy() == doctest::Approx(run["arap_energy"][it].number()).epsilon(1e-8));
  }
  CHECK(worst(arap.shape(), run["arap_5"].vec3s<double>()) < 1e-7);
  arap.step(run["converged_iters"].integer() + 200);
  CHECK(worst(arap.shape(), run["converged"].vec3s<double>()) < 1e-5);
  CHECK(arap.energy() == doctest::Approx(run["converged_energy"].number()).epsilon(1e-8));

  auto cartoon = bind_case<Weights>(golden, 0);  // mu = 0: the thesis
  cartoon.set_shape(initial);
  for (int it = 1; it <= 2; ++it) {
    cartoon.step(1);
    CHECK(cartoon.energy() == doctest::Approx(run["cartoon_energy"][it].number()).epsilon(1e-8));
  }
  CHECK(worst(cartoon.shape(), run["cartoon_2"].vec3s<double>()) < 1e-7);
  for (const char* lambda : {"0.0", "1.0", "3.0"}) {
    if (!run["pose"].has(lambda)) continue;
    CAPTURE(lambda);
    cartoon.pose(LinearLaw<double>{std::atof(lambda)});
    CHECK(worst(cartoon.positions(), run["pose"][lambda].vec3s<double>()) < 1e-7);
    CHECK(worst(cartoon.shape(), run["cartoon_2"].vec3s<double>()) < 1e-7);  // the pose never feeds back
  }
  if (run.has("pose_power")) {
    cartoon.pose(PowerLaw<double>{3.0, 0.1, 10.0});
    CHECK(worst(cartoon.positions(), run["pose_power"]["3.0"].vec3s<double>()) < 1e-7);
  }
  cartoon.step(3);
  CHECK(worst(cartoon.shape(), run["cartoon_5"].vec3s<double>()) < 1e-7);

  if (run.has("cartoon_mu05_5")) {
    auto elastic = bind_case<Weights>(golden, 0.5);
    elastic.set_shape(initial);
    elastic.step(5);
    CHECK(worst(elastic.shape(), run["cartoon_mu05_5"].vec3s<double>()) < 1e-7);
  }
}

// L x = L rest with the discs' vertices carried along unturned (Eq 2.8), by a dense solve.
Points naive_laplacian_edit(const Deformer<double>& deformer, const Points& targets) {
  const Cells<double>& cells = deformer.cells();
  const Discs<double>& discs = deformer.discs();
  const auto n = static_cast<Eigen::Index>(cells.size());
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n, n), rest(n, 3);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    rest.row(row) = cells.rest[i].transpose();
    for_each_edge(cells, i, [&](double w, const Vec3<double>&, std::size_t j) {
      L(row, row) += w;
      L(row, static_cast<Eigen::Index>(j)) -= w;
    });
  }
  Eigen::MatrixXd b = L * rest;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!discs.holds(i)) continue;
    const auto row = static_cast<Eigen::Index>(i);
    const auto c = static_cast<std::size_t>(discs.owner[i]);
    L.row(row).setZero();
    L(row, row) = 1;
    b.row(row) = (targets[c] + cells.rest[i] - discs.center[c]).transpose();
  }
  const Eigen::MatrixXd x = L.partialPivLu().solve(b);
  Points surface;
  for (Eigen::Index i = 0; i < n; ++i) surface.push_back(x.row(i).transpose());
  return surface;
}

}  // namespace

TEST_CASE("hard rows agree with the golden bend and stretch: iterates, energies, minimum, pose") {
  for (const char* name : {"deform_bend", "deform_stretch"}) {
    const json::Value golden = json::parse_file(std::string(RIGLESS_TEST_DIR "golden/") + name + ".json");
    int runs = 0;
    for (const json::Value& run : golden["runs"].array()) {
      if (run["mode"].string() != "row") continue;
      CAPTURE(name);
      CAPTURE(run["weights"].string());
      run["weights"].string() == "cotan" ? check_run<CotangentWeights>(golden, run)
                                         : check_run<UniformWeights>(golden, run);
      ++runs;
    }
    CHECK(runs == 2);
  }
}

TEST_CASE("turning discs agree with the golden case and never raise the energy") {
  const json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/discs.json");
  Deformer<double> deformer;
  REQUIRE(deformer.bind(golden["vertices"].vec3s<double>(), golden["faces"].faces(), {infinite}).ok());
  const auto controls = golden["controls"].integers();
  // radii between the golden disc's last vertex and the next one outside
  REQUIRE(deformer.set_controls(std::vector<Control<double>>{{controls[0], 0.58}, {controls[1], 0.63}}).ok());
  for (std::size_t c = 0; c < 2; ++c) {
    auto expected = golden["discs"][c].integers();
    std::sort(expected.begin(), expected.end());
    const auto& d = deformer.discs();
    CHECK(std::vector<std::int32_t>(d.member.begin() + d.first[c], d.member.begin() + d.first[c + 1]) == expected);
  }
  deformer.set_targets(golden["targets"].vec3s<double>());

  // the golden run starts at the naive Laplacian edit: rotations of rest, discs unturned
  deformer.set_shape(naive_laplacian_edit(deformer, golden["targets"].vec3s<double>()));
  double energy = std::numeric_limits<double>::max();
  for (int it = 1; it <= 1000; ++it) {
    deformer.step(1);
    const double next = deformer.energy();
    CHECK(next <= energy * (1 + 1e-9));
    energy = next;
    if (it == 1) CHECK(energy == doctest::Approx(golden["discs_energy"][0].number()).epsilon(1e-7));
    if (it == 3) CHECK(worst(deformer.shape(), golden["discs_3"].vec3s<double>()) < 1e-5);
    if (it == 10) CHECK(energy == doctest::Approx(golden["discs_energy"][1].number()).epsilon(1e-7));
    if (it == 100) CHECK(energy == doctest::Approx(golden["discs_energy"][2].number()).epsilon(1e-7));
  }
  CHECK(energy == doctest::Approx(golden["discs_energy"][3].number()).epsilon(1e-7));
  CHECK(worst(deformer.shape(), golden["discs_converged"].vec3s<double>()) < 1e-5);
  for (std::size_t c = 0; c < 2; ++c) {
    for (int r = 0; r < 3; ++r) {
      const Vec3<double> row = golden["disc_rotations"][c][r].vec3<double>();
      CHECK((deformer.disc_rotations()[c].row(r).transpose() - row).cwiseAbs().maxCoeff() < 1e-5);
    }
  }
}

TEST_CASE("relax reaches the minimum sooner than step, and never rises") {
  const json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/deform_bend.json");
  auto plain = bind_case<CotangentWeights>(golden, infinite);
  auto relaxed = bind_case<CotangentWeights>(golden, infinite);
  const double minimum = golden["runs"][0]["converged_energy"].number();
  int plain_steps = 0, relaxed_steps = 0;
  double last = std::numeric_limits<double>::max();
  plain.start();
  while (plain.energy() > 1.001 * minimum) {
    plain.step(1);
    REQUIRE(++plain_steps < 200);
  }
  for (bool there = false; !there;) {  // momentum starts anew at each call, so count by longer and longer runs
    REQUIRE(++relaxed_steps < 200);
    relaxed.start();
    relaxed.relax(relaxed_steps);
    CHECK(relaxed.energy() <= last * (1 + 1e-9));
    last = relaxed.energy();
    there = last <= 1.001 * minimum;
  }
  MESSAGE("iterations to 0.1 % of the minimum: ", plain_steps, " plain, ", relaxed_steps, " relaxed");
  CHECK(2 * relaxed_steps <= plain_steps);
  relaxed.relax(300);
  CHECK(relaxed.energy() == doctest::Approx(minimum).epsilon(1e-8));
}

TEST_CASE("rigidly moved targets give the rigidly moved mesh") {
  const json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/deform_bend.json");
  auto deformer = bind_case<CotangentWeights>(golden, 0.5);
  const Points rest = golden["vertices"].vec3s<double>();
  const Mat3<double> R = Eigen::AngleAxisd(0.8, Vec3<double>(1, 2, -1).normalized()).toRotationMatrix();
  Points targets, moved;
  for (const auto& v : rest) moved.push_back(R * v + Vec3<double>(3, -1, 2));
  for (const std::int32_t c : golden["controls"].integers()) targets.push_back(moved[static_cast<std::size_t>(c)]);
  deformer.set_targets(targets);
  SUBCASE("at once, from the start that fits them") { deformer.start(); }
  SUBCASE("or after many steps from rest") { deformer.step(600); }
  deformer.pose(1.0);
  CHECK(worst(deformer.shape(), moved) < 1e-9);
  CHECK(worst(deformer.positions(), moved) < 1e-9);
  CHECK(deformer.energy() < 1e-16);
}

TEST_CASE("volume: cartoon keeps at least half of what as-rigid-as-possible loses") {
  const Cylinder cylinder(16, 20);
  const double rest = signed_volume<double>(cylinder.vertices, cylinder.faces);
  const auto ratio = [&](Span<const Vec3<double>> v) { return signed_volume<double>(v, cylinder.faces) / rest; };
  for (const double factor : {1.5, 0.6}) {
    CAPTURE(factor);
    Deformer<double> arap, cartoon;
    REQUIRE(arap.bind(cylinder.vertices, cylinder.faces, {infinite}).ok());
    REQUIRE(cartoon.bind(cylinder.vertices, cylinder.faces).ok());
    for (auto* d : {&arap, &cartoon}) {
      REQUIRE(d->set_controls(cylinder.ends).ok());
      d->set_targets(cylinder.stretched(factor));
      d->step(factor < 1 ? 5 : 40);
    }
    const double lost = std::abs(ratio(arap.shape()) - 1);
    cartoon.pose(1.0);
    const double natural = std::abs(ratio(cartoon.positions()) - 1);
    MESSAGE("x", factor, ": ARAP ", ratio(arap.shape()), ", cartoon ", ratio(cartoon.positions()));
    CHECK(natural <= 0.5 * lost);
    // more lambda_v, more volume change against the stretch
    double last = 0;
    for (const double lambda : {0.0, 0.5, 1.0, 2.0, 3.0}) {
      cartoon.pose(lambda);
      const double volume = ratio(cartoon.positions());
      if (lambda > 0) CHECK((factor > 1 ? volume < last : volume > last));
      last = volume;
    }
  }
}

TEST_CASE_TEMPLATE("stepping, posing, resetting and setting targets allocate nothing", S, float, double) {
  const Cylinder cylinder(16, 20);
  std::vector<Vec3<S>> vertices;
  for (const auto& v : cylinder.vertices) vertices.push_back(v.cast<S>());
  Deformer<S> deformer;
  REQUIRE(deformer.bind(vertices, cylinder.faces).ok());
  REQUIRE(deformer.set_controls(std::vector<Control<S>>{{0, S(0.6)}, {200, S(0.6)}, {310, S(0.6)}}).ok());
  const std::vector<Vec3<S>> targets = {{2, 0, 0}, {0, 3, 1}, {0, 5, 0}};
  const auto before = test::allocation_count;
  deformer.set_targets(targets);
  deformer.start();
  deformer.step(3);
  deformer.relax(4);
  deformer.pose(S(1));
  deformer.reset();
  CHECK(test::allocation_count == before);
}

TEST_CASE("bad input is refused by name, and the present binding goes on") {
  const Cylinder cylinder(8, 6);
  Deformer<double> deformer;
  CHECK(deformer.bind(cylinder.vertices, {}).error == Error::no_faces);
  REQUIRE(deformer.bind(cylinder.vertices, cylinder.faces).ok());
  REQUIRE(deformer.set_controls(cylinder.ends).ok());
  deformer.set_targets(cylinder.stretched(1.3));
  deformer.step(2);
  const Points before(deformer.shape().begin(), deformer.shape().end());

  std::vector<Face> wrong = cylinder.faces;
  wrong[7][1] = 4000;
  const Status range = deformer.bind(cylinder.vertices, wrong);
  CHECK(range.error == Error::index_out_of_range);
  CHECK(range.where == 7);
  Points broken = cylinder.vertices;
  broken[5].y() = std::nan("");
  const Status finite = deformer.bind(broken, cylinder.faces);
  CHECK(finite.error == Error::not_finite);
  CHECK(finite.where == 5);
  CHECK(deformer.set_controls({}).error == Error::no_controls);
  CHECK(deformer.set_controls(std::vector<Control<double>>{{0, 0.0}, {-1, 0.0}}).where == 1);

  CHECK(worst(deformer.shape(), before) == 0);
  deformer.step(1);
  CHECK(worst(deformer.shape(), before) < 1);
}

TEST_CASE("two shells and a lonely vertex move together with one control") {
  Cylinder cylinder(8, 6);
  const auto n = static_cast<std::int32_t>(cylinder.vertices.size());
  for (std::int32_t i = 0; i < n; ++i) {
    cylinder.vertices.push_back(cylinder.vertices[static_cast<std::size_t>(i)] + Vec3<double>(3, 0, 0));
  }
  const std::size_t count = cylinder.faces.size();
  for (std::size_t f = 0; f < count; ++f) {
    const Face face = cylinder.faces[f];
    cylinder.faces.push_back({face[0] + n, face[1] + n, face[2] + n});
  }
  cylinder.vertices.push_back({0, 6, 0});
  Deformer<double> deformer;
  REQUIRE(deformer.bind(cylinder.vertices, cylinder.faces).ok());
  REQUIRE(deformer.set_controls(std::vector<Control<double>>{{0, 0.9}}).ok());
  const Vec3<double> shift(1, 2, 3);
  deformer.set_targets(Points{cylinder.vertices[0] + shift});
  deformer.start();
  deformer.step(3);
  for (std::size_t v = 0; v < cylinder.vertices.size(); ++v) {
    CHECK((deformer.shape()[v] - cylinder.vertices[v] - shift).norm() < 1e-6);
  }
}
