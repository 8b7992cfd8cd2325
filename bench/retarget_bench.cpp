// One retarget of a whole clip: 10 controls from 8 examples, 300 frames and 10,000; and the whole performance with what
// the page asks of it (mirror images, places, contacts, coverage).
#include <malloc.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "harness.h"
#include "rigless/scene/performance_builder.h"

namespace {

using rigless::Vec3;

template <class S>
Vec3<S> joint_at(double t, std::size_t joint) {
  const double phase = 1.7 * static_cast<double>(joint), swing = 0.1 + 0.03 * static_cast<double>(joint);
  return Vec3<double>(swing * std::cos(t), 0.9 + swing * std::sin(2 * t + phase), swing * std::sin(t + phase))
      .template cast<S>();
}

constexpr std::int32_t joints = 31;
constexpr std::size_t controls = 10, examples = 8;

template <class S>
void measure(rigless_bench::Bench& bench, const char* scalar, std::size_t frames) {
  std::vector<Vec3<S>> clip, example_joints, example_controls, tracks;
  std::vector<std::int32_t> pairs;
  for (std::size_t f = 0; f < frames; ++f)
    for (std::size_t j = 0; j < joints; ++j) clip.push_back(joint_at<S>(static_cast<double>(f) / 10, j));
  for (std::size_t n = 0; n < examples; ++n) {
    for (std::size_t j = 0; j < joints; ++j) example_joints.push_back(joint_at<S>(0.8 * static_cast<double>(n), j));
    for (std::size_t c = 0; c < controls; ++c)
      example_controls.push_back(joint_at<S>(0.8 * static_cast<double>(n) + 0.02 * static_cast<double>(c), 2 * c));
  }
  for (std::size_t c = 0; c < controls; ++c) pairs.push_back(static_cast<std::int32_t>(2 * c));
  rigless::RetargetInput<S> input{clip, joints, pairs, {example_joints, example_controls}, {}};
  const auto solve = [&] {
    if (!rigless::retarget<S>(input, {}, tracks).ok()) std::exit(1);
  };
  const std::string name = "retarget 10 x " + std::to_string(frames) + " from 8 examples " + scalar;
  bench.run(name, solve);
  for (std::int32_t c = 0; c < 5; ++c) {
    input.constraints.push_back(rigless::position_constraint<S>(c, 50 + 40 * c, Vec3<S>(0, S(0.5), 0)));
    input.constraints.push_back(rigless::velocity_constraint<S>(c, 51 + 40 * c, Vec3<S>::Zero()));
  }
  bench.run(name + " and 10 constraints", solve);
}

// Legs, arms and all else swing; both feet stand half of the time.
void measure_performance(rigless_bench::Bench& bench, std::int32_t frames) {
  rigless::StagedMotion<double> motion;
  motion.clip.frames = frames;
  motion.clip.fps = 30;
  for (std::int32_t j = 0; j < joints; ++j) {
    motion.clip.skeleton.names.push_back((j % 2 == 0 ? "l" : "r") + std::string("arm") +
                                         std::string(static_cast<std::size_t>(j / 2), 'x'));
    motion.clip.skeleton.parents.push_back(j - 1);
  }
  for (std::int32_t f = 0; f < frames; ++f) {
    for (std::size_t j = 0; j < joints; ++j) motion.local.push_back(joint_at<double>(f / 10.0, j));
    motion.yaw.push_back(0.01 * f);
    motion.left.push_back(f % 30 < 18 ? 1 : 0);
    motion.right.push_back(f % 30 < 18 ? 0 : 1);
  }
  motion.clip.positions = motion.local;
  motion.roles.left.ankle = 0;
  motion.roles.right.ankle = 4;
  std::vector<std::int32_t> pairs, partners;
  std::vector<Vec3<double>> rest, example_joints, example_controls;
  for (std::size_t c = 0; c < controls; ++c) {
    pairs.push_back(static_cast<std::int32_t>(2 * c));
    partners.push_back(static_cast<std::int32_t>(c ^ 1U));
    rest.push_back(joint_at<double>(0, 2 * c));
  }
  for (std::size_t n = 0; n < examples; ++n) {
    for (std::size_t j = 0; j < joints; ++j)
      example_joints.push_back(joint_at<double>(0.8 * static_cast<double>(n), j));
    for (std::size_t c = 0; c < controls; ++c)
      example_controls.push_back(joint_at<double>(0.8 * static_cast<double>(n) + 0.02, 2 * c));
  }
  rigless::PerformanceInput<double> input;
  input.motion = &motion;
  input.pairs = pairs;
  input.rest = rest;
  input.examples = {example_joints, example_controls};
  input.mirror = partners;
  for (std::int32_t c = 0; c < 5; ++c) {
    input.constraints.push_back(rigless::position_constraint<double>(c, frames / 7 * (c + 1), Vec3<double>(0, 0.5, 0)));
    input.constraints.push_back(
        rigless::velocity_constraint<double>(c, frames / 7 * (c + 1) + 1, Vec3<double>::Zero()));
  }
  rigless::Performance<double> out;
  const std::string name = "performance 10 x " + std::to_string(frames) + " from 8 examples and their images";
  bench.run(
      name + ", 10 constraints",
      [&] {
        if (!rigless::build_performance(input, out).ok()) std::exit(1);
      },
      frames > 1000 ? 10 : 50);
  const auto used = [] { return static_cast<double>(mallinfo2().uordblks) / 1e6; };
  const double before = used();
  rigless::PerformanceBuilder<double> builder;
  if (!builder.begin(input).ok()) std::exit(1);
  while (builder.advance(1 << 20)) {
  }
  std::printf("%-60s %8.1f MB\n", (name + ", memory").c_str(), used() - before);
}

}  // namespace

int main(int argc, char** argv) {
  rigless_bench::Bench bench(argc, argv);
  measure<float>(bench, "float", 300);
  measure<double>(bench, "double", 300);
  if (!bench.small()) measure<double>(bench, "double", 10000);
  measure_performance(bench, 300);
  if (!bench.small()) measure_performance(bench, 10000);
}
