// From a motion and examples to a performance.
#pragma once

#include "rigless/retarget/foot_lock.h"
#include "rigless/retarget/retarget.h"
#include "rigless/retarget/root_motion.h"
#include "rigless/retarget/starter_examples.h"
#include "rigless/scene/standing_controls.h"

namespace rigless {

template <class S>
struct PerformanceSettings {
  S smoothness = S(0.3);       // lambda_A at 30 fps
  bool ground_contact = true;  // feet that stand do not slide
  bool in_place = false;       // the body does not travel
};

// What a performance is built from. J joints, C controls, N examples.
template <class S>
struct PerformanceInput {
  const StagedMotion<S>* motion = nullptr;
  Span<const std::int32_t> pairs;  // C: joint, or -1: the whole pose
  Span<const Vec3<S>> rest;        // C, controls at rest, stage metres
  S floor = 0;                     // y of the lowest vertex at rest
  S height = 1;                    // of the mesh at rest
  Examples<S> examples;            // the user's; while they are few, starters are added
  PerformanceSettings<S> settings;
};

// begin(), then advance() until it returns false, then finish().
template <class S>
class PerformanceBuilder {
 public:
  // Copies what it needs but the motion, which must live until finish(). Allocates. Errors: no_frames, no_controls,
  // size_mismatch, index_out_of_range (where: control), not_finite (where: example).
  Status begin(const PerformanceInput<S>& input) {
    const StagedMotion<S>& motion = *input.motion;
    const std::int32_t joints = motion.clip.joints();
    if (input.pairs.empty()) return {Error::no_controls, -1};
    if (input.rest.size() != input.pairs.size()) return {Error::size_mismatch, -1};
    ExampleStorage<S> examples;
    examples.joints.assign(input.examples.joints.begin(), input.examples.joints.end());
    examples.controls.assign(input.examples.controls.begin(), input.examples.controls.end());
    const Status started = add_starters<S>(motion.local, joints, input.pairs, input.rest, input.height, {}, examples);
    if (!started.ok()) return started;

    RetargetInput<S> retarget;
    retarget.joints = motion.local;
    retarget.joint_count = joints;
    retarget.pairs = input.pairs;
    retarget.examples = examples.view();
    RetargetOptions<S> options;
    options.fps = static_cast<S>(performance_fps);
    options.smoothness = input.settings.smoothness;
    if (const Status begun = retargeter_.begin(retarget, options); !begun.ok()) return begun;
    motion_ = &motion;
    settings_ = input.settings;
    standing_ = standing_controls(motion, input.pairs, input.rest, input.floor, input.height);
    controls_ = input.pairs.size();
    return {};
  }

  // Works on for about `budget` frames of one control. Returns true while work is left.
  bool advance(std::int32_t budget) { return retargeter_.advance(budget); }
  double progress() const { return retargeter_.progress(); }

  // Allocates. Errors: factorization_failed (where: frame). On failure `out` keeps what it had.
  Status finish(Performance<S>& out) {
    Performance<S> p;
    if (const Status status = retargeter_.finish(p.controls); !status.ok()) return status;
    p.frames = motion_->clip.frames;
    p.flights = motion_->flights;
    p.yaw = motion_->yaw;
    p.contacts.assign(p.controls.size(), 0);
    const std::size_t feet = standing_.control.size();
    for (std::size_t i = 0; i < standing_.labels.size(); ++i)
      p.contacts[track_index(i / feet, i % feet)] = standing_.labels[i];
    if (const Status status = stand(p); !status.ok()) return status;
    if (settings_.in_place) p.travel.assign(p.travel.size(), {S(0), S(0)});
    out = std::move(p);
    return {};
  }

 private:
  std::size_t track_index(std::size_t frame, std::size_t foot) const {
    return frame * controls_ + static_cast<std::size_t>(standing_.control[foot]);
  }

  // The tracks of the standing controls go into the world, get the root motion that keeps them where they stand and are
  // locked there; what the lock moved goes back into the body-local tracks. The height of the root is left behind: only
  // the deformed surface knows what touches the ground.
  Status stand(Performance<S>& p) const {
    const auto frames = static_cast<std::size_t>(p.frames);
    const std::size_t feet = standing_.control.size();
    std::vector<Vec3<S>> world;
    world.reserve(frames * feet);
    for (std::size_t f = 0; f < frames; ++f) {
      for (std::size_t k = 0; k < feet; ++k) {
        world.push_back(from_body<S>(p.controls[track_index(f, k)], Vec3<S>::Zero(), p.yaw[f]));
      }
    }
    RootMotionOptions<S> moving;
    moving.fps = static_cast<S>(performance_fps);
    std::vector<Vec3<S>> root;
    Status status = root_from_contacts<S>(world, standing_.labels, standing_.ground, moving, root);
    if (!status.ok()) return status;
    for (std::size_t i = 0; i < world.size(); ++i) world[i] += root[i / feet];
    for (const Vec3<S>& r : root) p.travel.push_back({r.x(), r.z()});

    const auto slip = [&] {
      return measure_slip<S>(world, standing_.labels, static_cast<std::int32_t>(feet), moving.fps);
    };
    p.slip_before = p.slip_after = slip();
    if (!settings_.ground_contact) return {};
    FootLockOptions<S> holding;
    holding.fps = moving.fps;
    status = lock_feet<S>(world, standing_.labels, standing_.ground, holding);
    if (!status.ok()) return status;
    p.slip_after = slip();
    for (std::size_t i = 0; i < world.size(); ++i) {
      const std::size_t f = i / feet;
      p.controls[track_index(f, i % feet)] = to_body<S>(world[i], root[f], p.yaw[f]);
    }
    return {};
  }

  Retargeter<S> retargeter_;
  const StagedMotion<S>* motion_ = nullptr;
  PerformanceSettings<S> settings_;
  StandingControls<S> standing_;
  std::size_t controls_ = 0;
};

// The whole of it in one call. Allocates. Errors: as begin() and finish(). On failure `out` keeps what it had.
template <class S>
Status build_performance(const PerformanceInput<S>& input, Performance<S>& out) {
  PerformanceBuilder<S> builder;
  if (const Status status = builder.begin(input); !status.ok()) return status;
  while (builder.advance(1 << 20)) {
  }
  return builder.finish(out);
}

}  // namespace rigless
