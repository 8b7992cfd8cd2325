#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "retarget/walker.h"
#include "rigless/retarget/detail/starter_examples.h"
#include "rigless/retarget/retarget.h"

namespace detail = rigless::detail;
using rigless::Vec3;

namespace {

using namespace rigless::test::walker;

constexpr std::int32_t few_joints = 4;  // root, head, left foot, right foot

// Of the walker no more than the few.
std::vector<Vec3<double>> few_walking(std::int32_t frames) {
  const std::vector<Vec3<double>> whole = walking(frames);
  std::vector<Vec3<double>> clip;
  for (std::int32_t f = 0; f < frames; ++f)
    for (const std::int32_t j : {root, head, left_foot, right_foot})
      clip.push_back(whole[rigless::to_size(f * joint_count + j)]);
  return clip;
}

const std::vector<std::int32_t> few_pairs = {1, 2, 3, -1};

template <class S>
rigless::ExampleStorage<S> started_by_offsets(const std::vector<Vec3<S>>& clip, const detail::StarterModel<S>& model,
                                              rigless::ExampleStorage<S> examples = {},
                                              const std::vector<std::int32_t>& joints = few_pairs) {
  const auto users = static_cast<std::int32_t>(examples.controls.size() / joints.size());
  REQUIRE(detail::add_starters<S>(clip, few_joints, joints, {}, model, users, {}, examples).ok());
  return examples;
}

}  // namespace

TEST_CASE("starter offsets: the model walks before the user has shown anything") {
  const auto clip = few_walking(120);
  const auto examples = started_by_offsets<double>(clip, {rest, 0, 1.7});
  REQUIRE(examples.controls.size() == 6 * 4);
  REQUIRE(examples.joints.size() == 6 * few_joints);
  std::vector<Vec3<double>> tracks;
  REQUIRE(rigless::retarget<double>({clip, few_joints, few_pairs, examples.view(), {}}, {}, tracks).ok());
  double left = 0, right = 0, least = 9, most = -9;
  for (std::size_t f = 0; f < 120; ++f) {
    const double expected = clip[f * few_joints + 2].z();
    left = std::max(left, std::abs(tracks[f * 4 + 1].z() - expected));
    right = std::max(right, std::abs(tracks[f * 4 + 2].z() + expected));
    least = std::min(least, tracks[f * 4 + 3].y());
    most = std::max(most, tracks[f * 4 + 3].y());
  }
  CHECK(left < 0.06);
  CHECK(right < 0.06);
  // The trunk has no joint: it leans a little.
  CHECK(most - least > 1e-3);
  CHECK(most - least < 0.15);
}

TEST_CASE_TEMPLATE("starter offsets: they follow the size of the model", S, double, float) {
  std::vector<Vec3<S>> clip, small, large;
  for (const auto& p : few_walking(60)) clip.push_back(p.cast<S>());
  for (const auto& p : rest) small.push_back((p / 1.7).cast<S>());
  for (const auto& p : rest) large.push_back((p / 0.17).cast<S>());
  const auto one = started_by_offsets<S>(clip, {small, 0, 1}), ten = started_by_offsets<S>(clip, {large, 0, 10});
  REQUIRE(one.controls.size() == ten.controls.size());
  for (std::size_t i = 0; i < one.controls.size(); ++i)
    CHECK((S(10) * one.controls[i] - ten.controls[i]).norm() < S(1e-4));
}

TEST_CASE("starter offsets: short legs take short steps, and near neighbours smaller ones") {
  const auto clip = few_walking(120);
  std::vector<std::uint8_t> stands;
  for (std::size_t f = 0; f < 120; ++f)
    for (const int on : {0, f % 20 < 12 ? 1 : 0, f % 20 < 12 ? 0 : 1, 0})
      stands.push_back(static_cast<std::uint8_t>(on));
  const auto swing = [&](double belly, double apart) {
    std::vector<Vec3<double>> body = rest;
    body[1].x() = apart / 2;
    body[2].x() = -apart / 2;
    body[3].y() = belly;
    const auto examples = started_by_offsets<double>(clip, {body, 0, 1.7, stands});
    double most = 0;
    for (std::size_t i = 1; i < examples.controls.size(); i += 4)
      most = std::max(most, std::abs(examples.controls[i].z() - body[1].z()));
    return most;
  };
  CHECK(swing(0.45, 0.6) == doctest::Approx(0.5 * swing(0.9, 0.6)).epsilon(0.05));
  CHECK(swing(0.9, 0.1) < 0.7 * swing(0.9, 0.2));
}

TEST_CASE("starter offsets: soles that stand are level, none is lower") {
  const auto clip = few_walking(120);
  const std::vector<std::uint8_t> stands = [] {
    std::vector<std::uint8_t> labels;
    for (int f = 0; f < 120; ++f)
      for (const int on : {0, 1, f % 9 < 5 ? 1 : 0, 0}) labels.push_back(static_cast<std::uint8_t>(on));
    return labels;
  }();
  std::vector<Vec3<double>> uneven = rest;
  uneven[1].y() = 0.1;  // a control higher above its sole
  const auto examples = started_by_offsets<double>(clip, {uneven, 0, 1.7, stands});
  const auto keys =
      detail::suggest_key_poses<double>(clip, few_joints, detail::paired_joints(few_pairs, few_joints), 6);
  for (std::size_t n = 0; n < keys.size(); ++n) {
    const double left = examples.controls[n * 4 + 1].y() - 0.1, right = examples.controls[n * 4 + 2].y();
    if (keys[n].frame % 9 < 5) CHECK(left == doctest::Approx(right));
    CHECK(right >= left - 1e-12);
  }
}

TEST_CASE("starter offsets: they learn from the user's examples, and yield to them") {
  const auto clip = few_walking(120);
  const detail::StarterModel<double> model = {rest, 0, 1.7};
  const auto starters = started_by_offsets<double>(clip, model);

  // The user shows the pose of the second starter, and in it the head a metre higher.
  rigless::ExampleStorage<double> mine;
  mine.joints.assign(starters.joints.begin() + few_joints, starters.joints.begin() + 2 * few_joints);
  mine.controls.assign(starters.controls.begin() + 4, starters.controls.begin() + 8);
  mine.controls[0].y() += 1;
  const auto one = started_by_offsets<double>(clip, model, mine);
  CHECK(one.controls.size() / 4 <= 5);
  CHECK(one.controls.size() / 4 >= 3);
  CHECK(one.controls[0] == mine.controls[0]);
  const auto paired = detail::paired_joints(few_pairs, few_joints);
  const auto spreads = detail::joint_spreads<double>(clip, few_joints);
  for (std::size_t n = 1; n < one.joints.size() / few_joints; ++n) {
    CHECK(detail::pose_distance_squared<double>(&one.joints[0], &one.joints[n * few_joints], paired, spreads) >= 0.49);
    const double learned = one.controls[n * 4].y() - rest[0].y();
    CHECK(learned > 0.01);
    CHECK(learned < 0.9);
  }

  // The more examples, the fewer starters; four are enough.
  std::size_t left = 6;
  for (std::ptrdiff_t n = 1; n <= 4; ++n) {
    rigless::ExampleStorage<double> some;
    some.joints.assign(starters.joints.begin(), starters.joints.begin() + n * few_joints);
    some.controls.assign(starters.controls.begin(), starters.controls.begin() + n * 4);
    const std::size_t now =
        started_by_offsets<double>(clip, model, some).controls.size() / 4 - static_cast<std::size_t>(n);
    CHECK(now <= left);
    left = now;
  }
  CHECK(left == 0);
}

TEST_CASE("starter offsets: one frame gives one, bad data none") {
  const auto clip = few_walking(1);
  auto examples = started_by_offsets<double>(clip, {rest, 0, 1.7});
  REQUIRE(examples.controls.size() == 4);
  for (std::size_t c = 0; c < 4; ++c) CHECK((examples.controls[c] - rest[c]).norm() < 1e-12);
  CHECK(detail::add_starters<double>({}, few_joints, few_pairs, {}, {rest, 0, 1.7}, 0, {}, examples).error ==
        rigless::Error::no_frames);
  const std::vector<std::int32_t> wrong = {1, 2, 9, -1};
  const auto status = detail::add_starters<double>(clip, few_joints, wrong, {}, {rest, 0, 1.7}, 1, {}, examples);
  CHECK(status.error == rigless::Error::index_out_of_range);
  CHECK(status.where == 2);
  CHECK(examples.controls.size() == 4);
}
