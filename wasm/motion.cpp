// Motions as flat C functions over integer handles. No logic of its own: it turns memory into spans, double into
// float32, and a Status into one number. Double inside. Built for size.

#include "exports.h"
#include "motions.h"
#include "rigless/motion/parse_bvh.h"

using rigless::Span;
using rigless::Status;
using rigless_wasm::Motion;
using rigless_wasm::motions;
using rigless_wasm::ObjectHandle;
using rigless_wasm::pack;

namespace {

using Vec3d = rigless::Vec3<double>;

std::string_view text_view(const char* text, std::int32_t bytes) { return {text, static_cast<std::size_t>(bytes)}; }

void narrow(Span<const Vec3d> points, std::vector<float>& out) {
  out.clear();
  out.reserve(3 * points.size());
  for (const Vec3d& p : points) {
    for (int k = 0; k < 3; ++k) out.push_back(static_cast<float>(p[k]));
  }
}

Status stage(rigless::Clip<double>& clip, Motion& motion) {
  motion.file = rigless::standardise<double>(clip, motion.notes.rest);
  if (const Status status = rigless::stage_motion(clip, motion.file.roles, motion.staged); !status.ok()) return status;
  narrow(motion.staged.clip.positions, motion.positions);
  narrow(motion.staged.local, motion.local);
  motion.yaw.assign(motion.staged.yaw.begin(), motion.staged.yaw.end());
  return {};
}

}  // namespace

RIGLESS_EXPORT ObjectHandle motion_new() { return motions.add(); }

RIGLESS_EXPORT void motion_delete(ObjectHandle motion) { motions.remove(motion); }

// UTF-8 text.
RIGLESS_EXPORT double motion_read_bvh(ObjectHandle motion, const char* text, std::int32_t bytes) {
  rigless::Clip<double> clip;
  Motion& m = motions[motion];
  if (const Status status = rigless::parse_bvh(text_view(text, bytes), clip, &m.notes); !status.ok())
    return pack(status);
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

// out: the numbers of ParseNotes, in its order, then whether Z is up in the file, and its LengthUnit.
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
  out[8] = motions[motion].file.up == rigless::UpAxis::z;
  out[9] = static_cast<double>(motions[motion].file.unit.unit);
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
