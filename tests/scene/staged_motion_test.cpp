// What of a motion is danced: cut, mirrored, and closed to a loop; and its file as the user says that it is.

#include "rigless/scene/staged_motion.h"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "rigless/scene/detail/read_motion.h"

namespace rigless::test {
namespace {

std::string motion_text(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(RIGLESS_TEST_DIR "../web/assets/motions/" + name).rdbuf();
  return text.str();
}

detail::MotionRead read(const std::string& name, const detail::MotionEdits& edits = {}) {
  detail::MotionRead motion;
  bool in_skeleton = false;
  REQUIRE(detail::read_motion(motion_text(name), "", edits, motion, in_skeleton).ok());
  return motion;
}

// The largest distance of the joints of two frames, seen from the body.
double apart(const StagedMotion<double>& a, std::int32_t f, const StagedMotion<double>& b, std::int32_t g) {
  double most = 0;
  const auto joints = static_cast<std::size_t>(a.clip.joints());
  for (std::size_t j = 0; j < joints; ++j)
    most = std::max(most, (a.local[to_size(f) * joints + j] - b.local[to_size(g) * joints + j]).norm());
  return most;
}

}  // namespace

TEST_CASE("a cut has the frames, contacts and flights of the whole motion, and begins in the middle") {
  const StagedMotion<double> whole = read("hop.bvh").staged;
  detail::MotionEdits edits;
  edits.cut = {20, 80, false};
  const StagedMotion<double> cut = read("hop.bvh", edits).staged;
  CHECK(cut.clip.frames == 61);
  CHECK(cut.take_frames == whole.clip.frames);
  for (const std::int32_t f : {0, 30, 60}) {
    CHECK(apart(cut, f, whole, f + 20) < 1e-9);
    CHECK(nth(cut.left, f) == nth(whole.left, f + 20));
    CHECK(nth(cut.right, f) == nth(whole.right, f + 20));
  }
  CHECK(cut.clip.at(0, 0).x() == 0);
  CHECK(cut.clip.at(0, 0).z() == 0);
  REQUIRE(whole.flights.size() == 3);
  REQUIRE(cut.flights.size() == 1);  // the others are cut into
  CHECK(cut.flights[0].take_off == whole.flights[1].take_off - 20);
  CHECK(cut.flights[0].landing == whole.flights[1].landing - 20);
  edits.cut = {5000, -3, false};
  CHECK(read("hop.bvh", edits).staged.clip.frames == 1);
}

TEST_CASE("a motion that is cut anywhere is closed to a loop, and goes on from where it is") {
  detail::MotionEdits edits;
  edits.cut = {20, 77, false};
  const StagedMotion<double> open = read("disco.bvh", edits).staged;
  CHECK(open.loop_period == 0);
  edits.cut.loop = true;
  const StagedMotion<double> closed = read("disco.bvh", edits).staged;
  const std::int32_t last = closed.clip.frames - 1;
  CHECK(closed.loop_period == last);
  CHECK(apart(closed, last, closed, 0) < 1e-9);
  CHECK(apart(open, last, open, 0) > 0.1);
  CHECK(apart(open, 20, closed, 20) == 0);
  CHECK(closed.clip.at(last, 0).y() == doctest::Approx(closed.clip.at(0, 0).y()));
  CHECK(closed.clip.at(last, 0).x() == doctest::Approx(open.clip.at(last, 0).x()));
  CHECK(closed.yaw.back() == open.yaw.back());
  CHECK(closed.left.back() == closed.left.front());
}

TEST_CASE("a mirrored motion swaps left and right, and mirrored twice it is itself") {
  const detail::MotionRead whole = read("kick.bvh");
  Clip<double> clip = whole.staged.clip;
  detail::mirror_clip(clip, whole.staged.roles);
  for (const std::int32_t f : {0, 30, 60}) {
    const Vec3<double>& left = whole.staged.clip.at(f, whole.staged.roles.left.ankle);
    const Vec3<double>& right = clip.at(f, whole.staged.roles.right.ankle);
    CHECK((right - Vec3<double>(-left.x(), left.y(), left.z())).norm() < 1e-12);
  }
  detail::mirror_clip(clip, whole.staged.roles);
  for (std::size_t i = 0; i < clip.positions.size(); ++i) CHECK(clip.positions[i] == whole.staged.clip.positions[i]);
}

TEST_CASE("what is said of a file stands instead of what is guessed") {
  const detail::MotionRead found = read("walk.bvh");
  detail::MotionEdits edits;
  edits.file.metres_per_unit = 0.02;
  edits.file.fps = 60;
  edits.file.up = static_cast<std::int32_t>(UpAxis::minus_y);
  const Skeleton& skeleton = found.staged.clip.skeleton;
  const auto name = [&](std::int32_t joint) { return skeleton.names[to_size(joint)]; };
  const std::string left = name(found.staged.roles.left.ankle), right = name(found.staged.roles.right.ankle);
  edits.file.joints = {"", "", "", "", right, left};
  const detail::MotionRead said = read("walk.bvh", edits);
  CHECK(said.file.unit.metres_per_unit == 0.02);
  CHECK(said.file.up == UpAxis::minus_y);
  CHECK(found.file.up == UpAxis::y);
  CHECK(said.staged.take_frames == (found.staged.take_frames + 1) / 2);
  CHECK(said.staged.source_fps == found.staged.source_fps);
  CHECK(said.file.roles.left.ankle == found.file.roles.right.ankle);
  CHECK(said.file.roles.left.hip == found.file.roles.right.hip);
  CHECK(said.file.roles.right.toe == found.file.roles.left.toe);

  edits.file = {};
  const std::string chest = name(found.staged.roles.chest);
  edits.file.joints[0] = chest;
  const detail::MotionRead upper = read("walk.bvh", edits);
  CHECK(upper.staged.clip.skeleton.names[0] == chest);
  CHECK(upper.staged.clip.joints() < found.staged.clip.joints());
}

TEST_CASE("the beginning of a motion is what it begins with") {
  const StagedMotion<double> whole = read("jump.bvh").staged;
  const std::int32_t frames = whole.clip.frames - 1;
  const StagedMotion<double> first = beginning_of(whole, frames);
  CHECK(first.clip.frames == frames);
  CHECK(first.clip.positions.size() == whole.clip.positions.size() - to_size(whole.clip.joints()));
  CHECK(first.yaw.size() == to_size(frames));
  CHECK(first.left.size() == to_size(frames));
  CHECK(apart(first, frames - 1, whole, frames - 1) == 0);
  REQUIRE(whole.flights.size() == 1);
  CHECK(first.flights.size() == 1);
  CHECK(beginning_of(whole, whole.flights[0].landing).flights.empty());
  CHECK(first.loop_period == 0);
}

}  // namespace rigless::test
