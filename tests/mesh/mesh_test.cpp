#include <doctest/doctest.h>

#include "rigless/mesh/detail/geodesic.h"
#include "rigless/mesh/detail/laplacian.h"
#include "rigless/mesh/detail/measure.h"
#include "rigless/mesh/inspect.h"
#include "support/json.h"

using namespace rigless;
using namespace rigless::detail;

TEST_CASE_TEMPLATE("edge weights, volume and area agree with the golden bar", S, float, double) {
  const json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/weights_jbar.json");
  const auto vertices = golden["vertices"].vec3s<S>();
  const auto faces = golden["faces"].faces();
  const auto ei = golden["ei"].integers(), ej = golden["ej"].integers();
  const OneRing ring = one_ring(faces, static_cast<std::int32_t>(vertices.size()));
  REQUIRE(static_cast<std::size_t>(ring.edges()) == ei.size());
  const double tolerance = std::is_same_v<S, double> ? 1e-9 : 1e-4;
  const auto check = [&](const std::vector<S>& w, const char* name) {
    CAPTURE(name);
    const auto expected = golden["weights"][name].numbers();
    for (std::size_t k = 0; k < ei.size(); ++k) {
      const auto slot = ring.slot(ei[k], ej[k]);
      REQUIRE(slot >= 0);
      CHECK(std::abs(static_cast<double>(w[static_cast<std::size_t>(slot)]) - expected[k]) < tolerance);
    }
  };
  check(cotangent_weights<S>(vertices, faces, ring, {S(-1e9), S(1e9)}), "cotan");
  check(uniform_weights<S>(ring), "uniform");
  CHECK(static_cast<double>(signed_volume<S>(vertices, faces)) ==
        doctest::Approx(golden["volume"].number()).epsilon(tolerance));
  CHECK(static_cast<double>(surface_area<S>(vertices, faces)) ==
        doctest::Approx(golden["area"].number()).epsilon(tolerance));
}

TEST_CASE("weights are clamped, symmetric, and finite on a triangle without area") {
  const std::vector<Vec3<double>> v = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}, {0.5, -5, 0}, {0.5, 0, 0}};
  const std::vector<Face> f = {{0, 1, 2}, {1, 0, 3}, {0, 4, 1}};
  const OneRing ring = one_ring(f, 5);
  for (double w : cotangent_weights<double>(v, f, ring)) {
    CHECK(w >= 1e-3);
    CHECK(w <= 1e3);
  }
}

TEST_CASE("one-rings list every neighbour once, even over duplicate and non-manifold faces") {
  const std::vector<Face> f = {{0, 1, 2}, {0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const OneRing ring = one_ring(f, 6);
  CHECK(ring.first[1] - ring.first[0] == 4);
  CHECK(ring.first[6] - ring.first[5] == 0);
  CHECK(ring.slot(0, 1) >= 0);
  CHECK(ring.slot(2, 3) == -1);
  const MeshTopology t = inspect_mesh(f, 6);
  CHECK(t.non_manifold_edges == 1);
  CHECK(t.isolated_vertices == 1);
  CHECK(t.shells == 1);
  CHECK_FALSE(t.closed());
}

TEST_CASE("faces out of range are named") {
  const std::vector<Face> f = {{0, 1, 2}, {0, 3, 1}};
  CHECK(check_faces(f, 4).ok());
  CHECK(check_faces(f, 3).error == Error::index_out_of_range);
  CHECK(check_faces(f, 3).where == 1);
  CHECK(check_faces({}, 3).error == Error::no_faces);
}

TEST_CASE("shells are tied to what is nearest until everything hangs together") {
  // three tetrahedra in a row and a lonely vertex
  std::vector<Vec3<double>> v;
  std::vector<Face> f;
  for (int s = 0; s < 3; ++s) {
    const auto b = static_cast<std::int32_t>(v.size());
    const double x = 3.0 * s;
    for (const Vec3<double>& p : {Vec3<double>(x, 0, 0), {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}}) v.push_back(p);
    for (const Face& t : {Face{b, b + 2, b + 1}, {b, b + 1, b + 3}, {b, b + 3, b + 2}, {b + 1, b + 2, b + 3}})
      f.push_back(t);
  }
  v.push_back({10, 0, 0});
  const auto count = static_cast<std::int32_t>(v.size());
  const OneRing ring = one_ring(f, count);
  CHECK(find_shells(ring).count == 4);
  const auto ties = tie_shells<double>(v, ring);
  std::vector<std::array<std::int32_t, 2>> pairs = ties;
  for (const Face& t : f) {
    for (std::size_t k = 0; k < 3; ++k) pairs.push_back({t[k], t[(k + 1) % 3]});
  }
  CHECK(find_shells(one_ring_from_pairs(pairs, count)).count == 1);
  for (const auto& [a, b] : ties) CHECK((v[static_cast<std::size_t>(a)] - v[static_cast<std::size_t>(b)]).norm() < 6);
  CHECK(tie_shells<double>({v.data(), 4}, one_ring({f.data(), 4}, 4)).empty());
}

TEST_CASE("geodesic distance follows the surface") {
  // a strip folded like a V: across the gap the ends are near, along the strip they are far
  std::vector<Vec3<double>> v;
  std::vector<Face> f;
  for (int k = 0; k <= 20; ++k) {
    const double t = k / 10.0 - 1.0;
    v.push_back({std::abs(t), 0.1 * t, 0});
    v.push_back({std::abs(t), 0.1 * t, 0.1});
  }
  for (std::int32_t k = 0; k < 20; ++k) {
    f.push_back({2 * k, 2 * k + 1, 2 * k + 2});
    f.push_back({2 * k + 1, 2 * k + 3, 2 * k + 2});
  }
  const OneRing ring = one_ring(f, static_cast<std::int32_t>(v.size()));
  const auto near = vertices_within<double>(v, ring, 0, 0.35);
  CHECK(near.front().vertex == 0);
  CHECK(near.front().distance == 0);
  for (const auto& g : near) CHECK(g.vertex <= 8);
  CHECK(vertices_within<double>(v, ring, 0, 0.0).size() == 1);
}
