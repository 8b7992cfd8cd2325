// A skin for what never had one.
#include "rigless/skin/skin_builder.h"

#include <doctest/doctest.h>

#include <cstring>

#include "support/advance.h"
#include "support/cylinder.h"

using namespace rigless;
using namespace rigless::test;

namespace {

template <class S>
struct Dance {
  std::vector<Vec3<S>> rest;
  std::vector<Face> faces;
  std::vector<std::vector<Vec3<S>>> frames;
};

Mat3<double> turn(double angle, const Vec3<double>& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

// A pole of three pieces that bend in two places, a quarter of it blended at each, and travels while it turns.
template <class S>
Dance<S> pole(int frames, int rows = 33) {
  Dance<S> out;
  const Cylinder c(12, rows);
  out.faces = c.faces;
  for (const auto& v : c.vertices) out.rest.push_back(v.cast<S>());
  for (int f = 0; f < frames; ++f) {
    const Mat3<double> A = turn(0.9 * std::sin(0.5 * f), {1, 0, 0.3}),
                       B = turn(0.7 * std::sin(0.8 * f + 1), {0, 0.4, 1});
    const Mat3<double> whole = turn(0.2 * f, {0.1, 1, 0});
    const Vec3<double> low(0, 1.3, 0), high(0, 2.6, 0);
    out.frames.emplace_back();
    for (const Vec3<double>& v : c.vertices) {
      const double a = std::clamp((v.y() - 0.8) / 1, 0.0, 1.0), b = std::clamp((v.y() - 2.1) / 1, 0.0, 1.0);
      const Vec3<double> middle = A * (v - low) + low, top = A * (B * (v - high) + high - low) + low;
      const Vec3<double> p = (1 - a) * v + a * ((1 - b) * middle + b * top);
      out.frames.back().push_back((whole * p + Vec3<double>(0.3 * f, 1, 0)).cast<S>());
    }
  }
  return out;
}

template <class S>
Status build(const Dance<S>& dance, Skin<S>& out, const SkinOptions& options = {}) {
  SkinBuilder<S> builder;
  if (const Status s = builder.begin(dance.rest, dance.faces, options); !s.ok()) return s;
  if (const Status s = build_from<S>(builder, dance.frames); !s.ok()) return s;
  out = builder.skin();
  return {};
}

// As an engine plays it: what Skin promises, worked out anew.
template <class S>
Vec3<S> played(const Skin<S>& skin, const Dance<S>& dance, std::size_t f, std::size_t v) {
  Vec3<S> sum = Vec3<S>::Zero(), p = dance.rest[v];
  const std::size_t K = to_size(skin.targets);
  for (std::size_t k = 0; k < K; ++k) p += skin.mix[f * K + k] * skin.way[k * dance.rest.size() + v];
  for (std::size_t k = 0; k < 4; ++k) {
    const auto j = to_size(skin.joint[4 * v + k]);
    const auto& pose = skin.pose[f * skin.centre.size() + j];
    sum += skin.weight[4 * v + k] * (pose.turn * (p - skin.centre[j]) + pose.place);
  }
  return skin.root[f].turn * sum + skin.root[f].place;
}

// In diagonals: rms and worst.
template <class S>
std::pair<double, double> likeness(const Skin<S>& skin, const Dance<S>& dance, double diagonal) {
  double sum = 0, worst = 0;
  for (std::size_t f = 0; f < dance.frames.size(); ++f) {
    for (std::size_t v = 0; v < dance.rest.size(); ++v) {
      const double missed = static_cast<double>((played(skin, dance, f, v) - dance.frames[f][v]).squaredNorm());
      sum += missed;
      worst = std::max(worst, missed);
    }
  }
  return {std::sqrt(sum / static_cast<double>(dance.frames.size() * dance.rest.size())) / diagonal,
          std::sqrt(worst) / diagonal};
}

const double pole_diagonal = Vec3<double>(1, 4, 1).norm();

template <class S>
void check_weights(const Skin<S>& skin, std::size_t vertices) {
  REQUIRE(skin.weight.size() == 4 * vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    S sum = 0;
    for (std::size_t k = 4 * v; k < 4 * v + 4; ++k) {
      CHECK(skin.weight[k] >= 0);
      CHECK(skin.joint[k] >= 0);
      CHECK(skin.joint[k] < skin.joints());
      sum += skin.weight[k];
    }
    CHECK(sum == doctest::Approx(1).epsilon(1e-5));
  }
}

}  // namespace

TEST_CASE_TEMPLATE("a skinned animation gets few joints, which play it", S, float, double) {
  const Dance<S> dance = pole<S>(30);
  Skin<S> skin;
  REQUIRE(build(dance, skin).ok());
  CHECK(skin.joints() >= 3);
  CHECK(skin.joints() <= 8);
  check_weights(skin, dance.rest.size());
  const auto [rms, worst] = likeness(skin, dance, pole_diagonal);
  CHECK(rms <= 0.0013);
  CHECK(worst <= 0.008);
  CHECK(skin.rms == doctest::Approx(rms).epsilon(0.01));
  CHECK(skin.worst == doctest::Approx(worst).epsilon(0.01));
  CHECK(skin.normals > 0);
  CHECK(skin.normals < 0.1);
  for (std::size_t f = 1; f < dance.frames.size(); ++f) CHECK(skin.root[f].turn.dot(skin.root[f - 1].turn) > 0);
}

TEST_CASE_TEMPLATE("what joints cannot hold is held by morph targets", S, float, double) {
  Dance<S> dance = pole<S>(40);
  for (std::size_t f = 0; f < dance.frames.size(); ++f) {
    for (std::size_t v = 0; v < dance.rest.size(); ++v) {  // a wave runs up the pole
      const double much = 0.25 * std::sin(5 * static_cast<double>(dance.rest[v].y()) + 0.9 * static_cast<double>(f));
      dance.frames[f][v].y() += static_cast<S>(much * std::cos(9 * static_cast<double>(dance.rest[v].y())));
    }
  }
  Skin<S> bare, skin;
  SkinOptions options;
  options.joints = 6;
  options.targets = 0;
  REQUIRE(build(dance, bare, options).ok());
  CHECK(bare.targets == 0);
  CHECK(bare.worst > 0.008);
  options.targets = 8;
  REQUIRE(build(dance, skin, options).ok());
  CHECK(skin.targets >= 1);
  CHECK(skin.targets <= 8);
  CHECK(skin.way.size() == to_size(skin.targets) * dance.rest.size());
  CHECK(skin.mix.size() == to_size(skin.targets) * dance.frames.size());
  const auto [rms, worst] = likeness(skin, dance, pole_diagonal);
  CHECK(rms < 0.6 * bare.rms);
  CHECK(skin.rms == doctest::Approx(rms).epsilon(0.01));
  CHECK(skin.worst == doctest::Approx(worst).epsilon(0.01));
}

TEST_CASE("more joints are more alike, and never more than were asked for") {
  const Dance<double> dance = pole<double>(30);
  Skin<double> two, eight;
  REQUIRE(build(dance, two, {2, 1e-5, 1e-5}).ok());
  REQUIRE(build(dance, eight, {8, 1e-5, 1e-5}).ok());
  CHECK(two.joints() == 2);
  CHECK(eight.joints() == 8);
  CHECK(eight.rms < 0.2 * two.rms);
}

TEST_CASE("what only travels and turns needs one joint, and that stands still") {
  Dance<double> dance = pole<double>(12);
  for (std::size_t f = 0; f < dance.frames.size(); ++f) {
    const double t = static_cast<double>(f);
    for (std::size_t v = 0; v < dance.rest.size(); ++v) {
      dance.frames[f][v] = turn(0.4 * t, {1, 2, 0}) * dance.rest[v] + Vec3<double>(t, 0, 1);
    }
  }
  Skin<double> skin;
  REQUIRE(build(dance, skin).ok());
  CHECK(skin.joints() == 1);
  CHECK(skin.worst < 1e-9);
  for (const auto& pose : skin.pose) {
    CHECK(std::abs(pose.turn.w()) == doctest::Approx(1));
    CHECK((pose.place - skin.centre[0]).norm() < 1e-9);
  }
}

TEST_CASE("both sides of a seam get the same weights; what only touches at rest does not") {
  Dance<float> dance = pole<float>(20);
  const std::size_t V = dance.rest.size();
  const auto copy = [&](std::size_t v, const Vec3<float>& drift) {
    dance.rest.push_back(dance.rest[v]);
    for (auto& frame : dance.frames) frame.push_back(frame[v] + drift);
  };
  for (std::size_t v = 0; v < V; v += 3) copy(v, {0, 0, 0});
  Skin<float> skin;
  REQUIRE(build(dance, skin).ok());
  for (std::size_t v = 0, seam = V; v < V; v += 3, ++seam) {
    CHECK(std::memcmp(&skin.weight[4 * v], &skin.weight[4 * seam], 4 * sizeof(float)) == 0);
    CHECK(std::memcmp(&skin.joint[4 * v], &skin.joint[4 * seam], 4 * sizeof(std::int32_t)) == 0);
  }
  for (std::size_t v = 0; v < V; v += 3) copy(v, {0.8f, 0, 0});  // a second coat that goes another way
  REQUIRE(build(dance, skin).ok());
  CHECK(skin.worst < 0.02);
}

TEST_CASE("the same comes out each time, and motions one after the other share their joints") {
  Dance<float> dance = pole<float>(20);
  Skin<float> one, two;
  REQUIRE(build(dance, one).ok());
  REQUIRE(build(dance, two).ok());
  CHECK(one.weight == two.weight);
  CHECK(one.joint == two.joint);
  for (std::size_t k = 0; k < one.pose.size(); ++k) CHECK(one.pose[k].place == two.pose[k].place);
  const std::size_t frames = 400;  // more than are looked at
  dance = pole<float>(frames, 9);
  REQUIRE(build(dance, one).ok());
  CHECK(one.root.size() == frames);
  CHECK(one.pose.size() == frames * one.centre.size());
  CHECK(likeness(one, dance, pole_diagonal).first < 0.002);
}

TEST_CASE("a point, a frame, points at one place and numbers that are none") {
  Skin<double> skin;
  const Vec3<double> p(1, 2, 3);
  REQUIRE(build<double>({{p}, {}, {{p}, {2 * p}}}, skin).ok());
  CHECK(skin.joints() == 1);
  CHECK((played<double>(skin, {{p}, {}, {}}, 1, 0) - 2 * p).norm() < 1e-12);
  Dance<double> dance = pole<double>(1);
  REQUIRE(build(dance, skin).ok());
  CHECK(skin.worst <= 0.008);
  dance = {{p, p, p}, {{0, 1, 2}}, {{p, p + p, p}, {p, p, p}}};
  REQUIRE(build(dance, skin).ok());
  check_weights(skin, 3);
  for (const auto& pose : skin.pose) CHECK(pose.place.allFinite());

  dance = pole<double>(3);
  dance.frames[1][7].x() = std::numeric_limits<double>::quiet_NaN();
  Status status = build(dance, skin);
  CHECK(status.error == Error::not_finite);
  CHECK(status.where == 7);
  dance.frames[1].pop_back();
  CHECK(build(dance, skin).error == Error::size_mismatch);
  dance.faces.push_back({0, 1, 9999});
  status = build(dance, skin);
  CHECK(status.error == Error::index_out_of_range);
  CHECK(status.where == count_of(dance.faces) - 1);
  dance.rest.clear();
  CHECK(build(dance, skin).error == Error::empty_input);
  SkinBuilder<double> idle;
  REQUIRE(idle.begin(pole<double>(0).rest, {}).ok());
  CHECK(!idle.advance());
}
