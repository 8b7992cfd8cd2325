// One retarget of the whole clip: 10 controls, 300 frames, 8 examples.
#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "harness.h"
#include "rigless/retarget/retarget.h"

namespace {

using rigless::Vec3;

template <class S>
Vec3<S> joint_at(double t, std::size_t joint) {
  const double phase = 1.7 * static_cast<double>(joint), swing = 0.1 + 0.03 * static_cast<double>(joint);
  return Vec3<double>(swing * std::cos(t), 0.9 + swing * std::sin(2 * t + phase), swing * std::sin(t + phase))
      .template cast<S>();
}

template <class S>
void measure(rigless_bench::Bench& bench, const char* scalar) {
  constexpr std::int32_t joints = 31;
  constexpr std::size_t controls = 10, frames = 300, examples = 8;
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
  const std::string name = std::string("retarget 10 x 300 from 8 examples ") + scalar;
  bench.run(name, solve);
  for (std::int32_t c = 0; c < 5; ++c) {
    input.constraints.positions.push_back({c, 50 + 40 * c, Vec3<S>(0, S(0.5), 0), {true, true, true}});
    input.constraints.velocities.push_back({c, 51 + 40 * c, Vec3<S>::Zero(), {true, true, true}});
  }
  bench.run(name + " and 10 constraints", solve);
}

}  // namespace

int main(int argc, char** argv) {
  rigless_bench::Bench bench(argc, argv);
  measure<float>(bench, "float");
  measure<double>(bench, "double");
}
