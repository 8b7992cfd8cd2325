// The kinds of control beside a free disc: a turned disc, a curve, a region that keeps its shape.
#include <doctest/doctest.h>

#include "rigless/deform/curve_control.h"
#include "rigless/deform/deformer.h"
#include "support/alloc_count.h"
#include "support/cylinder.h"

using namespace rigless;
using test::Cylinder;

namespace {

const int around = 16, rows = 21;

std::int32_t at(int row, int column) { return row * around + column; }

}  // namespace

TEST_CASE("a turned disc keeps its turn, a freed one turns with its surroundings again") {
  const Cylinder cylinder(around, rows);
  Deformer<double> deformer;
  REQUIRE(deformer.bind(cylinder.vertices, cylinder.faces).ok());
  REQUIRE(deformer.set_controls(std::vector<Control<double>>{{at(0, 0), 0.5}, {at(20, 0), 0.5}}).ok());
  const Mat3<double> quarter = Eigen::AngleAxisd(0.9, Vec3<double>::UnitY()).toRotationMatrix();
  deformer.turn(1, quarter);
  deformer.start();
  deformer.relax(60);
  CHECK((deformer.disc_rotations()[1] - quarter).norm() < 1e-12);
  const auto v = static_cast<std::size_t>(at(20, 1));
  const auto center = static_cast<std::size_t>(at(20, 0));
  REQUIRE(deformer.discs().owner[v] == 1);
  CHECK((deformer.shape()[v] - cylinder.vertices[center] - quarter * (cylinder.vertices[v] - cylinder.vertices[center]))
            .norm() < 1e-12);
  CHECK(deformer.energy() < 1e-8);  // nothing keeps the rest from turning along

  deformer.free_turn(1);
  deformer.start();
  deformer.relax(200);
  CHECK((deformer.disc_rotations()[1] - Mat3<double>::Identity()).norm() < 1e-4);
  CHECK(deformer.energy() < 1e-8);
}

TEST_CASE("a stiff region keeps its shape and the rest gives") {
  const Cylinder cylinder(around, rows);
  const auto strain = [&](double stiffness, int from, int to) {
    std::vector<double> rigidity(cylinder.vertices.size(), 1.0);
    for (int r = 8; r <= 12; ++r) {
      for (int a = 0; a < around; ++a) rigidity[static_cast<std::size_t>(at(r, a))] = stiffness;
    }
    DeformerOptions<double> options;
    options.rigidity = rigidity;
    Deformer<double> deformer;
    REQUIRE(deformer.bind(cylinder.vertices, cylinder.faces, options).ok());
    REQUIRE(deformer.set_controls(cylinder.ends).ok());
    deformer.set_targets(cylinder.stretched(1.5));
    deformer.start();
    deformer.relax(200);
    double worst = 0;
    for (int r = from; r < to; ++r) {
      for (int a = 0; a < around; ++a) {
        const auto i = static_cast<std::size_t>(at(r, a)), j = static_cast<std::size_t>(at(r + 1, a));
        const double rest = (cylinder.vertices[j] - cylinder.vertices[i]).norm();
        worst = std::max(worst, std::abs((deformer.shape()[j] - deformer.shape()[i]).norm() / rest - 1));
      }
    }
    return worst;
  };
  const double soft = strain(1, 8, 12), stiff = strain(10, 8, 12);
  MESSAGE("strain of the region: ", soft, " soft, ", stiff, " at ten times the weight");
  CHECK(stiff < 0.5 * soft);
  CHECK(strain(10, 2, 6) > strain(1, 2, 6));

  std::vector<double> wrong(cylinder.vertices.size(), 1.0);
  wrong[3] = 0;
  DeformerOptions<double> options;
  options.rigidity = wrong;
  Deformer<double> deformer;
  CHECK(deformer.bind(cylinder.vertices, cylinder.faces, options).where == 3);
  wrong.pop_back();
  options.rigidity = wrong;
  CHECK(deformer.bind(cylinder.vertices, cylinder.faces, options).error == Error::size_mismatch);
}

TEST_CASE("a curve runs along the surface and passes smoothly through its knots") {
  const Cylinder cylinder(around, rows);
  Deformer<double> deformer;
  REQUIRE(deformer.bind(cylinder.vertices, cylinder.faces).ok());
  CurveControl<double> curve;
  const std::vector<std::int32_t> knots = {at(2, 0), at(8, 0), at(14, 0), at(18, 0)};
  REQUIRE(curve.bind(deformer.cells(), knots).ok());
  CHECK(curve.size() == 17);
  for (const std::int32_t v : curve.path()) CHECK(v % around == 0);  // straight up one side

  std::vector<Vec3<double>> moved, targets(curve.size());
  for (std::size_t k = 0; k < knots.size(); ++k) {
    moved.push_back(cylinder.vertices[static_cast<std::size_t>(knots[k])] + Vec3<double>(k == 1 ? 1.0 : 0.0, 0, 0));
  }
  const auto before = test::allocation_count;
  curve.targets(moved, targets);
  CHECK(test::allocation_count == before);
  for (std::size_t p = 0; p < curve.size(); ++p) {
    for (std::size_t k = 0; k < knots.size(); ++k) {
      if (curve.path()[p] == knots[k]) CHECK((targets[p] - moved[k]).norm() < 1e-12);
    }
    if (p > 1) CHECK((targets[p] - 2 * targets[p - 1] + targets[p - 2]).norm() < 0.12);  // no corner
  }
  // all knots moved alike move the path alike
  for (auto& m : moved) m = Vec3<double>(0.3, 0.2, 0.1);
  for (std::size_t k = 0; k < knots.size(); ++k) moved[k] += cylinder.vertices[static_cast<std::size_t>(knots[k])];
  curve.targets(moved, targets);
  for (std::size_t p = 0; p < curve.size(); ++p) {
    const auto v = static_cast<std::size_t>(curve.path()[p]);
    CHECK((targets[p] - cylinder.vertices[v] - Vec3<double>(0.3, 0.2, 0.1)).norm() < 1e-12);
  }
  REQUIRE(deformer.set_controls(curve.controls()).ok());
  deformer.set_targets(targets);
  deformer.start();
  deformer.relax(5);
  for (std::size_t p = 0; p < curve.size(); ++p) {
    CHECK((deformer.shape()[static_cast<std::size_t>(curve.path()[p])] - targets[p]).norm() < 1e-12);
  }

  CHECK(curve.bind(deformer.cells(), std::vector<std::int32_t>{4}).error == Error::no_controls);
  CHECK(curve.bind(deformer.cells(), std::vector<std::int32_t>{4, 99999}).where == 1);
  CHECK(curve.bind(deformer.cells(), std::vector<std::int32_t>{4, 4}).error == Error::infeasible);
  CHECK(curve.size() == 17);
}
