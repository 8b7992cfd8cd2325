// The core as flat C functions over integer handles. No logic of its own: it turns memory into spans, double into
// float32, and a Status into one number. Vertices are float; motions and control tracks are double inside.
// A pointer into an object holds until the object changes or the heap grows.

#include <algorithm>
#include <cstdlib>

#include "handle_table.h"
#include "rigless/motion/parse_acclaim.h"
#include "rigless/motion/parse_bvh.h"
#include "rigless/scene/bake.h"
#include "rigless/scene/body.h"
#include "rigless/scene/performance_builder.h"

#define RIGLESS_EXPORT extern "C" __attribute__((used, visibility("default")))

using rigless::Error;
using rigless::Face;
using rigless::Span;
using rigless::Status;
using rigless_wasm::HandleTable;
using rigless_wasm::ObjectHandle;

namespace {

using Body = rigless::Body<float>;
using Vec3f = rigless::Vec3<float>;

// A motion as it was read, and what of it goes to the page as float32.
struct Motion {
  rigless::AcclaimSkeleton skeleton;
  rigless::ParseNotes notes;
  rigless::FileGuess guess;
  rigless::StagedMotion<double> staged;
  std::vector<float> positions, local, yaw;
};

// A performance in the making, then made.
struct Play {
  rigless::PerformanceBuilder<double> builder;
  bool made = false;
  float volume = 1;
  Body* body = nullptr;
  rigless::Performance<float> performance;
  rigless::Bake<float> bake;
};

HandleTable<Body> bodies;
HandleTable<Motion> motions;
HandleTable<Play> plays;

constexpr std::int32_t slice_frames = 64;  // of one control: well under a millisecond

// error * 2^32 + where: exact in a double, and 0 when all is well.
double pack(Status status) {
  if (status.ok()) return 0;
  return static_cast<double>(status.error) * 4294967296.0 +
         static_cast<double>(static_cast<std::uint32_t>(status.where));
}

template <class T, class U>
Span<const T> view(const U* data, std::int32_t count) {
  return {reinterpret_cast<const T*>(data), static_cast<std::size_t>(count)};
}

std::string_view text_view(const char* text, std::int32_t bytes) { return {text, static_cast<std::size_t>(bytes)}; }

std::vector<rigless::Vec3<double>> widen(Span<const Vec3f> points) {
  std::vector<rigless::Vec3<double>> out;
  out.reserve(points.size());
  for (const Vec3f& p : points) out.push_back(p.cast<double>());
  return out;
}

void narrow(Span<const rigless::Vec3<double>> points, std::vector<float>& out) {
  out.clear();
  out.reserve(3 * points.size());
  for (const rigless::Vec3<double>& p : points) {
    for (int k = 0; k < 3; ++k) out.push_back(static_cast<float>(p[k]));
  }
}

Status stage(const rigless::Clip<double>& clip, Motion& motion) {
  if (const Status status = rigless::stage_motion(clip, motion.staged); !status.ok()) return status;
  narrow(motion.staged.clip.positions, motion.positions);
  narrow(motion.staged.local, motion.local);
  motion.yaw.assign(motion.staged.yaw.begin(), motion.staged.yaw.end());
  return {};
}

}  // namespace

RIGLESS_EXPORT void* alloc(std::int32_t bytes) { return std::malloc(static_cast<std::size_t>(bytes)); }

RIGLESS_EXPORT void release(void* memory) { std::free(memory); }

RIGLESS_EXPORT ObjectHandle body_new() { return bodies.add(); }

RIGLESS_EXPORT void body_delete(ObjectHandle body) { bodies.remove(body); }

// positions: V x 3; faces: F x 3. Forgets controls. On failure the body keeps what it had.
RIGLESS_EXPORT double body_set_mesh(ObjectHandle body, const float* positions, std::int32_t vertices,
                                    const std::int32_t* faces, std::int32_t face_count) {
  return pack(bodies[body].set_mesh(view<Vec3f>(positions, vertices), view<Face>(faces, face_count)));
}

// out: volume (NaN when open), boundary edges, non-manifold edges, shells, isolated vertices, degenerate faces.
RIGLESS_EXPORT void body_report(ObjectHandle body, double* out) {
  const rigless::MeshTopology& t = bodies[body].topology();
  out[0] = static_cast<double>(bodies[body].volume());
  out[1] = t.boundary_edges;
  out[2] = t.non_manifold_edges;
  out[3] = t.shells;
  out[4] = t.isolated_vertices;
  out[5] = t.degenerate_faces;
}

// C vertices and geodesic radii. On failure the old controls stay.
RIGLESS_EXPORT double body_set_controls(ObjectHandle body, const std::int32_t* vertices, const float* radii,
                                        std::int32_t count) {
  std::vector<rigless::Handle<float>> controls;
  for (std::int32_t c = 0; c < count; ++c) controls.push_back({vertices[c], radii[c]});
  return pack(bodies[body].set_controls(controls));
}

// targets: C x 3, body-local. The result is body_positions().
RIGLESS_EXPORT double body_drag(ObjectHandle body, const float* targets, std::int32_t count, float volume,
                                std::int32_t restart) {
  return pack(bodies[body].drag(view<Vec3f>(targets, count), volume, restart != 0));
}

RIGLESS_EXPORT const float* body_positions(ObjectHandle body) {
  return bodies[body].deformer().positions().data()->data();
}

RIGLESS_EXPORT double body_volume_ratio(ObjectHandle body) {
  return static_cast<double>(bodies[body].volume_ratio(bodies[body].deformer().positions()));
}

RIGLESS_EXPORT ObjectHandle motion_new() { return motions.add(); }

RIGLESS_EXPORT void motion_delete(ObjectHandle motion) { motions.remove(motion); }

// UTF-8 text.
RIGLESS_EXPORT double motion_read_bvh(ObjectHandle motion, const char* text, std::int32_t bytes) {
  rigless::Clip<double> clip;
  Motion& m = motions[motion];
  if (const Status status = rigless::parse_bvh(text_view(text, bytes), clip, &m.notes); !status.ok())
    return pack(status);
  m.guess = rigless::stand_in_metres<double>(clip, m.notes.rest);
  return pack(stage(clip, m));
}

RIGLESS_EXPORT double motion_read_asf(ObjectHandle motion, const char* text, std::int32_t bytes) {
  return pack(rigless::parse_asf(text_view(text, bytes), motions[motion].skeleton));
}

// On the skeleton of motion_read_asf().
RIGLESS_EXPORT double motion_read_amc(ObjectHandle motion, const char* text, std::int32_t bytes) {
  Motion& m = motions[motion];
  rigless::Clip<double> clip;
  const Status status = rigless::parse_amc(text_view(text, bytes), m.skeleton, clip, &m.notes);
  return pack(status.ok() ? stage(clip, m) : status);
}

// out: T, J, frames and rate of the file, metres per unit of the file.
RIGLESS_EXPORT void motion_info(ObjectHandle motion, double* out) {
  const rigless::StagedMotion<double>& m = motions[motion].staged;
  out[0] = m.clip.frames;
  out[1] = m.clip.joints();
  out[2] = m.source_frames;
  out[3] = m.source_fps;
  out[4] = m.clip.metres_per_unit;
}

// out: the numbers of ParseNotes, in its order, then those of FileGuess.
RIGLESS_EXPORT void motion_notes(ObjectHandle motion, double* out) {
  const rigless::ParseNotes& n = motions[motion].notes;
  out[0] = n.frames_declared;
  out[1] = n.frames_read;
  out[2] = n.frame_cut;
  out[3] = n.text_after_end;
  out[4] = n.frame_time_assumed;
  out[5] = n.roots;
  out[6] = n.renamed;
  out[7] = n.lengths_ignored;
  out[8] = motions[motion].guess.z_up;
  out[9] = static_cast<double>(motions[motion].guess.unit);
}

RIGLESS_EXPORT const char* motion_name(ObjectHandle motion, std::int32_t joint) {
  return motions[motion].staged.clip.skeleton.names[static_cast<std::size_t>(joint)].data();
}

RIGLESS_EXPORT std::int32_t motion_name_bytes(ObjectHandle motion, std::int32_t joint) {
  return static_cast<std::int32_t>(motions[motion].staged.clip.skeleton.names[static_cast<std::size_t>(joint)].size());
}

// J
RIGLESS_EXPORT const std::int32_t* motion_parents(ObjectHandle motion) {
  return motions[motion].staged.clip.skeleton.parents.data();
}

// T x J x 3, T x J x 3 and T, float32
RIGLESS_EXPORT const float* motion_positions(ObjectHandle motion) { return motions[motion].positions.data(); }
RIGLESS_EXPORT const float* motion_local(ObjectHandle motion) { return motions[motion].local.data(); }
RIGLESS_EXPORT const float* motion_yaw(ObjectHandle motion) { return motions[motion].yaw.data(); }

RIGLESS_EXPORT ObjectHandle performance_new() { return plays.add(); }

RIGLESS_EXPORT void performance_delete(ObjectHandle performance) { plays.remove(performance); }

// pairs: C; example_joints: N x J x 3 body-local metres, NaN where unknown; example_controls: N x C x 3. The motion
// must stay until performance_progress() is 1, the body and its controls as long as frames are baked.
RIGLESS_EXPORT double performance_begin(ObjectHandle performance, ObjectHandle body, ObjectHandle motion,
                                        const std::int32_t* pairs, std::int32_t controls, const float* example_joints,
                                        const float* example_controls, std::int32_t examples, double smoothness,
                                        double volume, std::int32_t ground_contact, std::int32_t in_place) {
  Play& play = plays[performance];
  play.body = &bodies[body];
  play.volume = static_cast<float>(volume);
  const rigless::StagedMotion<double>& staged = motions[motion].staged;
  const std::vector<rigless::Vec3<double>> rest = widen(play.body->rest_controls());
  const std::vector<rigless::Vec3<double>> joints = widen(view<Vec3f>(example_joints, examples * staged.clip.joints()));
  const std::vector<rigless::Vec3<double>> places = widen(view<Vec3f>(example_controls, examples * controls));
  const rigless::Bounds<float> box = rigless::bounds(play.body->rest());
  rigless::PerformanceInput<double> input;
  input.motion = &staged;
  input.pairs = view<std::int32_t>(pairs, controls);
  input.rest = rest;
  input.floor = box.low.y();
  input.height = box.height();
  input.examples = {joints, places};
  input.settings = {smoothness, ground_contact != 0, in_place != 0};
  return pack(play.builder.begin(input));
}

// One slice. Call until performance_progress() is 1.
RIGLESS_EXPORT double performance_advance(ObjectHandle performance) {
  Play& play = plays[performance];
  if (play.builder.advance(slice_frames)) return 0;
  rigless::Performance<double> made;
  if (const Status status = play.builder.finish(made); !status.ok()) return pack(status);
  play.performance = rigless::performance_cast<float>(made);
  play.bake.bind(play.body->deformer(), play.performance, play.volume);
  play.made = true;
  return 0;
}

RIGLESS_EXPORT double performance_progress(ObjectHandle performance) {
  const Play& play = plays[performance];
  return play.made ? 1.0 : std::min(play.builder.progress(), 0.99);
}

// out: T, C, number of flights, slip before and after the foot lock (metres per second).
RIGLESS_EXPORT void performance_info(ObjectHandle performance, double* out) {
  const rigless::Performance<float>& p = plays[performance].performance;
  out[0] = p.frames;
  out[1] = static_cast<double>(p.control_count());
  out[2] = static_cast<double>(p.flights.size());
  out[3] = static_cast<double>(p.slip_before.mean);
  out[4] = static_cast<double>(p.slip_after.mean);
}

// T x C x 3; T x C; pairs of frames; T; T x 2
RIGLESS_EXPORT const float* performance_controls(ObjectHandle performance) {
  return plays[performance].performance.controls.data()->data();
}
RIGLESS_EXPORT const std::uint8_t* performance_contacts(ObjectHandle performance) {
  return plays[performance].performance.contacts.data();
}
RIGLESS_EXPORT const std::int32_t* performance_flights(ObjectHandle performance) {
  return reinterpret_cast<const std::int32_t*>(plays[performance].performance.flights.data());
}
RIGLESS_EXPORT const float* performance_yaw(ObjectHandle performance) {
  return plays[performance].performance.yaw.data();
}
RIGLESS_EXPORT const float* performance_travel(ObjectHandle performance) {
  return plays[performance].performance.travel.data()->data();
}

// Makes a frame: performance_positions(), V x 3 in the world, and performance_root().
RIGLESS_EXPORT double performance_bake(ObjectHandle performance, std::int32_t frame) {
  return pack(plays[performance].bake.frame(frame));
}

RIGLESS_EXPORT const float* performance_positions(ObjectHandle performance) {
  return plays[performance].bake.positions().data()->data();
}

// out: x, y, z and yaw of the body's origin, volume ratio (NaN when open).
RIGLESS_EXPORT void performance_root(ObjectHandle performance, double* out) {
  const Play& play = plays[performance];
  for (int k = 0; k < 3; ++k) out[k] = static_cast<double>(play.bake.root().position[k]);
  out[3] = static_cast<double>(play.bake.root().yaw);
  out[4] = static_cast<double>(play.body->volume_ratio(play.bake.positions()));
}
