// A motion as the stage takes it: at 30 fps, on the floor, in both frames of reference.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>

#include "rigless/motion/contacts.h"
#include "rigless/motion/detail/body_frame.h"
#include "rigless/motion/detail/close_seam.h"
#include "rigless/motion/detail/resample.h"
#include "rigless/scene/detail/loop.h"
#include "rigless/scene/performance.h"

namespace rigless {

// T frames of J joints at 30 fps.
template <class S>
struct StagedMotion {
  Clip<S> clip;                // the lowest joint of all frames on y = 0; the root begins over x = z = 0
  std::vector<Vec3<S>> local;  // T x J, body-local
  std::vector<S> yaw;          // T
  JointRoles roles;
  std::vector<std::uint8_t> left, right;  // T, 1 while the foot stands; found at the rate of the file
  std::vector<Flight> flights;
  std::int32_t loop_period = 0;    // frames after which it begins again; 0: it does not
  std::int32_t take_frames = 0;    // before it was cut
  std::int32_t source_frames = 0;  // of the file
  S source_fps = 0;
};

// What is danced of a motion: frames at 30 fps, both included, as far as the motion goes.
struct MotionCut {
  std::int32_t first = 0;
  std::int32_t last = std::numeric_limits<std::int32_t>::max();
  bool loop = false;  // the last frame is made the first again
};

// `source`: as standardise() leaves it, with the roles that it found. Allocates. Errors: no_frames; not_finite (where:
// frame of the source); out_of_memory. On failure `out` keeps what it had.
template <class S>
Status stage_motion(const Clip<S>& source, const JointRoles& roles, StagedMotion<S>& out, const MotionCut& cut = {}) {
  for (std::size_t i = 0; i < source.positions.size(); ++i) {
    if (!source.positions[i].allFinite()) {
      return {Error::not_finite, i / source.skeleton.names.size()};
    }
  }
  StagedMotion<S> staged;
  const auto fps = static_cast<S>(performance_fps);
  if (const Status status = detail::resample(source, fps, staged.clip, cut.first, cut.last); !status.ok())
    return status;
  staged.take_frames = detail::resampled_frames(source, fps);
  const std::int32_t frames = staged.clip.frames, first = std::clamp(cut.first, 0, staged.take_frames - frames);
  Vec3<S> origin = staged.clip.at(0, 0);
  for (const Vec3<S>& p : staged.clip.positions) origin.y() = std::min(origin.y(), p.y());
  for (Vec3<S>& p : staged.clip.positions) p -= origin;
  staged.yaw = detail::body_yaw(staged.clip);
  if (cut.loop) detail::close_seam(staged.yaw, staged.clip);
  staged.local = detail::body_local_positions<S>(staged.clip, staged.yaw);
  const Contacts contacts = find_contacts(source, roles);
  staged.left = contact_labels(contacts.left, source.fps, fps, frames, first);
  staged.right = contact_labels(contacts.right, source.fps, fps, frames, first);
  for (const Flight& whole : resample_flights(contacts.flights, source.fps, fps, staged.take_frames)) {
    const Flight flight = {whole.take_off - first, whole.landing - first};
    if (flight.take_off < 0 || flight.landing >= frames) continue;  // a flight begins and ends in the clip
    staged.flights.push_back(flight);
    for (std::int32_t f = flight.take_off + 1; f < flight.landing; ++f) {  // rounded outwards: labels may reach in
      nth(staged.left, f) = nth(staged.right, f) = 0;
    }
  }
  if (cut.loop) {
    staged.left.back() = staged.left.front();
    staged.right.back() = staged.right.front();
  }
  staged.loop_period = detail::loop_period<S>(staged.local, staged.clip.skeleton.names.size());
  staged.roles = roles;
  staged.source_frames = source.frames;
  staged.source_fps = source.fps;
  out = std::move(staged);
  return {};
}

// The first frames of a motion that has more as a motion of its own: a first look at a long one. Allocates.
template <class S>
StagedMotion<S> beginning_of(const StagedMotion<S>& motion, std::int32_t frames) {
  const std::size_t joints = motion.clip.skeleton.names.size();
  StagedMotion<S> first;
  first.clip.skeleton = motion.clip.skeleton;
  first.clip.fps = motion.clip.fps;
  first.clip.frames = first.take_frames = frames;
  first.roles = motion.roles;
  for (std::size_t f = 0; f < to_size(frames); ++f) {
    for (std::size_t i = f * joints; i < (f + 1) * joints; ++i) {
      first.clip.positions.push_back(motion.clip.positions[i]);
      first.local.push_back(motion.local[i]);
    }
    first.yaw.push_back(motion.yaw[f]);
    first.left.push_back(motion.left[f]);
    first.right.push_back(motion.right[f]);
  }
  for (const Flight& flight : motion.flights)
    if (flight.landing < frames) first.flights.push_back(flight);
  return first;
}

}  // namespace rigless
