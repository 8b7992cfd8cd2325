// The ground under a performance: who stands when, and what that does to the tracks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/retarget/constraints.h"
#include "rigless/retarget/detail/foot_lock.h"
#include "rigless/retarget/detail/root_motion.h"
#include "rigless/scene/detail/loop.h"
#include "rigless/scene/detail/slip.h"
#include "rigless/scene/detail/standing_controls.h"

namespace rigless::detail {

template <class S>
class Ground {
 public:
  S travel_scale = 1;  // body's way over human's, where nothing stands to tell

  // Who stands when, with what the user said about it: runs, and flights in which nothing stands but what those runs
  // say (null: the flights of the motion). pairs, rest: C; floor: y of the lowest vertex at rest; height: of the mesh.
  // The motion must live as long as this is used. Allocates.
  RIGLESS_COLD void begin(const StagedMotion<S>& motion, Span<const std::int32_t> pairs, Span<const Vec3<S>> rest,
                          S floor, S height, Span<const ContactEdit> edits, const Span<const Flight>* flights) {
    motion_ = &motion;
    controls_ = pairs.size();
    const std::int32_t frames = motion.clip.frames;
    source_ = standing_ = standing_controls(motion, pairs, rest, floor, height);
    flights_ = motion.flights;
    if (flights != nullptr) {
      flights_ = tidy_flights(*flights, frames);
      const std::size_t feet = standing_.control.size();
      for (const Flight& flight : flights_) {
        const auto in_air = [&](std::int32_t f) {
          return standing_.labels.begin() + static_cast<std::ptrdiff_t>(to_size(f) * feet);
        };
        std::fill(in_air(flight.take_off + 1), in_air(flight.landing), std::uint8_t{0});
      }
    }
    edit_standing<S>(edits, rest, floor, frames, standing_);
  }

  // T x C, 1 while a control stands: with the user's runs, and as the motion has it. Allocates.
  std::vector<std::uint8_t> labels() const { return labels_of_all(standing_); }
  std::vector<std::uint8_t> source_labels() const { return labels_of_all(source_); }
  const std::vector<Flight>& flights() const { return flights_; }

  // The tracks of the standing controls go into the world, get the root motion that keeps them where they stand and are
  // locked there; what the lock moved goes back into the body-local tracks. Of a loop all this is done with some of the
  // laps before and after it. The height of the root is left behind: only the deformed surface knows what touches the
  // ground.
  // `root`: T, where the body's origin goes; its height as the controls alone can tell.
  // On failure `p` is half done. Allocates. Errors: those of root_from_contacts() and lock_feet().
  RIGLESS_COLD Status stand(const Constraints<S>& constraints, bool lock, Performance<S>& p,
                            std::vector<Vec3<S>>& root) const {
    const std::size_t feet = standing_.control.size();
    const LapMargin laps = {p.frames, motion_->loop_period, longest_stance};
    const std::size_t before = to_size(laps.margin()), own = to_size(p.frames) * feet;
    const S lap_turn = turn_of_lap(p.yaw);
    const std::vector<std::uint8_t> pinned = pins(constraints);
    std::vector<Vec3<S>> world, way;
    std::vector<std::uint8_t> stands, held;
    for (std::int32_t f = -laps.margin(); f < p.frames + laps.margin(); ++f) {
      const std::int32_t g = frame_around(f, p.frames, laps.period), to = std::max(g > 0 ? g : p.frames - 1, 1);
      const S turn = f == g ? S(0) : static_cast<S>((f - g) / laps.period) * lap_turn;
      way.push_back(way.empty() ? Vec3<S>(Vec3<S>::Zero()) : way.back());
      if (p.frames > 1) {
        const Vec3<S> step = motion_->clip.at(to, 0) - motion_->clip.at(to - 1, 0);
        way.back() += from_body<S>(step, Vec3<S>::Zero(), g > 0 ? turn : turn - lap_turn);
      }
      for (std::size_t k = 0; k < feet; ++k) {
        const std::size_t i = to_size(g) * feet + k;
        const Vec3<S>& local = p.controls[track_index(to_size(g), k)];
        world.push_back(from_body<S>(local, Vec3<S>::Zero(), nth(p.yaw, g) + turn));
        stands.push_back(standing_.labels[i]);
        if (!pinned.empty()) held.push_back(pinned[i]);
      }
    }
    RootMotionOptions<S> moving;
    moving.fps = static_cast<S>(performance_fps);
    std::vector<Vec3<S>> wound;
    Status status = root_from_contacts<S>(world, stands, standing_.ground, {way, travel_scale}, moving, wound);
    if (!status.ok()) return status;
    const Vec3<S> begin = before > 0 ? Vec3<S>(wound[before].x(), 0, wound[before].z()) : Vec3<S>(Vec3<S>::Zero());
    for (Vec3<S>& r : wound) r -= begin;
    for (std::size_t i = 0; i < world.size(); ++i) world[i] += wound[i / feet];
    const auto first = wound.begin() + static_cast<std::ptrdiff_t>(before);
    root.assign(first, first + p.frames);
    const std::vector<S> lift = lifts();
    for (std::int32_t f = 0; f < p.frames; ++f) p.travel.push_back({nth(root, f).x(), nth(root, f).z(), nth(lift, f)});

    const auto slip = [&] {
      return measure_slip<S>({world.data() + before * feet, own}, standing_.labels, static_cast<std::int32_t>(feet),
                             moving.fps);
    };
    p.slip_before = p.slip_after = slip();
    if (!lock) return {};
    FootLockOptions<S> holding;
    holding.fps = moving.fps;
    status = lock_feet<S>(world, stands, held, standing_.ground, holding);
    if (!status.ok()) return status;
    p.slip_after = slip();
    for (std::size_t i = 0; i < own; ++i) {
      const std::size_t f = i / feet;
      p.controls[track_index(f, i % feet)] = to_body<S>(world[before * feet + i], root[f], p.yaw[f]);
    }
    return {};
  }

 private:
  static constexpr std::int32_t longest_stance = 60;  // frames: a loop's stances are whole on both sides of its seam

  // T: how far the human is above what it stood on before and will stand on, in the model's size; 0 where it stands or
  // flies. Allocates.
  RIGLESS_COLD std::vector<S> lifts() const {
    const std::size_t feet = standing_.control.size();
    const std::int32_t frames = motion_->clip.frames, period = motion_->loop_period;
    std::vector<S> lowest, lift(to_size(frames), S(-1));
    for (std::int32_t f = 0; f < frames; ++f) {
      lowest.push_back(motion_->clip.at(f, 0).y());
      for (std::int32_t j = 1; j < motion_->clip.joints(); ++j)
        lowest.back() = std::min(lowest.back(), motion_->clip.at(f, j).y());
    }
    const auto stands = [&](std::int32_t f) {
      const auto labels = standing_.labels.begin() + static_cast<std::ptrdiff_t>(to_size(f) * feet);
      return std::count(labels, labels + static_cast<std::ptrdiff_t>(feet), 1) > 0;
    };
    for (const std::int32_t way : {1, -1}) {  // from where it stood last, then from where it stands next
      std::int32_t stood = -1;
      for (std::int32_t k = -period; k < frames; ++k) {
        const std::int32_t f = way > 0 ? k : frames - 1 - k, g = frame_around(f, frames, period);
        if (stands(g)) stood = g;
        if (k < 0 || stood < 0) continue;
        const S above = std::max(nth(lowest, f) - nth(lowest, stood), S(0));
        nth(lift, f) = nth(lift, f) < S(0) ? above : std::min(nth(lift, f), above);
      }
    }
    for (S& above : lift) above = travel_scale * std::max(above, S(0));
    for (const Flight& flight : flights_)
      for (std::int32_t f = flight.take_off + 1; f < flight.landing; ++f) nth(lift, f) = 0;
    return lift;
  }

  // What a loop turns until it begins again.
  S turn_of_lap(const std::vector<S>& yaw) const {
    const bool twice = motion_->loop_period < motion_->clip.frames || yaw.size() < 2;  // the last frame is the first
    return yaw.back() - yaw.front() + (twice ? S(0) : yaw.back() - yaw[yaw.size() - 2]);
  }

  std::size_t track_index(std::size_t frame, std::size_t foot) const {
    return frame * controls_ + to_size(standing_.control[foot]);
  }

  // The coordinates of standing controls that constraints hold, as bits: T x K, or empty.
  RIGLESS_COLD std::vector<std::uint8_t> pins(const Constraints<S>& constraints) const {
    const std::size_t feet = standing_.control.size();
    std::vector<std::uint8_t> pins(!constraints.empty() ? standing_.labels.size() : 0, 0);
    for (const Constraint<S>& c : constraints) {
      if (c.from) continue;
      for (std::size_t k = 0; k < feet; ++k) {
        if (standing_.control[k] != c.at.track) continue;
        for (int axis = 0; axis < 3; ++axis)
          if (nth(c.axes, axis)) pins[to_size(c.at.frame) * feet + k] |= static_cast<std::uint8_t>(1 << axis);
      }
    }
    return pins;
  }

  RIGLESS_COLD std::vector<std::uint8_t> labels_of_all(const StandingControls<S>& standing) const {
    const std::size_t feet = standing.control.size();
    std::vector<std::uint8_t> labels(to_size(motion_->clip.frames) * controls_, 0);
    for (std::size_t i = 0; i < standing.labels.size(); ++i)
      labels[i / feet * controls_ + to_size(standing.control[i % feet])] = standing.labels[i];
    return labels;
  }

  const StagedMotion<S>* motion_ = nullptr;
  std::size_t controls_ = 0;
  StandingControls<S> source_, standing_;  // as in the motion, and with what the user said
  std::vector<Flight> flights_;
};

}  // namespace rigless::detail
