#include "rigless/retarget_mesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "motion/sample_motions.h"
#include "support/alloc_count.h"
#include "support/json.h"
#include "support/voxels.h"

using namespace rigless;
using namespace rigless::detail;

namespace {

const std::string& walk() {
  static const std::string text = json::read_text(RIGLESS_TEST_DIR "../web/assets/motions/walk.bvh");
  return text;
}

// A human of blocks, some units tall and somewhere in its file; `axes`: its left, up and front there.
template <class S>
BlockBody<S> human(const Mat3<S>& axes) {
  BlockBody<S> body = build_blocks<S>(block_human);
  for (Vec3<S>& p : body.vertices) p = axes * p * S(0.1) + Vec3<S>(3, -2, 7);
  return body;
}

// z up, facing -y.
template <class S>
Mat3<S> z_up() {
  Mat3<S> axes;
  axes << Vec3<S>::UnitX(), Vec3<S>::UnitZ(), -Vec3<S>::UnitY();
  return axes;
}

// A human of blocks that is held at six points.
template <class S>
struct SixPoints {
  Mat3<S> axes = z_up<S>();
  BlockBody<S> body = human(axes);
  std::vector<MeshPoint<S>> points;
  std::vector<MeshPose<S>> poses;

  SixPoints() {
    const auto at = [&](S x, S y, S z) -> Vec3<S> { return axes * Vec3<S>(x, y, z) * S(0.1) + Vec3<S>(3, -2, 7); };
    for (const auto& [place, joint] :
         {std::pair(at(2, 0, 3), "LeftFoot"), std::pair(at(-2, 0, 3), "rfoot"), std::pair(at(16, 28, 0), "left hand"),
          std::pair(at(-16, 28, 0), "RightHand"), std::pair(at(0, 40, 0), "Head"), std::pair(at(0, 20, 2), "")}) {
      MeshPoint<S> point;
      point.position = place;
      point.joint = joint;
      points.push_back(point);
    }
    points[4].radius = S(0.1);
    MeshPose<S> pose;
    pose.frame = 12;
    for (const MeshPoint<S>& point : points) pose.points.push_back(point.position + axes * Vec3<S>(0, S(0.3), 0));
    poses.push_back(pose);
  }

  RetargetMeshInput<S> input() const {
    RetargetMeshInput<S> in;
    in.motion = walk();
    in.vertices = body.vertices;
    in.faces = body.faces;
    in.points = points;
    in.poses = poses;
    return in;
  }

  RetargetMeshOptions<S> options() const {
    RetargetMeshOptions<S> out;
    out.axes = {Axis::plus_z, Axis::minus_y};
    out.volume = S(1.5);
    out.settings.smoothness = 0.5;
    return out;
  }
};

template <class S>
std::int32_t nearest(const std::vector<Vec3<S>>& vertices, const Vec3<S>& place) {
  const auto far = [&](const Vec3<S>& p) { return (p - place).squaredNorm(); };
  return static_cast<std::int32_t>(
      std::min_element(vertices.begin(), vertices.end(), [&](auto& a, auto& b) { return far(a) < far(b); }) -
      vertices.begin());
}

// Frames of SixPoints<S>, put together from the parts one by one.
template <class S>
std::vector<Vec3<S>> the_long_way(const SixPoints<S>& held) {
  Clip<double> clip;
  ParseNotes notes;
  REQUIRE(parse_bvh(walk(), clip, &notes).ok());
  const JointRoles roles = standardise<double>(clip, notes.rest).roles;
  StagedMotion<double> motion;
  REQUIRE(stage_motion(clip, roles, motion).ok());

  // 1.7 m tall, on the floor; the file is z up and faces -y.
  const std::vector<Vec3<S>>& file = held.body.vertices;
  Vec3<double> low = file[0].template cast<double>(), high = low;
  for (const Vec3<S>& p : file) {
    low = low.cwiseMin(p.template cast<double>());
    high = high.cwiseMax(p.template cast<double>());
  }
  const double scale = 1.7 / (high.z() - low.z());
  const Vec3<double> offset(-scale * ((low.x() + high.x()) / 2), -scale * low.z(),
                            -scale * ((-low.y() - high.y()) / 2));
  const auto onto = [&](const Vec3<S>& p) -> Vec3<S> {
    const Vec3<double> q = p.template cast<double>();
    return (scale * Vec3<double>(q.x(), q.z(), -q.y()) + offset).template cast<S>();
  };
  std::vector<Vec3<S>> rest;
  for (const Vec3<S>& p : file) rest.push_back(onto(p));

  Body<S> body;
  REQUIRE(body.set_mesh(rest, held.body.faces, Solve::solid).ok());
  std::vector<Control<S>> controls;
  for (const MeshPoint<S>& point : held.points)
    controls.push_back({nearest(file, point.position), point.radius * S(1.7)});
  REQUIRE(body.set_controls(controls).ok());

  const std::vector<std::string>& names = motion.clip.skeleton.names;
  std::vector<std::int32_t> pairs;
  for (const char* joint : {"LeftFoot", "RightFoot", "LeftHand", "RightHand", "Head"})
    pairs.push_back(static_cast<std::int32_t>(std::find(names.begin(), names.end(), joint) - names.begin()));
  pairs.push_back(-1);
  std::vector<Vec3<double>> resting, shown;
  for (const Vec3<S>& p : body.rest_controls()) resting.push_back(p.template cast<double>());
  for (const Vec3<S>& p : held.poses[0].points) shown.push_back(onto(p).template cast<double>());
  const std::vector<Vec3<double>> pose(motion.local.begin() + 12 * motion.clip.joints(),
                                       motion.local.begin() + 13 * motion.clip.joints());
  const Bounds<S> box = bounds(body.rest());
  const std::vector<ModelLimb<double>> limbs = detail::model_limbs(body);
  std::vector<FollowThrough> follow(pairs.size(), FollowThrough::stiff);
  follow.back() = FollowThrough::bouncy;
  PerformanceInput<double> input;
  input.follow = follow;
  input.motion = &motion;
  input.pairs = pairs;
  input.rest = resting;
  input.limbs = limbs;
  input.floor = static_cast<double>(box.low.y());
  input.height = static_cast<double>(box.height());
  input.examples = {pose, shown};
  input.settings.smoothness = 0.5;
  Performance<double> made;
  REQUIRE(build_performance(input, made).ok());
  const Performance<S> performance = performance_cast<S>(made);
  Bake<S> bake;
  bake.bind(body, performance, S(1.5));
  std::vector<Vec3<S>> frames;
  for (std::int32_t f = 0; f < performance.frames; ++f) {
    REQUIRE(bake.frame(f).ok());
    for (const Vec3<S>& p : bake.positions()) {
      const Vec3<double> q = (p.template cast<double>() - offset) / scale;
      frames.push_back(Vec3<double>(q.x(), -q.z(), q.y()).template cast<S>());
    }
  }
  return frames;
}

template <class S>
Vec3<S> mean(const std::vector<Vec3<S>>& points) {
  Vec3<S> sum = Vec3<S>::Zero();
  for (const Vec3<S>& p : points) sum += p;
  return sum / static_cast<S>(points.size());
}

}  // namespace

TEST_CASE_TEMPLATE("one call gives the frames of the long way to the bit", S, float, double) {
  const SixPoints<S> held;
  RetargetedMesh<S> made;
  REQUIRE(retarget_mesh(held.input(), held.options(), made).ok());
  const std::vector<Vec3<S>> frames = made.all_frames();
  CHECK(made.frames() > 30);
  CHECK(frames.size() == static_cast<std::size_t>(made.frames()) * held.body.vertices.size());
  CHECK(frames == the_long_way(held));
}

TEST_CASE("points say what they were found to follow") {
  const SixPoints<float> held;
  RetargetedMesh<float> made;
  REQUIRE(retarget_mesh(held.input(), held.options(), made).ok());
  std::vector<std::string> joints;
  for (const MeshPoint<float>& point : made.points()) {
    joints.push_back(point.joint);
    CHECK(point.position == held.body.vertices[static_cast<std::size_t>(point.vertex)]);
  }
  CHECK(joints == std::vector<std::string>{"LeftFoot", "RightFoot", "LeftHand", "RightHand", "Head", ""});
}

TEST_CASE("a mesh and a motion are enough, however the file holds the mesh") {
  const Mat3<float> y_up = Mat3<float>::Identity();
  for (const Mat3<float>& axes : {y_up, z_up<float>()}) {
    const BlockBody<float> body = human(axes);
    RetargetMeshInput<float> input;
    input.motion = walk();
    input.vertices = body.vertices;
    input.faces = body.faces;
    RetargetedMesh<float> made;
    REQUIRE(retarget_mesh(input, {}, made).ok());
    std::vector<std::string> joints;
    for (const MeshPoint<float>& point : made.points()) joints.push_back(point.joint);
    for (const char* joint : {"LeftFoot", "RightFoot", "LeftHand", "RightHand", "Head"})
      CHECK(std::count(joints.begin(), joints.end(), joint) == 1);

    // It walks ahead on its own floor, in its own units.
    std::vector<Vec3<float>> frame(body.vertices.size());
    REQUIRE(made.frame(made.frames() - 1, frame).ok());
    const Vec3<float> way = axes.transpose() * (mean(frame) - mean(body.vertices));
    CHECK(way.z() > 1.0F);
    CHECK(std::abs(way.x()) < 0.5F);
    float floor = std::numeric_limits<float>::max(), rest = floor;
    for (const Vec3<float>& p : frame) floor = std::min(floor, axes.col(1).dot(p));
    for (const Vec3<float>& p : body.vertices) rest = std::min(rest, axes.col(1).dot(p));
    CHECK(floor == doctest::Approx(rest).epsilon(1e-4));
  }
}

TEST_CASE("axes that are said are not guessed") {
  const BlockBody<float> body = human<float>(Mat3<float>::Identity());
  RetargetMeshInput<float> input;
  input.motion = walk();
  input.vertices = body.vertices;
  input.faces = body.faces;
  RetargetMeshOptions<float> options;
  options.axes = {Axis::plus_y, Axis::minus_z};
  RetargetedMesh<float> made;
  REQUIRE(retarget_mesh(input, options, made).ok());
  std::vector<Vec3<float>> frame(body.vertices.size());
  REQUIRE(made.frame(made.frames() - 1, frame).ok());
  CHECK((mean(frame) - mean(body.vertices)).z() < -1.0F);
}

TEST_CASE("Acclaim's two texts are read too") {
  const BlockBody<float> body = human<float>(Mat3<float>::Identity());
  std::vector<MeshPoint<float>> points(2);
  points[0].vertex = 5;
  points[0].joint = "shin";
  points[1].vertex = 200;
  RetargetMeshInput<float> input;
  input.motion = small_amc;
  input.skeleton = small_asf;
  input.vertices = body.vertices;
  input.faces = body.faces;
  input.points = points;
  RetargetedMesh<float> made;
  REQUIRE(retarget_mesh(input, {}, made).ok());
  CHECK(made.frames() == 1);
  CHECK(made.points()[0].joint == "shin");
  input.skeleton = {};
  CHECK(retarget_mesh(input, {}, made).error == Error::empty_input);
  CHECK(made.frames() == 1);
}

TEST_CASE("what is wrong is said, and nothing is lost") {
  const SixPoints<float> held;
  RetargetedMesh<float> made;
  REQUIRE(retarget_mesh(held.input(), held.options(), made).ok());
  const std::int32_t frames = made.frames();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const auto check = [&](auto change, Error error, std::int32_t where) {
    SixPoints<float> bad;
    RetargetMeshInput<float> input = bad.input();
    RetargetMeshOptions<float> options = bad.options();
    change(bad, input, options);
    const Status status = retarget_mesh(input, options, made);
    CHECK(status.error == error);
    CHECK(status.where == where);
    CHECK(made.frames() == frames);
  };
  check([](auto&, auto& in, auto&) { in.motion = ""; }, Error::empty_input, -1);
  check([](auto&, auto& in, auto&) { in.motion = "solid cube"; }, Error::not_this_format, 1);
  check([](auto&, auto& in, auto&) { in.faces = {}; }, Error::no_faces, -1);
  check([](auto& bad, auto&, auto&) { bad.body.faces[3][1] = 999999; }, Error::index_out_of_range, 3);
  check([](auto& bad, auto&, auto&) { bad.body.vertices[7].y() = nan; }, Error::not_finite, 7);
  check([](auto& bad, auto&, auto&) { bad.points[2].vertex = 999999; }, Error::index_out_of_range, 2);
  check([](auto& bad, auto&, auto&) { bad.points[2].position.x() = nan; }, Error::not_finite, 2);
  check([](auto& bad, auto&, auto&) { bad.points[2].radius = nan; }, Error::not_finite, 2);
  check([](auto& bad, auto&, auto&) { bad.points[3].joint = "left wing"; }, Error::unknown_joint, 3);
  check([](auto& bad, auto&, auto&) { bad.poses[0].frame = 100000; }, Error::index_out_of_range, 0);
  check([](auto& bad, auto&, auto&) { bad.poses[0].points.pop_back(); }, Error::size_mismatch, 0);
  check([](auto& bad, auto&, auto&) { bad.poses[0].points[1].z() = nan; }, Error::not_finite, 0);
  check([](auto&, auto&, auto& options) { options.axes = {Axis::plus_y, Axis::minus_y}; }, Error::unsupported, -1);
  // no joint of this motion is a part of a body
  check(
      [](auto&, auto& in, auto&) {
        static const std::string nobody = replaced(replaced(small_bvh, "Hips", "a"), "Knee", "b");
        in.motion = nobody;
        in.points = {};
        in.poses = {};
        in.faces = in.faces.subspan(0, 1);
      },
      Error::unknown_joint, -1);
}

TEST_CASE("points that are near the same vertex get one each") {
  SixPoints<float> held;
  for (MeshPoint<float>& point : held.points) point.position = held.points[0].position;
  RetargetMeshInput<float> input = held.input();
  input.poses = {};
  RetargetedMesh<float> made;
  REQUIRE(retarget_mesh(input, held.options(), made).ok());
  std::vector<std::int32_t> vertices;
  for (const MeshPoint<float>& point : made.points()) vertices.push_back(point.vertex);
  std::sort(vertices.begin(), vertices.end());
  CHECK(std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end());
}

TEST_CASE("a frame does not allocate, and names what is not there") {
  const SixPoints<float> held;
  RetargetedMesh<float> made;
  std::vector<Vec3<float>> out(held.body.vertices.size());
  CHECK(made.frames() == 0);
  CHECK(made.points().empty());
  CHECK(made.all_frames().empty());
  CHECK(made.frame(0, out).error == Error::index_out_of_range);
  REQUIRE(retarget_mesh(held.input(), held.options(), made).ok());
  CHECK(made.frame(made.frames(), out).error == Error::index_out_of_range);
  CHECK(made.frame(0, {out.data(), 5}).error == Error::size_mismatch);
  const std::int64_t before = test::allocation_count;
  const bool ok = made.frame(12, out).ok();
  CHECK(test::allocation_count == before);
  CHECK(ok);
}

TEST_CASE_TEMPLATE("a mesh on the stage is as tall as a human, or as wide as fits beside one", S, float, double) {
  const BlockBody<S> tall = human(z_up<S>()), wide = build_blocks<S>({{{0, 0, 0}, {1, 2, 20}}});
  const auto staged = [](const BlockBody<S>& body, const StageTransform<S>& stage) {
    std::vector<Vec3<S>> out;
    for (const Vec3<S>& p : body.vertices) {
      out.push_back(stage.to_stage(p));
      CHECK((stage.from_stage(out.back()) - p).norm() < S(1e-5));
    }
    return bounds<S>(out);
  };
  const Posture<S> z_posture = detail::posture_of<S>({Axis::plus_z, Axis::minus_y});
  const Bounds<S> human_box = staged(tall, stage_transform<S>(tall.vertices, z_posture));
  CHECK(human_box.height() == doctest::Approx(1.7));
  CHECK(std::abs(human_box.low.y()) < S(1e-6));
  CHECK(std::abs(human_box.low.z() + human_box.high.z()) < S(1e-6));
  const Bounds<S> wide_box = staged(wide, stage_transform<S>(wide.vertices, Posture<S>{}));
  CHECK(S(0.6) * wide_box.extent().z() == doctest::Approx(1.7));
}
