#include "rigless/motion/standardise.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "rigless/motion/parse_acclaim.h"
#include "rigless/motion/parse_bvh.h"
#include "sample_motions.h"

using namespace rigless;
using namespace rigless::detail;

namespace {

// A person of 1.72 m who stands, feet apart, left at +X, facing +Z and turned by `yaw`; lengths times `scale`.
template <class S>
Clip<S> person(double scale, double yaw = 0) {
  struct Joint {
    const char* name;
    std::int32_t parent;
    Vec3<double> at;
  };
  const Joint joints[] = {
      {"Hips", -1, {0, .95, 0}},     {"LeftUpLeg", 0, {.1, .9, 0}},      {"LeftLeg", 1, {.1, .5, 0}},
      {"LeftFoot", 2, {.1, .08, 0}}, {"LeftToeBase", 3, {.1, .02, .15}}, {"RightUpLeg", 0, {-.1, .9, 0}},
      {"RightLeg", 5, {-.1, .5, 0}}, {"RightFoot", 6, {-.1, .08, 0}},    {"RightToeBase", 7, {-.1, .02, .15}},
      {"Neck", 0, {0, 1.45, 0}},     {"Head", 9, {0, 1.55, 0}},          {"Head_end", 10, {0, 1.72, 0}}};
  Clip<S> clip;
  const Eigen::AngleAxisd turn(yaw, Vec3<double>::UnitY());
  for (const Joint& joint : joints) {
    clip.skeleton.names.push_back(joint.name);
    clip.skeleton.parents.push_back(joint.parent);
    clip.positions.push_back((turn * joint.at * scale).template cast<S>());
  }
  clip.root_rotation.push_back(Eigen::Quaterniond(turn).cast<S>());
  clip.frames = 1;
  clip.fps = 30;
  clip.metres_per_unit = 1;
  return clip;
}

std::vector<Vec3<double>> rest_of(const Clip<double>& clip) { return clip.positions; }

// Mean body-local position of every joint.
template <class S>
std::vector<Vec3<S>> mean_body_pose(const Clip<S>& clip) {
  const std::vector<S> yaw = body_yaw(clip);
  const std::vector<Vec3<S>> local = body_local_positions(clip, Span<const S>(yaw));
  std::vector<Vec3<S>> mean(clip.skeleton.names.size(), Vec3<S>::Zero());
  for (std::size_t i = 0; i < local.size(); ++i) mean[i % mean.size()] += local[i] / static_cast<S>(clip.frames);
  return mean;
}

}  // namespace

TEST_CASE_TEMPLATE("units by standing height", S, float, double) {
  const std::pair<double, LengthUnit> units[] = {{1, LengthUnit::metre},           {100, LengthUnit::centimetre},
                                                 {1000, LengthUnit::millimetre},   {1 / 0.0254, LengthUnit::inch},
                                                 {0.45 / 0.0254, LengthUnit::cmu}, {1 / 0.3048, LengthUnit::foot}};
  for (const auto& [scale, expected] : units) {
    for (const double tall : {0.8, 1.0, 1.15}) {
      Clip<S> clip = person<S>(scale * tall);
      const UnitGuess<S> guess = guess_unit(clip, find_joint_roles(clip.skeleton));
      CHECK(guess.unit == expected);
      CHECK(guess.metres_per_unit == doctest::Approx(1 / scale));
      scale_clip(clip, guess.metres_per_unit);
      CHECK(clip.metres_per_unit == doctest::Approx(1 / scale));
      CHECK(clip.at(0, 11).y() == doctest::Approx(1.72 * tall));
    }
  }
}

TEST_CASE("a body that no unit makes human is made 1.7 m tall") {
  for (const double scale : {1e-6, 1e6, 9.0}) {
    Clip<double> clip = person<double>(scale);
    const UnitGuess<double> guess = guess_unit(clip, find_joint_roles(clip.skeleton));
    CHECK(guess.unit == LengthUnit::none);
    scale_clip(clip, guess.metres_per_unit);
    CHECK(standing_height(clip, find_joint_roles(clip.skeleton)) == doctest::Approx(1.7));
  }
  for (const double tall : {0.96, 1.0, 1.13}) {  // a child in inches
    const Clip<double> child = person<double>(tall / 1.72 / 0.0254);
    CHECK(guess_unit(child, find_joint_roles(child.skeleton)).unit == LengthUnit::inch);
  }
  Clip<double> point = person<double>(0);
  CHECK(guess_unit(point, find_joint_roles(point.skeleton)).metres_per_unit == 1);
  Clip<double> nameless = person<double>(100);
  for (std::string& name : nameless.skeleton.names) name = "x";
  CHECK(guess_unit(nameless, JointRoles{}).unit == LengthUnit::centimetre);
}

TEST_CASE_TEMPLATE("Z up becomes Y up, with the same yaw", S, float, double) {
  Clip<S> clip = person<S>(1, 0.7);
  const Clip<S> upright = clip;
  // The same person in a world where Z is up: Y becomes Z, Z becomes -Y; the root stands along Z at rest.
  for (Vec3<S>& p : clip.positions) p = Vec3<S>(p.x(), -p.z(), p.y());
  clip.root_rotation[0] = Eigen::AngleAxis<S>(S(0.7), Vec3<S>::UnitZ());
  const Standardised<S> done = standardise(clip, {});
  CHECK(done.up == UpAxis::z);
  CHECK_FALSE(done.root_axes_aligned);
  for (std::int32_t j = 0; j < clip.joints(); ++j) CHECK((clip.at(0, j) - upright.at(0, j)).norm() < S(1e-5));
  CHECK(body_yaw(clip)[0] == doctest::Approx(0.7).epsilon(1e-5));
}

TEST_CASE("who lies down in a Y-up file stays down") {
  Clip<double> clip = person<double>(1);
  const std::vector<Vec3<double>> rest = rest_of(clip);
  for (Vec3<double>& p : clip.positions) p = Vec3<double>(p.x(), -p.z(), p.y());
  CHECK(guess_up_axis<double>(clip, find_joint_roles(clip.skeleton), rest) == UpAxis::y);
  CHECK(guess_up_axis<double>(clip, find_joint_roles(clip.skeleton), {}) == UpAxis::z);
}

TEST_CASE("who stands on the head in the file stands on the feet") {
  for (const UpAxis up : {UpAxis::minus_y, UpAxis::minus_z}) {
    Clip<double> clip = person<double>(1, 0.7);
    const Clip<double> upright = clip;
    const auto turned = [&](const Vec3<double>& p) {
      return up == UpAxis::minus_y ? Vec3<double>(p.x(), -p.y(), -p.z()) : Vec3<double>(p.x(), p.z(), -p.y());
    };
    for (Vec3<double>& p : clip.positions) p = turned(p);
    const std::vector<Vec3<double>> rest = rest_of(clip);
    CHECK(guess_up_axis<double>(clip, find_joint_roles(clip.skeleton), rest) == up);
    turn_upright(clip, up);
    for (std::int32_t j = 0; j < clip.joints(); ++j) CHECK((clip.at(0, j) - upright.at(0, j)).norm() < 1e-9);
    // Who walks on his hands rests as others do.
    for (std::size_t j = 0; j < rest.size(); ++j) clip.positions[j] = turned(upright.positions[j]);
    CHECK(guess_up_axis<double>(clip, find_joint_roles(clip.skeleton), upright.positions) == UpAxis::y);
  }
}

TEST_CASE("where names do not tell, the axis is up along which the lowest joint stays level") {
  for (const bool z_up : {false, true}) {
    Clip<double> clip = person<double>(1);
    const std::vector<Vec3<double>> body = clip.positions;
    clip.positions.clear();
    clip.frames = 60;
    for (std::int32_t f = 0; f < clip.frames; ++f) {  // walks, which moves the lowest point of every axis but one
      for (const Vec3<double>& p : body) {
        const Vec3<double> q = p + Vec3<double>(0, 0, 0.05 * f);
        clip.positions.push_back(z_up ? Vec3<double>(q.x(), -q.z(), q.y()) : q);
      }
      clip.root_rotation.push_back(Eigen::Quaterniond::Identity());
    }
    CHECK(guess_up_axis<double>(clip, JointRoles{}, {}) == (z_up ? UpAxis::z : UpAxis::y));
  }
}

TEST_CASE("a pose in front of the take is left out, a take that begins with one is not") {
  const Clip<double> rest = person<double>(100);
  for (const double bend : {0.5, 0.02}) {
    Clip<double> clip = rest;
    for (std::int32_t f = 0; f < 20; ++f) {
      for (std::int32_t j = 0; j < clip.joints(); ++j) {
        const Vec3<double> lift(0, 0, j == 4 ? 100 * bend * (bend < 0.1 ? f : 1) : 0);
        clip.positions.push_back(rest.at(0, j) + lift);
      }
      clip.root_rotation.push_back(rest.root_rotation[0]);
      ++clip.frames;
    }
    Clip<double> rested = clip;
    CHECK(leave_out_pose_in_front<double>(rested, rest.positions) == (bend < 0.1 ? 0 : 1));
    CHECK(rested.frames == (bend < 0.1 ? 21 : 20));
    CHECK(rested.positions.size() == static_cast<std::size_t>(rested.frames * rested.joints()));
    CHECK(rested.root_rotation.size() == static_cast<std::size_t>(rested.frames));
  }
}

TEST_CASE_TEMPLATE("who begins facing away is turned to the viewer", S, float, double) {
  for (const double yaw : {3.0, -2.0, 1.7}) {
    Clip<S> clip = person<S>(1, yaw);
    clip.positions.insert(clip.positions.end(), clip.positions.begin(), clip.positions.end());
    clip.root_rotation.push_back(person<S>(1, yaw + 1).root_rotation[0]);
    clip.frames = 2;
    const bool away = std::abs(yaw) > 1.9;
    const Standardised<S> done = standardise(clip, {});
    CHECK(done.faced_away == away);
    CHECK(body_yaw(clip)[0] == doctest::Approx(away ? 0 : yaw).epsilon(1e-5));
    CHECK(body_yaw(clip)[1] == doctest::Approx(away ? 1 : yaw + 1).epsilon(1e-5));
    if (away) CHECK((clip.at(0, 4) - person<S>(1).at(0, 4)).norm() < S(1e-5));
  }
}

TEST_CASE_TEMPLATE("a root with axes of its own faces where the body faces", S, float, double) {
  for (const double yaw : {0.0, 1.0, -2.0}) {
    Clip<S> clip = person<S>(1, yaw);
    CHECK_FALSE(align_root_axes(clip, find_joint_roles(clip.skeleton)));
    // X up, Y forward, Z right; its twist about Y is undefined at yaw 0.
    Mat3<S> axes;
    axes << 0, 0, -1, 1, 0, 0, 0, 1, 0;
    REQUIRE(axes.determinant() == doctest::Approx(-1).epsilon(1e-5));
    axes.col(2) *= -1;
    clip.root_rotation[0] = clip.root_rotation[0] * Eigen::Quaternion<S>(axes);
    CHECK(align_root_axes(clip, find_joint_roles(clip.skeleton)));
    CHECK(body_yaw(clip)[0] == doctest::Approx(yaw).epsilon(1e-5));
    CHECK_FALSE(align_root_axes(clip, find_joint_roles(clip.skeleton)));
  }
}

TEST_CASE("real files come out in metres, Y up, facing where they walk" * test::needs_shared()) {
  struct Case {
    const char* name;
    LengthUnit unit;
    UpAxis up;
  };
  for (const Case& c :
       {Case{"131_03.bvh", LengthUnit::cmu, UpAxis::y}, Case{"jumping_jacks.bvh", LengthUnit::cmu, UpAxis::y},
        Case{"zombie.bvh", LengthUnit::inch, UpAxis::z}}) {
    const std::string text = shared_motion(c.name);
    Clip<double> clip;
    ParseNotes notes;
    REQUIRE(parse_bvh(text, clip, &notes).ok());
    const Standardised<double> done = standardise<double>(clip, notes.rest);
    CHECK(done.unit.unit == c.unit);
    CHECK(done.up == c.up);
    CHECK_FALSE(done.root_axes_aligned);
    for (const LimbRoles* limb : {&done.roles.left, &done.roles.right}) {
      REQUIRE(limb->ankle >= 0);
      REQUIRE(limb->toe >= 0);
    }
    const std::vector<Vec3<double>> mean = mean_body_pose(clip);
    const auto at = [&](std::int32_t j) { return mean[static_cast<std::size_t>(j)]; };
    CHECK(at(done.roles.head).y() > 0.3);
    CHECK(at(done.roles.left.ankle).y() < -0.5);
    CHECK(at(done.roles.left.hip).x() > at(done.roles.right.hip).x() + 0.05);
    CHECK(at(done.roles.left.toe).z() > at(done.roles.left.ankle).z() + 0.05);
  }
  const std::string asf = shared_motion("02.asf");
  const std::string amc = shared_motion("02_01.amc");
  Clip<double> clip;
  ParseNotes notes;
  REQUIRE(parse_acclaim(asf, amc, clip, &notes).ok());
  const Standardised<double> done = standardise<double>(clip, notes.rest);
  CHECK(done.unit.metres_per_unit == 1);
  CHECK(done.up == UpAxis::y);
  CHECK_FALSE(done.root_axes_aligned);
}
