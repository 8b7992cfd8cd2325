// When each foot stands, and when the body flies, from the motion alone.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/signal.h"
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

template <class S>
struct ContactOptions {
  S height = S(0.04);          // metres above its floor up to which a foot stands
  S speed = S(0.7);            // metres per second below which it stands
  S floor_window = S(1.4);     // seconds over which the lowest point is its floor: floors of captures drift and climb
  S smoothing = S(0.05);       // seconds
  S shortest = S(0.06);        // seconds; shorter runs, gaps and flights are noise
  S step = S(0.2);             // metres between the floors of the two feet; a foot that rests higher is held in the air
  S flight_height = S(0.045);  // metres above the floor that both feet keep in flight
  S flight_acceleration = S(-5.886);  // -0.6 g: what the mean of the joints reaches in flight
  S flight_window = S(0.1);           // seconds over which the acceleration is fitted
};

struct Contacts {
  std::vector<FrameRun> left;
  std::vector<FrameRun> right;
  std::vector<Flight> flights;
};

// At the clip's own rate; lengths in metres, Y up. A foot stands while one of its joints is low and slow; without foot
// roles both runs are empty and so are the flights. A run that the clip's first or last frame cuts is kept however
// short; a flight must begin and end half a flight window inside the clip. Allocates. Source: floor and thresholds as
// measured on CMU 02_01, 02_03, 02_04; at 30 fps and more.
template <class S>
Contacts find_contacts(const Clip<S>& clip, const JointRoles& roles, const ContactOptions<S>& options = {});

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

template <class S>
class ContactFinder {
 public:
  ContactFinder(const Clip<S>& clip, const ContactOptions<S>& options)
      : clip_(clip),
        options_(options),
        shortest_(std::max(1, static_cast<std::int32_t>(options.shortest * clip.fps))) {}

  Contacts find(const JointRoles& roles) {
    const std::array<std::vector<std::int32_t>, 2> feet = {foot_joints(roles.left), foot_joints(roles.right)};
    Contacts contacts;
    if (clip_.frames == 0 || feet[0].empty() || feet[1].empty()) return contacts;
    find_floor(feet);
    const std::vector<std::uint8_t> left = standing(feet[0]);
    const std::vector<std::uint8_t> right = standing(feet[1]);
    contacts.left = runs(left);
    contacts.right = runs(right);
    contacts.flights = flights(left, right);
    return contacts;
  }

 private:
  // What touches the ground: ball and tip, or ankle and end of a foot without a ball. The ankle of a foot with a ball
  // would call the heel's swing into the ground a contact.
  static std::vector<std::int32_t> foot_joints(const LimbRoles& limb) {
    std::vector<std::int32_t> joints;
    for (const std::int32_t j : {limb.tip >= 0 ? -1 : limb.ankle, limb.toe, limb.tip})
      if (j >= 0) joints.push_back(j);
    return joints;
  }

  std::vector<S> coordinate(std::int32_t joint, std::int32_t axis) const {
    std::vector<S> x;
    x.reserve(static_cast<std::size_t>(clip_.frames));
    for (std::int32_t f = 0; f < clip_.frames; ++f) x.push_back(clip_.at(f, joint)[axis]);
    return x;
  }
  std::vector<S> smooth(const std::vector<S>& x) const {
    return running_mean(x, half_window(options_.smoothing, clip_.fps));
  }
  std::vector<S> floor_under(const std::vector<S>& y) const {
    return running_minimum(y, half_window(options_.floor_window, clip_.fps));
  }

  // The lowest foot joint, and how low it comes nearby.
  void find_floor(const std::array<std::vector<std::int32_t>, 2>& feet) {
    lowest_ = coordinate(feet[0][0], 1);
    for (const std::vector<std::int32_t>& joints : feet) {
      for (const std::int32_t j : joints) {
        const std::vector<S> y = coordinate(j, 1);
        for (std::size_t f = 0; f < y.size(); ++f) lowest_[f] = std::min(lowest_[f], y[f]);
      }
    }
    floor_ = floor_under(lowest_);
  }

  std::vector<std::uint8_t> standing(const std::vector<std::int32_t>& joints) const {
    std::vector<std::uint8_t> on(static_cast<std::size_t>(clip_.frames), 0);
    for (const std::int32_t joint : joints) {
      const std::array<std::vector<S>, 3> p = {smooth(coordinate(joint, 0)), smooth(coordinate(joint, 1)),
                                               smooth(coordinate(joint, 2))};
      const std::vector<S> floor = floor_under(p[1]);
      for (std::size_t f = 0; f < on.size(); ++f) {
        const std::size_t a = f == 0 ? 0 : f - 1;
        const std::size_t b = std::min(f + 1, on.size() - 1);
        const Vec3<S> move(p[0][b] - p[0][a], p[1][b] - p[1][a], p[2][b] - p[2][a]);
        const bool slow = move.norm() * clip_.fps <= options_.speed * static_cast<S>(b - a);
        const bool low = p[1][f] < floor[f] + options_.height;
        const bool grounded = floor[f] < floor_[f] + options_.step;
        if (slow && low && grounded) on[f] = 1;
      }
    }
    drop_short(on, 0);
    drop_short(on, 1);
    return on;
  }

  // Runs of `value` that are too short take the other one, except at the ends.
  void drop_short(std::vector<std::uint8_t>& on, std::uint8_t value) const {
    for (std::size_t begin = 0, end = 0; begin < on.size(); begin = end) {
      for (end = begin; end < on.size() && on[end] == on[begin];) ++end;
      if (on[begin] != value || begin == 0 || end == on.size()) continue;
      if (end - begin >= static_cast<std::size_t>(shortest_)) continue;
      std::fill(on.begin() + static_cast<std::ptrdiff_t>(begin), on.begin() + static_cast<std::ptrdiff_t>(end),
                static_cast<std::uint8_t>(1 - value));
    }
  }

  static std::vector<FrameRun> runs(const std::vector<std::uint8_t>& on) {
    std::vector<FrameRun> found;
    for (std::size_t begin = 0, end = 0; begin < on.size(); begin = end) {
      for (end = begin; end < on.size() && on[end] == on[begin];) ++end;
      if (on[begin] != 0) found.push_back({static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end)});
    }
    return found;
  }

  std::vector<S> mean_height() const {
    std::vector<S> mean(static_cast<std::size_t>(clip_.frames), 0);
    for (std::size_t i = 0; i < clip_.positions.size(); ++i)
      mean[i / clip_.skeleton.names.size()] += clip_.positions[i].y() / static_cast<S>(clip_.joints());
    return mean;
  }

  // A flight is where no foot stands, both are high and the body is falling; somewhere in it, it falls nearly freely.
  std::vector<Flight> flights(const std::vector<std::uint8_t>& left, const std::vector<std::uint8_t>& right) const {
    const std::int32_t half = std::max(1, half_window(options_.flight_window, clip_.fps));
    const std::vector<S> acceleration = parabola_acceleration(mean_height(), half, clip_.fps);
    std::vector<std::uint8_t> airborne(left.size(), 0);
    for (std::size_t f = 0; f < airborne.size(); ++f) {
      const bool high = lowest_[f] > floor_[f] + options_.flight_height;
      airborne[f] = high && left[f] == 0 && right[f] == 0 && acceleration[f] < 0 ? 1 : 0;
    }
    std::vector<Flight> found;
    for (const FrameRun& run : runs(airborne)) {
      const auto first = acceleration.begin() + run.begin;
      const bool free = *std::min_element(first, acceleration.begin() + run.end) < options_.flight_acceleration;
      const bool whole = run.begin >= half && run.end <= clip_.frames - half;  // beyond, the fit is a guess
      if (free && whole && run.end - run.begin >= shortest_) found.push_back({run.begin - 1, run.end});
    }
    return found;
  }

  const Clip<S>& clip_;
  const ContactOptions<S>& options_;
  std::int32_t shortest_;  // frames
  std::vector<S> lowest_;  // T, height of the lowest foot joint
  std::vector<S> floor_;   // T
};

}  // namespace rigless::detail

namespace rigless {

template <class S>
Contacts find_contacts(const Clip<S>& clip, const JointRoles& roles, const ContactOptions<S>& options) {
  return detail::ContactFinder<S>(clip, options).find(roles);
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
