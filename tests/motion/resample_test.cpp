#include "rigless/motion/detail/resample.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace rigless;
using namespace rigless::detail;

namespace {

// One joint on a circle of radius 1, the root turning with it, one turn in two seconds.
template <class S>
Clip<S> circle(S fps, std::int32_t frames) {
  Clip<S> clip;
  clip.skeleton = {{"root"}, {-1}};
  clip.fps = fps;
  clip.metres_per_unit = 1;
  clip.frames = frames;
  for (std::int32_t f = 0; f < frames; ++f) {
    const S angle = static_cast<S>(3.14159265358979) * static_cast<S>(f) / fps;
    clip.positions.emplace_back(std::cos(angle), 0, -std::sin(angle));
    clip.root_rotation.emplace_back(Eigen::AngleAxis<S>(angle, Vec3<S>::UnitY()));
    if (f % 3 == 0) clip.root_rotation.back().coeffs() *= -1;  // the same rotation
  }
  return clip;
}

}  // namespace

TEST_CASE_TEMPLATE("a smooth motion stays itself at any rate", S, float, double) {
  for (const S fps : {S(15), S(24), S(29.97), S(30), S(60), S(120), S(120.00048), S(240)}) {
    CAPTURE(fps);
    const std::int32_t source_frames = static_cast<std::int32_t>(fps * 3) + 1;
    Clip<S> out;
    REQUIRE(resample(circle<S>(fps, source_frames), S(30), out).ok());
    CHECK(out.fps == 30);
    CHECK(std::abs(out.frames - 91) <= 1);
    const Clip<S> exact = circle<S>(30, out.frames);
    for (std::int32_t f = 0; f < out.frames; ++f) {
      const std::size_t i = static_cast<std::size_t>(f);
      // A cubic misses a circle of 30 points by less than 1e-3, a few times that where the curve ends.
      const bool at_end = f < 2 || f >= out.frames - 3;
      CHECK((out.at(f, 0) - exact.at(f, 0)).norm() < (at_end ? S(1e-2) : S(1e-3)));
      CHECK(out.root_rotation[i].angularDistance(exact.root_rotation[i]) < S(1e-2));
    }
  }
}

TEST_CASE("frames that fall on source frames are those frames") {
  const Clip<double> source = circle<double>(120, 343);
  Clip<double> out;
  REQUIRE(resample(source, 30.0, out).ok());
  REQUIRE(out.frames == 86);
  for (std::int32_t f = 0; f < out.frames; ++f) CHECK(out.at(f, 0) == source.at(4 * f, 0));
}

TEST_CASE("one frame, in place, and what cannot be") {
  Clip<double> clip = circle<double>(120, 1);
  REQUIRE(resample(clip, 30.0, clip).ok());
  CHECK(clip.frames == 1);
  CHECK(clip.at(0, 0) == Vec3<double>(1, 0, 0));

  Clip<double> slow = circle<double>(1e-9, 2);
  CHECK(resample(slow, 30.0, clip).error == Error::out_of_memory);
  CHECK(clip.frames == 1);
  CHECK(resample(Clip<double>{}, 30.0, clip).error == Error::no_frames);

  const Clip<double> rounded = circle<double>(30.003, 125);  // a frame time of .03333
  REQUIRE(resample(rounded, 30.0, clip).ok());
  CHECK(clip.frames == 125);
}
