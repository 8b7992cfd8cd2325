#include "rigless/thesis/laplacian_editor.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "support/alloc_count.h"
#include "support/json.h"
#include "thesis/points.h"

using namespace rigless;
using namespace rigless::detail;
using test::largest_difference;
using test::Points;

namespace {

// w_ij = 1 / |N(i)|: not symmetric; only for Eq 2.1.
template <class S>
std::vector<S> normalized_uniform_weights(const OneRing& ring) {
  std::vector<S> w(to_size(ring.edges()));
  for (std::size_t i = 0; i + 1 < ring.first.size(); ++i) {
    for (std::int32_t k = ring.first[i]; k < ring.first[i + 1]; ++k) {
      nth(w, k) = S(1) / static_cast<S>(ring.first[i + 1] - ring.first[i]);
    }
  }
  return w;
}

// The mesh of the thesis' Fig 2.2.
struct Fan {
  json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/laplacian_fan.json");
  Points rest = golden["vertices"].vec3s<double>();
  std::vector<Face> faces = golden["faces"].faces();
  std::vector<std::int32_t> controls = golden["controls"].integers();
  Points targets = golden["targets"].vec3s<double>();
  double lambda = golden["lam"].number();
  OneRing ring = one_ring(faces, static_cast<std::int32_t>(rest.size()));

  std::vector<double> weight(const std::string& name) const {
    if (name == "cotan") return cotangent_weights<double>(rest, faces, ring, {-1e9, 1e9});  // the case does not clamp
    return name == "uniform" ? uniform_weights<double>(ring) : normalized_uniform_weights<double>(ring);
  }

  template <class Constraint>
  Points edit(const std::string& weights, const Constraint& constraint) const {
    LaplacianEditor<double, Constraint> editor;
    REQUIRE(editor.bind(rest, ring, weight(weights), controls, constraint).ok());
    Points out(rest.size());
    editor.edit(targets, out);
    return out;
  }
};

template <class S>
std::vector<Vec3<S>> cast(const Points& points) {
  std::vector<Vec3<S>> out;
  for (const auto& p : points) out.push_back(p.cast<S>());
  return out;
}

Eigen::MatrixXd matrix(const Points& points) {
  Eigen::MatrixXd m(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) m.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return m;
}

}  // namespace

TEST_CASE("the fan of the thesis: L, delta and every edit of the golden case") {
  const Fan fan;
  int edits = 0;
  for (const std::string& name : fan.golden["weights"].keys()) {
    CAPTURE(name);
    const json::Value& expected = fan.golden["weights"][name];
    const std::vector<double> weight = fan.weight(name);
    const Eigen::MatrixXd L = laplacian_matrix<double>(fan.ring, weight);
    CHECK((L - expected["L"].matrix<double>()).cwiseAbs().maxCoeff() < 1e-9);

    LaplacianEditor<double, RowReplacement<double>> editor;
    REQUIRE(editor.bind(fan.rest, fan.ring, weight, fan.controls).ok());
    CHECK(largest_difference(editor.delta(), expected["delta"].vec3s<double>()) < 1e-9);

    const auto check = [&](const char* mode, const Points& edited) {
      if (!expected.has(mode)) return;
      CAPTURE(mode);
      CHECK(largest_difference(edited, expected[mode].vec3s<double>()) < 1e-9);
      ++edits;
    };
    check("ls", fan.edit(name, SoftRows<double>{fan.lambda}));
    check("soft", fan.edit(name, SoftDiagonal<double>{fan.lambda}));
    check("col", fan.edit(name, ColumnElimination<double>{}));
    check("row", fan.edit(name, RowReplacement<double>{}));
  }
  CHECK(edits == 11);  // four modes of three weights, but soft needs symmetric ones
}

TEST_CASE("the x of Eq 2.6, 2.7 and 2.8, with 1/3 for the printed 0.33") {
  const Fan fan;
  const auto check = [](const Points& edited, std::initializer_list<double> x) {
    std::size_t v = 0;
    for (const double expected : x) CHECK(edited[v++].x() == doctest::Approx(expected).epsilon(1e-4));
  };
  check(fan.edit("uniform_norm", SoftRows<double>{0.5}), {6, 10.1568, 12.1098, 7, .8902, 2.8432});
  check(fan.edit("uniform_norm", ColumnElimination<double>{}), {6, 11, 12.7, 7, .3, 2});
  check(fan.edit("uniform_norm", RowReplacement<double>{}), {6, 11, 12.3333, 7, .6667, 2});
}

TEST_CASE("the soft diagonal solves its equations with asymmetric weights too") {
  const Fan fan;
  Eigen::MatrixXd A = laplacian_matrix<double>(fan.ring, fan.weight("uniform_norm"));
  Eigen::MatrixXd b = A * matrix(fan.rest);
  for (std::size_t c = 0; c < fan.controls.size(); ++c) {
    A(fan.controls[c], fan.controls[c]) += 0.25;
    b.row(fan.controls[c]) += 0.25 * fan.targets[c].transpose();
  }
  const Eigen::MatrixXd expected = A.fullPivLu().solve(b);
  const Eigen::MatrixXd edited = matrix(fan.edit("uniform_norm", SoftDiagonal<double>{0.5}));
  CHECK((edited - expected).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE_TEMPLATE("an edit keeps the rest, follows a shift and allocates nothing", Editor,
                   LaplacianEditor<double, SoftRows<double>>, LaplacianEditor<double, SoftDiagonal<double>>,
                   LaplacianEditor<double, ColumnElimination<double>>, LaplacianEditor<double, RowReplacement<double>>,
                   LaplacianEditor<float, SoftRows<float>>, LaplacianEditor<float, SoftDiagonal<float>>,
                   LaplacianEditor<float, ColumnElimination<float>>, LaplacianEditor<float, RowReplacement<float>>) {
  using Scalar = typename std::remove_const_t<
      std::remove_pointer_t<decltype(std::declval<const Editor&>().delta().data())>>::Scalar;
  const Scalar tolerance = sizeof(Scalar) == 4 ? Scalar(1e-4) : Scalar(1e-9);
  const Fan fan;
  const auto rest = cast<Scalar>(fan.rest);
  const auto weight = uniform_weights<Scalar>(fan.ring);
  Editor editor;
  REQUIRE(editor.bind(rest, fan.ring, weight, fan.controls).ok());
  for (const Vec3<Scalar>& shift : {Vec3<Scalar>(0, 0, 0), Vec3<Scalar>(3, -2, 5)}) {
    std::vector<Vec3<Scalar>> targets, edited(rest.size());
    for (const std::int32_t c : fan.controls) targets.push_back(rest[static_cast<std::size_t>(c)] + shift);
    const auto before = test::allocation_count;
    editor.edit(targets, edited);
    CHECK(test::allocation_count == before);
    for (std::size_t v = 0; v < rest.size(); ++v) CHECK((edited[v] - rest[v] - shift).norm() < tolerance);
  }
}

TEST_CASE("what cannot be bound is refused by name, and the present binding goes on") {
  const Fan fan;
  using Hard = LaplacianEditor<double, ColumnElimination<double>>;
  const auto weight = fan.weight("uniform");
  Hard editor;
  REQUIRE(editor.bind(fan.rest, fan.ring, weight, fan.controls).ok());
  const auto refused = [&](const Points& rest, const OneRing& ring, const std::vector<double>& w,
                           std::vector<std::int32_t> controls, Error error, std::int32_t where) {
    const Status s = editor.bind(rest, ring, w, controls);
    CHECK(s.error == error);
    CHECK(s.where == where);
  };
  refused(fan.rest, fan.ring, {1, 1}, {1, 5}, Error::size_mismatch, -1);
  refused(fan.rest, fan.ring, weight, {1, 6}, Error::index_out_of_range, 1);
  refused(fan.rest, fan.ring, weight, {}, Error::no_controls, 0);
  refused(fan.rest, fan.ring, weight, {1, 5, 1}, Error::infeasible, 2);
  Points broken = fan.rest;
  broken[4].z() = std::nan("");
  refused(broken, fan.ring, weight, {1, 5}, Error::not_finite, 4);
  Points lonely = fan.rest;
  lonely.emplace_back(0, 0, 0);
  const OneRing seven = one_ring(fan.faces, 7);
  refused(lonely, seven, uniform_weights<double>(seven), {1, 5}, Error::no_controls, 6);

  LaplacianEditor<double, SoftRows<double>> soft;  // two pulls on one vertex are no contradiction
  CHECK(soft.bind(fan.rest, fan.ring, weight, std::vector<std::int32_t>{1, 5, 1}).ok());

  Points edited(fan.rest.size());
  editor.edit(fan.targets, edited);
  CHECK(largest_difference(edited, fan.golden["weights"]["uniform"]["col"].vec3s<double>()) < 1e-9);
}
