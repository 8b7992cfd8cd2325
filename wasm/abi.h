// What crosses the boundary, told once. wasm/abi.mjs reads this file and the exported functions beside it and writes
// what TypeScript knows of them, so it takes only what is written as here: aliases of the core's enums and constants,
// and structs of the field types below. A field that an answer leaves out, or that its struct does not have, does not
// compile.
#pragma once

#include <cstdint>
#include <new>
#include <type_traits>

#include "rigless/deform/detail/control.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/mesh/shape_analysis.h"
#include "rigless/motion/standardise.h"
#include "rigless/retarget/retarget.h"
#include "rigless/scene/body.h"
#include "rigless/scene/detail/loop.h"
#include "rigless/scene/detail/stage_transform.h"
#include "rigless/scene/performance.h"

namespace rigless_wasm {

// Index in the low half, generation in the high half; never 0.
using ObjectHandle = std::uint32_t;

// 0 when all is well, otherwise error * 2^32 + where: exact in a double.
using PackedStatus = double;

// Enums whose names both sides know.
using CoreError = rigless::Error;
using LengthUnit = rigless::LengthUnit;
using FrameTimeUnit = rigless::FrameTimeUnit;
using UpAxis = rigless::UpAxis;
using BodyRole = rigless::BodyRole;
using FileAxes = rigless::FileAxes;
using BodyPart = rigless::BodyPart;
using BodySide = rigless::BodySide;
using Solve = rigless::Solve;
using FollowThrough = rigless::FollowThrough;

// Constants that both sides know.
inline constexpr double fps = rigless::performance_fps;                  // of every performance
inline constexpr double person_height = rigless::person_height;          // metres, where nothing better is known
inline constexpr double stage_height = rigless::stage_height;            // how tall a model stands on the stage, metres
inline constexpr double width_share = rigless::detail::width_share;      // how much of its width counts as height
inline constexpr double default_radius = rigless::default_radius;        // of a point, in model heights
inline constexpr double shortest_loop = rigless::detail::shortest_loop;  // frames of a motion that may close
inline constexpr double default_smoothness = rigless::default_smoothness;  // weight of acceleration at 30 fps

// Field types: one double each, a vector three.
struct Number {
  double value;
  template <class T>
  Number(T number) : value(static_cast<double>(number)) {}
};

struct Flag {
  double value;
  Flag(bool flag) : value(flag ? 1 : 0) {}
};

template <class Enum>
struct NameOf {
  double value;
  NameOf(Enum one) : value(static_cast<double>(one)) {}
};

struct Vector {
  Number x, y, z;
  template <class S>
  Vector(const rigless::Vec3<S>& v) : x(v.x()), y(v.y()), z(v.z()) {}
};

inline rigless::Vec3<float> vector(const Vector& v) {
  return rigless::Vec3<double>(v.x.value, v.y.value, v.z.value).cast<float>();
}

static_assert(sizeof(Number) == sizeof(double) && sizeof(Vector) == 3 * sizeof(double));

// Where a mesh is held.
struct ControlInput {
  Number vertex;
  Number radius;  // of the disc along the surface or of the ball in the solid, metres
  Flag slab;      // of a solid: holds a level slab instead of a ball
  Flag on_limb;   // of a solid: it is known to be at the tip of a limb
  Vector base;    // where that limb leaves the trunk, stage metres
  Vector bend;    // where it bends at rest, stage metres
};

inline rigless::Control<float> control(const ControlInput& c) {
  return {static_cast<std::int32_t>(c.vertex.value),
          static_cast<float>(c.radius.value),
          c.slab.value != 0,
          c.on_limb.value != 0,
          vector(c.base),
          vector(c.bend)};
}

// Where a control is at a frame, or the way to there from a control at a frame, on the axes named; body-local stage
// metres.
struct ConstraintInput {
  Number control;
  Number frame;
  Number from_control;  // -1: the value is a place
  Number from_frame;
  Vector value;
  Flag x;  // whether the value speaks of it
  Flag y;
  Flag z;
};

inline rigless::Constraint<double> constraint(const ConstraintInput& c) {
  const auto integer = [](const Number& n) { return static_cast<std::int32_t>(n.value); };
  rigless::Constraint<double> out;
  out.at = {integer(c.control), integer(c.frame)};
  if (c.from_control.value >= 0) out.from = {integer(c.from_control), integer(c.from_frame)};
  out.value = rigless::Vec3<double>(c.value.x.value, c.value.y.value, c.value.z.value);
  out.axes = {c.x.value != 0, c.y.value != 0, c.z.value != 0};
  return out;
}

struct BodyReport {
  Number volume;  // NaN when open
  Number boundary_edges;
  Number non_manifold_edges;
  Number shells;
  Number isolated_vertices;
  Number degenerate_faces;
  Number floor;   // height of the lowest vertex above y = 0
  Number height;  // from there to the highest vertex
};

// What is solved inside a mesh.
struct SolidInfo {
  Number nodes;     // N
  Number elements;  // E
  Number edges;     // directed
  Number cell;      // edge of an element, metres
};

// Joints and weights for frames of a mesh.
struct SkinInfo {
  Number joints;   // J
  Number frames;   // F
  Number targets;  // K
  Number rms;      // of all vertices in all frames, in diagonals
  Number worst;    // the same
  Number normals;  // radians, rms
};

// Morph targets for frames of a mesh.
struct MorphInfo {
  Number targets;  // K
  Number frames;   // F
  Number rms;      // of all vertices in all frames, in diagonals
  Number worst;    // the same
};

struct BakeRoot {
  Vector position;      // of the body's origin in the world
  Number yaw;           // radians
  Number volume_ratio;  // NaN when open
};

// What the user says of a motion: instead of what is guessed, and what is danced of it.
struct MotionEdits {
  Number metres_per_unit;  // 0: guessed
  Number fps;              // 0: the file's
  Number up;               // an UpAxis; -1: guessed
  Number turns;            // quarter turns, counter-clockwise from above
  Flag mirror;
  Number first;  // frames at 30 fps
  Number last;
  Flag loop;
};

struct MotionInfo {
  Number frames;  // T
  Number joints;  // J
  Number source_frames;
  Number source_fps;
  Number metres_per_unit;  // of the file
  Flag told;               // which joints are its feet and its head or hands
  Number take_frames;      // before it was cut
};

// What a joint is; no place of a body has two.
struct JointPlace {
  NameOf<BodySide> side;
  NameOf<BodyPart> part;
};

// What a parser worked around (rigless::ParseNotes), and what was guessed of the file.
struct MotionNotes {
  Number frames_declared;
  Number frames_read;
  Flag frame_cut;
  Flag text_after_end;
  Flag frame_time_assumed;
  NameOf<FrameTimeUnit> frame_time_unit;
  Flag frame_numbers;
  Number rows_replaced;
  Number row_replaced;  // the line of the first
  Flag radians;
  Number roots;
  Number renamed;
  Number lengths_ignored;
  Number joints_folded;
  NameOf<UpAxis> up;
  NameOf<LengthUnit> unit;
  Number pose_in_front;  // frames
  Flag faced_away;
};

struct PerformanceInfo {
  Number frames;    // T
  Number controls;  // C
  Number flights;
  Number constraints;
  Number asks;
  Number slip_before;  // metres per second, without the foot lock
  Number slip_after;   // with it
  Number have;         // the user's examples, images counted
  Number want;         // how many would be enough
  Number starters;
};

// How far a constraint is missed.
struct Miss {
  Number metres;
  Number opponent;  // the constraint that it contradicts, or -1
};

// A frame that is worth an example.
struct Ask {
  Number frame;
  Number gain;
};

// A place of a body that its file names, in the mesh's own axes and units; a tip says only that something is there.
struct Landmark {
  Vector position;
  NameOf<BodyRole> role;
  Number side;  // 1 on the body's left, -1 on its right, 0 in the middle
};

inline rigless::Landmark<float> landmark(const Landmark& one) {
  return {vector(one.position), static_cast<BodyRole>(one.role.value), static_cast<std::int32_t>(one.side.value)};
}

// What a bare mesh says of itself, in its own axes and units.
struct Shape {
  Vector up;
  Vector front;
  Number sure;  // of both, 0 to 1; below a half it is as well to ask
  Vector plane_point;
  Vector plane_normal;
  Number misfit;   // of the mirrored surface, in diagonals
  Flag symmetric;  // in the plane
  Number points;
};

struct ShapePoint {
  Number vertex;
  NameOf<BodyRole> role;
  Number side;     // 1 on the body's left, -1 on its right, 0 in the middle
  Number partner;  // index of the same point on the other side, its own on the plane, or -1
  Number radius;
  Flag wanted;
};

// Keeps an answer until the same is asked again.
template <class Struct>
RIGLESS_INNER const Struct* answer(const Struct& value) {
  static_assert(std::is_trivially_copyable_v<Struct> && std::is_standard_layout_v<Struct>);
  static_assert(sizeof(Struct) % sizeof(double) == 0 && alignof(Struct) == alignof(double));
  alignas(Struct) static char kept[sizeof(Struct)];
  return new (kept) Struct(value);
}

}  // namespace rigless_wasm
