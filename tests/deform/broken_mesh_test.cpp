// Meshes as people have them. Each behaviour is defined: the deformer binds, holds its controls, and stays finite.
#include <doctest/doctest.h>

#include <random>

#include "rigless/deform/deformer.h"
#include "rigless/mesh/detail/measure.h"
#include "support/cylinder.h"

using namespace rigless;
using namespace rigless::detail;
using test::Cylinder;

namespace {

// Random drags on a few controls; every frame must be finite, near, and hold what it was told to.
template <class S>
void drag_around(const std::vector<Vec3<double>>& vertices, const std::vector<Face>& faces) {
  std::vector<Vec3<S>> rest;
  for (const auto& v : vertices) rest.push_back(v.cast<S>());
  const S diagonal = bounds<S>(rest).diagonal();
  Deformer<S> deformer;
  REQUIRE(deformer.bind(rest, faces).ok());
  const auto count = static_cast<std::int32_t>(rest.size());
  const std::vector<Control<S>> controls = {{0, S(0)}, {count / 2, S(0.1) * diagonal}, {count - 1, S(0.05) * diagonal}};
  REQUIRE(deformer.set_controls(controls).ok());
  std::mt19937 random(11);
  std::uniform_real_distribution<S> uniform(S(-0.3), S(0.3));
  for (int frame = 0; frame < 40; ++frame) {
    std::vector<Vec3<S>> targets;
    for (const auto& h : controls) {
      targets.push_back(rest[static_cast<std::size_t>(h.vertex)] +
                        diagonal * Vec3<S>(uniform(random), uniform(random), uniform(random)));
    }
    deformer.set_targets(targets);
    if (frame % 3 == 0) deformer.start();
    frame % 2 ? deformer.step(2) : deformer.relax(4);
    deformer.pose(S(1));
    for (std::size_t c = 0; c < controls.size(); ++c) {
      const auto v = static_cast<std::size_t>(controls[c].vertex);
      if (deformer.discs().owner[v] != static_cast<std::int32_t>(c)) continue;
      CHECK((deformer.positions()[v] - targets[c]).norm() <= S(1e-5) * diagonal);
    }
    S farthest = 0;
    for (std::size_t v = 0; v < rest.size(); ++v) {
      REQUIRE(deformer.positions()[v].allFinite());
      farthest = std::max(farthest, (deformer.positions()[v] - rest[v]).norm());
    }
    CHECK(farthest < S(3) * diagonal);
  }
}

}  // namespace

TEST_CASE_TEMPLATE("an open surface", S, float, double) {
  Cylinder cylinder(12, 9);
  cylinder.faces.resize(cylinder.faces.size() / 2);
  drag_around<S>(cylinder.vertices, cylinder.faces);  // the far half is left as isolated vertices, too
}

TEST_CASE_TEMPLATE("many shells and stray vertices", S, float, double) {
  const Cylinder one(8, 5);
  std::vector<Vec3<double>> vertices;
  std::vector<Face> faces;
  for (int k = 0; k < 14; ++k) {
    const auto base = static_cast<std::int32_t>(vertices.size());
    for (const auto& v : one.vertices) vertices.push_back(v + Vec3<double>(1.3 * (k % 4), 0, 1.1 * (k / 4)));
    for (const Face& f : one.faces) faces.push_back({f[0] + base, f[1] + base, f[2] + base});
    vertices.push_back({0.1 * k, 5, 0});
  }
  drag_around<S>(vertices, faces);
}

TEST_CASE_TEMPLATE("duplicate, flipped, degenerate and zero-area faces, edges of many faces", S, float, double) {
  Cylinder cylinder(10, 8);
  const std::size_t count = cylinder.faces.size();
  for (std::size_t f = 0; f < count; f += 3) {
    const Face face = cylinder.faces[f];
    cylinder.faces.push_back(face);
    cylinder.faces.push_back({face[2], face[1], face[0]});
    cylinder.faces.push_back({face[0], face[0], face[1]});
    const auto middle = static_cast<std::int32_t>(cylinder.vertices.size());  // on the edge: no area
    cylinder.vertices.push_back(0.5 * (cylinder.vertices[static_cast<std::size_t>(face[0])] +
                                       cylinder.vertices[static_cast<std::size_t>(face[1])]));
    cylinder.faces.push_back({face[0], face[1], middle});
    const auto fin = static_cast<std::int32_t>(cylinder.vertices.size());
    cylinder.vertices.push_back(1.4 * cylinder.vertices[static_cast<std::size_t>(face[0])]);
    cylinder.faces.push_back({face[0], face[1], fin});
  }
  drag_around<S>(cylinder.vertices, cylinder.faces);
}

TEST_CASE_TEMPLATE("vertices that lie on one another", S, float, double) {
  Cylinder soup(9, 6);  // triangle soup: every face has corners of its own
  std::vector<Vec3<double>> vertices;
  std::vector<Face> faces;
  for (const Face& f : soup.faces) {
    const auto base = static_cast<std::int32_t>(vertices.size());
    for (const std::int32_t v : f) vertices.push_back(soup.vertices[static_cast<std::size_t>(v)]);
    faces.push_back({base, base + 1, base + 2});
  }
  drag_around<S>(vertices, faces);
}

TEST_CASE_TEMPLATE("slivers and a scale from millimetres to kilometres", S, float, double) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    Cylinder cylinder(40, 5);
    for (auto& v : cylinder.vertices) v = scale * Vec3<double>(v.x(), 3 * v.y(), v.z());
    drag_around<S>(cylinder.vertices, cylinder.faces);
  }
}

TEST_CASE_TEMPLATE("a target that is no number leaves its control where it was", S, float, double) {
  const Cylinder cylinder(12, 9);
  std::vector<Vec3<S>> rest;
  for (const auto& v : cylinder.vertices) rest.push_back(v.cast<S>());
  Deformer<S> deformer;
  REQUIRE(deformer.bind(rest, cylinder.faces).ok());
  REQUIRE(deformer.set_controls(std::vector<Control<S>>{{0, S(0.4)}, {100, S(0.4)}}).ok());
  const Vec3<S> moved = rest[100] + Vec3<S>(S(0.5), S(0.5), S(0));
  deformer.set_targets(std::vector<Vec3<S>>{rest[0], moved});
  const S nan = std::numeric_limits<S>::quiet_NaN();
  deformer.set_targets(std::vector<Vec3<S>>{{nan, 0, 0}, {0, std::numeric_limits<S>::infinity(), 0}});
  deformer.start();
  deformer.relax(5);
  deformer.pose(S(1));
  CHECK((deformer.positions()[0] - rest[0]).norm() < S(1e-5));
  CHECK((deformer.positions()[100] - moved).norm() < S(1e-5));
  for (const auto& p : deformer.positions()) CHECK(p.allFinite());
}

TEST_CASE("a shell without a control follows what is nearest") {
  Cylinder body(12, 9);
  const auto count = static_cast<std::int32_t>(body.vertices.size());
  const std::vector<Vec3<double>> hat = {{0, 4.05, 0.1}, {0.1, 4.05, -0.1}, {-0.1, 4.05, -0.1}, {0, 4.3, 0}};
  for (const auto& v : hat) body.vertices.push_back(v);
  for (const Face& f : {Face{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}}) {
    body.faces.push_back({f[0] + count, f[1] + count, f[2] + count});
  }
  Deformer<double> deformer;
  REQUIRE(deformer.bind(body.vertices, body.faces).ok());
  REQUIRE(deformer.set_controls(body.ends).ok());
  const Vec3<double> shift(1.5, 0.5, 0);
  std::vector<Vec3<double>> targets;
  for (const auto& h : body.ends) {
    const Vec3<double>& v = body.vertices[static_cast<std::size_t>(h.vertex)];
    targets.push_back(v.y() > 2 ? v + shift : v);
  }
  deformer.set_targets(targets);
  deformer.start();
  deformer.relax(60);
  for (std::size_t k = 0; k < hat.size(); ++k) {
    const auto v = static_cast<std::size_t>(count) + k;
    CHECK((deformer.shape()[v] - hat[k] - shift).norm() < 0.3);
  }
}
