// Performances as flat C functions over integer handles. No logic of its own: it turns memory into spans, double into
// float32, and a Status into one number. Double inside. Built for speed as far as that costs no size.

#include <algorithm>

#include "exports.h"
#include "motions.h"
#include "rigless/scene/performance_builder.h"

using rigless::Span;
using rigless::Status;
using rigless_wasm::answer;
using rigless_wasm::Ask;
using rigless_wasm::ConstraintInput;
using rigless_wasm::HandleTable;
using rigless_wasm::Miss;
using rigless_wasm::motions;
using rigless_wasm::ObjectHandle;
using rigless_wasm::pack;
using rigless_wasm::PackedStatus;
using rigless_wasm::PerformanceInfo;
using rigless_wasm::view;

namespace {

using Vec3d = rigless::Vec3<double>;

// A performance in the making, then made; first what the user asks of it.
struct Play {
  rigless::Constraints<double> constraints;
  std::vector<rigless::ContactEdit> contacts;
  std::vector<rigless::Flight> flights;
  bool own_flights = false;
  std::vector<std::int32_t> mirror;
  Vec3d mirror_normal = Vec3d::UnitX();
  std::vector<rigless::FollowThrough> follow;
  std::vector<double> pose_weights;
  rigless::PerformanceBuilder<double> builder;
  rigless::Performance<float> performance;
  bool made = false;
};

HandleTable<Play> plays;

constexpr std::int32_t slice_frames = 64;  // of one control: well under a millisecond

std::vector<Vec3d> widen(const float* numbers, std::int32_t count) {
  std::vector<Vec3d> out;
  for (const rigless::Vec3<float>& p : view<rigless::Vec3<float>>(numbers, count)) out.push_back(p.cast<double>());
  return out;
}

}  // namespace

RIGLESS_EXPORT ObjectHandle performance_new() { return plays.add(); }

RIGLESS_EXPORT void performance_delete(ObjectHandle performance) { plays.remove(performance); }

// What the user asks of a performance, before performance_begin(): first its constraints.
RIGLESS_EXPORT void performance_constrain(ObjectHandle performance, const ConstraintInput* constraints,
                                          std::int32_t count) {
  for (const ConstraintInput& one : view<ConstraintInput>(constraints, count)) {
    plays[performance].constraints.push_back(rigless_wasm::constraint(one));
  }
}

// The control stands in [begin, end), and in no other run of the motion.
RIGLESS_EXPORT void performance_stand(ObjectHandle performance, std::int32_t control, std::int32_t begin,
                                      std::int32_t end) {
  plays[performance].contacts.push_back({control, {begin, end}});
}

// The flights are these, pairs of frames, instead of the motion's.
RIGLESS_EXPORT void performance_fly(ObjectHandle performance, const std::int32_t* flights, std::int32_t count) {
  const Span<const rigless::Flight> own = view<rigless::Flight>(flights, count);
  plays[performance].flights.assign(own.begin(), own.end());
  plays[performance].own_flights = true;
}

// partners: C; x, y, z: normal of the mesh's plane.
RIGLESS_EXPORT void performance_mirror(ObjectHandle performance, const std::int32_t* partners, std::int32_t controls,
                                       double x, double y, double z) {
  const Span<const std::int32_t> mirror = view<std::int32_t>(partners, controls);
  plays[performance].mirror.assign(mirror.begin(), mirror.end());
  plays[performance].mirror_normal = {x, y, z};
}

// follow: C, how those without a joint hang on the body, or 0; weights: C, of the whole pose beside their own joint, or
// 0.
RIGLESS_EXPORT void performance_follow(ObjectHandle performance, const std::int32_t* follow, const float* weights,
                                       std::int32_t controls) {
  Play& play = plays[performance];
  for (std::int32_t c = 0; c < controls; ++c) {
    if (follow != nullptr) play.follow.push_back(static_cast<rigless::FollowThrough>(follow[c]));
    if (weights != nullptr) play.pose_weights.push_back(static_cast<double>(weights[c]));
  }
}

// pairs: C; rest: C x 3, the controls at rest; limbs: C x 5, of body_limbs(), or 0; floor, height: of the mesh at rest;
// example_joints: N x J x 3 body-local metres, NaN where unknown; example_controls: N x C x 3. The motion must stay
// until performance_progress() is 1. turned: performance_turn() comes after it.
RIGLESS_EXPORT PackedStatus performance_begin(ObjectHandle performance, ObjectHandle motion, const std::int32_t* pairs,
                                              const float* rest, const float* limbs, std::int32_t controls,
                                              double floor, double height, const float* example_joints,
                                              const float* example_controls, std::int32_t examples, double smoothness,
                                              std::int32_t ground_contact, std::int32_t in_place, double energy,
                                              std::int32_t paper, std::int32_t turned) {
  const rigless::StagedMotion<double>& staged = motions[motion].staged;
  const std::vector<Vec3d> rest_controls = widen(rest, controls);
  const std::vector<Vec3d> joints = widen(example_joints, examples * staged.clip.joints());
  const std::vector<Vec3d> places = widen(example_controls, examples * controls);
  std::vector<rigless::ModelLimb<double>> model_limbs;
  for (const auto& [x, y, z, length, swing] : view<std::array<float, 5>>(limbs, limbs == nullptr ? 0 : controls))
    model_limbs.push_back({Vec3d(x, y, z), static_cast<double>(length), static_cast<double>(swing)});
  rigless::PerformanceInput<double> input;
  input.motion = &staged;
  input.pairs = view<std::int32_t>(pairs, controls);
  input.rest = rest_controls;
  input.limbs = model_limbs;
  input.floor = floor;
  input.height = height;
  input.examples = {joints, places};
  input.settings = {smoothness, ground_contact != 0, in_place != 0, energy, paper != 0};
  Play& play = plays[performance];
  const Span<const rigless::Flight> flights = play.flights;
  input.constraints = play.constraints;
  input.contacts = play.contacts;
  if (play.own_flights) input.flights = &flights;
  input.follow = play.follow;
  input.pose_weights = play.pose_weights;
  input.mirror = play.mirror;
  input.mirror_normal = play.mirror_normal;
  input.turns = turned != 0;
  return pack(play.builder.begin(input));
}

// One slice. Call until performance_progress() is 1.
RIGLESS_EXPORT PackedStatus performance_advance(ObjectHandle performance) {
  Play& play = plays[performance];
  if (play.builder.advance(slice_frames)) return 0;
  rigless::Performance<double> made;
  if (const Status status = play.builder.finish(made); !status.ok()) return pack(status);
  play.performance = rigless::performance_cast<float>(made);
  play.made = true;
  return 0;
}

RIGLESS_EXPORT double performance_progress(ObjectHandle performance) {
  const Play& play = plays[performance];
  return play.made ? 1.0 : std::min(play.builder.progress(), 0.99);
}

RIGLESS_EXPORT const PerformanceInfo* performance_info(ObjectHandle performance) {
  const rigless::Performance<float>& p = plays[performance].performance;
  return answer<PerformanceInfo>({
      .frames = p.frames,
      .controls = p.control_count(),
      .flights = p.flights.size(),
      .constraints = p.missed.size(),
      .asks = p.asks.size(),
      .slip_before = p.slip_before.mean,
      .slip_after = p.slip_after.mean,
      .have = p.have,
      .want = p.want,
      .starters = p.starters,
  });
}

RIGLESS_EXPORT const Miss* performance_miss(ObjectHandle performance, std::int32_t constraint) {
  const rigless::Performance<float>& p = plays[performance].performance;
  const auto k = static_cast<std::size_t>(constraint);
  return answer<Miss>({.metres = p.missed[k], .opponent = p.opponents[k]});
}

// Best first.
RIGLESS_EXPORT const Ask* performance_ask(ObjectHandle performance, std::int32_t index) {
  const rigless::Ask& ask = plays[performance].performance.asks[static_cast<std::size_t>(index)];
  return answer<Ask>({.frame = ask.frame, .gain = ask.gain});
}

// turns: rotation vectors of the first `count` examples that know the control.
RIGLESS_EXPORT void performance_turn(ObjectHandle performance, std::int32_t control, const float* turns,
                                     std::int32_t count) {
  Play& play = plays[performance];
  play.builder.turn<float>(control, view<rigless::Vec3<float>>(turns, count), play.performance);
}

// T x C x 3; the same, or 0; T x C; pairs of frames; T; T x 2; T x C; T
RIGLESS_EXPORT const float* performance_controls(ObjectHandle performance) {
  return plays[performance].performance.controls.data()->data();
}
RIGLESS_EXPORT const float* performance_turns(ObjectHandle performance) {
  const auto& turns = plays[performance].performance.turns;
  return turns.empty() ? nullptr : turns.data()->data();
}
RIGLESS_EXPORT const std::uint8_t* performance_contacts(ObjectHandle performance) {
  return plays[performance].performance.contacts.data();
}
RIGLESS_EXPORT const std::int32_t* performance_flights(ObjectHandle performance) {
  return reinterpret_cast<const std::int32_t*>(plays[performance].performance.flights.data());
}
RIGLESS_EXPORT const float* performance_yaw(ObjectHandle performance) {
  return plays[performance].performance.yaw.data();
}
RIGLESS_EXPORT const float* performance_travel(ObjectHandle performance) {
  return plays[performance].performance.travel.data()->data();
}
RIGLESS_EXPORT const std::uint8_t* performance_source_contacts(ObjectHandle performance) {
  return plays[performance].performance.source_contacts.data();
}
RIGLESS_EXPORT const float* performance_coverage(ObjectHandle performance) {
  return plays[performance].performance.coverage.data();
}
