#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "rigless/retarget/detail/example_size.h"
#include "rigless/scene/bake.h"
#include "scene/dancers.h"

using namespace rigless;
using namespace rigless::detail;
using test::Cactus;

namespace {

using Vec3d = Vec3<double>;

constexpr double whole_turn = 2 * 3.14159265358979323846;

// Two seconds of a swing of `amplitude` metres at some hertz.
std::vector<Vec3d> swing(double hertz, double amplitude, std::int32_t frames = 60) {
  std::vector<Vec3d> track;
  for (std::int32_t f = 0; f < frames; ++f)
    track.emplace_back(amplitude * std::sin(whole_turn * hertz * f / performance_fps), 1, 0);
  return track;
}

double widest(const std::vector<Vec3d>& track) {
  double most = 0;
  for (const Vec3d& p : track) most = std::max(most, std::abs(p.x()));
  return most;
}

std::vector<Vec3d> accentuated(std::vector<Vec3d> track, double gain) {
  const std::vector<double> free(track.size(), 1);
  accentuate<double>(gain, free, false, 1, 0, static_cast<std::int32_t>(track.size()), track);
  return track;
}

template <class S>
double step(const Performance<S>& p, std::int32_t a, std::int32_t b) {
  const std::size_t controls = p.control_count();
  double sum = 0;
  for (std::size_t c = 0; c < controls; ++c)
    sum += static_cast<double>(
        (p.controls[to_size(a) * controls + c] - p.controls[to_size(b) * controls + c]).squaredNorm());
  return std::sqrt(sum / static_cast<double>(controls));
}

}  // namespace

TEST_CASE("a clip that comes back to where it began is a loop, with its first frame at its end or without") {
  const std::vector<Vec3d> lap = swing(1, 0.3);
  CHECK(loop_period<double>(lap, 1) == 60);
  std::vector<Vec3d> twice = lap;
  twice.push_back(lap[0]);
  CHECK(loop_period<double>(twice, 1) == 60);
  std::vector<Vec3d> cut(lap.begin(), lap.begin() + 40);
  CHECK(loop_period<double>(cut, 1) == 0);
  CHECK(loop_period<double>({lap.data(), 4}, 1) == 0);
  CHECK(frame_around(-1, 61, 60) == 59);
  CHECK(frame_around(61, 61, 60) == 1);
  CHECK(frame_around(61, 61, 0) == 60);
}

TEST_CASE("accents grow near two hertz; what is slow, or still, hardly does") {
  const auto growth = [](double hertz) {
    return widest(accentuated(swing(hertz, 0.3), 4)) / widest(swing(hertz, 0.3));
  };
  CHECK(growth(0.5) < 1.06);
  CHECK(growth(2.5) > 1.4);
  CHECK(growth(10) < 1.05);
  const std::vector<Vec3d> still(60, Vec3d(1, 2, 3));
  for (const Vec3d& p : accentuated(still, 4)) CHECK((p - still[0]).norm() < 1e-12);
}

TEST_CASE("a track gets the accents that its joint has, and no more") {
  std::vector<Vec3d> joint = swing(0.5, 0.3), track = joint;
  for (std::size_t f = 0; f < joint.size(); ++f) {
    joint[f] += 0.3 * swing(2.5, 0.3)[f];
    track[f] += 0.24 * swing(2.5, 0.3)[f];
  }
  const auto sums = [](const std::vector<Vec3d>& of) { return AccentSums<double>(Track<double>{of, 1, 0, 60}); };
  const double share = sums(joint).share(0);
  const double gain = gain_towards(share, sums(track));
  CHECK(gain > 0.1);
  CHECK(gain < accent_gain);
  CHECK(sums(accentuated(track, gain)).share(0) == doctest::Approx(share).epsilon(0.02));
  CHECK(gain_towards(share, sums(joint)) == 0);
}

TEST_CASE("a loop's seam is a step like every other") {
  Cactus<double> cactus("run.bvh");
  Performance<double> p;
  REQUIRE(cactus.perform({}, p).ok());
  REQUIRE(cactus.motion.loop_period >= p.frames - 1);
  std::vector<double> steps;
  for (std::int32_t f = 1; f < p.frames; ++f) steps.push_back(step(p, f - 1, f));
  std::sort(steps.begin(), steps.end());
  CHECK(step(p, p.frames - 1, 0) <= steps[steps.size() * 95 / 100]);
}

TEST_CASE("energy takes the poses farther from rest, or nearer to it") {
  Cactus<double> cactus("disco.bvh");
  const auto range = [&](double energy) {
    PerformanceSettings<double> settings;
    settings.energy = energy;
    Performance<double> p;
    REQUIRE(cactus.perform(settings, p).ok());
    double sum = 0;
    for (std::int32_t f = 1; f < p.frames; ++f) sum += step(p, f - 1, f);
    return sum;
  };
  const double taught = range(0);
  CHECK(range(-1) < 0.8 * taught);
  CHECK(range(1) > 1.2 * taught);
}

TEST_CASE("a child's dance and a giant's are the same dance") {
  Cactus<double> cactus("disco.bvh");
  PerformanceSettings<double> settings;
  settings.ground_contact = false;
  Performance<double> own;
  REQUIRE(cactus.perform(settings, own).ok());
  for (const double size : {0.7, 1.25}) {
    Cactus<double> other("disco.bvh");
    for (Vec3d& p : other.motion.local) p *= size;
    for (Vec3d& p : other.motion.clip.positions) p *= size;
    Performance<double> p;
    REQUIRE(other.perform(settings, p).ok());
    double sum = 0;
    for (std::size_t i = 0; i < p.controls.size(); ++i) sum += (p.controls[i] - own.controls[i]).squaredNorm();
    CHECK(std::sqrt(sum / static_cast<double>(p.controls.size())) < 0.005 * Cactus<double>::height);
  }
}

TEST_CASE("poses of an actor whose bones are hardly known, or the same, stay as they are") {
  const std::vector<std::int32_t> parents = {-1, 0, 1, 2, 3};
  std::vector<Vec3d> pose;
  for (int j = 0; j < 5; ++j) pose.emplace_back(0.1 * j, 1, 0);
  std::vector<Vec3d> larger = pose;
  for (Vec3d& p : larger) p *= 1.3;
  CHECK(bone_ratio<double>(parents, pose, larger) == doctest::Approx(1.3));
  CHECK(bone_ratio<double>(parents, pose, pose) == 1);
  larger[1].setConstant(std::nan(""));
  CHECK(bone_ratio<double>(parents, pose, larger) == 1);
}

TEST_CASE("a part that no joint moves lags, swings beyond and settles; a stiff one does not") {
  // The body stands, makes one step to the side within four frames, and stands again.
  std::vector<Vec3d> path;
  for (std::int32_t f = 0; f < 90; ++f) path.emplace_back(0.3 * std::min(1.0, std::max(0.0, (f - 20) / 4.0)), 1, 0);
  const std::vector<double> yaw(path.size(), 0);
  const auto lag = [&](const Spring<double>& spring) { return spring_lag(spring, path, yaw, 0.4, false); };
  const std::vector<Vec3d> bouncy = lag({2.2, 0.2});
  double behind = 0, beyond = 0;
  for (const Vec3d& p : bouncy) {
    behind = std::min(behind, p.x());
    beyond = std::max(beyond, p.x());
  }
  CHECK(behind < -0.1);
  CHECK(beyond > 0.05);
  CHECK(bouncy.back().norm() < 0.01);
  CHECK(bouncy[19].norm() == 0);
  for (const Vec3d& p : lag({2.2, 1})) CHECK(p.x() < beyond / 2);
  for (const Vec3d& p : lag(spring_of<double>(FollowThrough::floppy))) behind = std::min(behind, p.x() + 0.02);
  CHECK(behind < -0.15);
  for (const Vec3d& p : lag({0.3, 0.2})) CHECK(p.norm() < 0.4);
}

namespace {

// A human of two joints, the hips a metre above the foot and as much higher as `up` says.
StagedMotion<double> standing_human(std::int32_t frames, const std::function<double(std::int32_t)>& up) {
  StagedMotion<double> motion;
  motion.clip.skeleton = {{"Hips", "Foot"}, {-1, 0}};
  motion.clip.frames = frames;
  for (std::int32_t f = 0; f < frames; ++f) {
    motion.local.emplace_back(0, 0, 0);
    motion.local.emplace_back(0, -1 - up(f), 0);
  }
  return motion;
}

double bounce(std::int32_t f) { return 0.05 * std::sin(whole_turn * 1.5 * f / performance_fps); }

double range(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

}  // namespace

TEST_CASE("a body rises on its feet as far as the human does, once, and what is held stays") {
  const StagedMotion<double> motion = standing_human(60, bounce);
  const Rise<double> rise = rise_of<double>(motion, {60, 60}, 2.0, 2.0);
  CHECK(range(rise.hips) == doctest::Approx(0.2).epsilon(0.1));  // a body twice as large
  CHECK(range(rise.breath) < 0.01);                              // no time to breathe
  const std::vector<Vec3d> rest = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}, root(60, Vec3d::Zero());
  std::vector<Vec3d> still, rising;
  for (std::size_t i = 0; i < 180; ++i) {
    still.push_back(rest[i % 3]);
    rising.emplace_back(rest[i % 3] + (i % 3 > 0 ? rise.hips[i / 3] : 0) * Vec3d::UnitY());
  }
  std::vector<double> freedom(180, 1);
  for (std::size_t i = 2; i < freedom.size(); i += 3) freedom[i] = 0;
  const auto heights = [&](std::vector<Vec3d> tracks, std::size_t c) {
    give_weight<double>(rise, rest, 0.0, 2.0, freedom, root, tracks);
    std::vector<double> y;
    for (std::size_t i = c; i < tracks.size(); i += 3) y.push_back(tracks[i].y());
    return y;
  };
  CHECK(range(heights(still, 0)) == 0);
  CHECK(range(heights(still, 1)) == doctest::Approx(1.3 * 0.2).epsilon(0.2));
  CHECK(range(heights(still, 2)) == 0);
  CHECK(range(heights(rising, 1)) == doctest::Approx(range(rise.hips)).epsilon(0.01));
}

TEST_CASE("a human that stands still breathes: slowly, and in a loop without a seam") {
  const StagedMotion<double> motion = standing_human(200, [](std::int32_t) { return 0.0; });
  const std::vector<double> once = rise_of<double>(motion, {200, 0}, 1.0, 2.0).breath;
  CHECK(range(once) == doctest::Approx(0.06));
  CHECK(once[0] == 0);
  CHECK(once[60] == doctest::Approx(0.06));
  CHECK(once[120] == doctest::Approx(0));
  const std::vector<double> loop = rise_of<double>(motion, {200, 200}, 1.0, 2.0).breath;
  CHECK(loop[50] == doctest::Approx(0.06));
  CHECK(loop[199] == doctest::Approx(loop[1]));
  CHECK(range(rise_of<double>(motion, {200, 0}, 1.0, 2.0).hips) < 1e-12);
  const StagedMotion<double> short_one = standing_human(20, [](std::int32_t) { return 0.0; });
  CHECK(range(rise_of<double>(short_one, {20, 20}, 1.0, 2.0).breath) < 1e-3);  // no breath of less than a second
}

TEST_CASE("a body breathes on planted feet") {
  Cactus<double> cactus("idle.bvh");
  auto& local = cactus.motion.local;
  for (std::size_t i = to_size(cactus.motion.clip.joints()); i < local.size(); ++i)
    local[i] = local[i - to_size(cactus.motion.clip.joints())];
  Performance<double> p;
  REQUIRE(cactus.perform({}, p).ok());
  for (std::size_t c = 0; c < p.control_count(); ++c) {
    std::vector<double> heights;
    for (std::size_t i = c; i < p.controls.size(); i += p.control_count()) heights.push_back(p.controls[i].y());
    const double level = cactus.body.rest_controls()[c].y() / Cactus<double>::height;
    CHECK(range(heights) == doctest::Approx(p.contacts[c] != 0 ? 0 : 0.03 * 1.7 * level).epsilon(0.02));
  }
}

TEST_CASE("a running cactus is in the air where the loop cuts its flight") {
  Cactus<double> cactus("run.bvh");
  Performance<double> p;
  REQUIRE(cactus.perform({}, p).ok());
  Bake<double> bake;
  bake.bind(cactus.body, p, 1.0);
  const auto lowest = [&](std::int32_t f) {
    REQUIRE(bake.frame(f).ok());
    double low = 1;
    for (const Vec3d& v : bake.positions()) low = std::min(low, v.y());
    return low;
  };
  const auto stands = [&](std::int32_t f) {
    const auto from = p.contacts.begin() + static_cast<std::ptrdiff_t>(to_size(f) * p.control_count());
    return std::count(from, from + static_cast<std::ptrdiff_t>(p.control_count()), 1) > 0;
  };
  REQUIRE_FALSE(stands(1));
  CHECK(p.flights[0].take_off > 1);
  CHECK(lowest(1) > 0.005);
  REQUIRE(stands(5));
  CHECK(lowest(5) == doctest::Approx(0).epsilon(1e-9));
}
