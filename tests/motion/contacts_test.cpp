#include "rigless/motion/contacts.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "rigless/motion/detail/units.h"
#include "rigless/motion/parse_acclaim.h"
#include "rigless/motion/parse_bvh.h"
#include "sample_motions.h"
#include "support/json.h"

using namespace rigless;
using namespace rigless::detail;

namespace {

void check_runs(const std::vector<FrameRun>& runs, const json::Value& golden, std::int32_t tolerance) {
  std::vector<std::array<std::int32_t, 2>> expected;
  for (const json::Value& run : golden.array()) expected.push_back({run[0].integer(), run[1].integer()});
  REQUIRE(runs.size() == expected.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    CHECK(std::abs(runs[k].begin - expected[k][0]) <= tolerance);
    CHECK(std::abs(runs[k].end - expected[k][1]) <= tolerance);
  }
}

// Two feet on legs of a metre below a root, 120 fps: `left` and `right` are the heights of the feet over time, and the
// root rides `root` above.
template <class S, class Left, class Right, class Root>
Clip<S> stilts(std::int32_t frames, Left left, Right right, Root root) {
  Clip<S> clip;
  clip.skeleton = {{"Hips", "LeftAnkle", "LeftAnkle_end", "RightAnkle", "RightAnkle_end"}, {-1, 0, 1, 0, 3}};
  clip.fps = 120;
  clip.metres_per_unit = 1;
  clip.frames = frames;
  for (std::int32_t f = 0; f < frames; ++f) {
    const double t = f / 120.0;
    for (const double x : {0.0, 0.1, -0.1}) {
      const double y = x == 0 ? root(t) : x > 0 ? left(t) : right(t);
      clip.positions.emplace_back(static_cast<S>(x), static_cast<S>(y), S(0));
      if (x != 0) clip.positions.emplace_back(static_cast<S>(x), static_cast<S>(y), S(0.2));
    }
    clip.root_rotation.push_back(Eigen::Quaternion<S>::Identity());
  }
  return clip;
}

}  // namespace

TEST_CASE_TEMPLATE("contacts and flights match the golden ones" * test::needs_shared(), S, float, double) {
  const json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/contacts.json");
  REQUIRE(golden["motions"].size() == 3);
  const std::int32_t tolerance = golden["tol"].integer();
  const std::string asf = shared_motion("02.asf");
  for (const json::Value& motion : golden["motions"].array()) {
    CAPTURE(motion["trial"].integer());
    Clip<S> clip;
    const std::string amc = shared_motion("02_0" + std::to_string(motion["trial"].integer()) + ".amc");
    REQUIRE(parse_acclaim(asf, amc, clip).ok());
    REQUIRE(clip.frames == motion["frames"].integer());
    const Contacts contacts = find_contacts(clip, find_joint_roles(clip));
    check_runs(contacts.left, motion["left_contact_runs"], tolerance);
    check_runs(contacts.right, motion["right_contact_runs"], tolerance);
    std::vector<FrameRun> flights;
    for (const Flight& flight : contacts.flights) flights.push_back({flight.take_off, flight.landing});
    check_runs(flights, motion["flights"], tolerance);
  }
}

TEST_CASE_TEMPLATE("131_03 leaps once, and flies only while no foot stands" * test::needs_shared(), S, float, double) {
  const std::string text = shared_motion("131_03.bvh");
  Clip<S> clip;
  REQUIRE(parse_bvh(text, clip).ok());
  scale_clip(clip, S(0.0254 / 0.45));
  const Contacts contacts = find_contacts(clip, find_joint_roles(clip));
  REQUIRE(contacts.flights.size() == 1);
  // The right ball leaves the floor at 797; the left one is back on it at 825.
  CHECK(std::abs(contacts.flights[0].take_off - 797) <= 3);
  CHECK(std::abs(contacts.flights[0].landing - 823) <= 4);
  for (const auto* runs : {&contacts.left, &contacts.right}) {
    CHECK(runs->size() > 5);
    for (const FrameRun& run : *runs) {
      CHECK((run.end <= contacts.flights[0].take_off + 1 || run.begin >= contacts.flights[0].landing));
    }
  }
}

TEST_CASE_TEMPLATE("a jump of known length, on a floor that does not matter", S, float, double) {
  for (const double floor : {0.0, 3.0, -0.5}) {
    // Up at 1 s with 2 m/s, so down at 1 + 4 / 9.81 = 1.408 s; frames 120 and 169.
    const auto foot = [floor](double t) {
      const double s = t - 1;
      return floor + std::max(0.0, s < 0 ? 0.0 : 2 * s - 9.81 / 2 * s * s);
    };
    const auto root = [&](double t) { return foot(t) + 1; };
    const Clip<S> clip = stilts<S>(300, foot, foot, root);
    const Contacts contacts = find_contacts(clip, find_joint_roles(clip));
    REQUIRE(contacts.flights.size() == 1);
    CHECK(std::abs(contacts.flights[0].take_off - 120) <= 4);
    CHECK(std::abs(contacts.flights[0].landing - 169) <= 4);
    REQUIRE(contacts.left.size() == 2);
    CHECK(contacts.left[0].begin == 0);
    CHECK(std::abs(contacts.left[0].end - 121) <= 4);
    CHECK(contacts.right[1].end == 300);
  }
}

TEST_CASE("a foot that is held in the air does not stand, one on a stair does") {
  const auto ground = [](double) { return 0.0; };
  const auto one = [](double) { return 1.0; };
  const auto held = [](double) { return 0.4; };
  const auto stair = [](double) { return 0.17; };
  const Clip<double> balance = stilts<double>(400, ground, held, one);
  CHECK(find_contacts(balance, find_joint_roles(balance)).left.size() == 1);
  CHECK(find_contacts(balance, find_joint_roles(balance)).right.empty());
  const Clip<double> stairs = stilts<double>(400, ground, stair, one);
  CHECK(find_contacts(stairs, find_joint_roles(stairs)).right.size() == 1);
  CHECK(find_contacts(stairs, JointRoles{}).left.empty());
  CHECK(find_contacts(Clip<double>{}, find_joint_roles(stairs)).left.empty());
}

TEST_CASE("short clips have contacts and no flights") {
  for (const std::int32_t frames : {1, 2, 5}) {
    const Clip<float> clip = stilts<float>(
        frames, [](double) { return 0.0; }, [](double) { return 0.0; }, [](double) { return 1.0; });
    const Contacts contacts = find_contacts(clip, find_joint_roles(clip));
    REQUIRE(contacts.left.size() == 1);
    CHECK(contacts.left[0].end == frames);
    CHECK(contacts.flights.empty());
  }
}

TEST_CASE("labels and flights at 30 fps") {
  const std::vector<std::uint8_t> labels = contact_labels<double>({{8, 17}, {100, 101}}, 120.00048, 30, 30);
  for (std::size_t f = 0; f < labels.size(); ++f) CHECK(labels[f] == ((f >= 2 && f <= 4) || f == 25 ? 1 : 0));
  const std::vector<Flight> flights = resample_flights<float>({{110, 175}, {8, 13}, {399, 480}}, 120, 30, 110);
  REQUIRE(flights.size() == 3);
  CHECK(flights[0].take_off == 27);
  CHECK(flights[0].landing == 44);
  CHECK(flights[1].take_off == 2);
  CHECK(flights[1].landing == 4);
  CHECK(flights[2].landing == 109);
}
