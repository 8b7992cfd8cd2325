#include "rigless/retarget/detail/coverage.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "rigless/retarget/detail/key_poses.h"

namespace detail = rigless::detail;
using rigless::Vec3;

namespace {

constexpr std::int32_t clip_joints = 4;
const std::vector<std::int32_t> clip_paired = {1, 2, 3};

// A clip that comes by three regions of poses, one after the other.
std::vector<Vec3<double>> clip_of(std::int32_t frames) {
  std::vector<Vec3<double>> clip;
  for (std::int32_t f = 0; f < frames; ++f) {
    const double t = 3.0 * f / frames;
    for (std::size_t j = 0; j < clip_joints; ++j) {
      const double p = 1.3 * static_cast<double>(j);
      clip.emplace_back(std::sin(4 * t + p), std::cos(t * t + p), std::floor(t) * std::sin(9 * t));
    }
  }
  return clip;
}

detail::PoseCoverage cover(const std::vector<Vec3<double>>& clip, const std::vector<Vec3<double>>& examples,
                           const detail::CoverageOptions& options = {}, const std::vector<std::int32_t>& mirror = {}) {
  detail::PoseCoverage coverage;
  coverage.begin(clip, clip_joints, clip_paired, examples, mirror, options);
  while (coverage.advance(7)) {
  }
  return coverage;
}

void teach(const std::vector<Vec3<double>>& clip, std::int32_t frame, std::vector<Vec3<double>>& examples) {
  const auto first = clip.begin() + frame * clip_joints;
  examples.insert(examples.end(), first, first + clip_joints);
}

double rms(const detail::PoseCoverage& coverage) {
  double sum = 0;
  for (const double e : coverage.coverage()) sum += e * e;
  return std::sqrt(sum / static_cast<double>(coverage.coverage().size()));
}

}  // namespace

TEST_CASE("coverage: a frame that was taught is covered, and frames like it nearly") {
  const auto clip = clip_of(90);
  std::vector<Vec3<double>> examples;
  CHECK(rms(cover(clip, examples)) == doctest::Approx(std::sqrt(2.0)).epsilon(1e-6));
  for (const std::int32_t f : {10, 40, 41}) teach(clip, f, examples);
  const auto coverage = cover(clip, examples);
  CHECK(coverage.coverage()[10] < 1e-3);
  CHECK(coverage.coverage()[40] < 1e-3);
  CHECK(coverage.coverage()[11] < 0.5);
  CHECK(coverage.coverage()[80] > 0.5);
  CHECK(coverage.have() == 3);
}

TEST_CASE("coverage: each ask lowers the error by its gain, and `want` of them are enough") {
  const auto clip = clip_of(90);
  std::vector<Vec3<double>> examples;
  const auto first = cover(clip, examples);
  REQUIRE(first.asks().size() == 8);
  double before = rms(first);
  for (std::size_t k = 0; k < 8; ++k) {
    teach(clip, first.asks()[k].frame, examples);
    const double after = rms(cover(clip, examples));
    CHECK(first.asks()[k].gain == doctest::Approx(std::max(0.0, before - after)).epsilon(1e-6));
    before = after;
  }
  examples.clear();
  detail::CoverageOptions options;
  options.asks = 24;
  const auto all = cover(clip, examples, options);
  REQUIRE(all.want() <= 24);
  for (std::int32_t k = 0; k < all.want(); ++k) {
    CHECK(rms(cover(clip, examples)) >= options.enough);
    teach(clip, all.asks()[static_cast<std::size_t>(k)].frame, examples);
  }
  CHECK(rms(cover(clip, examples)) < options.enough);
  CHECK(cover(clip, examples).want() == all.want());
}

TEST_CASE("coverage: asked for frames cover the clip better than the farthest ones") {
  const auto clip = clip_of(90);
  const auto error = [&](const std::vector<std::int32_t>& frames) {
    std::vector<Vec3<double>> examples;
    for (const std::int32_t f : frames) teach(clip, f, examples);
    return rms(cover(clip, examples));
  };
  std::vector<std::int32_t> asked, farthest;
  const auto coverage = cover(clip, {});
  for (const auto& ask : coverage.asks()) asked.push_back(ask.frame);
  for (const auto& key : detail::suggest_key_poses<double>(clip, clip_joints, clip_paired, 8))
    farthest.push_back(key.frame);
  CHECK(error(asked) < error(farthest));
}

TEST_CASE("coverage: mirror images teach as well") {
  const auto clip = clip_of(90);
  const std::vector<std::int32_t> mirror = {0, 2, 1, 3};
  std::vector<Vec3<double>> examples;
  teach(clip, 20, examples);
  for (std::size_t j = 0; j < clip_joints; ++j) {
    const Vec3<double>& p = examples[static_cast<std::size_t>(mirror[j])];
    examples.emplace_back(-p.x(), p.y(), p.z());
  }
  const auto coverage = cover(clip, examples, {}, mirror);
  CHECK(coverage.have() == 2);
  CHECK(coverage.want() % 2 == 0);
}

TEST_CASE("coverage: clips of a frame or ten thousand, clips that stand still, and slices") {
  for (const std::int32_t frames : {1, 2, 3, 10000}) {
    CAPTURE(frames);
    const auto clip = clip_of(frames);
    const auto coverage = cover(clip, {});
    CHECK(coverage.coverage().size() == static_cast<std::size_t>(frames));
    for (const auto& ask : coverage.asks()) CHECK((ask.frame >= 0 && ask.frame < frames && std::isfinite(ask.gain)));
    if (frames < 4) CHECK(coverage.want() <= frames);
  }
  const std::vector<Vec3<double>> still(30 * clip_joints, Vec3<double>(1, 2, 3));
  const auto coverage = cover(still, {});
  CHECK(coverage.want() == 1);
  CHECK(coverage.asks().size() == 1);
}
