#include "rigless/retarget/starter_examples.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "rigless/retarget/retarget.h"

using rigless::Vec3;

namespace {

constexpr std::int32_t joint_count = 4;  // root, head, left foot, right foot

std::vector<Vec3<double>> walk(std::int32_t frames) {
  std::vector<Vec3<double>> clip;
  for (std::int32_t f = 0; f < frames; ++f) {
    const double phase = 0.2 * f, swing = 0.3 * std::sin(phase);
    clip.push_back({0, 0, 0});
    clip.push_back({0, 0.8, 0.02 * std::sin(2 * phase)});
    clip.push_back({0.1, -0.9 + 0.05 * std::max(0.0, std::cos(phase)), swing});
    clip.push_back({-0.1, -0.9 + 0.05 * std::max(0.0, -std::cos(phase)), -swing});
  }
  return clip;
}

const std::vector<std::int32_t> pairs = {1, 2, 3, -1};
const std::vector<Vec3<double>> rest = {{0, 1.7, 0.4}, {0.3, 0, 0}, {-0.3, 0, 0}, {0, 0.8, -0.6}};

}  // namespace

TEST_CASE("starter examples: the model walks before the user has shown anything") {
  const auto clip = walk(120);
  rigless::ExampleStorage<double> examples;
  REQUIRE(rigless::add_starters<double>(clip, joint_count, pairs, rest, 1.7, {}, examples).ok());
  REQUIRE(examples.controls.size() == 6 * 4);
  REQUIRE(examples.joints.size() == 6 * joint_count);
  std::vector<Vec3<double>> tracks;
  REQUIRE(rigless::retarget<double>({clip, joint_count, pairs, examples.view(), {}}, {}, tracks).ok());
  double left = 0, right = 0, still = 0;
  for (std::size_t f = 0; f < 120; ++f) {
    const double expected = clip[f * joint_count + 2].z();
    left = std::max(left, std::abs(tracks[f * 4 + 1].z() - expected));
    right = std::max(right, std::abs(tracks[f * 4 + 2].z() + expected));
    still = std::max(still, (tracks[f * 4 + 3] - rest[3]).norm());
  }
  CHECK(left < 0.06);
  CHECK(right < 0.06);
  CHECK(still < 1e-9);
}

TEST_CASE_TEMPLATE("starter examples: they follow the size of the model", S, double, float) {
  std::vector<Vec3<S>> clip, small;
  for (const auto& p : walk(60)) clip.push_back(p.cast<S>());
  for (const auto& p : rest) small.push_back(p.cast<S>());
  rigless::ExampleStorage<S> one, ten;
  REQUIRE(rigless::add_starters<S>(clip, joint_count, pairs, small, S(1), {}, one).ok());
  REQUIRE(rigless::add_starters<S>(clip, joint_count, pairs, small, S(10), {}, ten).ok());
  REQUIRE(one.controls.size() == ten.controls.size());
  for (std::size_t i = 0; i < one.controls.size(); ++i)
    CHECK((S(10) * (one.controls[i] - small[i % 4]) - (ten.controls[i] - small[i % 4])).norm() < S(1e-4));
}

TEST_CASE("starter examples: they yield to the user's examples") {
  const auto clip = walk(120);
  rigless::ExampleStorage<double> starters;
  REQUIRE(rigless::add_starters<double>(clip, joint_count, pairs, rest, 1.7, {}, starters).ok());

  // The user shows the pose of the second starter.
  rigless::ExampleStorage<double> mine;
  mine.joints.assign(starters.joints.begin() + joint_count, starters.joints.begin() + 2 * joint_count);
  mine.controls.assign(4, Vec3<double>(7, 7, 7));
  REQUIRE(rigless::add_starters<double>(clip, joint_count, pairs, rest, 1.7, {}, mine).ok());
  CHECK(mine.controls.size() / 4 <= 6);
  CHECK(mine.controls.size() / 4 >= 3);
  CHECK(mine.controls[0] == Vec3<double>(7, 7, 7));
  const auto paired = rigless::paired_joints(pairs, joint_count);
  const auto spreads = rigless::joint_spreads<double>(clip, joint_count);
  for (std::size_t n = 1; n < mine.joints.size() / joint_count; ++n)
    CHECK(rigless::pose_distance_squared<double>(&mine.joints[0], &mine.joints[n * joint_count], paired, spreads) >=
          0.49);

  // Four are enough.
  rigless::ExampleStorage<double> four;
  four.joints.assign(starters.joints.begin(), starters.joints.begin() + 4 * joint_count);
  four.controls.assign(16, Vec3<double>::Zero());
  REQUIRE(rigless::add_starters<double>(clip, joint_count, pairs, rest, 1.7, {}, four).ok());
  CHECK(four.controls.size() == 16);
}

TEST_CASE("starter examples: one frame gives one, bad data none") {
  const auto clip = walk(1);
  rigless::ExampleStorage<double> examples;
  REQUIRE(rigless::add_starters<double>(clip, joint_count, pairs, rest, 1.7, {}, examples).ok());
  REQUIRE(examples.controls.size() == 4);
  for (std::size_t c = 0; c < 4; ++c) CHECK((examples.controls[c] - rest[c]).norm() < 1e-12);
  CHECK(rigless::add_starters<double>({}, joint_count, pairs, rest, 1.7, {}, examples).error ==
        rigless::Error::no_frames);
  const std::vector<std::int32_t> wrong = {1, 2, 9, -1};
  const auto status = rigless::add_starters<double>(clip, joint_count, wrong, rest, 1.7, {}, examples);
  CHECK(status.error == rigless::Error::index_out_of_range);
  CHECK(status.where == 2);
  CHECK(examples.controls.size() == 4);
}
