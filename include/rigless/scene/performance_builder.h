// From a motion and examples to a performance.
#pragma once

#include "rigless/motion/detail/mirror_joints.h"
#include "rigless/retarget/detail/coverage.h"
#include "rigless/retarget/detail/example_size.h"
#include "rigless/retarget/detail/mirror_examples.h"
#include "rigless/retarget/detail/pose_spread.h"
#include "rigless/retarget/detail/starter_examples.h"
#include "rigless/retarget/retarget.h"
#include "rigless/scene/detail/accents.h"
#include "rigless/scene/detail/follow_through.h"
#include "rigless/scene/detail/ground.h"
#include "rigless/scene/detail/weight.h"

namespace rigless {

template <class S>
struct PerformanceSettings {
  S smoothness = S(default_smoothness);  // lambda_A at 30 fps
  bool ground_contact = true;            // feet that stand do not slide, and carry a weight
  bool in_place = false;                 // the body does not travel
  S energy = 0;                          // -1 calm, 0 as taught, 1 as in a cartoon
  bool paper = false;                    // as in the paper: RetargetOptions::thesis(), and no accents of the human's
};

// What a performance is built from. J joints, C controls, N examples.
template <class S>
struct PerformanceInput {
  const StagedMotion<S>* motion = nullptr;
  Span<const std::int32_t> pairs;    // C: joint, or -1: the whole pose
  Span<const Vec3<S>> rest;          // C, controls at rest, stage metres
  Span<const ModelLimb<S>> limbs;    // C: what each control is the end of; or empty
  Span<const FollowThrough> follow;  // C: how those without a joint hang on the body; or empty: stiff
  Span<const S> pose_weights;        // C: as in RetargetInput; or empty
  S floor = 0;                       // y of the lowest vertex at rest
  S height = 1;                      // of the mesh at rest
  Examples<S> examples;              // the user's; while they are few, starters are added
  PerformanceSettings<S> settings;
  Constraints<S> constraints;                   // of controls, body-local stage metres (per frame)
  Span<const ContactEdit> contacts;             // the user's own, of the controls that they name
  const Span<const Flight>* flights = nullptr;  // the user's own; null: those of the motion
  Span<const std::int32_t> mirror;              // C: partner, itself on the plane, -1: none. Empty: no mirror images
  Vec3<S> mirror_normal = Vec3<S>::UnitX();     // of the mesh's plane
  bool turns = false;                           // turn() will be asked for
};

// begin(), then advance() until it returns false, then finish().
template <class S>
class PerformanceBuilder {
 public:
  // Copies what it needs but the motion, which must live until finish(). Allocates. Errors: no_frames, no_controls,
  // size_mismatch, index_out_of_range (where: control), not_finite (where: example), bad_constraint; then
  // this must begin again before it goes on.
  Status begin(const PerformanceInput<S>& input) {
    const StagedMotion<S>& motion = *input.motion;
    const std::int32_t joints = motion.clip.joints();
    if (const Status status = check(input); !status.ok()) return status;
    std::vector<detail::ConstraintRow<S>> rows;  // checked on the clip itself: the solver knows frames around it too
    const Status holds = detail::constraint_rows(input.constraints, motion.clip.frames, count_of(input.pairs), rows);
    if (!holds.ok()) return holds;
    ExampleStorage<S> examples;
    examples.joints.assign(input.examples.joints.begin(), input.examples.joints.end());
    examples.controls.assign(input.examples.controls.begin(), input.examples.controls.end());
    detail::scale_to_actor<S>(motion.clip.skeleton.parents, {motion.local.data(), to_size(joints)}, examples.joints);
    const std::vector<std::int32_t> paired = detail::paired_joints(input.pairs, joints);
    detail::fill_unknown_joints<S>(motion.local, paired, joints, examples.joints);
    std::vector<std::int32_t> joint_mirror;
    if (!input.mirror.empty()) {
      joint_mirror = detail::mirror_joints(motion.clip.skeleton, motion.roles);
      detail::add_mirror_images<S>({joint_mirror, input.mirror, input.mirror_normal.normalized()}, input.rest,
                                   examples);
    }
    const std::size_t taught = examples.joints.size();
    motion_ = &motion;
    controls_ = input.pairs.size();
    ground_.begin(motion, input.pairs, input.rest, input.floor, input.height, input.contacts, input.flights);
    const std::vector<std::uint8_t> stands = ground_.labels();
    const detail::StarterFigure<S> figure(motion.local, motion.clip.skeleton, motion.roles);
    const Status started = detail::add_starters<S>(
        motion.local, joints, input.pairs, figure, {input.rest, input.floor, input.height, stands, input.limbs},
        static_cast<std::int32_t>(input.examples.controls.size() / controls_), {}, examples);
    if (!started.ok()) return started;

    detail::exaggerate<S>(input.rest, input.settings.energy, examples.controls);
    laps_ = {motion.clip.frames, motion.loop_period};
    std::vector<Vec3<S>> wound;
    RetargetInput<S> retarget;
    retarget.joints = laps_.wind<S>(motion.local, to_size(joints), wound);
    retarget.joint_count = joints;
    retarget.pairs = input.pairs;
    retarget.examples = examples.view();
    retarget.constraints = input.constraints;
    laps_.shift(retarget.constraints);
    retarget.pose_weights = input.pose_weights;
    RetargetOptions<S> options = input.settings.paper ? RetargetOptions<S>::thesis() : RetargetOptions<S>();
    options.fps = static_cast<S>(performance_fps);
    options.smoothness = input.settings.smoothness;
    options.keep_weights = input.turns;
    if (const Status begun = retargeter_.begin(retarget, options); !begun.ok()) return begun;
    settings_ = input.settings;
    pairs_.assign(input.pairs.begin(), input.pairs.end());
    follow_.assign(input.follow.begin(), input.follow.end());
    rest_.assign(input.rest.begin(), input.rest.end());
    floor_ = input.floor;
    height_ = input.height;
    constraints_ = input.constraints;
    ground_.travel_scale = input.height / std::max(detail::figure_height<S>(motion.local, joints), S(1e-6));
    starters_ = static_cast<std::int32_t>((examples.joints.size() - taught) / to_size(joints));
    coverage_.begin(motion.local, joints, paired, {examples.joints.data(), taught}, joint_mirror, {});
    return {};
  }

  // Works on for about `budget` frames of one control. Returns true while work is left.
  bool advance(std::int32_t budget) { return retargeter_.advance(budget) || coverage_.advance(budget); }
  double progress() const { return retargeter_.progress(); }

  // Allocates. Errors: factorization_failed (where: frame). On failure `out` keeps what it had.
  Status finish(Performance<S>& out) {
    Performance<S> p;
    if (const Status status = retargeter_.finish(p.controls); !status.ok())
      return {status.error, std::max(status.where - laps_.margin(), 0)};
    p.frames = motion_->clip.frames;
    laps_.unwind(p.controls);
    p.flights = ground_.flights();
    p.yaw = motion_->yaw;
    p.contacts = ground_.labels();
    p.source_contacts = ground_.source_labels();
    const std::vector<double> freedom =
        detail::freedom_of(detail::held_controls(constraints_, p), controls_, p.frames, motion_->loop_period);
    if (!settings_.paper) detail::give_accents<S>(*motion_, pairs_, freedom, settings_.energy, p);
    std::vector<Vec3<S>> root;
    if (const Status status = ground_.stand(constraints_, settings_.ground_contact, p, root); !status.ok())
      return status;
    if (settings_.ground_contact) {
      const detail::Rise<S> rise = detail::rise_of<S>(*motion_, laps_, ground_.travel_scale, height_);
      detail::give_weight<S>(rise, rest_, floor_, height_, freedom, root, p.controls);
    }
    detail::follow_through<S>(follow_, root, height_, motion_->loop_period > 0, p);
    laps_.close(p.controls);
    if (settings_.in_place)
      for (auto& at : p.travel) at[0] = at[1] = 0;
    measure_constraints(p);
    p.opponents.assign(retargeter_.opponents().begin(), retargeter_.opponents().end());
    p.coverage.assign(coverage_.coverage().begin(), coverage_.coverage().end());
    p.asks = coverage_.asks();
    p.have = coverage_.have();
    p.want = coverage_.want();
    p.starters = starters_;
    out = std::move(p);
    return {};
  }

  // After finish(), where the input asked for turns: control c of what was made turns as its examples do. turns:
  // rotation vectors of the first of the examples that know it; the others do not turn it. Allocates.
  template <class T>
  RIGLESS_COLD void turn(std::int32_t c, Span<const Vec3<T>> turns, Performance<T>& made) const {
    const Span<const double> wound = retargeter_.weights(c);
    const auto margin = to_size(laps_.margin()), frames = to_size(laps_.frames);
    const std::size_t examples = wound.size() / (frames + 2 * margin);
    made.turns.resize(made.controls.size(), Vec3<T>::Zero());
    for (std::size_t f = 0; f < frames; ++f)
      for (std::size_t n = 0; n < turns.size(); ++n)
        made.turns[f * controls_ + to_size(c)] += static_cast<T>(wound[(margin + f) * examples + n]) * turns[n];
  }

 private:
  RIGLESS_COLD static Status check(const PerformanceInput<S>& in) {
    const auto controls = count_of(in.pairs);
    if (controls == 0) return {Error::no_controls, -1};
    if (in.rest.size() != in.pairs.size()) return {Error::size_mismatch, -1};
    if (!in.mirror.empty() && in.mirror.size() != in.pairs.size()) return {Error::size_mismatch, -1};
    if (!in.follow.empty() && in.follow.size() != in.pairs.size()) return {Error::size_mismatch, -1};
    const std::size_t examples = in.examples.controls.size() / in.pairs.size();
    if (in.examples.controls.size() != examples * in.pairs.size() ||
        in.examples.joints.size() != examples * to_size(in.motion->clip.joints()))
      return {Error::size_mismatch, -1};
    for (std::int32_t c = 0; c < controls; ++c) {
      const auto i = to_size(c);
      if (in.pairs[i] < -1 || in.pairs[i] >= in.motion->clip.joints()) return {Error::index_out_of_range, c};
      if (!in.mirror.empty() && (in.mirror[i] < -1 || in.mirror[i] >= controls)) return {Error::index_out_of_range, c};
    }
    for (const ContactEdit& edit : in.contacts)
      if (edit.control < 0 || edit.control >= controls) return {Error::index_out_of_range, edit.control};
    for (std::size_t i = 0; i < in.examples.controls.size(); ++i)
      if (!in.examples.controls[i].allFinite()) return {Error::not_finite, i / in.pairs.size()};
    return {};
  }

  // On the finished tracks, so that what the ground asks for counts too.
  RIGLESS_COLD void measure_constraints(Performance<S>& p) const {
    const auto at = [&](const TrackFrame& t) { return p.controls[to_size(t.frame) * controls_ + to_size(t.track)]; };
    for (const Constraint<S>& c : constraints_) {
      Vec3<S> miss = at(c.at) - c.value;
      if (c.from) miss -= at(*c.from);
      for (int axis = 0; axis < 3; ++axis)
        if (!nth(c.axes, axis)) miss[axis] = 0;
      p.missed.push_back(miss.norm());
    }
  }

  Retargeter<S> retargeter_;
  detail::PoseCoverage coverage_;
  const StagedMotion<S>* motion_ = nullptr;
  PerformanceSettings<S> settings_;
  Constraints<S> constraints_;
  detail::Ground<S> ground_;
  std::vector<std::int32_t> pairs_;    // C
  std::vector<FollowThrough> follow_;  // C, or none
  std::vector<Vec3<S>> rest_;          // C
  S floor_ = 0, height_ = 1;
  detail::LapMargin laps_;
  std::int32_t starters_ = 0;
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
