// Properties that hold for any clip, mesh and set of examples.
#include "rigless/retarget/retarget.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using rigless::Vec3;

namespace {

constexpr std::int32_t swinging_joints = 6;

// A clip of six joints that swing and bob, and examples taken from it: a scaled body, a hand that drags imprecisely.
template <class S>
struct Scene {
  std::vector<Vec3<S>> clip, example_joints, example_controls;
  std::vector<std::int32_t> pairs = {1, 2, 3, 4, -1};
  rigless::Constraints<S> constraints;
  rigless::RetargetOptions<S> options;

  rigless::RetargetInput<S> input() const {
    return {clip, swinging_joints, pairs, {example_joints, example_controls}, constraints};
  }
  std::vector<Vec3<S>> solve() const {
    std::vector<Vec3<S>> tracks;
    CHECK(rigless::retarget(input(), options, tracks).ok());
    return tracks;
  }
};

template <class S>
Vec3<S> joint_at(double t, std::size_t j) {
  const double phase = 1.7 * static_cast<double>(j), swing = 0.1 + 0.05 * static_cast<double>(j);
  return Vec3<double>(0.2 * static_cast<double>(j) + 0.3 * swing * std::cos(2 * t + phase),
                      0.9 + 0.1 * std::sin(4 * t + phase), swing * std::sin(2 * t + phase))
      .template cast<S>();
}

template <class S>
void add_example(Scene<S>& scene, double t, std::mt19937& random, double noise = 0.02) {
  std::uniform_real_distribution<double> drag(-noise, noise);
  for (std::size_t j = 0; j < swinging_joints; ++j) scene.example_joints.push_back(joint_at<S>(t, j));
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const Vec3<double> p = 0.7 * joint_at<double>(t, c + 1) + Vec3<double>(drag(random), drag(random), drag(random));
    scene.example_controls.push_back(p.template cast<S>());
  }
}

template <class S>
Scene<S> scene_of(std::int32_t frames, std::int32_t examples, double fps = 30, std::uint32_t seed = 1) {
  Scene<S> scene;
  std::mt19937 random(seed);
  for (std::int32_t f = 0; f < frames; ++f)
    for (std::size_t j = 0; j < swinging_joints; ++j) scene.clip.push_back(joint_at<S>(f / fps, j));
  for (std::int32_t n = 0; n < examples; ++n) add_example(scene, 0.37 * n, random);
  scene.options.fps = static_cast<S>(fps);
  return scene;
}

template <class S>
double worst(const std::vector<Vec3<S>>& a, const std::vector<Vec3<S>>& b) {
  REQUIRE(a.size() == b.size());
  double error = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto e = static_cast<double>((a[i] - b[i]).cwiseAbs().maxCoeff());
    error = std::isfinite(e) ? std::max(error, e) : std::numeric_limits<double>::infinity();
  }
  return error;
}

// Every control stays within a few extents of its examples.
template <class S>
void check_sane(const Scene<S>& scene, const std::vector<Vec3<S>>& tracks, double extents = 3) {
  const std::size_t controls = scene.pairs.size();
  REQUIRE(tracks.size() == scene.clip.size() / swinging_joints * controls);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t e = i % controls; e < scene.example_controls.size(); e += controls)
      nearest = std::min(nearest, static_cast<double>((tracks[i] - scene.example_controls[e]).norm()));
    if (!(nearest < extents)) FAIL_CHECK("control " << i % controls << " frame " << i / controls << ": " << nearest);
  }
}

}  // namespace

TEST_CASE_TEMPLATE("retarget: an example's own pose gives its own controls", S, double, float) {
  for (std::int32_t examples = 1; examples <= 12; ++examples) {
    auto scene = scene_of<S>(1, examples);
    CAPTURE(examples);
    for (std::int32_t n = 0; n < examples; ++n) {
      scene.clip.assign(scene.example_joints.begin() + n * swinging_joints,
                        scene.example_joints.begin() + (n + 1) * swinging_joints);
      const auto first = scene.example_controls.begin() + n * 5;
      CHECK(worst(scene.solve(), std::vector<Vec3<S>>(first, first + 5)) <= (std::is_same_v<S, double> ? 1e-6 : 1e-5));
    }
  }
}

TEST_CASE("retarget: duplicates of an example change nothing about it") {
  auto scene = scene_of<double>(1, 4);
  const auto joints = scene.example_joints;
  const auto controls = scene.example_controls;
  for (int copy = 0; copy < 2; ++copy) {
    scene.example_joints.insert(scene.example_joints.end(), joints.begin(), joints.begin() + swinging_joints);
    scene.example_controls.insert(scene.example_controls.end(), controls.begin(), controls.begin() + 5);
  }
  scene.clip.assign(joints.begin(), joints.begin() + swinging_joints);
  CHECK(worst(scene.solve(), {controls.begin(), controls.begin() + 5}) <= 1e-6);
  scene.clip.assign(joints.begin() + swinging_joints, joints.begin() + 2 * swinging_joints);
  CHECK(worst(scene.solve(), {controls.begin() + 5, controls.begin() + 10}) <= 1e-6);
}

TEST_CASE("retarget: one example is held") {
  const auto scene = scene_of<double>(40, 1);
  const auto tracks = scene.solve();
  for (std::size_t i = 0; i < tracks.size(); ++i) CHECK((tracks[i] - scene.example_controls[i % 5]).norm() < 1e-9);
}

TEST_CASE("retarget: moving and turning motion or model moves and turns the result") {
  const auto scene = scene_of<double>(60, 6);
  const auto tracks = scene.solve();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Vec3<double> shift(5, -3, 2);

  auto other_motion = scene;
  for (auto* points : {&other_motion.clip, &other_motion.example_joints})
    for (auto& p : *points) p = turn * p + shift;
  CHECK(worst(other_motion.solve(), tracks) < 1e-4);

  auto inches = scene;
  for (auto* points : {&inches.clip, &inches.example_joints})
    for (auto& p : *points) p *= 39.37;
  CHECK(worst(inches.solve(), tracks) < 1e-4);

  auto other_model = scene;
  for (auto& p : other_model.example_controls) p = 100 * (turn * p) + shift;
  auto expected = tracks;
  for (auto& p : expected) p = 100 * (turn * p) + shift;
  CHECK(worst(other_model.solve(), expected) < 1e-2);
}

TEST_CASE_TEMPLATE("retarget: any number of examples, frames and any rate", S, double, float) {
  for (std::int32_t examples = 1; examples <= 12; ++examples) {
    const auto scene = scene_of<S>(50, examples);
    check_sane(scene, scene.solve());
  }
  for (const std::int32_t frames : {1, 2, 3, 4, 5}) {
    const auto scene = scene_of<S>(frames, 5);
    check_sane(scene, scene.solve());
  }
  for (const double fps : {15.0, 24.0, 60.0, 120.0, 240.0}) {
    const auto scene = scene_of<S>(static_cast<std::int32_t>(2 * fps), 6, fps);
    check_sane(scene, scene.solve());
  }
}

TEST_CASE("retarget: the rate of the clip hardly matters") {
  const auto slow = scene_of<double>(61, 6, 30), fast = scene_of<double>(241, 6, 120);
  const auto a = slow.solve(), b = fast.solve();
  double error = 0;
  for (std::size_t f = 5; f < 56; ++f)
    for (std::size_t c = 0; c < 5; ++c) error = std::max(error, (a[f * 5 + c] - b[4 * f * 5 + c]).norm());
  CHECK(error < 0.02);
}

TEST_CASE("retarget: hostile examples give finite tracks") {
  SUBCASE("all identical") {
    auto scene = scene_of<double>(40, 5);
    for (std::size_t i = swinging_joints; i < scene.example_joints.size(); ++i)
      scene.example_joints[i] = scene.example_joints[i % swinging_joints];
    for (std::size_t i = 5; i < scene.example_controls.size(); ++i)
      scene.example_controls[i] = scene.example_controls[i % 5];
    check_sane(scene, scene.solve(), 1e-6);
  }
  SUBCASE("same pose, contradicting controls") {
    auto scene = scene_of<double>(40, 2);
    for (std::size_t i = swinging_joints; i < scene.example_joints.size(); ++i)
      scene.example_joints[i] = scene.example_joints[i % swinging_joints];
    const auto tracks = scene.solve();
    check_sane(scene, tracks);
    for (std::size_t c = 0; c < 5; ++c) {
      const Vec3<double> middle = (scene.example_controls[c] + scene.example_controls[5 + c]) / 2;
      CHECK((tracks[20 * 5 + c] - middle).norm() < 1e-3);
    }
  }
  SUBCASE("coplanar joints and controls") {
    auto scene = scene_of<double>(40, 6);
    for (auto& p : scene.example_joints) p.y() = 0.9;
    for (auto& p : scene.example_controls) p.z() = 0;
    check_sane(scene, scene.solve());
  }
  SUBCASE("nearly the same pose twice") {
    auto scene = scene_of<double>(60, 6);
    for (std::size_t j = 0; j < swinging_joints; ++j)
      scene.example_joints[swinging_joints + j] = scene.example_joints[j] + Vec3<double>(1e-5, 0, -1e-5);
    check_sane(scene, scene.solve());
  }
  SUBCASE("no control has a joint") {
    auto scene = scene_of<double>(40, 6);
    scene.pairs.assign(5, -1);
    check_sane(scene, scene.solve());
  }
}

TEST_CASE("retarget: a joint that an example does not know comes from the clip") {
  auto scene = scene_of<double>(80, 5);
  const auto whole = scene.solve();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t j : {std::size_t(3), std::size_t(5)})
    scene.example_joints[2 * swinging_joints + j] = Vec3<double>(nan, nan, nan);
  CHECK(worst(scene.solve(), whole) < 0.05);
  for (std::size_t j = 0; j < swinging_joints; ++j) scene.example_joints[2 * swinging_joints + j].setConstant(nan);
  check_sane(scene, scene.solve());
}

TEST_CASE("retarget: bad data is named, and the last run survives") {
  const auto good = scene_of<double>(10, 3);
  rigless::Retargeter<double> run;
  REQUIRE(run.begin(good.input(), good.options).ok());
  const auto refused = [&](const Scene<double>& scene, rigless::Error error, std::int32_t where) {
    const auto status = run.begin(scene.input(), scene.options);
    CHECK(status.error == error);
    CHECK(status.where == where);
  };
  auto bad = good;
  bad.clip[7 * swinging_joints + 2].x() = std::numeric_limits<double>::quiet_NaN();
  refused(bad, rigless::Error::not_finite, 7);
  bad = good;
  bad.example_controls[2 * 5 + 1].z() = std::numeric_limits<double>::infinity();
  refused(bad, rigless::Error::not_finite, 2);
  bad = good;
  bad.pairs[3] = swinging_joints;
  refused(bad, rigless::Error::index_out_of_range, 3);
  bad = good;
  bad.example_controls.clear();
  refused(bad, rigless::Error::no_examples, -1);
  bad = good;
  bad.example_joints.pop_back();
  refused(bad, rigless::Error::size_mismatch, -1);
  bad = good;
  bad.clip.clear();
  refused(bad, rigless::Error::no_frames, -1);
  bad = good;
  bad.pairs.clear();
  refused(bad, rigless::Error::no_controls, -1);
  bad = good;
  bad.constraints.push_back(rigless::position_constraint<double>(1, 3, Vec3<double>::Zero()));
  bad.constraints.push_back(rigless::velocity_constraint<double>(1, 0, Vec3<double>::Zero()));
  refused(bad, rigless::Error::bad_constraint, 1);
  bad.constraints = {};
  bad.constraints.push_back(rigless::position_constraint<double>(9, 3, Vec3<double>::Zero()));
  refused(bad, rigless::Error::bad_constraint, 0);

  while (run.advance(3)) {
  }
  std::vector<Vec3<double>> tracks;
  REQUIRE(run.finish(tracks).ok());
  CHECK(worst(tracks, good.solve()) == 0);
}

TEST_CASE("retarget: slices give the same as one go, and progress grows") {
  auto scene = scene_of<double>(30, 4);
  scene.constraints.push_back(rigless::position_constraint<double>(1, 12, Vec3<double>(0.2, 0.5, 0.1)));
  rigless::Retargeter<double> run;
  REQUIRE(run.begin(scene.input(), scene.options).ok());
  double progress = 0;
  int slices = 0;
  for (bool more = true; more; ++slices) {
    more = run.advance(7);
    CHECK(run.progress() >= progress);
    progress = run.progress();
  }
  CHECK(slices > 20);
  CHECK(progress == 1);
  std::vector<Vec3<double>> tracks;
  REQUIRE(run.finish(tracks).ok());
  CHECK(worst(tracks, scene.solve()) == 0);
}

TEST_CASE_TEMPLATE("retarget: hard constraints are met with any number of examples, and disturb no other control", S,
                   double, float) {
  for (const std::int32_t examples : {1, 2, 3, 8}) {
    CAPTURE(examples);
    auto scene = scene_of<S>(60, examples);
    const auto before = scene.solve();
    const Vec3<S> target(S(0.1), S(0.9), S(-0.2));
    scene.constraints.push_back(rigless::position_constraint<S>(1, 20, target));
    scene.constraints.push_back(rigless::velocity_constraint<S>(1, 21, Vec3<S>::Zero()));
    scene.constraints.push_back(rigless::height_constraint<S>(1, 2, 40, S(0.05)));
    const auto tracks = scene.solve();
    CHECK((tracks[20 * 5 + 1] - target).norm() < S(1e-5));
    CHECK((tracks[21 * 5 + 1] - target).norm() < S(1e-5));
    CHECK(tracks[40 * 5 + 1].y() - tracks[40 * 5 + 2].y() == doctest::Approx(0.05).epsilon(1e-3));
    for (std::size_t f = 0; f < 60; ++f)
      for (const std::size_t c : {std::size_t(0), std::size_t(3), std::size_t(4)})
        CHECK((tracks[f * 5 + c] - before[f * 5 + c]).norm() == S(0));
  }
}

TEST_CASE("retarget: repeated constraints change nothing, contradicting ones meet in the middle") {
  auto scene = scene_of<double>(60, 5);
  const auto at = [](double y) { return Vec3<double>(0.1, y, -0.2); };
  scene.constraints.push_back(rigless::position_constraint<double>(1, 20, at(0.9)));
  const auto once = scene.solve();
  scene.constraints.push_back(rigless::position_constraint<double>(1, 20, at(0.9)));
  scene.constraints.push_back(rigless::velocity_constraint<double>(1, 21, Vec3<double>::Zero()));
  scene.constraints.push_back(rigless::position_constraint<double>(1, 21, at(0.9)));
  const auto loop = scene.solve();
  CHECK((loop[20 * 5 + 1] - at(0.9)).norm() < 1e-6);
  CHECK((loop[21 * 5 + 1] - at(0.9)).norm() < 1e-6);
  CHECK(once.size() == loop.size());

  scene.constraints = {};
  scene.constraints.push_back(rigless::position_constraint<double>(1, 20, at(0.9)));
  scene.constraints.push_back(rigless::position_constraint<double>(1, 20, at(1.1)));
  rigless::Retargeter<double> run;
  REQUIRE(run.begin(scene.input(), scene.options).ok());
  while (run.advance(1000)) {
  }
  std::vector<Vec3<double>> tracks;
  REQUIRE(run.finish(tracks).ok());
  CHECK((tracks[20 * 5 + 1] - at(1.0)).norm() < 1e-5);
  CHECK(run.residual(0) == doctest::Approx(0.1).epsilon(1e-3));
  CHECK(run.residual(1) == doctest::Approx(0.1).epsilon(1e-3));
  CHECK(run.opponents()[0] == 1);
  CHECK(run.opponents()[1] == 0);

  // A loop that does not close: 20 and 21 are apart, but the control shall not move between them. Others do not mind.
  scene.constraints.insert(scene.constraints.begin(), rigless::position_constraint<double>(3, 30, at(1)));
  scene.constraints[2].at.frame = 21;
  scene.constraints.push_back(rigless::velocity_constraint<double>(1, 21, Vec3<double>::Zero()));
  REQUIRE(run.begin(scene.input(), scene.options).ok());
  while (run.advance(1000)) {
  }
  REQUIRE(run.finish(tracks).ok());
  CHECK(run.residual(0) < 1e-6);
  CHECK(run.opponents()[0] == -1);
  for (const std::size_t i : {1U, 2U, 3U}) {
    CHECK(run.residual(i) == doctest::Approx(0.2 / 3).epsilon(1e-3));
    CHECK(run.opponents()[i] >= 1);
    CHECK(run.opponents()[i] != static_cast<std::int32_t>(i));
  }

  // Without an offset track one example cannot move at all: the constraint is missed, and says so.
  auto stuck = scene_of<double>(30, 1);
  stuck.options.offset_weight = 0;
  stuck.constraints.push_back(
      rigless::position_constraint<double>(0, 3, stuck.example_controls[0] + Vec3<double>(0, 1, 0)));
  REQUIRE(run.begin(stuck.input(), stuck.options).ok());
  while (run.advance(1000)) {
  }
  REQUIRE(run.finish(tracks).ok());
  CHECK((tracks[3 * 5] - stuck.example_controls[0]).norm() < 1e-6);
  CHECK(run.residual(0) == doctest::Approx(1));
}

TEST_CASE("retarget: a constraint does not pop") {
  auto scene = scene_of<double>(90, 6);
  const auto before = scene.solve();
  scene.constraints.push_back(
      rigless::position_constraint<double>(1, 45, before[45 * 5 + 1] + Vec3<double>(0, 0.2, 0)));
  const auto peak = [](const std::vector<Vec3<double>>& t) {
    double most = 0;
    for (std::size_t f = 1; f + 1 < 90; ++f)
      most = std::max(most, (t[(f - 1) * 5 + 1] - 2 * t[f * 5 + 1] + t[(f + 1) * 5 + 1]).norm());
    return most;
  };
  const double soft = peak(scene.solve());
  scene.options.offset_weight = 0;
  CHECK(soft < 0.7 * peak(scene.solve()));
}

TEST_CASE("retarget: the whole pose tells apart what one joint cannot") {
  // The control squashes only while both joints are low; its own joint is often low alone.
  Scene<double> scene;
  scene.pairs = {1, 2};
  const auto heights = [](double t) { return Vec3<double>(std::sin(t), std::sin(1.9 * t), 0); };
  const auto squash = [&](double t) {
    const Vec3<double> h = heights(t);
    return Vec3<double>(0, h.x() + h.y(), 0);
  };
  const auto pose = [&](double t, std::vector<Vec3<double>>& out) {
    for (std::size_t j = 0; j < swinging_joints; ++j)
      out.push_back(Vec3<double>(0, j == 1 || j == 2 ? heights(t)[static_cast<Eigen::Index>(j) - 1] : 0, 0));
  };
  for (int f = 0; f < 200; ++f) pose(0.05 * f, scene.clip);
  for (int n = 0; n < 8; ++n) {
    pose(1.25 * n, scene.example_joints);
    scene.example_controls.push_back(squash(1.25 * n));
    scene.example_controls.push_back(squash(1.25 * n));
  }
  const auto error = [&] {
    const auto tracks = scene.solve();
    double sum = 0;
    for (int f = 0; f < 200; ++f) sum += (tracks[static_cast<std::size_t>(f) * 2] - squash(0.05 * f)).squaredNorm();
    return std::sqrt(sum / 200);
  };
  const double with_pose = error();
  scene.options.pose_weight = 0;
  CHECK(with_pose < 0.5 * error());
}

TEST_CASE("retarget: a constraint pops half as much as in the paper's settings, or less") {
  auto scene = scene_of<double>(90, 6);
  auto paper = scene;
  paper.options = rigless::RetargetOptions<double>::thesis();
  const auto added_peak = [](Scene<double>& s) {
    const auto before = s.solve();
    s.constraints.push_back(rigless::position_constraint<double>(1, 45, before[45 * 5 + 1] + Vec3<double>(0, 0.2, 0)));
    const auto after = s.solve();
    double most = 0;
    const auto change = [&](std::size_t f) { return (after[f * 5 + 1] - before[f * 5 + 1]).eval(); };
    for (std::size_t f = 1; f + 1 < 90; ++f)
      most = std::max(most, (change(f - 1) - 2 * change(f) + change(f + 1)).norm());
    return most;
  };
  const double ours = added_peak(scene), theirs = added_peak(paper);
  MESSAGE("peak acceleration that a constraint adds: " << ours << ", the paper's settings " << theirs);
  CHECK(ours <= 0.5 * theirs);
}

TEST_CASE("retarget: bounded weights keep a noisy hand from throwing a control away") {
  auto scene = scene_of<double>(60, 6, 30, 3);
  std::mt19937 random(5);
  scene.example_joints.clear();
  scene.example_controls.clear();
  for (int n = 0; n < 6; ++n) add_example(scene, 0.1 * n, random, 0.1);  // nearly flat tetrahedra
  scene.options = rigless::RetargetOptions<double>::thesis();
  rigless::Retargeter<double> free;
  rigless::BoundedRetargeter<double> bounded;
  bounded.solver().set_bounds(-0.5, 1.5);
  const auto largest = [&](auto& run) {
    REQUIRE(run.begin(scene.input(), scene.options).ok());
    while (run.advance(500)) {
    }
    std::vector<Vec3<double>> tracks;
    REQUIRE(run.finish(tracks).ok());
    double most = 0;
    for (std::int32_t c = 0; c < 5; ++c)
      for (const double w : run.weights(c)) most = std::max(most, std::abs(w));
    return most;
  };
  CHECK(largest(free) > 3);
  CHECK(largest(bounded) <= 1.5 + 1e-6);
}

TEST_CASE("retarget: the paper's settings follow the motion too") {
  auto scene = scene_of<double>(60, 4);
  scene.options = rigless::RetargetOptions<double>::thesis();
  rigless::Retargeter<double> run;
  REQUIRE(run.begin(scene.input(), scene.options).ok());
  while (run.advance(100)) {
  }
  std::vector<Vec3<double>> tracks;
  REQUIRE(run.finish(tracks).ok());
  double sum = 0;
  for (std::size_t f = 0; f < 60; ++f)
    for (std::size_t c = 0; c < 4; ++c)
      sum += (tracks[f * 5 + c] - 0.7 * joint_at<double>(static_cast<double>(f) / 30, c + 1)).squaredNorm();
  CHECK(std::sqrt(sum / 240) < 0.1);
}
