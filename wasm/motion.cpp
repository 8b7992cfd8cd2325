// Motions as flat C functions over integer handles. No logic of its own: it turns memory into spans and a Status into
// one number. Double. Built for size.

#include <algorithm>

#include "exports.h"
#include "motions.h"

using rigless::Span;
using rigless::Status;
using rigless_wasm::answer;
using rigless_wasm::JointPlace;
using rigless_wasm::Motion;
using rigless_wasm::MotionEdits;
using rigless_wasm::MotionInfo;
using rigless_wasm::MotionNotes;
using rigless_wasm::motions;
using rigless_wasm::ObjectHandle;
using rigless_wasm::pack;
using rigless_wasm::PackedStatus;

namespace {

std::string_view text_view(const char* text, std::int32_t bytes) { return {text, static_cast<std::size_t>(bytes)}; }

}  // namespace

RIGLESS_EXPORT ObjectHandle motion_new() { return motions.add(); }

RIGLESS_EXPORT void motion_delete(ObjectHandle motion) { motions.remove(motion); }

// UTF-8 texts of a motion in any format, and of the skeleton beside it, which may be empty. joints: names of its hips,
// head, hands and feet as rigless::detail::Corrections has them, each on a line of its own.
RIGLESS_EXPORT PackedStatus motion_read(ObjectHandle motion, const char* text, std::int32_t bytes, const char* skeleton,
                                        std::int32_t skeleton_bytes, const MotionEdits* said, const char* joints,
                                        std::int32_t joints_bytes) {
  Motion& m = motions[motion];
  std::string_view names = text_view(joints, joints_bytes);
  const auto whole = [](const rigless_wasm::Number& n) { return static_cast<std::int32_t>(n.value); };
  rigless::detail::MotionEdits edits;
  edits.file = {said->metres_per_unit.value, said->fps.value, whole(said->up), whole(said->turns), {}};
  for (std::string_view& name : edits.file.joints) {
    name = names.substr(0, names.find('\n'));
    names.remove_prefix(std::min(name.size() + 1, names.size()));
  }
  edits.mirror = said->mirror.value != 0;
  edits.cut = {whole(said->first), whole(said->last), said->loop.value != 0};
  const Status status = rigless::detail::read_motion(text_view(text, bytes), text_view(skeleton, skeleton_bytes), edits,
                                                     m, m.in_skeleton);
  if (!status.ok()) return pack(status);
  m.places = m.staged.roles.places(m.staged.clip.joints());
  return 0;
}

// The first frames of a motion that has more, as one that can be danced.
RIGLESS_EXPORT ObjectHandle motion_beginning(ObjectHandle motion, std::int32_t frames) {
  const ObjectHandle beginning = motions.add();
  motions[beginning].staged = rigless::beginning_of(motions[motion].staged, frames);
  return beginning;
}

// 1 if what motion_read() refused is the skeleton.
RIGLESS_EXPORT std::int32_t motion_refused_skeleton(ObjectHandle motion) { return motions[motion].in_skeleton ? 1 : 0; }

RIGLESS_EXPORT const MotionInfo* motion_info(ObjectHandle motion) {
  const rigless::StagedMotion<double>& m = motions[motion].staged;
  return answer<MotionInfo>({
      .frames = m.clip.frames,
      .joints = m.clip.joints(),
      .source_frames = m.source_frames,
      .source_fps = m.source_fps,
      .metres_per_unit = m.clip.metres_per_unit,
      .told = m.roles.known(),
      .take_frames = m.take_frames,
  });
}

RIGLESS_EXPORT const MotionNotes* motion_notes(ObjectHandle motion) {
  const rigless::ParseNotes& n = motions[motion].notes;
  return answer<MotionNotes>({
      .frames_declared = n.frames_declared,
      .frames_read = n.frames_read,
      .frame_cut = n.frame_cut,
      .text_after_end = n.text_after_end,
      .frame_time_assumed = n.frame_time_assumed,
      .frame_time_unit = n.frame_time_unit,
      .frame_numbers = n.frame_numbers,
      .rows_replaced = n.rows_replaced,
      .row_replaced = n.row_replaced,
      .radians = n.radians,
      .roots = n.roots,
      .renamed = n.renamed,
      .lengths_ignored = n.lengths_ignored,
      .joints_folded = n.joints_folded,
      .up = motions[motion].file.up,
      .unit = motions[motion].file.unit.unit,
      .pose_in_front = motions[motion].file.pose_in_front,
      .faced_away = motions[motion].file.faced_away,
  });
}

RIGLESS_EXPORT const char* motion_name(ObjectHandle motion, std::int32_t joint) {
  return motions[motion].staged.clip.skeleton.names[static_cast<std::size_t>(joint)].data();
}

RIGLESS_EXPORT std::int32_t motion_name_bytes(ObjectHandle motion, std::int32_t joint) {
  return static_cast<std::int32_t>(motions[motion].staged.clip.skeleton.names[static_cast<std::size_t>(joint)].size());
}

RIGLESS_EXPORT const JointPlace* motion_place(ObjectHandle motion, std::int32_t joint) {
  const rigless::BodyPlace& place = motions[motion].places[static_cast<std::size_t>(joint)];
  return answer<JointPlace>({.side = place.side, .part = place.part});
}

// J
RIGLESS_EXPORT const std::int32_t* motion_parents(ObjectHandle motion) {
  return motions[motion].staged.clip.skeleton.parents.data();
}

// T, 1 while the left foot stands; the right one.
RIGLESS_EXPORT const std::uint8_t* motion_left(ObjectHandle motion) { return motions[motion].staged.left.data(); }
RIGLESS_EXPORT const std::uint8_t* motion_right(ObjectHandle motion) { return motions[motion].staged.right.data(); }

// T x J x 3, T x J x 3 and T
RIGLESS_EXPORT const double* motion_positions(ObjectHandle motion) {
  return motions[motion].staged.clip.positions.data()->data();
}
RIGLESS_EXPORT const double* motion_local(ObjectHandle motion) { return motions[motion].staged.local.data()->data(); }
RIGLESS_EXPORT const double* motion_yaw(ObjectHandle motion) { return motions[motion].staged.yaw.data(); }
