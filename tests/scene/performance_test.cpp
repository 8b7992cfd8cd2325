#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "rigless/retarget/detail/mirror_examples.h"
#include "rigless/scene/performance_builder.h"

using namespace rigless;
using namespace rigless::detail;

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

TEST_CASE("in the air the body goes where the human goes, not on with its last step") {
  // Hops on the spot, and hops forwards: .9 s on the ground, in which the body sways forwards, then .4 s in the air.
  for (const double speed : {0.0, 1.0}) {
    CAPTURE(speed);
    Clip<double> clip = walk(480, 0);
    for (std::int32_t f = 0; f < clip.frames; ++f) {
      const double cycle = std::fmod(f / 120.0, 1.3), air = cycle - 0.9;
      const double height = air > 0 ? 0.5 * 9.81 * air * (0.4 - air) : 0;
      const double sway = air > 0 ? 0 : 0.08 * std::sin(2 * pi * cycle / 0.9 - pi / 2) + 0.08;
      const double way = speed * (std::floor(f / 120.0 / 1.3) * 0.4 + std::max(air, 0.0));
      for (std::int32_t j = 0; j < clip.joints(); ++j) {
        Vec3d& p = clip.positions[static_cast<std::size_t>(f * clip.joints() + j)];
        const Vec3d stance = clip.positions[static_cast<std::size_t>(j)];
        const bool leg = j > 0 && j < 9;
        p = {stance.x(), stance.y() + height, (leg ? 0 : stance.z() + sway) + way};
      }
    }
    Stick stick;
    REQUIRE(stage(clip, stick.motion).ok());
    REQUIRE(stick.motion.flights.size() == 3);
    Performance<double> performance;
    REQUIRE(build_performance(stick.input(), performance).ok());
    for (const Flight& flight : performance.flights) {
      const double went = performance.travel[static_cast<std::size_t>(flight.landing)][1] -
                          performance.travel[static_cast<std::size_t>(flight.take_off)][1];
      CHECK(std::abs(went - 0.4 * speed) < 0.12);
    }
    CHECK(std::abs(performance.travel.back()[1] - 3 * 0.4 * speed) < 0.3);
  }
}

TEST_CASE("a mirrored motion gives the mirrored performance") {
  Stick stick;
  stick.pairs = {4, 8, 9, -1, 11};  // toes, head, belly, one hand that has no partner on the model
  stick.rest = {{0.11, 0.05, 0}, {-0.1, 0.02, 0.01}, {0, 1.6, 0}, {0, 1, 0}, {0.3, 1, 0}};
  const std::vector<std::int32_t> partners = {1, 0, 2, 3, -1};
  REQUIRE(stage(walk(240, 0.3), stick.motion).ok());
  StagedMotion<double> twin = stick.motion;
  const auto joints = mirror_joints(twin.clip.skeleton, twin.roles);
  const auto mirror_all = [&](const std::vector<Vec3d>& from, std::vector<Vec3d>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const std::size_t j = i % joints.size();
      const Vec3d& p = from[i - j + static_cast<std::size_t>(joints[j])];
      to[i] = {-p.x(), p.y(), p.z()};
    }
  };
  mirror_all(stick.motion.local, twin.local);
  mirror_all(stick.motion.clip.positions, twin.clip.positions);
  for (double& yaw : twin.yaw) yaw = -yaw;
  std::swap(twin.left, twin.right);
  for (const std::int32_t f : {5, 17, 40, 51}) {
    const auto first = stick.motion.local.begin() + f * static_cast<std::ptrdiff_t>(joints.size());
    stick.joints.insert(stick.joints.end(), first, first + static_cast<std::ptrdiff_t>(joints.size()));
    for (std::size_t c = 0; c < 5; ++c)
      stick.controls.push_back(stick.rest[c] + 0.2 * Vec3d(std::sin(f + 3.0 * static_cast<double>(c)),
                                                           std::cos(2.0 * f), std::sin(1.0 * f)));
  }
  for (const bool locked : {false, true}) {
    stick.settings.ground_contact = locked;
    PerformanceInput<double> input = stick.input();
    input.mirror = partners;
    Performance<double> here, there;
    REQUIRE(build_performance(input, here).ok());
    input.motion = &twin;
    REQUIRE(build_performance(input, there).ok());
    // Resting feet are not quite each other's images, so what is locked to the ground is theirs alone.
    const double tolerance = locked ? 0.1 : 1e-9;
    double worst = 0;
    for (std::size_t i = 0; i < here.controls.size(); ++i) {
      const std::size_t c = i % 5;
      if (partners[c] < 0) continue;
      const auto other = static_cast<std::size_t>(partners[c]);
      const Vec3d moved = reflected<double>(here.controls[i - c + other] - stick.rest[other], Vec3d::UnitX());
      worst = std::max(worst, (there.controls[i] - stick.rest[c] - moved).norm());
    }
    CHECK(worst < tolerance);
    CHECK(here.have == 8);
    CHECK(here.starters == 0);
  }
}

TEST_CASE("the user's contacts, flights and places count, and what is missed is said") {
  Stick stick;
  REQUIRE(stage(walk(480, 0), stick.motion).ok());
  Performance<double> plain, edited;
  REQUIRE(build_performance(stick.input(), plain).ok());
  const auto stands = [](const Performance<double>& p, std::int32_t f, std::size_t c) {
    return p.contacts[static_cast<std::size_t>(f) * 4 + c] != 0;
  };
  CHECK(plain.source_contacts == plain.contacts);

  PerformanceInput<double> input = stick.input();
  const std::vector<ContactEdit> contacts = {{0, {0, 0}}, {2, {-5, 30}}, {2, {100, 900}}};
  const std::vector<Flight> list = {{60, 80}, {70, 75}, {-9, 3}};
  const Span<const Flight> flights = list;
  input.contacts = contacts;
  input.flights = &flights;
  REQUIRE(build_performance(input, edited).ok());
  CHECK(edited.source_contacts == plain.contacts);
  REQUIRE(edited.flights.size() == 2);
  CHECK((edited.flights[0].take_off == 0 && edited.flights[1].landing == 80));
  for (std::int32_t f = 0; f < edited.frames; ++f) {
    CHECK_FALSE(stands(edited, f, 0));
    CHECK(stands(edited, f, 2) == (f < 30 || f >= 100));
    const bool flies = (f > 0 && f < 3) || (f > 60 && f < 80);
    CHECK(stands(edited, f, 1) == (stands(plain, f, 1) && !flies));
  }
  CHECK(edited.slip_after.maximum < 1e-9);

  // A place for a foot that stands moves where it stands; a free foot goes there; a hand that may not move does not.
  std::int32_t standing = 40, swinging = 40;
  while (!stands(plain, standing, 1) || !stands(plain, standing + 3, 1)) ++standing;
  while (stands(plain, swinging, 0)) ++swinging;
  input = stick.input();
  const auto near = [&](std::int32_t f, std::size_t c) {
    return (plain.controls[static_cast<std::size_t>(f) * 4 + c] + Vec3d(0.03, 0, 0.04)).eval();
  };
  input.constraints.push_back(
      rigless::position_constraint<double>(1, standing, near(standing, 1), {true, false, true}));
  input.constraints.push_back(rigless::position_constraint<double>(0, swinging, near(swinging, 0)));
  input.constraints.push_back(rigless::velocity_constraint<double>(2, 50, Vec3d::Zero()));
  REQUIRE(build_performance(input, edited).ok());
  REQUIRE(edited.missed.size() == 3);
  for (const double missed : edited.missed) CHECK(missed < 1e-6);
  for (const std::int32_t opponent : edited.opponents) CHECK(opponent == -1);
  CHECK(edited.slip_after.maximum < 1e-9);
}

TEST_CASE("a performance of any length, with everything asked of it") {
  const std::vector<std::int32_t> partners = {1, 0, 2, 3};
  for (const std::int32_t frames : {1, 2, 3, 10000}) {
    CAPTURE(frames);
    Stick stick;
    REQUIRE(stage(walk(4 * frames - 3, 0.1), stick.motion).ok());
    REQUIRE(stick.motion.clip.frames == frames);
    PerformanceInput<double> input = stick.input();
    input.mirror = partners;
    const Vec3d high(0, 1.8, 0.1);
    for (const std::int32_t f : {0, frames - 1}) {
      input.constraints.push_back(rigless::position_constraint<double>(2, f, high));
      if (f > 0) input.constraints.push_back(rigless::velocity_constraint<double>(3, f, Vec3d::Zero()));
    }
    const std::vector<ContactEdit> contacts = {{0, {0, 1}}, {1, {frames - 1, frames}}};
    input.contacts = contacts;
    Performance<double> performance;
    REQUIRE(build_performance(input, performance).ok());
    CHECK(performance.controls.size() == 4 * static_cast<std::size_t>(frames));
    CHECK(performance.coverage.size() == static_cast<std::size_t>(frames));
    double largest = 0;
    for (const Vec3d& p : performance.controls) largest = p.allFinite() ? std::max(largest, p.norm()) : 1e9;
    CHECK(largest < 5);
    for (const double missed : performance.missed) CHECK(missed < 1e-6);
    for (const auto& at : performance.travel) CHECK((std::isfinite(at[0]) && std::isfinite(at[1])));
  }
}

TEST_CASE("a control turns as far as the performance follows the example that turns it") {
  Stick stick;
  REQUIRE(stage(walk(361, 0), stick.motion).ok());
  for (const std::int32_t f : {10, 25}) {
    const auto joints = to_size(stick.motion.clip.joints());
    const auto pose = stick.motion.local.begin() + static_cast<std::ptrdiff_t>(to_size(f) * joints);
    stick.joints.insert(stick.joints.end(), pose, pose + static_cast<std::ptrdiff_t>(joints));
    stick.controls.insert(stick.controls.end(), stick.rest.begin(), stick.rest.end());
  }
  PerformanceBuilder<double> builder;
  PerformanceInput<double> input = stick.input();
  input.turns = true;
  REQUIRE(builder.begin(input).ok());
  while (builder.advance(1 << 20)) {
  }
  Performance<double> made;
  REQUIRE(builder.finish(made).ok());
  const std::vector<Vec3d> ways = {Vec3d(0, 1, 0), Vec3d::Zero()};
  builder.turn<double>(2, ways, made);
  const auto turn = [&](std::int32_t f) { return made.turns[to_size(4 * f + 2)].y(); };
  CHECK(turn(10) > 0.6);
  CHECK(turn(25) < 0.3);
  CHECK(made.turns[4 * 10 + 1].norm() == 0);
}

TEST_CASE("the rate of the file hardly matters") {
  Stick stick;
  REQUIRE(stage(walk(480, 0), stick.motion).ok());
  Performance<double> usual;
  REQUIRE(build_performance(stick.input(), usual).ok());
  for (const double fps : {15.0, 24.0, 60.0, 240.0}) {
    CAPTURE(fps);
    Clip<double> clip;
    REQUIRE(resample(walk(480, 0), fps, clip).ok());
    REQUIRE(stage(clip, stick.motion).ok());
    Performance<double> performance;
    REQUIRE(build_performance(stick.input(), performance).ok());
    CHECK(std::abs(performance.frames - usual.frames) <= 2);
    CHECK(performance.travel.back()[1] == doctest::Approx(usual.travel.back()[1]).epsilon(0.15));
    CHECK(performance.slip_after.maximum < 1e-9);
  }
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
  stick.joints = stick.controls = {};
  PerformanceInput<double> input = stick.input();
  input.mirror = {stick.pairs.data(), 3};
  CHECK(build_performance(input, performance).error == Error::size_mismatch);
  const std::vector<std::int32_t> partners = {0, 1, 2, 4};
  input.mirror = partners;
  CHECK(build_performance(input, performance).where == 3);
  const std::vector<ContactEdit> contacts = {{4, {1, 2}}};
  input = stick.input();
  input.contacts = contacts;
  CHECK(build_performance(input, performance).where == 4);
  input = stick.input();
  input.constraints.push_back(rigless::velocity_constraint<double>(0, 0, Vec3d::Zero()));
  CHECK(build_performance(input, performance).error == Error::bad_constraint);
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

TEST_CASE("a foreleg stands with the foot across, but not while the human's hand is raised") {
  Clip<double> clip = walk(240, 0);
  clip.skeleton.names.insert(clip.skeleton.names.end(), {"LeftArm", "RightArm"});
  clip.skeleton.parents.insert(clip.skeleton.parents.end(), {0, 0});
  clip.skeleton.parents[10] = 12;
  clip.skeleton.parents[11] = 13;
  std::vector<Vec3d> positions;
  for (std::int32_t f = 0; f < clip.frames; ++f) {
    const auto* pose = &clip.positions[to_size(f) * 12];
    positions.insert(positions.end(), pose, pose + 12);
    const Vec3d left = pose[0] + Vec3d(0.2, 0.5, 0), right = pose[0] + Vec3d(-0.2, 0.5, 0);
    Vec3d* hands = &positions[to_size(f) * 14 + 10];
    hands[0] = left + Vec3d(0, f < 120 ? -0.6 : 0.6, 0);
    hands[1] = right + Vec3d(0, -0.6, 0);
    positions.insert(positions.end(), {left, right});
  }
  clip.positions = positions;
  Stick stick;
  REQUIRE(stage(clip, stick.motion).ok());
  REQUIRE(stick.motion.roles.left.shoulder == 12);
  stick.pairs = {10, 11, 3, 7};  // hands, feet
  stick.rest = {{0.2, 0.02, 1}, {-0.2, 0.02, 1}, {0.2, 0, 0}, {-0.2, 0, 0}};
  const auto standing = standing_controls<double>(stick.motion, stick.pairs, stick.rest, 0.0, 1.7);
  REQUIRE(standing.control == std::vector<std::int32_t>{0, 1, 2, 3});
  int stood = 0;
  for (std::size_t f = 0; f < stick.motion.left.size(); ++f) {
    CHECK(standing.labels[4 * f] == (f < 30 ? stick.motion.right[f] : 0));
    CHECK(standing.labels[4 * f + 1] == stick.motion.left[f]);
    stood += standing.labels[4 * f];
  }
  CHECK(stood > 5);
}
