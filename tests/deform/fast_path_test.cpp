// The fast path against the reference on a real mesh.
#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "rigless/deform/deformer.h"
#include "rigless/mesh/detail/measure.h"
#include "rigless/thesis/thesis_deformer.h"
#include "support/json.h"

using namespace rigless;
using namespace rigless::detail;

namespace {

using Points = std::vector<Vec3<double>>;

struct Mesh {
  Points vertices;
  std::vector<Face> faces;
};

// Positions and triangles of a Wavefront OBJ text; nothing else. Positions are rounded to float, so that both
// precisions start from the same mesh.
Mesh read_obj(const std::string& text) {
  Mesh mesh;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v") {
      float x = 0, y = 0, z = 0;
      words >> x >> y >> z;
      mesh.vertices.emplace_back(x, y, z);
    } else if (key == "f") {
      Face f{};
      for (std::int32_t& corner : f) {
        std::string word;
        words >> word;
        corner = std::atoi(word.c_str()) - 1;
      }
      mesh.faces.push_back(f);
    }
  }
  return mesh;
}

template <class To, class From>
std::vector<Vec3<To>> cast(Span<const Vec3<From>> points) {
  std::vector<Vec3<To>> out;
  for (const auto& p : points) out.push_back(p.template cast<To>());
  return out;
}

// The vertices that lie furthest up, down, forward, back, and down to either side.
std::vector<std::int32_t> extremes(const Points& vertices) {
  std::vector<std::int32_t> out;
  for (const Vec3<double>& way : Points{{0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {1, -0.9, 0}, {-1, -0.9, 0}}) {
    const auto furthest =
        std::max_element(vertices.begin(), vertices.end(),
                         [&](const Vec3<double>& a, const Vec3<double>& b) { return way.dot(a) < way.dot(b); });
    const auto v = static_cast<std::int32_t>(furthest - vertices.begin());
    if (std::find(out.begin(), out.end(), v) == out.end()) out.push_back(v);
  }
  return out;
}

struct Distance {
  double rms = 0;
  double worst = 0;
};

Distance distance(Span<const Vec3<double>> a, Span<const Vec3<double>> b, double diagonal) {
  Distance d;
  for (std::size_t v = 0; v < a.size(); ++v) {
    const double length = (a[v] - b[v]).norm() / diagonal;
    d.rms += length * length / static_cast<double>(a.size());
    d.worst = std::max(d.worst, length);
  }
  d.rms = std::sqrt(d.rms);
  return d;
}

struct Comparison {
  double energy_off = 0;      // relative, both measured by the reference
  double own_energy_off = 0;  // relative, what the fast path says of its own surface
  Distance shape, pose;       // in diagonals
};

// 30 iterations of Deformer<S> and of the reference, single vertices pulled 15 % of the diagonal from rest, then pose.
template <class S>
Comparison compare(const Mesh& mesh, double mu) {
  const double diagonal = bounds<double>(mesh.vertices).diagonal();
  const OneRing ring = one_ring(mesh.faces, static_cast<std::int32_t>(mesh.vertices.size()));
  const std::vector<std::int32_t> ends = extremes(mesh.vertices);
  REQUIRE(ends.size() >= 5);
  std::vector<Control<S>> controls;
  std::vector<Vec3<S>> targets;
  for (std::size_t c = 0; c < ends.size(); ++c) {
    const auto angle = static_cast<double>(c);
    const Vec3<double> way(std::cos(3 * angle), std::sin(2 * angle), std::sin(5 * angle));
    controls.push_back({ends[c], S(0)});
    targets.push_back((mesh.vertices[static_cast<std::size_t>(ends[c])] + 0.15 * diagonal * way).cast<S>());
  }
  ThesisDeformer<double, RowReplacement<double>> reference;
  REQUIRE(
      reference.bind(mesh.vertices, ring, cotangent_weights<double>(mesh.vertices, mesh.faces, ring), ends, {}, {mu})
          .ok());
  reference.set_targets(cast<double, S>(targets));
  reference.step(30);
  Deformer<S> fast;
  REQUIRE(fast.bind(cast<S, double>(mesh.vertices), mesh.faces, {static_cast<S>(mu)}).ok());
  REQUIRE(fast.set_controls(controls).ok());
  fast.set_targets(targets);
  fast.step(30);

  Comparison result;
  const Points shape = cast<double, S>(fast.shape());
  const double energy = shape_energy<double>(reference.cells(), shape, {mu});
  result.energy_off = energy / reference.energy() - 1;
  result.own_energy_off = fast.energy() / energy - 1;
  result.shape = distance(shape, reference.shape(), diagonal);
  fast.pose(PowerLaw<S>{S(1)});
  reference.pose(PowerLaw<double>{1});
  result.pose = distance(cast<double, S>(fast.positions()), reference.positions(), diagonal);
  MESSAGE("mu ", mu, ": energy ", reference.energy(), ", off by ", result.energy_off, ", own figure by ",
          result.own_energy_off, "; shape rms ", result.shape.rms, ", worst ", result.shape.worst, "; pose rms ",
          result.pose.rms, ", worst ", result.pose.worst, " diagonals");
  return result;
}

}  // namespace

TEST_CASE("after 30 iterations the fast path stands where the reference does") {
  const std::string text = json::read_text(RIGLESS_SHARED_DIR "data/meshes/spot.obj");
  if (text.empty()) {
    MESSAGE("skipped: no meshes at " RIGLESS_SHARED_DIR);
    return;
  }
  const Mesh mesh = read_obj(text);
  REQUIRE(mesh.faces.size() == 5856);
  const double unbounded = std::numeric_limits<double>::infinity();
  SUBCASE("single precision") {
    for (const double mu : {0.0, 0.5, unbounded}) {
      const Comparison c = compare<float>(mesh, mu);
      CHECK(std::abs(c.energy_off) < 1e-5);
      CHECK(std::abs(c.own_energy_off) < 1e-5);
      CHECK(c.shape.rms < 1e-5);
      CHECK(c.shape.worst < 1e-4);
      CHECK(c.pose.rms < 1e-4);
    }
  }
  SUBCASE("double precision") {
    for (const double mu : {0.0, 0.5, unbounded}) {
      const Comparison c = compare<double>(mesh, mu);
      CHECK(std::abs(c.energy_off) < 1e-12);
      CHECK(std::abs(c.own_energy_off) < 1e-12);
      CHECK(c.shape.worst < 1e-12);
      CHECK(c.pose.worst < 1e-9);
    }
  }
}
