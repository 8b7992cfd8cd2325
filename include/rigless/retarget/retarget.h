// Human motion in, control tracks out.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/retarget/constraints.h"
#include "rigless/retarget/detail/bounded_spacetime.h"
#include "rigless/retarget/detail/example.h"
#include "rigless/retarget/detail/features.h"
#include "rigless/retarget/detail/pose_spread.h"
#include "rigless/retarget/detail/spacetime.h"

namespace rigless {

inline constexpr double default_smoothness = 0.3;

template <class S>
struct RetargetOptions {
  S fps = 30;                            // of the clip
  S smoothness = S(default_smoothness);  // lambda_A at 30 fps; at other rates times (fps / 30)^2
  S pose_weight = S(0.5);                // a: how much the whole pose counts beside the control's joint
  WeightOptions<S> weights;              // all examples, the near ones first; weights sum to 1
  S offset_weight = S(0.05);             // offset track of constrained controls; 0: none
  S offset_acceleration = 3;             // at 30 fps
  S compliance = S(1e-9);                // of hard constraints
  bool keep_weights = true;              // else Retargeter::weights() is empty

  // The paper's own formulation: each control from its joint alone, the 4 nearest examples, a soft affine row, exact
  // constraints without an offset track.
  static RetargetOptions thesis() {
    const detail::SpacetimeOptions<S> paper = detail::SpacetimeOptions<S>::thesis();
    RetargetOptions options;
    options.pose_weight = 0;
    options.weights = paper.weights;
    options.offset_weight = paper.track.offset_weight;
    options.compliance = paper.compliance;
    return options;
  }
};

template <class S>
struct RetargetInput {
  Span<const Vec3<S>> joints;      // T x J, body-local metres
  std::int32_t joint_count = 0;    // J
  Span<const std::int32_t> pairs;  // C: joint that drives each control, or -1: the whole pose
  Examples<S> examples;            // N x J, N x C
  Constraints<S> constraints;      // track: control; mesh-local units (per frame)
  Span<const S> pose_weights{};    // C: of each control its own pose_weight; or empty
};

// Retargets a clip: normalises examples and clip, solves the spacetime system over all controls, and puts the tracks
// back into mesh-local units. The examples' own poses give their own controls as far as smoothness lets them.
//
// begin(), then advance() until it returns false, then finish(). Computes in double whatever S is: the normal equations
// square the condition number, and the time goes into memory and small matrices anyway.
template <class S, class Solver = detail::SpacetimeSolver<double>>
class Retargeter {
 public:
  Retargeter() = default;
  Retargeter(const Retargeter&) = delete;  // the solver points into inputs_, which a move keeps in place
  Retargeter(Retargeter&&) = default;
  Retargeter& operator=(const Retargeter&) = delete;
  Retargeter& operator=(Retargeter&&) = default;

  // Copies what it needs. Allocates. Errors: no_frames; no_controls; no_examples (none knows a control; where:
  // control); size_mismatch; index_out_of_range (a pair; where: control); bad_constraint; not_finite (a
  // joint of the clip, where: frame; an infinite control of an example, where: example). On failure the previous run is
  // kept.
  Status begin(const RetargetInput<S>& input, const RetargetOptions<S>& options) {
    const Status status = check(input);
    if (!status.ok()) return status;
    const auto joints = to_size(input.joint_count);
    const auto frames = static_cast<std::int32_t>(input.joints.size() / joints);
    const std::size_t controls = input.pairs.size();

    std::vector<Vec3<double>> widened;
    const Span<const Vec3<double>> clip = doubles(input.joints, widened);
    const std::vector<Vec3<double>> example_controls = widen(input.examples.controls);
    std::vector<Vec3<double>> example_joints = widen(input.examples.joints);
    const std::vector<std::int32_t> paired = detail::paired_joints(input.pairs, input.joint_count);
    detail::fill_unknown_joints<double>(clip, paired, input.joint_count, example_joints);

    Inputs next;
    next.space = detail::ControlSpace<double>::of(example_controls, controls);
    next.poses.bind(clip, example_joints, input.joint_count, paired);
    next.clip.resize(controls);
    next.examples.resize(controls);
    next.controls.resize(controls);
    std::vector<detail::TrackInput<double>> tracks;
    for (std::size_t c = 0; c < controls; ++c) {
      const S weight = input.pose_weights.empty() ? options.pose_weight : input.pose_weights[c];
      const double share =
          next.poses.features(input.pairs[c], static_cast<double>(weight), next.clip[c], next.examples[c]);
      keep_known(example_controls, c, next);
      if (next.controls[c].empty()) return {Error::no_examples, c};
      tracks.push_back({next.clip[c], next.examples[c], next.controls[c], {}, {}, next.poses.poses(), share});
    }
    const Status begun =
        solver_.begin(tracks, frames, normalised(input.constraints, next.space), solver_options(options));
    if (!begun.ok()) return begun;
    inputs_ = std::move(next);
    frames_ = to_size(frames);
    return {};
  }

  // Works on for about `budget` frames of one control. Returns true while work is left.
  bool advance(std::int32_t budget) { return solver_.advance(budget); }
  double progress() const { return solver_.progress(); }

  // The tracks, T x C, mesh-local. Allocates. Errors: factorization_failed (where: frame); then `tracks` is untouched.
  Status finish(std::vector<Vec3<S>>& tracks) {
    const Status status = solver_.finish();
    if (!status.ok()) return status;
    const std::size_t controls = inputs_.controls.size();
    tracks.resize(frames_ * controls);
    for (std::size_t c = 0; c < controls; ++c) {
      const auto track = solver_.track(static_cast<std::int32_t>(c));
      for (std::size_t f = 0; f < frames_; ++f)
        tracks[f * controls + c] = inputs_.space.out(track[f], c).template cast<S>();
    }
    return {};
  }

  Solver& solver() { return solver_; }

  // T x N weights of one control, where they are kept; how far each constraint is missed, mesh-local units; which other
  // one it contradicts, or -1.
  Span<const double> weights(std::int32_t control) const { return solver_.weights(control); }
  double residual(std::size_t constraint) const { return solver_.residuals()[constraint] * inputs_.space.spread; }
  Span<const std::int32_t> opponents() const { return solver_.opponents(); }

 private:
  // The solver looks at these arrays until it is done; moving the vectors does not move what they hold.
  struct Inputs {
    detail::ControlSpace<double> space;
    detail::PoseFeatures<double> poses;
    std::vector<std::vector<double>> clip, examples;  // C x (T x 3 or none), C x (N x D)
    std::vector<std::vector<Vec3<double>>> controls;  // C x N
  };

  // The examples that know control c: their places, and their rows of the features.
  static void keep_known(Span<const Vec3<double>> places, std::size_t c, Inputs& inputs) {
    const std::size_t controls = inputs.controls.size(), count = places.size() / controls;
    std::vector<double>& features = inputs.examples[c];
    const std::size_t dimension = features.size() / count;
    auto end = features.begin();
    for (std::size_t n = 0; n < count; ++n) {
      const Vec3<double>& place = places[n * controls + c];
      if (!place.allFinite()) continue;
      inputs.controls[c].push_back(inputs.space.in(place, c));
      const auto row = features.begin() + static_cast<std::ptrdiff_t>(n * dimension);
      end = std::copy(row, row + static_cast<std::ptrdiff_t>(dimension), end);
    }
    features.erase(end, features.end());
  }

  static std::vector<Vec3<double>> widen(Span<const Vec3<S>> points) {
    std::vector<Vec3<double>> out;
    out.reserve(points.size());
    for (const Vec3<S>& p : points) out.push_back(p.template cast<double>());
    return out;
  }

  // The points themselves where they are doubles already: those of a long clip are many.
  static Span<const Vec3<double>> doubles(Span<const Vec3<S>> points, std::vector<Vec3<double>>& widened) {
    if constexpr (std::is_same_v<S, double>) return points;
    widened = widen(points);
    return widened;
  }

  static Status check(const RetargetInput<S>& in) {
    if (in.joint_count <= 0 || in.joints.empty()) return {Error::no_frames, -1};
    const auto joints = to_size(in.joint_count);
    const std::size_t controls = in.pairs.size();
    if (controls == 0) return {Error::no_controls, -1};
    if (!in.pose_weights.empty() && in.pose_weights.size() != controls) return {Error::size_mismatch, -1};
    const std::size_t examples = in.examples.controls.size() / controls;
    if (examples == 0) return {Error::no_examples, -1};
    if (in.joints.size() % joints != 0 || in.examples.controls.size() != examples * controls ||
        in.examples.joints.size() != examples * joints)
      return {Error::size_mismatch, -1};
    for (std::size_t c = 0; c < controls; ++c)
      if (in.pairs[c] < -1 || in.pairs[c] >= in.joint_count) return {Error::index_out_of_range, c};
    for (std::size_t i = 0; i < in.joints.size(); ++i)
      if (!in.joints[i].allFinite()) return {Error::not_finite, i / joints};
    for (std::size_t i = 0; i < in.examples.controls.size(); ++i)
      if (in.examples.controls[i].array().isInf().any()) return {Error::not_finite, i / controls};
    return {};
  }

  static detail::SpacetimeOptions<double> solver_options(const RetargetOptions<S>& options) {
    const double rate = static_cast<double>(options.fps) / 30;
    detail::SpacetimeOptions<double> out;
    out.weights.locality = static_cast<double>(options.weights.locality);
    out.weights.sharing = static_cast<double>(options.weights.sharing);
    out.weights.soft_affine = static_cast<double>(options.weights.soft_affine);
    out.weights.nearest = options.weights.nearest;
    out.weights.tikhonov = static_cast<double>(options.weights.tikhonov);
    out.track.acceleration = static_cast<double>(options.smoothness) * rate * rate;
    out.track.offset_weight = static_cast<double>(options.offset_weight);
    out.track.offset_acceleration = static_cast<double>(options.offset_acceleration) * rate * rate;
    out.compliance = static_cast<double>(options.compliance);
    out.keep_weights = options.keep_weights;
    return out;
  }

  // Constraints that name a control which does not exist pass through: the solver reports them.
  static Constraints<double> normalised(const Constraints<S>& in, const detail::ControlSpace<double>& space) {
    const auto centre = [&](std::int32_t control) {
      const bool exists = control >= 0 && to_size(control) < space.centre.size();
      return exists ? nth(space.centre, control) : Vec3<double>::Zero().eval();
    };
    Constraints<double> out;
    for (const Constraint<S>& c : in) {
      const Vec3<double> origin = c.from ? (centre(c.at.track) - centre(c.from->track)).eval() : centre(c.at.track);
      out.push_back({c.at, c.from, (c.value.template cast<double>() - origin) / space.spread, c.axes});
    }
    return out;
  }

  Inputs inputs_;
  std::size_t frames_ = 0;
  Solver solver_;
};

// The same under bounds of the weights, which solver().set_bounds() sets before begin().
template <class S>
using BoundedRetargeter = Retargeter<S, detail::BoundedSpacetimeSolver<double>>;

// The whole of it in one call; see Retargeter. Allocates.
template <class S>
Status retarget(const RetargetInput<S>& input, const RetargetOptions<S>& options, std::vector<Vec3<S>>& tracks) {
  Retargeter<S> run;
  const Status status = run.begin(input, options);
  if (!status.ok()) return status;
  while (run.advance(1 << 20)) {
  }
  return run.finish(tracks);
}

}  // namespace rigless
