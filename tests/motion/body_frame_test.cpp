#include "rigless/motion/detail/body_frame.h"

#include <doctest/doctest.h>

#include <cmath>

#include "rigless/motion/parse_bvh.h"
#include "sample_motions.h"
#include "support/json.h"

using namespace rigless;
using namespace rigless::detail;

TEST_CASE("yaw of a BVH motion matches the golden one, turns unwrapped" * test::needs_shared()) {
  const json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/motion.json")["bvh"];
  const std::string text = shared_motion("131_03.bvh");
  Clip<double> clip;
  REQUIRE(parse_bvh(text, clip).ok());
  const std::vector<double> yaw = body_yaw(clip);
  for (std::size_t k = 0; k < golden["frames"].size(); ++k) {
    CHECK(std::abs(yaw[static_cast<std::size_t>(golden["frames"][k].integer())] - golden["yaw"][k].number()) < 1e-6);
  }
  for (std::size_t f = 1; f < yaw.size(); ++f) CHECK(std::abs(yaw[f] - yaw[f - 1]) < 0.3);
}

TEST_CASE_TEMPLATE("turning the world about Y turns the yaw and nothing else", S, float, double) {
  Clip<S> clip;
  clip.skeleton = {{"root", "a"}, {-1, 0}};
  clip.fps = 30;
  for (int f = 0; f < 200; ++f) {
    const S t = static_cast<S>(f) / 10;
    const Eigen::Quaternion<S> swing(Eigen::AngleAxis<S>(std::sin(t), Vec3<S>(1, 0, S(0.5)).normalized()));
    clip.root_rotation.push_back(Eigen::AngleAxis<S>(t, Vec3<S>::UnitY()) * swing);
    clip.positions.emplace_back(t, 1, 0);
    clip.positions.push_back(clip.positions.back() + clip.root_rotation.back() * Vec3<S>(0, 0, 1));
    ++clip.frames;
  }
  const std::vector<S> yaw = body_yaw(clip);
  CHECK(yaw.back() == doctest::Approx(19.9).epsilon(1e-3));  // three turns, unwrapped

  Clip<S> turned = clip;
  const Eigen::AngleAxis<S> turn(S(2.5), Vec3<S>::UnitY());
  for (Vec3<S>& p : turned.positions) p = turn * p;
  for (Eigen::Quaternion<S>& q : turned.root_rotation) q = turn * q;
  const std::vector<S> turned_yaw = body_yaw(turned);
  const std::vector<Vec3<S>> a = body_local_positions<S>(clip, yaw);
  const std::vector<Vec3<S>> b = body_local_positions<S>(turned, turned_yaw);
  for (std::size_t f = 0; f < yaw.size(); ++f) CHECK(turned_yaw[f] - yaw[f] == doctest::Approx(2.5).epsilon(1e-5));
  for (std::size_t i = 0; i < a.size(); ++i) CHECK((a[i] - b[i]).norm() < S(1e-4));
  const Vec3<S> back = from_body<S>(a[7], clip.at(3, 0), yaw[3]);
  CHECK((back - clip.at(3, 1)).norm() < S(1e-5));
}

TEST_CASE("a root that is upside down keeps its last yaw") {
  Clip<double> clip;
  clip.frames = 3;
  clip.root_rotation = {Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vec3<double>::UnitY())),
                        Eigen::Quaterniond(0, 1, 0, 0), Eigen::Quaterniond(0, 0, 0, 1)};
  const std::vector<double> yaw = body_yaw(clip);
  CHECK(yaw[0] == doctest::Approx(0.5));
  CHECK(yaw[1] == yaw[0]);
  CHECK(yaw[2] == yaw[0]);
}
