#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "rigless/scene/performance_builder.h"

using namespace rigless;

namespace {

using Vec3d = Vec3<double>;

constexpr double pi = 3.14159265358979323846;

// A stick man of two legs, arms and a head who walks along +Z at 1.2 m/s, turning to his left by `turn` radians per
// second: each foot stands for .6 of a 1 s cycle. 120 fps.
Clip<double> walk(std::int32_t frames, double turn) {
  Clip<double> clip;
  clip.skeleton.names = {"Hips",     "LeftUpLeg", "LeftLeg",      "LeftFoot", "LeftToeBase", "RightUpLeg",
                         "RightLeg", "RightFoot", "RightToeBase", "Head",     "LeftHand",    "RightHand"};
  clip.skeleton.parents = {-1, 0, 1, 2, 3, 0, 5, 6, 7, 0, 0, 0};
  clip.fps = 120;
  clip.metres_per_unit = 1;
  clip.frames = frames;
  for (std::int32_t f = 0; f < frames; ++f) {
    const double t = f / 120.0, speed = 1.2, yaw = turn * t;
    // the path: along +Z for the turn that is asked for
    const double r = turn != 0 ? speed / turn : 0;
    const Vec3d hips(turn != 0 ? r * (1 - std::cos(yaw)) : 0, 0.95, turn != 0 ? r * std::sin(yaw) : speed * t);
    const auto place = [&](double x, double y, double z) {
      return from_body<double>(Vec3d(x, y, z), Vec3d(hips.x(), 0, hips.z()), yaw);
    };
    std::vector<Vec3d> p{hips};
    for (const double side : {0.1, -0.1}) {
      const double phase = std::fmod(t + (side > 0 ? 0 : 0.5), 1.0);
      const bool stands = phase < 0.6;
      const double swing = (phase - 0.6) / 0.4;
      const double z = speed * (stands ? 0.3 - phase : 0.6 * swing - 0.3);
      const double y = stands ? 0 : 0.15 * std::sin(pi * swing);
      p.push_back(place(side, 0.9, 0));
      p.push_back(place(side, 0.5, z / 2));
      p.push_back(place(side, y + 0.08, z - 0.12));
      p.push_back(place(side, y + 0.01, z));
    }
    p.push_back(place(0, 1.6, 0));
    p.push_back(place(0.3, 0.9, 0.3 * std::sin(2 * pi * t)));
    p.push_back(place(-0.3, 0.9, -0.3 * std::sin(2 * pi * t)));
    clip.positions.insert(clip.positions.end(), p.begin(), p.end());
    clip.root_rotation.emplace_back(Eigen::AngleAxisd(yaw, Vec3d::UnitY()));
  }
  return clip;
}

struct Stick {
  StagedMotion<double> motion;
  std::vector<std::int32_t> pairs{4, 8, 9, -1};  // left and right toe, head, belly
  std::vector<Vec3d> rest{{0.1, 0.05, 0}, {-0.1, 0.02, 0}, {0, 1.6, 0}, {0, 1, 0}};
  std::vector<Vec3d> joints, controls;  // of examples
  PerformanceSettings<double> settings;

  PerformanceInput<double> input() const {
    PerformanceInput<double> in;
    in.motion = &motion;
    in.pairs = pairs;
    in.rest = rest;
    in.height = 1.7;
    in.examples = {joints, controls};
    in.settings = settings;
    return in;
  }
};

Status stage(const Clip<double>& clip, StagedMotion<double>& motion) {
  return stage_motion(clip, find_joint_roles(clip), motion);
}

}  // namespace

TEST_CASE("the only frame of a clip gives the controls of the example made on it") {
  Stick stick;
  REQUIRE(stage(walk(1, 0), stick.motion).ok());
  REQUIRE(stick.motion.clip.frames == 1);
  stick.joints = stick.motion.local;
  stick.controls = {{0.2, 0.3, 0.1}, {-0.3, 0.1, 0.2}, {0.1, 1.4, 0.4}, {0, 1.2, -0.3}};
  stick.settings.ground_contact = false;
  Performance<double> performance;
  REQUIRE(build_performance(stick.input(), performance).ok());
  REQUIRE(performance.frames == 1);
  for (std::size_t c = 0; c < 4; ++c) CHECK((performance.controls[c] - stick.controls[c]).norm() < 1e-6);
}

TEST_CASE("standing feet keep their place in the world while the body walks and turns") {
  for (const double turn : {0.0, 0.8}) {
    Stick stick;
    REQUIRE(stage(walk(480, turn), stick.motion).ok());
    Performance<double> performance;
    REQUIRE(build_performance(stick.input(), performance).ok());
    CHECK(performance.slip_before.mean > 1e-3);
    CHECK(performance.slip_after.maximum < 1e-9);

    std::vector<Vec3d> world;
    for (std::size_t i = 0; i < performance.controls.size(); ++i) {
      const auto& at = performance.travel[i / 4];
      world.push_back(from_body<double>(performance.controls[i], Vec3d(at[0], 0, at[1]), performance.yaw[i / 4]));
    }
    const Slip<double> slip = measure_slip<double>(world, performance.contacts, 4, 30.0);
    CHECK(slip.maximum < 1e-9);
    std::int32_t left = 0, others = 0;
    for (std::size_t i = 0; i < performance.contacts.size(); ++i) {
      (i % 4 < 2 ? left : others) += performance.contacts[i];
    }
    CHECK(left > performance.frames / 2);
    CHECK(others == 0);
    // 1.2 m/s for 4 s, on the arc that turns with it
    const double expected = turn == 0 ? 4.8 : 2 * 1.2 / turn * std::sin(turn * 2);
    const auto& end = performance.travel.back();
    CHECK(std::hypot(end[0], end[1]) == doctest::Approx(expected).epsilon(0.2));
  }
}

TEST_CASE("both soles are level where both feet stand") {
  Stick stick;
  REQUIRE(stage(walk(480, 0), stick.motion).ok());
  Performance<double> performance;
  REQUIRE(build_performance(stick.input(), performance).ok());
  std::int32_t both = 0;
  for (std::size_t i = 0; i < performance.controls.size(); i += 4) {
    if (performance.contacts[i] == 0 || performance.contacts[i + 1] == 0) continue;
    ++both;
    CHECK(performance.controls[i].y() - 0.05 == doctest::Approx(performance.controls[i + 1].y() - 0.02).epsilon(1e-9));
  }
  CHECK(both > 10);
}

TEST_CASE("in place nothing travels, and all else stays") {
  Stick stick;
  REQUIRE(stage(walk(240, 0), stick.motion).ok());
  Performance<double> moving, still;
  REQUIRE(build_performance(stick.input(), moving).ok());
  stick.settings.in_place = true;
  REQUIRE(build_performance(stick.input(), still).ok());
  CHECK(still.controls == moving.controls);
  for (const auto& at : still.travel) CHECK((at[0] == 0 && at[1] == 0));
}

TEST_CASE("without ground contact the tracks are those of the examples") {
  Stick stick;
  REQUIRE(stage(walk(240, 0), stick.motion).ok());
  Performance<double> locked, loose;
  REQUIRE(build_performance(stick.input(), locked).ok());
  stick.settings.ground_contact = false;
  REQUIRE(build_performance(stick.input(), loose).ok());
  CHECK(loose.slip_after.mean == loose.slip_before.mean);
  CHECK(loose.slip_after.mean == doctest::Approx(locked.slip_before.mean));
  for (std::size_t i = 0; i < loose.controls.size(); i += 4) CHECK(loose.controls[i + 2] == locked.controls[i + 2]);
}

TEST_CASE("a body without feet stands on its lowest controls when either foot does") {
  Stick stick;
  REQUIRE(stage(walk(240, 0), stick.motion).ok());
  stick.pairs = {10, 11, 9, -1};  // hands, head
  const auto standing = standing_controls<double>(stick.motion, stick.pairs, stick.rest, 0.0, 1.7);
  CHECK(standing.control == std::vector<std::int32_t>{0, 1});
  CHECK(standing.ground[0] == doctest::Approx(0.05));
  for (std::size_t f = 0; f < stick.motion.left.size(); ++f) {
    CHECK(standing.labels[2 * f] == (stick.motion.left[f] | stick.motion.right[f]));
  }
}

TEST_CASE("what cannot be built leaves the old performance") {
  Stick stick;
  REQUIRE(stage(walk(120, 0), stick.motion).ok());
  Performance<double> performance;
  REQUIRE(build_performance(stick.input(), performance).ok());
  const auto before = performance.controls;

  stick.pairs[2] = 12;
  Status status = build_performance(stick.input(), performance);
  CHECK(status.error == Error::index_out_of_range);
  CHECK(status.where == 2);
  stick.pairs[2] = 9;
  stick.joints = {stick.motion.local.begin(), stick.motion.local.begin() + 12};
  stick.controls = stick.rest;
  stick.controls[1].x() = std::numeric_limits<double>::quiet_NaN();
  status = build_performance(stick.input(), performance);
  CHECK(status.error == Error::not_finite);
  CHECK(status.where == 0);
  stick.pairs.clear();
  CHECK(build_performance(stick.input(), performance).error == Error::no_controls);
  CHECK(performance.controls == before);
}

TEST_CASE("a staged motion stands on the floor and begins over the origin") {
  Clip<double> clip = walk(240, 0.5);
  for (Vec3d& p : clip.positions) p += Vec3d(3, -7, 11);
  StagedMotion<double> motion;
  REQUIRE(stage(clip, motion).ok());
  CHECK(motion.clip.frames == 60);
  double lowest = 1;
  for (const Vec3d& p : motion.clip.positions) lowest = std::min(lowest, p.y());
  CHECK(lowest == doctest::Approx(0));
  CHECK(std::hypot(motion.clip.at(0, 0).x(), motion.clip.at(0, 0).z()) < 1e-12);
  CHECK(motion.local[0].norm() < 1e-12);

  clip.positions[12 * 7 + 3].y() = std::numeric_limits<double>::infinity();
  const Status status = stage(clip, motion);
  CHECK(status.error == Error::not_finite);
  CHECK(status.where == 7);
  CHECK(motion.clip.frames == 60);
}
