// A motion as the stage takes it: at 30 fps, on the floor, in both frames of reference.
#pragma once

#include <algorithm>
#include <utility>

#include "rigless/motion/contacts.h"
#include "rigless/motion/detail/body_frame.h"
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
  std::int32_t source_frames = 0;  // of the file
  S source_fps = 0;
};

// `source`: as standardise() leaves it, with the roles that it found. Allocates. Errors: no_frames; not_finite (where:
// frame of the source); out_of_memory. On failure `out` keeps what it had.
template <class S>
Status stage_motion(const Clip<S>& source, const JointRoles& roles, StagedMotion<S>& out) {
  for (std::size_t i = 0; i < source.positions.size(); ++i) {
    if (!source.positions[i].allFinite()) {
      return {Error::not_finite, i / source.skeleton.names.size()};
    }
  }
  StagedMotion<S> staged;
  if (const Status status = detail::resample(source, static_cast<S>(performance_fps), staged.clip); !status.ok())
    return status;
  Vec3<S> origin = staged.clip.at(0, 0);
  for (const Vec3<S>& p : staged.clip.positions) origin.y() = std::min(origin.y(), p.y());
  for (Vec3<S>& p : staged.clip.positions) p -= origin;
  staged.yaw = detail::body_yaw(staged.clip);
  staged.local = detail::body_local_positions<S>(staged.clip, staged.yaw);
  staged.loop_period = detail::loop_period<S>(staged.local, staged.clip.skeleton.names.size());
  staged.roles = roles;
  const Contacts contacts = find_contacts(source, roles);
  const auto fps = static_cast<S>(performance_fps);
  staged.flights = resample_flights(contacts.flights, source.fps, fps, staged.clip.frames);
  staged.left = contact_labels(contacts.left, source.fps, fps, staged.clip.frames);
  staged.right = contact_labels(contacts.right, source.fps, fps, staged.clip.frames);
  for (const Flight& flight : staged.flights) {  // rounded outwards, so the labels may reach in
    for (std::int32_t f = flight.take_off + 1; f < flight.landing; ++f) {
      nth(staged.left, f) = nth(staged.right, f) = 0;
    }
  }
  staged.source_frames = source.frames;
  staged.source_fps = source.fps;
  out = std::move(staged);
  return {};
}

}  // namespace rigless
