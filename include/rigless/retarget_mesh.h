// The whole way in one call: a human motion as text and a mesh in, the mesh's vertices in every frame out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rigless/mesh/shape_analysis.h"
#include "rigless/scene/bake.h"
#include "rigless/scene/body.h"
#include "rigless/scene/detail/pair_points.h"
#include "rigless/scene/detail/read_motion.h"
#include "rigless/scene/detail/stage_transform.h"
#include "rigless/scene/performance_builder.h"

namespace rigless {

enum class Axis : std::int32_t { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };

// How a mesh stands in its own axes; `front` must not lie along `up`.
struct MeshAxes {
  Axis up = Axis::plus_y;
  Axis front = Axis::plus_z;
};

// A point of the mesh, and the joint that it follows.
template <class S>
struct MeshPoint {
  std::int32_t vertex = -1;            // -1: the vertex nearest to `position` that no point before has
  Vec3<S> position = Vec3<S>::Zero();  // the mesh's own units and axes; not read where a vertex is given
  std::string joint;                   // name, or part of the body ("left foot"); empty: follows the whole pose
  S radius = S(default_radius);        // of what moves as one piece with it, in mesh heights: see Control
  bool slab = false;                   // of the trunk: see Control
  FollowThrough follow = FollowThrough::bouncy;  // without a joint: how it hangs on the body
};

// "When the human does this, my mesh does that."
template <class S>
struct MeshPose {
  std::int32_t frame = 0;       // of the motion at 30 fps
  std::vector<Vec3<S>> points;  // C, the mesh's own units and axes
};

template <class S>
struct RetargetMeshInput {
  std::string_view motion;          // text of a BVH or an AMC file
  std::string_view skeleton;        // text of the ASF file that an AMC needs; not read for a BVH
  Span<const Vec3<S>> vertices;     // V, any units and axes
  Span<const Face> faces;           // F
  Span<const MeshPoint<S>> points;  // C; empty: guessed from the shape
  Span<const MeshPose<S>> poses;    // N; while they are few, others are made up beside them
};

template <class S>
struct RetargetMeshOptions {
  std::optional<MeshAxes> axes;          // not said: Y up and Z front, but guessed from the shape when the points are
  Solve solve = Solve::solid;            // surface: the mesh's own, as in the paper; for clean closed ones
  S volume = 1;                          // lambda_v: 0 rotations only, 1 natural, 3 exaggerated
  PerformanceSettings<double> settings;  // smoothness, contact with the ground, travel, energy
};

// A mesh that acts out a motion: V vertices over T frames. Empty until retarget_mesh() fills it.
template <class S>
class RetargetedMesh {
 public:
  static constexpr double fps = performance_fps;

  std::int32_t frames() const { return made_ ? made_->performance.frames : 0; }  // T

  // A frame, V vertices in the mesh's own units and axes: the floor is level with the lowest vertex at rest, and the
  // body sets out from where it rests. Depends on nothing but the frame. No allocation. Errors: index_out_of_range
  // (where: frame); size_mismatch.
  Status frame(std::int32_t f, Span<Vec3<S>> out);

  // Every frame: T x V. Allocates.
  std::vector<Vec3<S>> all_frames();

  // C, as given or as guessed: with their vertices, and the names of the joints that they were found to follow.
  Span<const MeshPoint<S>> points() const {
    return made_ ? Span<const MeshPoint<S>>(made_->points) : Span<const MeshPoint<S>>();
  }

  // Contacts, flights and tracks, in metres of the stage. Only when it is not empty.
  const Performance<S>& performance() const { return made_->performance; }

 private:
  struct Made {
    detail::StageTransform<S> stage;
    std::vector<MeshPoint<S>> points;  // C
    Body<S> body;
    Performance<S> performance;
    Bake<S> bake;
  };

  template <class T>
  friend Status retarget_mesh(const RetargetMeshInput<T>& input, const RetargetMeshOptions<T>& options,
                              RetargetedMesh<T>& out);

  Status make(const RetargetMeshInput<S>& input, const RetargetMeshOptions<S>& options);

  std::unique_ptr<Made> made_;  // the bake looks at its neighbours, which a move keeps in place
};

// Reads the motion, puts the mesh on the stage beside the human, pairs points with joints and solves; frames are then
// deformed when they are asked for. Computes the tracks in double whatever S is. Allocates.
// Errors: those of parse_bvh(), parse_asf(), parse_amc() and stage_motion() (where: line or frame);
// no_faces, index_out_of_range (where: face), not_finite (where: vertex) of the mesh;
// index_out_of_range (a point's vertex), unknown_joint (no joint of the motion is called so or is that part of the
// body; for guessed points, with where -1: the motion's joints cannot be told), not_finite (a position or radius;
// where: point); index_out_of_range (a pose's frame), size_mismatch, not_finite (where: pose); unsupported (axes: the
// front lies along up); factorization_failed. On failure `out` keeps what it had.
template <class S>
Status retarget_mesh(const RetargetMeshInput<S>& input, const RetargetMeshOptions<S>& options, RetargetedMesh<S>& out);

// ---------------------------------------------------------------------------------------------------------------------

namespace detail {

template <class S>
Posture<S> posture_of(const MeshAxes& axes) {
  Posture<S> posture;
  posture.up = signed_axis<S>(static_cast<int>(axes.up));
  posture.front = signed_axis<S>(static_cast<int>(axes.front));
  posture.left = posture.up.cross(posture.front);
  return posture;
}

// The poses as examples. Errors: see retarget_mesh().
template <class S>
Status pose_examples(Span<const MeshPose<S>> poses, std::size_t points, const StageTransform<S>& stage,
                     const StagedMotion<double>& motion, ExampleStorage<double>& out) {
  for (std::size_t n = 0; n < poses.size(); ++n) {
    const MeshPose<S>& pose = poses[n];
    const auto where = static_cast<std::int32_t>(n);
    if (pose.frame < 0 || pose.frame >= motion.clip.frames) return {Error::index_out_of_range, where};
    if (pose.points.size() != points) return {Error::size_mismatch, where};
    const Vec3<double>* human = &motion.local[to_size(pose.frame) * motion.clip.skeleton.names.size()];
    out.joints.insert(out.joints.end(), human, human + motion.clip.joints());
    for (const Vec3<S>& p : pose.points) {
      if (!p.allFinite()) return {Error::not_finite, where};
      out.controls.push_back(stage.to_stage(p).template cast<double>());
    }
  }
  return {};
}

}  // namespace detail

template <class S>
Status RetargetedMesh<S>::make(const RetargetMeshInput<S>& input, const RetargetMeshOptions<S>& options) {
  detail::MotionRead read;
  bool in_skeleton = false;
  if (const Status status = detail::read_motion(input.motion, input.skeleton, {}, read, in_skeleton); !status.ok())
    return status;
  const StagedMotion<double>& motion = read.staged;

  const MeshAxes axes = options.axes.value_or(MeshAxes{});
  Posture<S> posture = detail::posture_of<S>(axes);
  if (posture.left.isZero()) return {Error::unsupported, -1};
  for (std::size_t v = 0; v < input.vertices.size(); ++v)
    if (!input.vertices[v].allFinite()) return {Error::not_finite, v};
  ShapeAnalysis<S> shape;
  if (input.points.empty()) {
    const Status status = analyse_shape(input.vertices, input.faces, shape, options.axes ? &posture : nullptr);
    if (!status.ok()) return status;
    posture = shape.posture;
  }

  auto made = std::make_unique<Made>();
  made->stage = detail::stage_transform(input.vertices, posture);
  std::vector<Vec3<S>> rest;
  for (const Vec3<S>& p : input.vertices) rest.push_back(made->stage.to_stage(p));
  if (const Status status = made->body.set_mesh(rest, input.faces, options.solve); !status.ok()) return status;

  std::vector<std::int32_t> joints;  // C
  made->points.assign(input.points.begin(), input.points.end());
  const auto height = static_cast<S>(stage_height / made->stage.scale);
  const Status found = input.points.empty() ? detail::guess_points(shape, height, motion, made->points, joints)
                                            : detail::find_points(input.vertices, motion, made->points, joints);
  if (!found.ok()) return found;
  std::vector<Control<S>> controls;
  for (std::size_t c = 0; c < joints.size(); ++c) {
    MeshPoint<S>& point = made->points[c];
    const auto vertex = to_size(point.vertex);
    point.position = input.vertices[vertex];
    point.joint = joints[c] < 0 ? "" : nth(motion.clip.skeleton.names, joints[c]);
    controls.push_back({point.vertex, point.radius * static_cast<S>(stage_height), point.slab});
  }
  if (const Status status = made->body.set_controls(controls); !status.ok()) return status;

  ExampleStorage<double> examples;
  if (const Status status = detail::pose_examples(input.poses, controls.size(), made->stage, motion, examples);
      !status.ok())
    return status;
  std::vector<FollowThrough> follow;
  for (std::size_t c = 0; c < joints.size(); ++c)
    follow.push_back(joints[c] < 0 ? made->points[c].follow : FollowThrough::stiff);
  std::vector<Vec3<double>> resting;
  for (const Vec3<S>& p : made->body.rest_controls()) resting.push_back(p.template cast<double>());
  const detail::Bounds<S> box = detail::bounds(made->body.rest());
  const std::vector<ModelLimb<double>> limbs = detail::model_limbs(made->body);
  PerformanceInput<double> play;
  play.motion = &motion;
  play.pairs = joints;
  play.rest = resting;
  play.limbs = limbs;
  play.follow = follow;
  play.floor = static_cast<double>(box.low.y());
  play.height = static_cast<double>(box.height());
  play.examples = examples.view();
  play.settings = options.settings;
  Performance<double> performance;
  if (const Status status = build_performance(play, performance); !status.ok()) return status;
  made->performance = performance_cast<S>(performance);
  made->bake.bind(made->body, made->performance, options.volume);
  made_ = std::move(made);
  return {};
}

template <class S>
Status retarget_mesh(const RetargetMeshInput<S>& input, const RetargetMeshOptions<S>& options, RetargetedMesh<S>& out) {
  return out.make(input, options);
}

template <class S>
Status RetargetedMesh<S>::frame(std::int32_t f, Span<Vec3<S>> out) {
  if (f < 0 || f >= frames()) return {Error::index_out_of_range, f};
  if (out.size() != made_->body.rest().size()) return {Error::size_mismatch, -1};
  if (const Status status = made_->bake.frame(f); !status.ok()) return status;
  const Span<const Vec3<S>> world = made_->bake.positions();
  for (std::size_t v = 0; v < out.size(); ++v) out[v] = made_->stage.from_stage(world[v]);
  return {};
}

template <class S>
std::vector<Vec3<S>> RetargetedMesh<S>::all_frames() {
  const std::size_t vertices = made_ ? made_->body.rest().size() : 0;
  std::vector<Vec3<S>> all(to_size(frames()) * vertices);
  for (std::int32_t f = 0; f < frames(); ++f) {
    const Status made = frame(f, {all.data() + to_size(f) * vertices, vertices});
    RIGLESS_ASSERT(made.ok());
    static_cast<void>(made);
  }
  return all;
}

}  // namespace rigless
