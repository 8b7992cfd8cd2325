// How a body's controls act out a motion: what a deformer needs to make any frame of it.
#pragma once

#include <array>
#include <vector>

#include "rigless/math/types.h"
#include "rigless/motion/contacts.h"
#include "rigless/motion/detail/units.h"
#include "rigless/retarget/detail/example.h"

namespace rigless {

inline constexpr double performance_fps = 30;
inline constexpr double stage_height = person_height;  // how tall a mesh is shown, metres
inline constexpr double default_radius = 0.05;         // of a point of a mesh, in mesh heights

// A run in which the user lets a control stand. A control that is named at all stands in its own runs only; an empty
// run just names it.
struct ContactEdit {
  std::int32_t control = 0;
  FrameRun run = {0, 0};
};

// How a control that no joint moves hangs on the body.
enum class FollowThrough : std::int32_t { stiff, bouncy, floppy };

// How much standing controls slide.
template <class S>
struct Slip {
  S mean = 0;
  S maximum = 0;
};

// T frames of C controls at 30 fps.
template <class S>
struct Performance {
  std::int32_t frames = 0;             // T
  std::vector<Vec3<S>> controls;       // T x C, body-local stage metres
  std::vector<Vec3<S>> turns;          // T x C, by how much controls turn beyond what surrounds them; or none
  std::vector<std::uint8_t> contacts;  // T x C, 1 while the control stands on the ground
  std::vector<Flight> flights;         // do not overlap
  std::vector<S> yaw;                  // T, put back after deforming
  std::vector<std::array<S, 3>>
      travel;                       // T, x and z of the body's origin; how high its lowest vertex is, but in flights
  Slip<S> slip_before, slip_after;  // metres per second, without and with the foot lock

  std::vector<std::uint8_t> source_contacts;  // T x C, before the user's own contacts
  std::vector<S> missed;                      // how far each constraint is missed, metres
  std::vector<std::int32_t> opponents;        // which other constraint each contradicts, or -1
  std::vector<S> coverage;                    // T, how far a frame is from what the user's examples teach, pose spreads
  std::vector<Ask> asks;                      // frames worth teaching next, best first
  std::int32_t have = 0, want = 0;            // user's examples, images counted, and how many would be enough
  std::int32_t starters = 0;                  // examples made up by the system that are in use

  std::size_t control_count() const { return frames > 0 ? controls.size() / to_size(frames) : 0; }
};

// The same in another scalar. Allocates.
template <class T, class S>
RIGLESS_COLD Performance<T> performance_cast(const Performance<S>& from) {
  const auto number = [](S x) { return static_cast<T>(x); };
  Performance<T> to;
  to.frames = from.frames;
  for (const Vec3<S>& p : from.controls) to.controls.push_back(p.template cast<T>());
  for (const Vec3<S>& p : from.turns) to.turns.push_back(p.template cast<T>());
  to.contacts = from.contacts;
  to.flights = from.flights;
  for (const S yaw : from.yaw) to.yaw.push_back(number(yaw));
  for (const auto& at : from.travel) to.travel.push_back({number(at[0]), number(at[1]), number(at[2])});
  to.source_contacts = from.source_contacts;
  for (const S miss : from.missed) to.missed.push_back(number(miss));
  to.opponents = from.opponents;
  for (const S far : from.coverage) to.coverage.push_back(number(far));
  to.asks = from.asks;
  to.have = from.have;
  to.want = from.want;
  to.starters = from.starters;
  to.slip_before = {number(from.slip_before.mean), number(from.slip_before.maximum)};
  to.slip_after = {number(from.slip_after.mean), number(from.slip_after.maximum)};
  return to;
}

}  // namespace rigless
