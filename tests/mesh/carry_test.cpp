// What a solid takes along: positions, normals, tangents.
#include <doctest/doctest.h>

#include "rigless/mesh/solid.h"
#include "support/alloc_count.h"
#include "support/odd_models.h"

using namespace rigless;
using namespace rigless::test;

namespace {

template <class S>
struct Ride {
  Model<S> model = mannequin(S(0.02));
  Solid<S> solid;
  std::vector<NodeTransform<S>> transforms;
  std::vector<Vec3<S>> now, out;

  Ride() {
    REQUIRE(build_solid<S>(model.vertices, model.faces, {}, solid).ok());
    transforms.resize(solid.rest.size());
    now = solid.rest;
    out.resize(model.vertices.size());
  }
  template <class Map>
  void go(const Map& map) {
    for (std::size_t i = 0; i < now.size(); ++i) now[i] = map(solid.rest[i]);
    node_transforms<S>(solid, now, transforms);
    carry_points<S>(solid, model.vertices, transforms, out);
  }
};

// A twist, a bend and a swelling of a body two units high.
template <class S>
Vec3<S> bent(const Vec3<S>& p, S much) {
  const S turn = much * p.y(), bow = much * S(0.7) * p.x();
  const Vec3<S> q(p.x() * std::cos(turn) - p.z() * std::sin(turn), p.y() + S(0.1) * std::sin(2 * p.x()),
                  p.x() * std::sin(turn) + p.z() * std::cos(turn));
  return {q.x(), q.y() * std::cos(bow) - q.z() * std::sin(bow), q.y() * std::sin(bow) + q.z() * std::cos(bow)};
}

template <class S>
Mat3<S> some_turn() {
  return Eigen::AngleAxis<S>(S(2.2), Vec3<S>(1, 2, -1).normalized()).toRotationMatrix();
}

}  // namespace

TEST_CASE_TEMPLATE("a solid that moves rigidly takes the model along rigidly", S, float, double) {
  Ride<S> ride;
  const Mat3<S> R = some_turn<S>();
  const Vec3<S> t(3, -1, 2);
  ride.go([&](const Vec3<S>& p) { return Vec3<S>(R * p + t); });
  const S fine = sizeof(S) == 4 ? S(2e-5) : S(1e-12);
  std::vector<Vec3<S>> normals, turned(ride.out.size());
  for (const Vec3<S>& v : ride.model.vertices) normals.push_back(v.normalized());
  carry_normals<S>(ride.solid, ride.model.vertices, ride.transforms, normals, turned);
  S worst = 0, worst_normal = 0;
  for (std::size_t v = 0; v < ride.out.size(); ++v) {
    worst = std::max(worst, (ride.out[v] - (R * ride.model.vertices[v] + t)).norm());
    worst_normal = std::max(worst_normal, (turned[v] - R * normals[v]).norm());
  }
  CHECK(worst < fine);
  CHECK(worst_normal < 10 * fine);
}

TEST_CASE_TEMPLATE("an affine map comes out but for what is taken to the rotation", S, float, double) {
  Ride<S> ride;
  Mat3<S> M;
  M << S(1.2), S(.1), 0, S(-.2), S(.8), S(.3), 0, S(.1), S(1.1);
  const Mat3<S> A = some_turn<S>() * M;
  ride.go([&](const Vec3<S>& p) { return Vec3<S>(A * p); });
  S worst = 0;
  for (std::size_t v = 0; v < ride.out.size(); ++v) {
    worst = std::max(worst, (ride.out[v] - A * ride.model.vertices[v]).norm());
  }
  const Mat3<S> R = detail::nearest_rotation<S>(A.transpose());
  CHECK(worst < S(0.02) * (R - A).norm() * ride.solid.cell);
  const Mat3<S> expected = A + S(0.02) * (R - A);
  for (const auto& t : ride.transforms) CHECK((t.A - expected).norm() < (sizeof(S) == 4 ? S(1e-4) : S(1e-6)));
}

TEST_CASE("normals and tangents follow the gradient of the map, hats included") {
  Ride<double> ride;
  ride.go([](const Vec3<double>& p) { return bent(p, 0.9); });
  const double step = 1e-6;
  const std::size_t count = ride.out.size();
  // differences along each axis; the clamp of the hats has a corner only at the faces of an element
  std::array<std::vector<Vec3<double>>, 3> difference;
  for (int a = 0; a < 3; ++a) {
    auto forth = ride.model.vertices, back = forth;
    for (auto& p : forth) p[a] += step;
    for (auto& p : back) p[a] -= step;
    carry_points<double>(ride.solid, forth, ride.transforms, forth);
    carry_points<double>(ride.solid, back, ride.transforms, back);
    for (std::size_t v = 0; v < count; ++v)
      difference[static_cast<std::size_t>(a)].push_back((forth[v] - back[v]) / (2 * step));
  }
  const std::vector<Vec3<double>> tangents(count, Vec3<double>(1, 2, -2) / 3),
      normals(count, Vec3<double>(2, 1, 2) / 3);
  std::vector<Vec3<double>> t(count), n(count);
  carry_tangents<double>(ride.solid, ride.model.vertices, ride.transforms, tangents, t);
  carry_normals<double>(ride.solid, ride.model.vertices, ride.transforms, normals, n);
  double worst_tangent = 0, worst_normal = 0, rotations_only = 0;
  for (std::size_t v = 0; v < count; ++v) {
    Mat3<double> F;
    for (int a = 0; a < 3; ++a) F.col(a) = difference[static_cast<std::size_t>(a)][v];
    worst_tangent = std::max(worst_tangent, (t[v] - (F * tangents[v]).normalized()).norm());
    worst_normal = std::max(worst_normal, (n[v] - (F.inverse().transpose() * normals[v]).normalized()).norm());
    const Mat3<double>& A = nth(ride.transforms, nth(ride.solid.element, ride.solid.element_of[v])[0]).A;
    rotations_only = std::max(rotations_only, (n[v] - (A * normals[v]).normalized()).norm());
  }
  CHECK(worst_tangent < 1e-6);
  CHECK(worst_normal < 1e-6);
  CHECK(rotations_only > 0.05);  // or the bend would prove nothing
}

TEST_CASE("seams stay closed, and the map is continuous from one element to the next") {
  Ride<double> ride;
  ride.go([](const Vec3<double>& p) { return bent(p, 0.9); });
  const Model<double> loose = soup(ride.model);
  Solid<double> solid;
  REQUIRE(build_solid<double>(loose.vertices, loose.faces, {}, solid).ok());
  std::vector<Vec3<double>> out(loose.vertices.size());
  carry_points<double>(solid, loose.vertices, ride.transforms, out);
  REQUIRE(solid.rest == ride.solid.rest);
  double worst = 0;
  for (std::size_t f = 0; f < loose.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const std::int32_t v : ride.model.faces[f]) {
        const std::size_t corner = 3 * f + k;
        if (nth(ride.model.vertices, v) == loose.vertices[corner])
          worst = std::max(worst, (nth(ride.out, v) - out[corner]).norm());
      }
    }
  }
  CHECK(worst == 0);

  // a vertex on the border of two elements that share nodes goes to one place from either
  const auto& solid_nodes = ride.solid;
  std::size_t pairs = 0;
  for (std::size_t e = 0; e + 1 < solid_nodes.element.size(); ++e) {
    const auto &a = solid_nodes.element[e], &b = solid_nodes.element[e + 1];
    if (a[1] != b[0] || a[3] != b[2] || a[5] != b[4] || a[7] != b[6]) continue;
    const Vec3<double> p = nth(solid_nodes.rest, a[1]) + solid_nodes.cell * Vec3<double>(0, .3, .6);
    const auto i = static_cast<std::int32_t>(e);
    const Vec3<double> one = detail::carried_point(solid_nodes, i, p, ride.transforms.data());
    const Vec3<double> two = detail::carried_point(solid_nodes, i + 1, p, ride.transforms.data());
    worst = std::max(worst, (one - two).norm());
    ++pairs;
  }
  CHECK(pairs > 100);
  CHECK(worst < 1e-12);
}

TEST_CASE("nodes that are inverted or flat get a finite transform") {
  Ride<float> ride;
  for (const float z : {-1.0f, 0.0f, 1e-8f}) {
    ride.go([&](const Vec3<float>& p) { return Vec3<float>(p.x(), p.y(), z * p.z()); });
    for (const auto& t : ride.transforms) REQUIRE(t.A.allFinite());
    for (const auto& p : ride.out) REQUIRE(p.allFinite());
  }
}

TEST_CASE("carrying allocates nothing") {
  Ride<float> ride;
  std::vector<Vec3<float>> normals(ride.out.size(), Vec3<float>(0, 1, 0));
  const std::int64_t before = allocation_count;
  ride.go([](const Vec3<float>& p) { return bent(p, 0.5f); });
  carry_normals<float>(ride.solid, ride.model.vertices, ride.transforms, normals, normals);
  carry_tangents<float>(ride.solid, ride.model.vertices, ride.transforms, normals, normals);
  const float v = volume<float>(ride.solid, ride.now);
  CHECK(allocation_count == before);
  CHECK(v > 0);
}

TEST_CASE_TEMPLATE("the volume is that of the elements", S, float, double) {
  Ride<S> ride;
  const double cell = static_cast<double>(ride.solid.cell);
  const double rest = cell * cell * cell * ride.solid.elements();
  CHECK(static_cast<double>(volume<S>(ride.solid, ride.solid.rest)) == doctest::Approx(rest).epsilon(1e-3));
  ride.go([](const Vec3<S>& p) { return Vec3<S>(2 * p.x(), p.y() + p.x(), S(1.5) * p.z()); });
  CHECK(static_cast<double>(volume<S>(ride.solid, ride.now)) == doctest::Approx(3 * rest).epsilon(1e-3));
}

TEST_CASE("the lowest vertex is among the outermost, in any pose") {
  Ride<double> ride;
  const auto outermost = outermost_vertices<double>(ride.solid, ride.model.vertices);
  CHECK(outermost.size() < ride.model.vertices.size() * 3 / 4);
  double worst = 0;
  for (int pose = 0; pose < 60; ++pose) {
    const Mat3<double> R =
        Eigen::AngleAxisd(0.7 * pose,
                          Vec3<double>(std::sin(pose), std::cos(2.0 * pose), std::sin(3.0 * pose)).normalized())
            .toRotationMatrix();
    ride.go([&](const Vec3<double>& p) { return Vec3<double>(R * bent(p, 0.02 * pose)); });
    double all = 1e9, some = 1e9;
    for (const auto& p : ride.out) all = std::min(all, p.y());
    for (const std::int32_t v : outermost) some = std::min(some, nth(ride.out, v).y());
    worst = std::max(worst, some - all);
  }
  CHECK(worst < 0.05 * ride.solid.cell);
}
