// The ground under a performance: who stands when, and what that does to the tracks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/retarget/constraints.h"
#include "rigless/retarget/detail/foot_lock.h"
#include "rigless/retarget/detail/root_motion.h"
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
  void begin(const StagedMotion<S>& motion, Span<const std::int32_t> pairs, Span<const Vec3<S>> rest, S floor, S height,
             Span<const ContactEdit> edits, const Span<const Flight>* flights) {
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
  // locked there; what the lock moved goes back into the body-local tracks. The height of the root is left behind: only
  // the deformed surface knows what touches the ground.
  // `root`: T, where the body's origin goes; its height as the controls alone can tell.
  // On failure `p` is half done. Allocates. Errors: those of root_from_contacts() and lock_feet().
  Status stand(const Constraints<S>& constraints, bool lock, Performance<S>& p, std::vector<Vec3<S>>& root) const {
    const auto frames = to_size(p.frames);
    const std::size_t feet = standing_.control.size();
    std::vector<Vec3<S>> world, way;
    world.reserve(frames * feet);
    for (std::size_t f = 0; f < frames; ++f) {
      way.push_back(motion_->clip.at(static_cast<std::int32_t>(f), 0));
      for (std::size_t k = 0; k < feet; ++k) {
        world.push_back(from_body<S>(p.controls[track_index(f, k)], Vec3<S>::Zero(), p.yaw[f]));
      }
    }
    RootMotionOptions<S> moving;
    moving.fps = static_cast<S>(performance_fps);
    Status status = root_from_contacts<S>(world, standing_.labels, standing_.ground, {way, travel_scale}, moving, root);
    if (!status.ok()) return status;
    for (std::size_t i = 0; i < world.size(); ++i) world[i] += root[i / feet];
    for (const Vec3<S>& r : root) p.travel.push_back({r.x(), r.z()});

    const auto slip = [&] {
      return measure_slip<S>(world, standing_.labels, static_cast<std::int32_t>(feet), moving.fps);
    };
    p.slip_before = p.slip_after = slip();
    if (!lock) return {};
    FootLockOptions<S> holding;
    holding.fps = moving.fps;
    status = lock_feet<S>(world, standing_.labels, pins(constraints), standing_.ground, holding);
    if (!status.ok()) return status;
    p.slip_after = slip();
    for (std::size_t i = 0; i < world.size(); ++i) {
      const std::size_t f = i / feet;
      p.controls[track_index(f, i % feet)] = to_body<S>(world[i], root[f], p.yaw[f]);
    }
    return {};
  }

 private:
  std::size_t track_index(std::size_t frame, std::size_t foot) const {
    return frame * controls_ + to_size(standing_.control[foot]);
  }

  // The coordinates of standing controls that constraints hold, as bits: T x K, or empty.
  std::vector<std::uint8_t> pins(const Constraints<S>& constraints) const {
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

  std::vector<std::uint8_t> labels_of_all(const StandingControls<S>& standing) const {
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
