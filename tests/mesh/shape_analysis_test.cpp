#include "rigless/mesh/shape_analysis.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/voxels.h"

using namespace rigless;
using namespace rigless::detail;

namespace {

// Every way in which a file may hold a body that stands on its feet: y or z up, and four ways to look.
template <class S>
std::vector<Mat3<S>> file_axes() {
  std::vector<Mat3<S>> all;
  for (const Vec3<S>& up : {Vec3<S>(0, 1, 0), Vec3<S>(0, 0, 1)}) {
    Vec3<S> front = up.y() > 0 ? Vec3<S>(0, 0, 1) : Vec3<S>(0, -1, 0);
    for (int turn = 0; turn < 4; ++turn, front = up.cross(front)) {
      Mat3<S> axes;
      axes << up.cross(front), up, front;
      all.push_back(axes);
    }
  }
  return all;
}

template <class S>
BlockBody<S> turned(const std::vector<Block>& blocks, const Mat3<S>& axes) {
  BlockBody<S> body = build_blocks<S>(blocks);
  for (Vec3<S>& p : body.vertices) p = axes * p * S(0.1) + Vec3<S>(3, -2, 7);
  return body;
}

template <class S>
std::int32_t count(const ShapeAnalysis<S>& u, BodyRole role, std::int32_t side) {
  std::int32_t n = 0;
  for (const BodyPoint<S>& p : u.points) n += p.wanted && p.role == role && p.side == side ? 1 : 0;
  return n;
}

// What must hold of any guess: points exist, each at a place of its own, partners agree, wanted ones come first.
template <class S>
void check_sound(const ShapeAnalysis<S>& u, const std::vector<Vec3<S>>& vertices) {
  bool wanted = true;
  for (std::size_t k = 0; k < u.points.size(); ++k) {
    const BodyPoint<S>& p = u.points[k];
    REQUIRE(p.vertex >= 0);
    REQUIRE(p.vertex < static_cast<std::int32_t>(vertices.size()));
    CHECK(p.radius > S(0));
    CHECK(std::isfinite(p.radius));
    CHECK((wanted || !p.wanted));
    wanted = p.wanted;
    if (p.partner >= 0) CHECK(u.points[static_cast<std::size_t>(p.partner)].partner == static_cast<std::int32_t>(k));
    for (std::size_t other = 0; other < k; ++other) CHECK(u.points[other].vertex != p.vertex);
  }
  const Posture<S>& q = u.posture;
  CHECK((q.up.cross(q.front) - q.left).norm() < S(1e-6));
  CHECK(q.up.cwiseAbs().maxCoeff() == S(1));
  CHECK(q.front.cwiseAbs().maxCoeff() == S(1));
}

}  // namespace

TEST_CASE_TEMPLATE("a human of blocks is found head to foot, however its file holds it", S, float, double) {
  for (const Mat3<S>& axes : file_axes<S>()) {
    const BlockBody<S> body = turned<S>(block_human, axes);
    ShapeAnalysis<S> u;
    REQUIRE(analyse_shape<S>(body.vertices, body.faces, u).ok());
    check_sound(u, body.vertices);
    CHECK((u.posture.up - axes.col(1)).norm() < S(1e-6));
    CHECK((u.posture.front - axes.col(2)).norm() < S(1e-6));
    CHECK(is_symmetric(u.plane));
    CHECK(std::abs(u.plane.normal.dot(axes.col(0))) > S(0.999));
    CHECK(count(u, BodyRole::head, 0) == 1);
    CHECK(std::any_of(u.points.begin(), u.points.end(), [](const auto& p) { return p.role == BodyRole::hips; }));
    for (const std::int32_t side : {1, -1}) {
      CHECK(count(u, BodyRole::foot, side) == 1);
      CHECK(count(u, BodyRole::hand, side) == 1);
    }
    for (const BodyPoint<S>& p : u.points) {
      const Vec3<S> place = axes.transpose() * (body.vertices[static_cast<std::size_t>(p.vertex)] - Vec3<S>(3, -2, 7));
      if (p.role == BodyRole::head) CHECK(place.y() > S(3.6));
      if (p.role == BodyRole::foot) CHECK(place.y() < S(0.3));
      if (p.role == BodyRole::hand) CHECK(place.x() * S(p.side) > S(1.3));
      if (p.wanted) CHECK(p.partner >= 0);
    }
  }
}

TEST_CASE_TEMPLATE("a dog of blocks stands on two forelegs and two feet, and its tail is no head", S, float, double) {
  for (const Mat3<S>& axes : file_axes<S>()) {
    const BlockBody<S> body = turned<S>(block_dog, axes);
    ShapeAnalysis<S> u;
    REQUIRE(analyse_shape<S>(body.vertices, body.faces, u).ok());
    check_sound(u, body.vertices);
    CHECK((u.posture.up - axes.col(1)).norm() < S(1e-6));
    CHECK((u.posture.front - axes.col(2)).norm() < S(1e-6));
    CHECK(is_symmetric(u.plane));
    for (const std::int32_t side : {1, -1}) {
      CHECK(count(u, BodyRole::foreleg, side) == 1);
      CHECK(count(u, BodyRole::foot, side) == 1);
      CHECK(count(u, BodyRole::hand, side) == 0);
    }
    bool tail = false;
    for (const BodyPoint<S>& p : u.points) tail = tail || p.role == BodyRole::tail;
    CHECK(tail);
  }
}

TEST_CASE_TEMPLATE("extremities are the ends of the limbs; the middle of the body is nearest to all", S, float,
                   double) {
  const BlockBody<S> body = build_blocks<S>(block_dog);
  const SurfaceGraph<S> graph = surface_graph<S>(body.vertices, body.faces, 600);
  CHECK(graph.size() <= 600);
  S area = 0;
  for (const S a : graph.area) area += a;
  CHECK(area == doctest::Approx(surface_area<S>(body.vertices, body.faces)).epsilon(1e-4));
  const std::vector<S> average = average_geodesic(graph);
  const auto least = std::min_element(average.begin(), average.end()) - average.begin();
  CHECK(std::abs(graph.position[static_cast<std::size_t>(least)].z()) < S(9));
  const auto tips = extremities<S>(graph, average, S(3));
  CHECK(tips.size() >= 6);  // four paws, the tail and the head
  for (std::size_t k = 1; k < tips.size(); ++k) CHECK(tips[k].prominence <= tips[k - 1].prominence);
  CHECK(extremities<S>(graph, average, S(1000)).empty());
}

TEST_CASE("a lopsided body has no plane of symmetry, a turned one has a turned plane") {
  std::vector<Block> blocks = block_human;
  blocks.push_back({{4, 16, 2}, {8, 20, 26}});
  blocks.push_back({{-20, 27, -12}, {-16, 30, 2}});
  blocks.push_back({{3, 36, -20}, {8, 40, 0}});
  const BlockBody<double> lopsided = build_blocks<double>(blocks);
  ShapeAnalysis<double> u;
  REQUIRE(analyse_shape<double>(lopsided.vertices, lopsided.faces, u).ok());
  check_sound(u, lopsided.vertices);
  CHECK_FALSE(is_symmetric(u.plane));
  for (const BodyPoint<double>& p : u.points) CHECK(p.partner == -1);

  BlockBody<double> body = build_blocks<double>(block_human);
  const Mat3<double> turn = Eigen::AngleAxisd(0.35, Vec3<double>::UnitY()).toRotationMatrix();
  for (Vec3<double>& p : body.vertices) p = turn * p;
  REQUIRE(analyse_shape<double>(body.vertices, body.faces, u).ok());
  CHECK(is_symmetric(u.plane));
  CHECK(std::abs(u.plane.normal.dot(turn.col(0))) > 0.995);
}

TEST_CASE("strange meshes get sound guesses or a clear refusal") {
  using V = Vec3<float>;
  ShapeAnalysis<float> u;
  SUBCASE("a triangle") {
    const std::vector<V> v = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    REQUIRE(analyse_shape<float>(v, std::vector<Face>{{0, 1, 2}}, u).ok());
    CHECK_FALSE(u.points.empty());
    check_sound(u, v);
  }
  SUBCASE("all at one place") {
    const std::vector<V> v(5, V(1, 1, 1));
    REQUIRE(analyse_shape<float>(v, std::vector<Face>{{0, 1, 2}, {2, 3, 4}}, u).ok());
    CHECK_FALSE(is_symmetric(u.plane));
    check_sound(u, v);
  }
  SUBCASE("a flat sheet is not symmetric in itself") {
    std::vector<V> v;
    std::vector<Face> f;
    for (int x = 0; x <= 8; ++x)
      for (int y = 0; y <= 12; ++y) {
        v.push_back(V(float(x), float(y), 0));
        if (x == 8 || y == 12) continue;
        const int a = 13 * x + y;
        f.push_back({a, a + 13, a + 14});
        f.push_back({a, a + 14, a + 1});
      }
    REQUIRE(analyse_shape<float>(v, f, u).ok());
    check_sound(u, v);
    CHECK(std::abs(u.plane.normal.z()) < 0.1f);
    CHECK(count(u, BodyRole::foot, 1) == 1);
    CHECK(count(u, BodyRole::foot, -1) == 1);
  }
  SUBCASE("crumbs and vertices without faces are not pointed at") {
    BlockBody<float> body = build_blocks<float>(block_human);
    const auto whole = static_cast<std::int32_t>(body.vertices.size());
    for (int n = 0; n < 40; ++n) {
      const auto at = static_cast<std::int32_t>(body.vertices.size());
      const V p(float(n - 20), 50, 20);
      body.vertices.insert(body.vertices.end(), {p, p + V(0.2f, 0, 0), p + V(0, 0.2f, 0), V(100, 100, float(n))});
      body.faces.push_back({at, at + 1, at + 2});
    }
    REQUIRE(analyse_shape<float>(body.vertices, body.faces, u).ok());
    check_sound(u, body.vertices);
    for (const BodyPoint<float>& p : u.points)
      if (p.role == BodyRole::tip || p.role == BodyRole::hand) CHECK(p.vertex < whole);
  }
  SUBCASE("what cannot be used is named, and the last answer stays") {
    u.points.resize(3);
    const std::vector<V> v = {{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}};
    CHECK(analyse_shape<float>(v, std::vector<Face>{}, u).error == Error::no_faces);
    CHECK(analyse_shape<float>(v, std::vector<Face>{{0, 1, 3}}, u).error == Error::index_out_of_range);
    const Status status = analyse_shape<float>(v, std::vector<Face>{{0, 1, 2}}, u);
    CHECK(status.error == Error::not_finite);
    CHECK(status.where == 2);
    CHECK(u.points.size() == 3);
  }
}

TEST_CASE("a body that says nothing of its posture stands as most files do") {
  std::vector<Vec3<double>> v;
  std::vector<Face> f;
  const int n = 24;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      const double t = 3.14159265358979 * i / n, p = 3.14159265358979 * j / n;
      v.push_back({std::sin(t) * std::cos(p), std::cos(t), std::sin(t) * std::sin(p)});
      if (i == n) continue;
      const int a = 2 * n * i + j, b = 2 * n * i + (j + 1) % (2 * n);
      f.push_back({a, b, b + 2 * n});
      f.push_back({a, b + 2 * n, a + 2 * n});
    }
  ShapeAnalysis<double> u;
  REQUIRE(analyse_shape<double>(v, f, u).ok());
  CHECK(u.posture.up.y() == 1);
  CHECK(u.posture.front.z() == 1);
  CHECK(std::abs(u.plane.normal.x()) > 0.99);
  CHECK(count(u, BodyRole::head, 0) == 1);
  CHECK(count(u, BodyRole::foot, 1) == 1);
}

TEST_CASE("arms are left and right, though of unequal height") {
  // seen from the side this one is exactly symmetric, seen from the front only nearly
  const std::vector<Block> cactus = {{{-5, 0, -5}, {5, 40, 5}},
                                     {{5, 18, -1}, {12, 21, 2}},
                                     {{10, 21, -1}, {13, 31, 2}},
                                     {{-12, 14, -1}, {-5, 17, 2}},
                                     {{-13, 17, -1}, {-10, 26, 2}}};
  const BlockBody<float> body = build_blocks<float>(cactus);
  ShapeAnalysis<float> u;
  REQUIRE(analyse_shape<float>(body.vertices, body.faces, u).ok());
  check_sound(u, body.vertices);
  CHECK(u.posture.front.z() == 1);
  CHECK(count(u, BodyRole::hand, 1) == 1);
  CHECK(count(u, BodyRole::hand, -1) == 1);
  CHECK(count(u, BodyRole::head, 0) == 1);
}

TEST_CASE("hands that are shells of their own are found, and two hooves side by side are two") {
  std::vector<Block> parts = block_human;
  BlockBody<float> body = build_blocks<float>(parts);
  // each hand in small pieces, which touch
  for (const float side : {1.f, -1.f}) {
    for (int n = 0; n < 6; ++n) {
      const BlockBody<float> piece = build_blocks<float>({{{0, 0, 0}, {1, 1, 1}}});
      const auto first = static_cast<std::int32_t>(body.vertices.size());
      for (const Vec3<float>& p : piece.vertices)
        body.vertices.push_back(Vec3<float>(side * (16.2f + 1.1f * float(n)) - 0.5f, 28, 0) + p);
      for (const Face& f : piece.faces) body.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
    }
  }
  ShapeAnalysis<float> u;
  REQUIRE(analyse_shape<float>(body.vertices, body.faces, u).ok());
  for (const BodyPoint<float>& p : u.points)
    if (p.role == BodyRole::hand) CHECK(std::abs(body.vertices[static_cast<std::size_t>(p.vertex)].x()) > 20);

  std::vector<Block> dog = block_dog;
  for (Block& block : dog)
    if (block.low[1] == 0)  // legs
      for (std::array<int, 3>* corner : {&block.low, &block.high})
        (*corner)[0] = (*corner)[0] > 0 ? (*corner)[0] - 1 : (*corner)[0] + 1;
  const BlockBody<float> narrow = build_blocks<float>(dog);
  REQUIRE(analyse_shape<float>(narrow.vertices, narrow.faces, u).ok());
  for (const std::int32_t side : {1, -1}) {
    CHECK(count(u, BodyRole::foreleg, side) == 1);
    CHECK(count(u, BodyRole::foot, side) == 1);
  }
}

TEST_CASE("what files of a kind say is believed, unless the shape says more") {
  // A human that lies on its back: glTF would have stood it up.
  const BlockBody<float> human = build_blocks<float>(block_human);
  std::vector<Vec3<float>> lying;
  for (const Vec3<float>& p : human.vertices) lying.push_back({p.x(), -p.z(), p.y()});
  ShapeAnalysis<float> u;
  REQUIRE(analyse_shape<float>(lying, human.faces, u, nullptr, FileAxes::unknown).ok());
  CHECK(u.posture.up.z() == 1);
  CHECK(u.sure > 0.4f);
  REQUIRE(analyse_shape<float>(lying, human.faces, u, nullptr, FileAxes::z_up).ok());
  CHECK(u.posture.up.z() == 1);
  REQUIRE(analyse_shape<float>(lying, human.faces, u, nullptr, FileAxes::y_up_by_rule).ok());
  CHECK(u.posture.up.y() == 1);

  // A ball could be anything.
  const BlockBody<float> block = build_blocks<float>({{{0, 0, 0}, {10, 10, 10}}});
  REQUIRE(analyse_shape<float>(block.vertices, block.faces, u, nullptr, FileAxes::unknown).ok());
  CHECK(u.sure < 0.5f);
  REQUIRE(analyse_shape<float>(block.vertices, block.faces, u, nullptr, FileAxes::z_up).ok());
  CHECK(u.posture.up.z() == 1);
}

TEST_CASE("places that are named stand for all of their role, and a named head is no higher thing") {
  const BlockBody<float> dog = build_blocks<float>(block_dog);
  using L = Landmark<float>;
  // A centaur, as its joints say: it stands on its hind legs and waves the others. Its head is where its chest seems.
  const std::vector<L> said = {{{3, 1, 11}, BodyRole::hand, 1},  {{-3, 1, 11}, BodyRole::hand, -1},
                               {{3, 1, -11}, BodyRole::foot, 1}, {{-3, 1, -11}, BodyRole::foot, -1},
                               {{0, 17, 12}, BodyRole::head, 0}, {{0, 26, 17}, BodyRole::tip, 0},
                               {{0, 14, -9}, BodyRole::hips, 0}};
  ShapeAnalysis<float> u;
  REQUIRE(analyse_shape<float>(dog.vertices, dog.faces, u, nullptr, FileAxes::y_up_by_rule, said).ok());
  check_sound(u, dog.vertices);
  CHECK(count(u, BodyRole::foreleg, 1) + count(u, BodyRole::foreleg, -1) == 0);
  for (const std::int32_t side : {1, -1}) {
    CHECK(count(u, BodyRole::hand, side) == 1);
    CHECK(count(u, BodyRole::foot, side) == 1);
  }
  for (const BodyPoint<float>& p : u.points) {
    const Vec3<float>& place = dog.vertices[static_cast<std::size_t>(p.vertex)];
    if (p.role == BodyRole::hand) CHECK((place - Vec3<float>(3.f * float(p.side), 1, 11)).norm() < 4);
    if (p.role == BodyRole::foot) CHECK((place - Vec3<float>(3.f * float(p.side), 1, -11)).norm() < 4);
    if (p.role == BodyRole::head) CHECK(place.y() < 23);
    if (p.role == BodyRole::hips) CHECK((place - Vec3<float>(0, 14, -9)).norm() < 6);
  }
  // Legs without arms: nothing else is taken for hands.
  const BlockBody<float> human = build_blocks<float>(block_human);
  const std::vector<L> legs = {{{2.5f, 1, 2}, BodyRole::foot, 1}, {{-2.5f, 1, 2}, BodyRole::foot, -1}};
  REQUIRE(analyse_shape<float>(human.vertices, human.faces, u, nullptr, FileAxes::y_up_by_rule, legs).ok());
  CHECK(count(u, BodyRole::hand, 1) == 0);
}

TEST_CASE("left and right are across the posture that is known, whatever else a body is symmetric in") {
  // wider than it is deep, and nearly the same in front and behind
  std::vector<Block> blocks = {{{-8, 0, -3}, {-4, 20, 3}}, {{4, 0, -3}, {8, 20, 3}}, {{-8, 20, -3}, {8, 30, 3}}};
  blocks.push_back({{5, 30, -2}, {14, 34, 2}});
  const BlockBody<float> body = build_blocks<float>(blocks);
  const Posture<float> posture;
  ShapeAnalysis<float> u;
  REQUIRE(analyse_shape<float>(body.vertices, body.faces, u, &posture).ok());
  CHECK(std::abs(u.plane.normal.x()) > 0.9f);
}

TEST_CASE("a ground and what lies far away are no body") {
  BlockBody<float> body = build_blocks<float>(block_human);
  const auto box = [&](const Vec3<float>& low, const Vec3<float>& high) {
    const auto first = static_cast<std::int32_t>(body.vertices.size());
    for (int k = 0; k < 8; ++k)
      body.vertices.push_back(
          {(k & 1) != 0 ? high.x() : low.x(), (k & 2) != 0 ? high.y() : low.y(), (k & 4) != 0 ? high.z() : low.z()});
    for (const Face& f : {Face{0, 2, 1}, Face{1, 2, 3}, Face{4, 5, 6}, Face{5, 7, 6}, Face{0, 1, 4}, Face{1, 5, 4},
                          Face{2, 6, 3}, Face{3, 6, 7}, Face{0, 4, 2}, Face{2, 4, 6}, Face{1, 3, 5}, Face{3, 7, 5}})
      body.faces.push_back({first + f[0], first + f[1], first + f[2]});
  };
  box({-90, -0.5f, -90}, {90, 0, 90});
  box({700, 60, -500}, {700.5f, 60.5f, -499.5f});
  box({-300, 160, 500}, {-299.5f, 160.5f, 500.5f});
  ShapeAnalysis<float> u;
  REQUIRE(analyse_shape<float>(body.vertices, body.faces, u, nullptr, FileAxes::y_up).ok());
  CHECK(u.posture.up.y() == 1);
  CHECK(u.posture.front.z() == 1);
  for (const std::int32_t side : {1, -1}) {
    CHECK(count(u, BodyRole::foot, side) == 1);
    CHECK(count(u, BodyRole::hand, side) == 1);
  }
}

TEST_CASE("two legs stand, though the file be upside down; glTF knows what is up") {
  const BlockBody<float> human = build_blocks<float>(block_human);
  std::vector<Vec3<float>> turned;
  for (const Vec3<float>& p : human.vertices) turned.push_back({-p.x(), -p.y(), p.z()});
  ShapeAnalysis<float> u;
  REQUIRE(analyse_shape<float>(turned, human.faces, u, nullptr, FileAxes::y_up).ok());
  CHECK(u.posture.up.y() == -1);
  REQUIRE(analyse_shape<float>(turned, human.faces, u, nullptr, FileAxes::y_up_by_rule).ok());
  CHECK(u.posture.up.y() == 1);
}

TEST_CASE("a tail held high is no head, and legs in full stride are four") {
  std::vector<Block> cat = block_dog;
  cat.back() = {{-1, 18, -16}, {1, 40, -13}};  // the tail
  cat[5] = {{-2, 14, 13}, {2, 18, 17}};        // neck and head, low
  cat[6] = {{-3, 12, 14}, {3, 19, 22}};
  for (const float sign : {1.f, -1.f}) {
    const BlockBody<float> body = build_blocks<float>(cat);
    std::vector<Vec3<float>> turned;
    for (const Vec3<float>& p : body.vertices) turned.push_back({sign * p.x(), p.y(), sign * p.z()});
    ShapeAnalysis<float> u;
    REQUIRE(analyse_shape<float>(turned, body.faces, u, nullptr, FileAxes::y_up).ok());
    CHECK(u.posture.front.z() == sign);
  }

  std::vector<Block> strides = block_dog;
  strides[0] = {{-5, 0, 15}, {-3, 14, 17}};
  strides[1] = {{3, 2, 5}, {5, 14, 7}};
  strides[2] = {{-5, 2, -8}, {-3, 14, -6}};
  strides[3] = {{3, 0, -18}, {5, 14, -16}};
  strides[4] = {{-5, 14, -18}, {5, 21, 17}};
  const BlockBody<float> body = build_blocks<float>(strides);
  ShapeAnalysis<float> u;
  REQUIRE(analyse_shape<float>(body.vertices, body.faces, u, nullptr, FileAxes::y_up_by_rule).ok());
  check_sound(u, body.vertices);
  for (const std::int32_t side : {1, -1}) {
    CHECK(count(u, BodyRole::foreleg, side) == 1);
    CHECK(count(u, BodyRole::foot, side) == 1);
  }
}

TEST_CASE("a fish swims with its thick end first, though its tail fin is its highest part") {
  const BlockBody<float> fish = build_blocks<float>({{{-6, 4, 4}, {6, 12, 24}},
                                                     {{-1, 12, 6}, {1, 18, 12}},
                                                     {{-2, 5, -6}, {2, 11, 4}},
                                                     {{-1, 5, -16}, {1, 9, -6}},
                                                     {{-1, 4, -20}, {1, 18, -14}}});
  for (const float sign : {1.f, -1.f}) {
    std::vector<Vec3<float>> turned;
    for (const Vec3<float>& p : fish.vertices) turned.push_back({sign * p.x(), p.y(), sign * p.z()});
    ShapeAnalysis<float> u;
    REQUIRE(analyse_shape<float>(turned, fish.faces, u, nullptr, FileAxes::y_up).ok());
    CHECK(u.posture.front.z() == sign);
  }
}

TEST_CASE("a limb is as long as it is from its tip to the trunk") {
  const BlockBody<double> body = build_blocks<double>(block_human);
  ShapeAnalysis<double> u;
  REQUIRE(analyse_shape<double>(body.vertices, body.faces, u).ok());
  std::vector<std::int32_t> hands;
  for (const BodyPoint<double>& p : u.points)
    if (p.role == BodyRole::hand) hands.push_back(p.vertex);
  REQUIRE(hands.size() == 2);
  const auto graph = detail::surface_graph<double>(body.vertices, body.faces);
  for (const std::int32_t hand : hands) {
    const detail::Limb<double> limb = detail::find_limb(graph, graph.node_of[to_size(hand)], 0.7 * 40);
    CHECK(std::abs(limb.base.x()) > 1);
    CHECK(std::abs(limb.base.x()) < 8);
    CHECK(limb.length > 8);
    CHECK(limb.length < 17);
    CHECK(std::abs(limb.middle.x()) > 6);
    CHECK(std::abs(limb.middle.x()) < 14);
  }
}
