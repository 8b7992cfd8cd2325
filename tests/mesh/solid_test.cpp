#include "rigless/mesh/solid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "rigless/mesh/detail/shells.h"
#include "support/odd_models.h"

using namespace rigless;
using namespace rigless::test;

namespace {

template <class S>
Solid<S> solid_of(const Model<S>& m, const SolidOptions& options = {}) {
  Solid<S> solid;
  REQUIRE(build_solid<S>(m.vertices, m.faces, options, solid).ok());
  return solid;
}

template <class S>
std::int32_t count_inside(const Solid<S>& solid) {
  return static_cast<std::int32_t>(std::count(solid.inside.begin(), solid.inside.end(), 1));
}

// Nodes of the elements that carry the vertices of m that `which` chooses.
template <class S, class Which>
std::set<std::int32_t> nodes_under(const Solid<S>& solid, const Model<S>& m, const Which& which) {
  std::set<std::int32_t> nodes;
  for (std::size_t v = 0; v < m.vertices.size(); ++v) {
    if (solid.element_of[v] < 0 || !which(m.vertices[v])) continue;
    for (const std::int32_t n : nth(solid.element, solid.element_of[v])) nodes.insert(n);
  }
  return nodes;
}

std::size_t common(const std::set<std::int32_t>& a, const std::set<std::int32_t>& b) {
  std::vector<std::int32_t> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both.size();
}

template <class S>
std::size_t bridges(const Solid<S>& solid) {
  return static_cast<std::size_t>(std::count(solid.weight.begin(), solid.weight.end(), Solid<S>::bridge)) / 2;
}

// What must hold of every solid.
template <class S>
void check_solid(const Solid<S>& solid, const Model<S>& m) {
  CHECK(solid.nodes() >= 2000);
  CHECK(solid.nodes() <= 4000);
  CHECK(solid.element_of.size() == m.vertices.size());
  CHECK(detail::find_shells(solid.ring).count == 1);
  bool sound = true;
  for (std::int32_t i = 0; i < solid.nodes(); ++i) {
    sound = sound && nth(solid.rest, i).allFinite();
    for (std::int32_t k = nth(solid.ring.first, i); k < nth(solid.ring.first, i + 1); ++k) {
      const std::int32_t back = solid.ring.slot(nth(solid.ring.neighbor, k), i);
      sound = sound && back >= 0 && nth(solid.weight, k) > S(0) && nth(solid.weight, k) == nth(solid.weight, back);
    }
  }
  for (const auto& corner : solid.element) {
    for (int k = 0; k < 8; ++k) {
      const Vec3<S> at(static_cast<S>(k & 1), static_cast<S>(k >> 1 & 1), static_cast<S>(k >> 2 & 1));
      const Vec3<S> off = nth(solid.rest, nth(corner, k)) - nth(solid.rest, corner[0]) - solid.cell * at;
      sound = sound && off.norm() < S(1e-3) * solid.cell;
    }
  }
  std::vector<char> used(m.vertices.size(), 0);
  for (const Face& f : m.faces)
    for (const std::int32_t v : f) nth(used, v) = 1;
  for (std::size_t v = 0; v < m.vertices.size(); ++v) {
    if (!used[v] || solid.element_of[v] < 0) continue;
    const Vec3<S> x = (m.vertices[v] - nth(solid.rest, nth(solid.element, solid.element_of[v])[0])) / solid.cell;
    sound = sound && x.minCoeff() > S(-1e-3) && x.maxCoeff() < S(1.001);
  }
  CHECK(sound);
}

std::uint64_t hash_of(const Solid<float>& solid) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](const void* data, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k) hash = (hash ^ static_cast<const unsigned char*>(data)[k]) * 0x100000001b3u;
  };
  for (const auto& p : solid.rest) add(p.data(), sizeof p);
  for (const auto& e : solid.element) add(e.data(), sizeof e);
  add(solid.element_of.data(), solid.element_of.size() * 4);
  add(solid.ring.neighbor.data(), solid.ring.neighbor.size() * 4);
  add(solid.weight.data(), solid.weight.size() * 4);
  return hash;
}

}  // namespace

TEST_CASE_TEMPLATE("a body of overlapping shells is one solid whose legs are two", S, float, double) {
  const Model<S> m = mannequin(S(0.02));
  const Solid<S> solid = solid_of(m);
  check_solid(solid, m);
  CHECK(bridges(solid) == 0);
  const auto left = nodes_under(solid, m, [](const Vec3<S>& p) { return p.x() > 0 && p.y() < S(.7); });
  const auto right = nodes_under(solid, m, [](const Vec3<S>& p) { return p.x() < 0 && p.y() < S(.7); });
  CHECK(left.size() > 100);
  CHECK(common(left, right) == 0);
  CHECK(count_inside(solid) > 200);
  const auto hips = nodes_under(solid, m, [](const Vec3<S>& p) { return p.y() > S(.75) && p.y() < S(1); });
  CHECK(common(hips, nodes_under(solid, m, [](const Vec3<S>& p) { return p.y() < S(.75); })) > 20);
}

TEST_CASE("a shell of two legs close together parts them too") {
  // a cut ring, like a pair of tongs: one shell, whose ends are 1 % of its height apart
  const auto tongs = welded(patch<double>(48, [](double u, double v) {
    const double turn = 0.012 + u * (6.283185307179586 - 0.024), around = 6.283185307179586 * v;
    const double r = 1 + 0.3 * std::cos(around), flat = std::min(1.0, 8 * std::min(u, 1 - u) + 0.02);
    return Vec3<double>(r * std::sin(turn), -r * std::cos(turn), -0.3 * flat * std::sin(around));
  }));
  const Solid<double> solid = solid_of(tongs);
  check_solid(solid, tongs);
  const auto below = [](double sign) {
    return [sign](const Vec3<double>& p) { return sign * p.x() > 0 && p.y() < 0; };
  };
  CHECK(common(nodes_under(solid, tongs, below(1)), nodes_under(solid, tongs, below(-1))) == 0);
}

TEST_CASE("parts that cross are filled for each, and hang together by what goes with both") {
  Model<double> m = ball<double>({0, 1, 0}, {.3, .6, .2});
  m.add(ball<double>({.33, 1, 0}, {.1, .5, .1}));  // an arm that dips into the trunk all the way down
  const Solid<double> grown = solid_of(m);
  SolidOptions options;
  std::vector<std::int32_t> part;
  const std::size_t arm = m.vertices.size() / 2;
  for (std::size_t v = 0; v < m.vertices.size(); ++v) {
    part.push_back(v < arm ? 0 : m.vertices[v].y() > 1.25 ? -1 : 1);
  }
  options.part = part;
  const Solid<double> solid = solid_of(m, options);
  check_solid(solid, m);
  CHECK(bridges(solid) == 0);
  const auto under = [&](const Solid<double>& of, bool is_arm, double low, double high) {
    std::set<std::int32_t> nodes;
    for (std::size_t v = is_arm ? arm : 0; v < (is_arm ? m.vertices.size() : arm); ++v) {
      if (m.vertices[v].y() < low || m.vertices[v].y() > high) continue;
      for (const std::int32_t n : nth(of.element, of.element_of[v])) nodes.insert(n);
    }
    return nodes;
  };
  CHECK(common(under(grown, true, .6, 1.1), under(grown, false, .6, 1.1)) > 20);
  CHECK(common(under(solid, true, .6, 1.1), under(solid, false, .6, 1.1)) == 0);
  CHECK(common(under(solid, true, 1.25, 2), under(solid, false, 1.25, 2)) > 10);
}

TEST_CASE("boots side by side in neighbouring voxels stay two") {
  Model<double> m = ball<double>({0, 1, 0}, {.5, .5, .3});
  m.add(ball<double>({.3, .3, 0}, {.12, .45, .12}));
  m.add(ball<double>({-.3, .3, 0}, {.12, .45, .12}));
  for (const double side : {1.0, -1.0}) m.add(box<double>({side * .16 - .14, -.2, -.1}, {side * .16 + .14, 0, .4}, 8));
  const Solid<double> solid = solid_of(m);
  check_solid(solid, m);
  CHECK(solid.cell > 0.03);  // the boots are 0.04 apart
  const auto boot = [](double sign) {
    return [sign](const Vec3<double>& p) { return sign * p.x() > 0 && p.y() < -.05; };
  };
  CHECK(common(nodes_under(solid, m, boot(1)), nodes_under(solid, m, boot(-1))) == 0);
}

TEST_CASE("a soup wound at random is the solid of the welded mesh") {
  const Model<double> m = mannequin(0.02), loose = soup(m);
  const Solid<double> a = solid_of(m), b = solid_of(loose);
  check_solid(b, loose);
  CHECK(a.nodes() == b.nodes());
  CHECK(a.rest == b.rest);
  std::size_t differ = 0;
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(loose.faces[f][k]);
      for (const std::int32_t v : m.faces[f]) {
        if (nth(m.vertices, v) == loose.vertices[corner] && nth(a.element_of, v) != b.element_of[corner]) ++differ;
      }
    }
  }
  CHECK(differ == 0);
}

TEST_CASE("holes are closed, openings are not") {
  const Model<double> coarse = ball<double>({0, 0, 0}, {1, 1, 1}, 7), whole = ball<double>({0, 0, 0}, {1, 1, 1}, 16);
  Model<double> holes = coarse;  // of triangles larger than a voxel
  holes.faces.clear();
  std::mt19937 random(3);
  for (const Face& f : coarse.faces)
    if (random() % 10 != 0) holes.faces.push_back(f);
  const std::int32_t inside = count_inside(solid_of(coarse));
  CHECK(inside > 500);
  const Solid<double> solid = solid_of(holes);
  CHECK(std::abs(count_inside(solid) - inside) < inside / 10);

  Model<double> cup = whole;  // a bowl: what is above the middle is gone
  cup.faces.clear();
  for (const Face& f : whole.faces)
    if (nth(whole.vertices, f[0]).y() < 0.1) cup.faces.push_back(f);
  CHECK(count_inside(solid_of(cup)) < 100);
  check_solid(solid_of(cup), cup);
}

TEST_CASE("a man of paper, a rod and two large triangles have a solid as others do") {
  const Model<double> paper = patch<double>(20, [](double u, double v) { return Vec3<double>(u, 2 * v, 0); });
  const Solid<double> flat = solid_of(paper);
  check_solid(flat, paper);
  std::set<double> levels;
  for (const auto& p : flat.rest) levels.insert(p.z());
  CHECK(levels.size() == 2);
  CHECK(*levels.begin() == doctest::Approx(-flat.cell / 2));

  const Model<double> rod = box<double>({0, 0, 0}, {.01, 3, .01});
  check_solid(solid_of(rod), rod);
  Model<double> slanted = rod;
  for (auto& p : slanted.vertices) p = Vec3<double>(p.x() + p.y(), p.y(), p.z() + p.y());
  check_solid(solid_of(slanted), slanted);
  const Model<double> square = patch<double>(1, [](double u, double v) { return Vec3<double>(u, v, u + v); });
  check_solid(solid_of(square), square);
}

TEST_CASE_TEMPLATE("debris far away neither counts nor moves", S, float, double) {
  const Model<S> m = mannequin(S(0.02));
  Model<S> littered = m;
  littered.add(ball<S>({40, 0, 7}, {S(.002), S(.002), S(.002)}, 1));
  const Solid<S> a = solid_of(m), b = solid_of(littered);
  check_solid(b, littered);
  CHECK(b.cell == doctest::Approx(a.cell).epsilon(0.1));
  for (std::size_t v = 0; v < littered.vertices.size(); ++v) {
    CHECK((b.element_of[v] < 0) == (v >= m.vertices.size()));
  }
}

TEST_CASE("what floats is bridged to what is nearest, softly") {
  Model<double> m = mannequin(0.02);
  m.add(ball<double>({0, 2.3, 0}, {.3, .08, .3}));
  const Solid<double> solid = solid_of(m);
  check_solid(solid, m);
  CHECK(bridges(solid) > 2);
  for (std::int32_t i = 0; i < solid.nodes(); ++i) {
    for (std::int32_t k = nth(solid.ring.first, i); k < nth(solid.ring.first, i + 1); ++k) {
      if (nth(solid.weight, k) == 1) continue;
      CHECK(nth(solid.rest, i).y() > 1.8);  // the head
    }
  }
}

TEST_CASE("boxes that all but touch hang on each other firmly") {
  Model<double> m;
  for (const double y : {0.0, 1.0, 2.0}) m.add(box<double>({0, y, 0}, {1, y + .98, 1}, 6));
  const Solid<double> solid = solid_of(m);
  check_solid(solid, m);
  CHECK(bridges(solid) == 0);
  std::size_t ties = 0;
  for (std::int32_t i = 0; i < solid.nodes(); ++i) {
    for (std::int32_t k = nth(solid.ring.first, i); k < nth(solid.ring.first, i + 1); ++k) {
      ties += nth(solid.rest, i) == nth(solid.rest, nth(solid.ring.neighbor, k));
    }
  }
  CHECK(ties > 100);
}

TEST_CASE("a ground stays out and still, a vertex of no face goes with what is near") {
  Model<double> m = mannequin(0.02);
  const std::size_t body = m.vertices.size();
  m.vertices.push_back({.3, 1.2, .05});
  m.add(patch<double>(4, [](double u, double v) { return Vec3<double>(6 * v - 3, -.001, 6 * u - 3); }));
  const Solid<double> solid = solid_of(m);
  check_solid(solid, m);
  CHECK(solid.cell < 0.1);
  for (std::size_t v = 0; v < m.vertices.size(); ++v) CHECK((solid.element_of[v] < 0) == (v > body));

  Model<double> upright = m;  // the same along z
  for (auto& p : upright.vertices) p = Vec3<double>(p.x(), -p.z(), p.y());
  CHECK(solid_of(upright).element_of[body + 1] < 0);
  CHECK(solid_of(upright).element_of[0] >= 0);
}

TEST_CASE("bad models end with an error, extreme ones end") {
  const Model<float> m = mannequin(0.02f);
  Solid<float> solid;
  solid.cell = 7;
  const auto build = [&](const Model<float>& bad) { return build_solid<float>(bad.vertices, bad.faces, {}, solid); };
  CHECK(build({m.vertices, {}}).error == Error::no_faces);
  Model<float> bad = m;
  bad.faces[5][1] = static_cast<std::int32_t>(m.vertices.size());
  CHECK(build(bad).error == Error::index_out_of_range);
  CHECK(build(bad).where == 5);
  for (const float x : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
    bad = m;
    bad.vertices[9].x() = x;
    CHECK(build(bad).error == Error::not_finite);
    CHECK(build(bad).where == 9);
  }
  bad = m;
  for (auto& v : bad.vertices) v = {1, 2, 3};
  CHECK(build(bad).error == Error::no_faces);
  CHECK(solid.cell == 7);

  bad = m;
  bad.vertices[9].x() = 1e15f;  // one triangle fan as long as numbers go
  REQUIRE(build(bad).ok());
  for (const auto& p : solid.rest) REQUIRE(p.allFinite());
  const Model<double> wide = mannequin(0.02);
  Model<double> far = wide;
  for (auto& v : far.vertices) v *= 1e30;
  const Solid<double> huge = solid_of(far), normal = solid_of(wide);
  CHECK(huge.nodes() == doctest::Approx(normal.nodes()).epsilon(0.05));
}

TEST_CASE("as many nodes as wanted") {
  const Model<float> m = mannequin(0.02f);
  for (const int wanted : {1500, 3000, 6000}) {
    CHECK(solid_of(m, {wanted, {}}).nodes() == doctest::Approx(wanted).epsilon(0.25));
  }
}

TEST_CASE("the same solid everywhere, to the bit") {
  Model<float> m = mannequin(0.02f);
  m.add(ball<float>({0, 2.3f, 0}, {.3f, .08f, .3f}));
  CHECK(hash_of(solid_of(m)) == 16963938706063680675u);
}

TEST_CASE("a part of it is stiffer, to its middle, and no edge is softer than before") {
  const Model<float> m = mannequin(0.02f);
  const Solid<float> soft = solid_of(m);
  Solid<float> stiff = soft;
  float top = 0;
  for (const auto& p : m.vertices) top = std::max(top, p.y());
  std::vector<float> rigidity;
  for (const auto& p : m.vertices) rigidity.push_back(p.y() > 0.85f * top ? 10.f : 1.f);
  stiffen<float>(rigidity, stiff);
  std::int32_t stiffer = 0;
  for (std::size_t i = 0; i < soft.rest.size(); ++i) {
    for (auto e = to_size(soft.ring.first[i]); e < to_size(soft.ring.first[i + 1]); ++e) {
      const float ratio = stiff.weight[e] / soft.weight[e];
      const float low = std::min(soft.rest[i].y(), nth(soft.rest, soft.ring.neighbor[e]).y());
      if (low > 0.85f * top + 3 * soft.cell) CHECK(ratio == doctest::Approx(10));
      if (low < 0.85f * top - 3 * soft.cell) CHECK(ratio == doctest::Approx(1));
      stiffer += ratio > 5 ? 1 : 0;
    }
  }
  CHECK(stiffer > 0);
}
