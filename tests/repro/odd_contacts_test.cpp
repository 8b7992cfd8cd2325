// Contacts by metres a second: a walk in slow motion stood 88 % of the time, a sprint never, a step void as soon as the
// other foot stood .2 m lower; a jump was cut in two by one frame of flailing limbs, and hops of two frames were none.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "rigless/motion/contacts.h"
#include "rigless/motion/detail/units.h"
#include "rigless/motion/parse_bvh.h"
#include "rigless/motion/standardise.h"
#include "support/json.h"

using namespace rigless;

namespace {

double eased(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

// Two feet that stand and swing in turn. Seconds, metres.
struct Gait {
  double cycle, stance, stride, lift;
  double fps, seconds;
  std::vector<double> ground[2];  // height of each footfall of the left and the right foot; of the last from then on

  double phase(int foot, double t) const { return t / cycle + foot * 0.5; }
  bool stands(int foot, double t) const {
    const double p = phase(foot, t);
    return (p - std::floor(p)) * cycle < stance;
  }
  double height(int foot, int footfall) const {
    const std::vector<double>& heights = ground[foot];
    return heights.empty() ? 0 : heights[std::min(static_cast<std::size_t>(footfall), heights.size() - 1)];
  }
  Vec3<double> place(int foot, double t) const {
    const double p = phase(foot, t);
    const int n = static_cast<int>(p);
    const double swing = std::max(0.0, ((p - n) * cycle - stance) / (cycle - stance));
    const double from = height(foot, n), to = height(foot, n + 1);  // it goes up before, and down after the edge
    const double y = from + (to - from) * eased(to > from ? 1.6 * swing : 1.6 * swing - 0.6);
    return {foot == 0 ? 0.1 : -0.1, y + lift * std::sin(3.14159265 * swing), stride * (n + eased(swing) - foot * 0.5)};
  }
  // The hips are thrown while neither foot stands, from a metre above the ground.
  double bounce(double t) const {
    const double air = cycle / 2 - stance;
    const double since = std::fmod(t, cycle / 2) - stance;
    return air > 0 && since > 0 ? 9.81 / 2 * since * (air - since) : 0;
  }
};

Clip<double> walk(const Gait& gait) {
  Clip<double> clip;
  clip.skeleton = {{"Hips", "Head", "LeftAnkle", "LeftAnkle_end", "RightAnkle", "RightAnkle_end"}, {-1, 0, 0, 2, 0, 4}};
  clip.fps = gait.fps;
  clip.metres_per_unit = 1;
  clip.frames = static_cast<std::int32_t>(gait.fps * gait.seconds);
  for (std::int32_t f = 0; f < clip.frames; ++f) {
    const double t = f / gait.fps;
    const Vec3<double> left = gait.place(0, t), right = gait.place(1, t), toes(0, 0, 0.2);
    const Vec3<double> hips(0, 0.95 + (left.y() + right.y()) / 2 + gait.bounce(t), gait.stride * t / gait.cycle);
    for (const Vec3<double>& p : {hips, Vec3<double>(hips + Vec3<double>(0, 0.7, 0)), left, Vec3<double>(left + toes),
                                  right, Vec3<double>(right + toes)})
      clip.positions.push_back(p);
    clip.root_rotation.push_back(Eigen::Quaterniond::Identity());
  }
  return clip;
}

Contacts contacts_of(const Clip<double>& clip) { return find_contacts(clip, find_joint_roles(clip)); }

double share(const std::vector<FrameRun>& runs, const Clip<double>& clip) {
  std::int32_t frames = 0;
  for (const FrameRun& run : runs) frames += run.end - run.begin;
  return static_cast<double>(frames) / clip.frames;
}

// Each stance of the gait is a run, to `tolerance` frames.
void check_stances(const std::vector<FrameRun>& runs, const Gait& gait, int foot, std::int32_t tolerance) {
  std::vector<FrameRun> expected;
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(gait.fps * gait.seconds); ++f) {
    if (!gait.stands(foot, f / gait.fps)) continue;
    if (expected.empty() || expected.back().end != f) expected.push_back({f, f});
    expected.back().end = f + 1;
  }
  REQUIRE(runs.size() == expected.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    CHECK(std::abs(runs[k].begin - expected[k].begin) <= tolerance);
    CHECK(std::abs(runs[k].end - expected[k].end) <= tolerance);
  }
}

const Gait walking = {1.1, 0.66, 1.4, 0.1, 60, 4.2, {}};

}  // namespace

TEST_CASE("a walk in slow motion stands as long as the walk") {
  const Clip<double> usual = walk(walking);
  for (const double speed : {0.5, 0.25, 0.15}) {
    CAPTURE(speed);
    Gait slow = walking;
    slow.cycle /= speed, slow.stance /= speed, slow.seconds /= speed;
    const Clip<double> clip = walk(slow);
    const Contacts contacts = contacts_of(clip);
    CHECK(share(contacts.left, clip) == doctest::Approx(share(contacts_of(usual).left, usual)).epsilon(0.08));
    CHECK(contacts.left.size() == contacts_of(usual).left.size());
    CHECK(contacts.flights.empty());
  }
}

TEST_CASE("a sprint has stances of three frames, and flies between them") {
  const Gait sprint = {0.44, 0.085, 4.2, 0.25, 30, 3, {}};
  const Contacts contacts = contacts_of(walk(sprint));
  check_stances(contacts.left, sprint, 0, 1);
  check_stances(contacts.right, sprint, 1, 1);
  REQUIRE(contacts.flights.size() == 13);
  for (const Flight& flight : contacts.flights) CHECK(std::abs(flight.landing - flight.take_off - 4) <= 1);
}

TEST_CASE("a walk over blocks of .38 m stands on all of them and never flies") {
  const std::vector<std::vector<double>> blocks[] = {{{0, 0.38, 0, 0}, {0, 0, 0, 0}},
                                                     {{0.38}, {0}},
                                                     {{0, 0.38, 0, 0.38}, {0, 0, 0.38, 0}},
                                                     {{0, 0.38, 1.14, 1.14}, {0, 0, 0.76, 1.14}}};
  for (const auto& heights : blocks) {
    Gait gait = walking;
    gait.ground[0] = heights[0], gait.ground[1] = heights[1];
    const Contacts contacts = contacts_of(walk(gait));
    check_stances(contacts.left, gait, 0, 5);
    check_stances(contacts.right, gait, 1, 5);
    CHECK(contacts.flights.empty());
  }
}

TEST_CASE("children and giants stand and fly in the same frames") {
  const Gait run = {0.7, 0.28, 2.6, 0.2, 60, 3, {}};
  const Clip<double> clip = walk(run);
  const Contacts usual = contacts_of(clip);
  CHECK(usual.left.size() == 5);
  CHECK(usual.flights.size() == 8);
  for (const double size : {0.5, 0.7, 1.25, 1.8}) {
    Clip<double> other = clip;
    detail::scale_clip(other, size);
    const Contacts contacts = contacts_of(other);
    REQUIRE(contacts.left.size() == usual.left.size());
    for (std::size_t k = 0; k < usual.left.size(); ++k) {
      CHECK(contacts.left[k].begin == usual.left[k].begin);
      CHECK(contacts.left[k].end == usual.left[k].end);
    }
    CHECK(contacts.flights.size() == usual.flights.size());
  }
}

TEST_CASE("a jump with one frame of flailing is one flight") {
  // Up with 2.5 m/s for half a second, from 1 s on.
  const Gait still = {100, 100, 0, 0, 120, 2.5, {}};
  for (const int frame : {128, 140, 151, 165}) {
    for (const double flail : {0.2, -0.2}) {
      Clip<double> clip = walk(still);
      for (std::size_t i = 0; i < clip.positions.size(); ++i) {
        const int f = static_cast<int>(i / 6), joint = static_cast<int>(i % 6);
        const double t = f / 120.0 - 1;
        clip.positions[i].y() += std::max(0.0, t < 0 ? 0.0 : 2.5 * t - 9.81 / 2 * t * t);
        if (joint >= 2 && f == frame) clip.positions[i].y() += flail;
      }
      const Contacts contacts = contacts_of(clip);
      REQUIRE(contacts.flights.size() == 1);
      CHECK(std::abs(contacts.flights[0].take_off - 120) <= 5);
      CHECK(std::abs(contacts.flights[0].landing - 181) <= 5);
    }
  }
}

TEST_CASE("our own run and folk dance stand or fly in nearly every frame") {
  for (const char* file : {"folk.bvh", "run.bvh"}) {
    Clip<double> clip;
    ParseNotes notes;
    REQUIRE(
        parse_bvh(json::read_text(std::string(RIGLESS_TEST_DIR "../web/assets/motions/") + file), clip, &notes).ok());
    const Standardised<double> done = standardise<double>(clip, notes.rest);
    const Contacts contacts = find_contacts(clip, done.roles);
    CHECK(contacts.flights.size() >= 6);
    std::int32_t neither = 0;
    for (std::int32_t f = 0; f < clip.frames; ++f) {
      const auto in = [&](const auto& runs) {
        return std::any_of(runs.begin(), runs.end(),
                           [&](const FrameRun& run) { return f >= run.begin && f < run.end; });
      };
      const bool flies = std::any_of(contacts.flights.begin(), contacts.flights.end(),
                                     [&](const Flight& flight) { return f > flight.take_off && f < flight.landing; });
      neither += !in(contacts.left) && !in(contacts.right) && !flies ? 1 : 0;
    }
    CHECK(neither <= clip.frames / 20);
  }
}
