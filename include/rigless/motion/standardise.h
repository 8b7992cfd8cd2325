// From what a file says to what the library takes: metres, Y up, a root that faces where the body faces.
#pragma once

#include <cstdint>
#include <utility>

#include "rigless/math/span.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/corrections.h"
#include "rigless/motion/detail/first_frame.h"
#include "rigless/motion/detail/length_unit.h"
#include "rigless/motion/detail/root_axes.h"
#include "rigless/motion/detail/units.h"
#include "rigless/motion/detail/up_axis.h"
#include "rigless/motion/joint_roles.h"

namespace rigless {

// What was found and done, so that the user can be told.
template <class S>
struct Standardised {
  JointRoles roles;
  UpAxis up = UpAxis::y;  // of the file
  UnitGuess<S> unit;      // of the file; a factor of 1 for files that state theirs
  bool root_axes_aligned = false;
  std::int32_t pose_in_front = 0;  // frames of the skeleton's rest before the take, which are left out
  bool faced_away = false;         // the clip began so, and was turned around
};

// After parsing, before everything else. `rest` as in ParseNotes, or empty; `said` stands instead of guesses. Allocates
// scratch.
template <class S>
Standardised<S> standardise(Clip<S>& clip, Span<const Vec3<double>> rest, const detail::Corrections& said = {}) {
  constexpr double quarter = 1.57079632679489661923;
  Standardised<S> done;
  if (said.fps > 0) clip.fps = static_cast<S>(said.fps);
  done.pose_in_front = detail::leave_out_pose_in_front(clip, rest);
  done.roles = find_joint_roles(clip);
  detail::correct_roles(clip.skeleton, said, done.roles);
  done.up = said.up >= 0 ? static_cast<UpAxis>(said.up) : detail::guess_up_axis(clip, done.roles, rest);
  detail::turn_upright(clip, done.up);
  done.root_axes_aligned = detail::align_root_axes(clip, done.roles);
  const double to_viewer = detail::turn_to_viewer(clip, done.roles);
  done.faced_away = to_viewer != 0;
  detail::turn_about_y(clip, to_viewer + quarter * said.turns);
  if (said.metres_per_unit > 0)
    done.unit = {static_cast<S>(said.metres_per_unit) / clip.metres_per_unit, LengthUnit::metre};
  else
    done.unit = detail::guess_unit(clip, done.roles);
  detail::scale_clip(clip, done.unit.metres_per_unit);
  return done;
}

}  // namespace rigless
