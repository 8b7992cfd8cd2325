// When each foot stands, and when the body flies, from the motion alone.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/free_fall.h"
#include "rigless/motion/detail/signal.h"
#include "rigless/motion/detail/standing_feet.h"
#include "rigless/motion/joint_roles.h"

namespace rigless {

// Frames [begin, end).
struct FrameRun {
  std::int32_t begin;
  std::int32_t end;
};

// From the last supported frame to the first supported frame after it.
struct Flight {
  std::int32_t take_off;
  std::int32_t landing;
};

struct Contacts {
  std::vector<FrameRun> left;
  std::vector<FrameRun> right;
  std::vector<Flight> flights;
};

// At the clip's own rate; lengths in metres, Y up. A foot stands while one of its joints is slow, measured by the feet
// and the legs of this clip, and low, or carries the body on a block. Where none does and the body falls freely it
// flies. Without foot roles there are no runs and no flights. A run that the clip's first or last frame cuts is kept
// however short; a flight begins and ends inside the clip. Allocates. Source: as measured, see detail/standing_feet.h.
template <class S>
Contacts find_contacts(const Clip<S>& clip, const JointRoles& roles);

// `frames` labels from the frame `first` on, 1 where the nearest source frame is in a run. Allocates the result.
template <class S>
std::vector<std::uint8_t> contact_labels(const std::vector<FrameRun>& runs, S source_fps, S fps, std::int32_t frames,
                                         std::int32_t first = 0);

// Flights inside the clip, in order, none over another and none without a frame in the air. Allocates.
inline std::vector<Flight> tidy_flights(Span<const Flight> flights, std::int32_t frames);

// The same flights at another rate, outwards to whole frames; those that fall together to nothing are gone. Allocates.
template <class S>
std::vector<Flight> resample_flights(const std::vector<Flight>& flights, S source_fps, S fps, std::int32_t frames);

// ---------------------------------------------------------------------------------------------------------------------

}  // namespace rigless

namespace rigless::detail {

inline std::vector<FrameRun> label_runs(const FrameLabels& on) {
  std::vector<FrameRun> found;
  for (std::size_t begin = 0, end = 0; begin < on.size(); begin = end) {
    end = run_end(on, begin);
    if (on[begin] != 0) found.push_back({static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end)});
  }
  return found;
}

// Where no foot stands and the body falls nearly freely, taken over the whole time: its limbs may flail. Short ones are
// noise; what the clip's ends cut is nobody's throw.
template <class S>
std::vector<Flight> find_flights(const Clip<S>& clip, const JointRoles& roles,
                                 const std::array<FrameLabels, 2>& standing) {
  const S fall = S(-6.2) * leg_length(clip, roles);  // 0.6 g for a leg of 0.95 m; flights have 0.9, all else 0.4
  const std::vector<S> centre = mass_heights(clip, roles);
  std::vector<Flight> found;
  std::int32_t supported = clip.frames;  // the last frame that was
  for (std::int32_t f = 0; f < clip.frames; ++f) {
    const auto frame = static_cast<std::size_t>(f);
    if (standing[0][frame] == 0 && standing[1][frame] == 0) continue;
    const bool gap = f > supported + 1 && static_cast<S>(f - supported) >= Standing<S>::shortest * clip.fps;
    if (gap && parabola_acceleration(centre, static_cast<std::size_t>(supported), frame, clip.fps) < fall)
      found.push_back({supported, f});
    supported = f;
  }
  return found;
}

}  // namespace rigless::detail

namespace rigless {

template <class S>
Contacts find_contacts(const Clip<S>& clip, const JointRoles& roles) {
  const std::array<detail::FrameLabels, 2> standing = detail::find_standing(clip, roles);
  if (standing[0].empty()) return {};
  return {detail::label_runs(standing[0]), detail::label_runs(standing[1]),
          detail::find_flights(clip, roles, standing)};
}

template <class S>
std::vector<std::uint8_t> contact_labels(const std::vector<FrameRun>& runs, S source_fps, S fps, std::int32_t frames,
                                         std::int32_t first) {
  std::vector<std::uint8_t> labels(static_cast<std::size_t>(frames), 0);
  for (std::int32_t f = 0; f < frames; ++f) {
    const std::int32_t source = static_cast<std::int32_t>(std::lround(static_cast<S>(first + f) * source_fps / fps));
    for (const FrameRun& run : runs)
      if (source >= run.begin && source < run.end) labels[static_cast<std::size_t>(f)] = 1;
  }
  return labels;
}

inline std::vector<Flight> tidy_flights(Span<const Flight> flights, std::int32_t frames) {
  std::vector<Flight> sorted(flights.begin(), flights.end()), tidy;
  for (std::size_t i = 1; i < sorted.size(); ++i)  // few: std::sort would bring a kilobyte of wasm
    for (std::size_t k = i; k > 0 && sorted[k].take_off < sorted[k - 1].take_off; --k)
      std::swap(sorted[k], sorted[k - 1]);
  for (const Flight& flight : sorted) {
    const std::int32_t first = std::max(flight.take_off, tidy.empty() ? 0 : tidy.back().landing);
    const std::int32_t last = std::min(flight.landing, frames - 1);
    if (last > first + 1) tidy.push_back({first, last});
  }
  return tidy;
}

template <class S>
std::vector<Flight> resample_flights(const std::vector<Flight>& flights, S source_fps, S fps, std::int32_t frames) {
  const S ratio = fps / source_fps;
  std::vector<Flight> result;
  for (const Flight& flight : flights) {
    // The small number keeps rates such as 120.00048 from moving a frame that falls on a frame.
    const S take_off = std::floor(static_cast<S>(flight.take_off) * ratio + S(0.02));
    const S landing = std::ceil(static_cast<S>(flight.landing) * ratio - S(0.02));
    const std::int32_t last = std::min(static_cast<std::int32_t>(landing), frames - 1);
    if (last > static_cast<std::int32_t>(take_off) + 1) result.push_back({static_cast<std::int32_t>(take_off), last});
  }
  return result;
}

}  // namespace rigless
