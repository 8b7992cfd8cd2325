#include "rigless/retarget/detail/starter_examples.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "retarget/walker.h"
#include "rigless/retarget/retarget.h"

namespace detail = rigless::detail;
using rigless::to_size;
using rigless::Vec3;

namespace {

using namespace rigless::test::walker;

const std::vector<std::int32_t> pairs = {head, left_foot, right_foot, -1};

template <class S>
rigless::ExampleStorage<S> started(const std::vector<Vec3<S>>& clip, detail::StarterModel<S> model,
                                   rigless::ExampleStorage<S> examples = {},
                                   const std::vector<std::int32_t>& joints = pairs) {
  const auto users = static_cast<std::int32_t>(examples.controls.size() / joints.size());
  const detail::StarterFigure<S> figure(clip, skeleton, roles());
  const std::vector<rigless::ModelLimb<S>> unknown(joints.size());  // a limb without a length is not known
  if (model.limbs.empty()) model.limbs = unknown;
  REQUIRE(detail::add_starters<S>(clip, joint_count, joints, figure, model, users, {}, examples).ok());
  return examples;
}

// Where one control is while the human stands still in a pose.
Vec3<double> placed(const std::vector<Vec3<double>>& pose, const detail::StarterModel<double>& model,
                    std::int32_t joint) {
  return started<double>(pose, model, {}, {joint}).controls[0];
}

}  // namespace

TEST_CASE("starter examples: the model walks before the user has shown anything") {
  const auto clip = walking(120);
  const auto examples = started<double>(clip, {rest, 0, 1.7});
  REQUIRE(examples.controls.size() == 12 * 4);
  REQUIRE(examples.joints.size() == 12 * joint_count);
  std::vector<Vec3<double>> tracks;
  REQUIRE(rigless::retarget<double>({clip, joint_count, pairs, examples.view(), {}}, {}, tracks).ok());
  double left = 0, right = 0, least = 9, most = -9;
  for (std::size_t f = 0; f < 120; ++f) {
    const double expected = 0.8 / 0.9 * clip[f * joint_count + left_foot].z();  // of legs 0.8 m long
    left = std::max(left, std::abs(tracks[f * 4 + 1].z() - expected));
    right = std::max(right, std::abs(tracks[f * 4 + 2].z() + expected));
    least = std::min(least, tracks[f * 4 + 3].y());
    most = std::max(most, tracks[f * 4 + 3].y());
  }
  CHECK(left < 0.06);
  CHECK(right < 0.06);
  CHECK(most - least < 0.15);  // the trunk has no joint, and this human leans nowhere
}

TEST_CASE_TEMPLATE("starter examples: they follow the size of the model", S, double, float) {
  std::vector<Vec3<S>> clip, small, large;
  for (const auto& p : walking(60)) clip.push_back(p.cast<S>());
  for (const auto& p : rest) small.push_back((p / 1.7).cast<S>());
  for (const auto& p : rest) large.push_back((p / 0.17).cast<S>());
  const auto one = started<S>(clip, {small, 0, 1}), ten = started<S>(clip, {large, 0, 10});
  REQUIRE(one.controls.size() == ten.controls.size());
  for (std::size_t i = 0; i < one.controls.size(); ++i)
    CHECK((S(10) * one.controls[i] - ten.controls[i]).norm() < S(1e-4));
}

TEST_CASE("starter examples: short legs take short steps") {
  const auto clip = walking(120);
  const auto swing = [&](double belly) {
    std::vector<Vec3<double>> body = rest;
    body[3].y() = belly;
    const auto examples = started<double>(clip, {body, 0, 1.7});
    double most = 0;
    for (std::size_t i = 1; i < examples.controls.size(); i += 4)
      most = std::max(most, std::abs(examples.controls[i].z() - body[1].z()));
    return most;
  };
  CHECK(swing(0.45) == doctest::Approx(0.5 * swing(0.9)).epsilon(0.05));
}

TEST_CASE("starter examples: a limb points where the human's does, whatever pose the model rests in") {
  const Vec3<double> base(0.3, 1.2, 0);
  const rigless::ModelLimb<double> limb = {base, 0.6};
  std::vector<Vec3<double>> raised = standing(), forward = standing();
  raised[elbow] = {0.2, 0.75, 0};
  raised[hand] = {0.2, 1.05, 0};
  forward[elbow] = {0.2, 0.45, 0.3};
  forward[hand] = {0.2, 0.45, 0.5};  // not quite stretched
  for (const Vec3<double>& resting : {Vec3<double>(0.9, 1.2, 0), Vec3<double>(0.4, 0.7, 0.2)}) {
    const std::vector<Vec3<double>> arm = {resting};
    const detail::StarterModel<double> model = {arm, 0, 1.7, {}, {&limb, 1}};
    CHECK((placed(standing(), model, hand) - base - Vec3<double>(0, -0.6, 0)).norm() < 1e-9);
    CHECK((placed(raised, model, hand) - base - Vec3<double>(0, 0.6, 0)).norm() < 1e-9);
    CHECK((placed(forward, model, hand) - base - Vec3<double>(0, 0, 0.6)).norm() < 0.01);
    CHECK((placed(forward, model, elbow) - base - Vec3<double>(0, 0, 0.6)).norm() < 0.01);
  }
}

TEST_CASE("starter examples: a stump swings half way from how it rests") {
  const Vec3<double> base(0.3, 1.2, 0);
  const rigless::ModelLimb<double> stump = {base, 0.2, 0.5};
  const std::vector<Vec3<double>> arm = {Vec3<double>(0.5, 1.2, 0)};
  const Vec3<double> hanging = placed(standing(), {arm, 0, 1.7, {}, {&stump, 1}}, hand) - base;
  CHECK((hanging - 0.2 * Vec3<double>(1, -1, 0).normalized()).norm() < 1e-9);
}

TEST_CASE(
    "starter examples: where the shape does not say, an arm begins where a human's would, and its elbow is on it") {
  std::vector<Vec3<double>> raised = standing();
  raised[elbow] = {0.2, 0.75, 0};
  raised[hand] = {0.2, 1.05, 0};
  const std::vector<Vec3<double>> t_pose = {{0.8, 1.3, 0}, {0.5, 1.3, 0}, {0, 1.7, 0}, {0, 0.8, 0}};
  const std::vector<std::int32_t> joints = {hand, elbow, head, root};
  const auto up = started<double>(raised, {t_pose, 0, 1.7}, {}, joints).controls;
  const auto down = started<double>(standing(), {t_pose, 0, 1.7}, {}, joints).controls;
  CHECK(up[0].y() > 1.7);
  CHECK(down[0].y() < 0.9);
  CHECK(std::abs(up[0].x() - 0.8) > 0.4);
  CHECK(up[1].y() < up[0].y());
  CHECK(((up[0] - down[0]) / 2 - (up[1] - down[1])).norm() < 1e-9);
}

TEST_CASE("starter examples: the trunk leans about the hips, also where the human leans all the time") {
  std::vector<Vec3<double>> bent = standing();
  const Eigen::AngleAxisd lean(0.6, Vec3<double>::UnitX());
  for (const std::int32_t j : {neck, head, shoulder, elbow, hand}) bent[to_size(j)] = lean * bent[to_size(j)];
  const std::vector<Vec3<double>> body = {{0, 0.8, 0}, {0, 1.3, 0}, {0, 1.7, 0}};
  const std::vector<std::int32_t> joints = {root, -1, head};
  const auto places = started<double>(bent, {body, 0, 1.7}, {}, joints).controls;
  CHECK((places[0] - body[0]).norm() < 1e-9);
  for (const std::size_t c : {1u, 2u}) {
    const Vec3<double> from_hips = places[c] - body[0];
    CHECK(std::atan2(from_hips.z(), from_hips.y()) == doctest::Approx(0.9 * 0.6).epsilon(0.1));
    CHECK(from_hips.norm() == doctest::Approx((body[c] - body[0]).norm()).epsilon(0.05));
  }
}

TEST_CASE("starter examples: soles that stand are level, none is lower") {
  const auto clip = walking(120);
  const std::vector<std::uint8_t> stands = [] {
    std::vector<std::uint8_t> labels;
    for (int f = 0; f < 120; ++f)
      for (const int on : {0, 1, f % 9 < 5 ? 1 : 0, 0}) labels.push_back(static_cast<std::uint8_t>(on));
    return labels;
  }();
  std::vector<Vec3<double>> uneven = rest;
  uneven[1].y() = 0.1;  // a control higher above its sole
  const auto examples = started<double>(clip, {uneven, 0, 1.7, stands});
  const auto keys = detail::suggest_key_poses<double>(clip, joint_count, detail::paired_joints(pairs, joint_count), 12);
  for (std::size_t n = 0; n < keys.size(); ++n) {
    const double left = examples.controls[n * 4 + 1].y() - 0.1, right = examples.controls[n * 4 + 2].y();
    if (keys[n].frame % 9 < 5) CHECK(left == doctest::Approx(right));
    CHECK(right >= left - 1e-12);
  }
}

TEST_CASE("starter examples: they learn from the user's examples, and yield to them") {
  const auto clip = walking(120);
  const detail::StarterModel<double> model = {rest, 0, 1.7};
  const auto starters = started<double>(clip, model);

  // The user shows the pose of the second starter, and in it the head a metre higher.
  rigless::ExampleStorage<double> mine;
  mine.joints.assign(starters.joints.begin() + joint_count, starters.joints.begin() + 2 * joint_count);
  mine.controls.assign(starters.controls.begin() + 4, starters.controls.begin() + 8);
  mine.controls[0].y() += 1;
  const auto one = started<double>(clip, model, mine);
  CHECK(one.controls.size() / 4 <= 10);
  CHECK(one.controls.size() / 4 >= 3);
  CHECK(one.controls[0] == mine.controls[0]);
  const auto paired = detail::paired_joints(pairs, joint_count);
  const auto spreads = detail::joint_spreads<double>(clip, joint_count);
  for (std::size_t n = 1; n < one.joints.size() / joint_count; ++n) {
    CHECK(detail::pose_distance_squared<double>(&one.joints[0], &one.joints[n * joint_count], paired, spreads) >= 0.49);
    const double learned = one.controls[n * 4].y() - rest[0].y();
    CHECK(learned > 0.01);
    CHECK(learned < 0.9);
  }

  // The more examples, the fewer starters; four are enough.
  std::size_t left = 12;
  for (std::ptrdiff_t n = 1; n <= 4; ++n) {
    rigless::ExampleStorage<double> some;
    some.joints.assign(starters.joints.begin(), starters.joints.begin() + n * joint_count);
    some.controls.assign(starters.controls.begin(), starters.controls.begin() + n * 4);
    const std::size_t now = started<double>(clip, model, some).controls.size() / 4 - static_cast<std::size_t>(n);
    CHECK(now <= left);
    left = now;
  }
  CHECK(left == 0);
}

TEST_CASE("starter examples: one frame gives one, bad data none") {
  const auto clip = walking(1);
  auto examples = started<double>(clip, {rest, 0, 1.7});
  REQUIRE(examples.controls.size() == 4);
  for (std::size_t c = 0; c < 4; ++c)  // but for the foot that this frame lifts
    CHECK((examples.controls[c] - rest[c]).norm() < (c == 1 ? 0.06 : 1e-12));
  CHECK(detail::add_starters<double>({}, joint_count, pairs, {}, {rest, 0, 1.7}, 0, {}, examples).error ==
        rigless::Error::no_frames);
  const std::vector<std::int32_t> wrong = {1, 2, joint_count, -1};
  const auto status = detail::add_starters<double>(clip, joint_count, wrong, {}, {rest, 0, 1.7}, 1, {}, examples);
  CHECK(status.error == rigless::Error::index_out_of_range);
  CHECK(status.where == 2);
  CHECK(examples.controls.size() == 4);
}

TEST_CASE("starter examples: a foreleg steps with the foot across until the hand is raised, then the body rears") {
  const std::vector<std::int32_t> joints = {hand, left_foot, right_foot, -1};
  const std::vector<Vec3<double>> dog = {{0.2, 0, 0.8}, {0.2, 0, -0.5}, {-0.2, 0, -0.5}, {0, 1, 0.8}};
  const std::vector<rigless::ModelLimb<double>> limbs = {{{0.2, 0.8, 0.8}, 0.8, 1}, {}, {}, {}};
  const detail::StarterModel<double> model = {dog, 0, 1.2, {}, limbs};
  const auto place = [&](const std::vector<Vec3<double>>& pose) {
    return started<double>(pose, model, {}, joints).controls;
  };
  std::vector<Vec3<double>> step = standing();
  step[right_foot] += Vec3<double>(0, 0.1, 0.3);
  const auto still = place(standing()), stepping = place(step);
  CHECK((still[0] - dog[0]).norm() < 1e-6);
  CHECK((stepping[0] - dog[0] - (stepping[2] - dog[2])).norm() < 1e-6);
  CHECK(stepping[0].z() > dog[0].z() + 0.1);

  std::vector<Vec3<double>> up = standing();
  up[elbow] = up[shoulder] + Vec3<double>(0, 0.3, 0);
  up[hand] = up[elbow] + Vec3<double>(0, 0.3, 0);
  const auto raised = place(up);
  CHECK(raised[0].y() > 0.5);
  CHECK(raised[0].z() > dog[0].z() + 0.3);
  CHECK(raised[3].y() > dog[3].y() + 0.1);
  CHECK((raised[1] - dog[1]).norm() < 1e-6);
}
