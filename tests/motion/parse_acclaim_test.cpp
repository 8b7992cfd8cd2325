#include "rigless/motion/parse_acclaim.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "rigless/motion/detail/body_frame.h"
#include "sample_motions.h"
#include "support/json.h"

using namespace rigless;
using namespace rigless::detail;

namespace {

constexpr double unit = 0.0254 / 0.45;

template <class S>
std::int32_t joint(const Clip<S>& clip, const std::string& name) {
  const auto& names = clip.skeleton.names;
  return static_cast<std::int32_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

void check_small_asf(const Clip<double>& clip) {
  REQUIRE(clip.frames == 2);
  REQUIRE(clip.skeleton.names == std::vector<std::string>{"root", "thigh", "shin"});
  CHECK(clip.fps == 120);
  CHECK(clip.metres_per_unit == doctest::Approx(unit));
  CHECK(clip.at(0, 1).isApprox(unit * Vec3<double>(0, 1, 0)));
  CHECK(clip.at(0, 2).isApprox(unit * Vec3<double>(0, -3, 0)));
  // The thigh's own x axis is the world's y: turning about it leaves a bone along y where it is.
  CHECK(clip.at(1, 1).isApprox(unit * Vec3<double>(1, 1, 0)));
  CHECK(clip.at(1, 2).isApprox(unit * Vec3<double>(1, -3, 0)));
}

}  // namespace

TEST_CASE_TEMPLATE("ASF/AMC joints, yaw and body-local joints match the golden motion" * test::needs_shared(), S, float,
                   double) {
  const json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/motion.json")["asf"];
  REQUIRE(golden["pos"].size() == 4);
  const std::string asf = shared_motion("02.asf");
  const std::string amc = shared_motion("02_01.amc");
  Clip<S> clip;
  ParseNotes notes;
  REQUIRE(parse_acclaim(asf, amc, clip, &notes).ok());
  CHECK(clip.frames == golden["frames_total"].integer());
  CHECK_FALSE(notes.frame_cut);
  CHECK(clip.fps == 120);
  REQUIRE(clip.joints() == static_cast<std::int32_t>(golden["names"].size()));
  const std::vector<S> yaw = body_yaw(clip);
  const std::vector<Vec3<S>> local = body_local_positions<S>(clip, yaw);
  const std::vector<std::string> names = golden["names"].strings();
  const std::vector<std::int32_t> parents = golden["parents"].integers();
  for (std::size_t k = 0; k < golden["frames"].size(); ++k) {
    const std::int32_t frame = golden["frames"][k].integer();
    CHECK(static_cast<double>(yaw[static_cast<std::size_t>(frame)]) ==
          doctest::Approx(golden["yaw"][k].number()).epsilon(1e-6));
    for (std::size_t g = 0; g < names.size(); ++g) {
      const std::int32_t j = joint(clip, names[g]);
      REQUIRE(j < clip.joints());
      const std::int32_t parent = clip.skeleton.parents[static_cast<std::size_t>(j)];
      CHECK((parent < 0) == (parents[g] < 0));
      if (parent >= 0) {
        CHECK(parent < j);
        CHECK(clip.skeleton.names[static_cast<std::size_t>(parent)] == names[static_cast<std::size_t>(parents[g])]);
      }
      const Vec3<double> p = clip.at(frame, j).template cast<double>();
      CHECK((p - golden["pos"][k][g].vec3<double>()).norm() < 1e-6);
      const Vec3<S>& l = local[static_cast<std::size_t>(frame) * names.size() + static_cast<std::size_t>(j)];
      CHECK((l.template cast<double>() - golden["local"][k][g].vec3<double>()).norm() < 1e-6);
    }
  }
}

TEST_CASE("the small ASF/AMC pair, in every guise") {
  Clip<double> clip;
  REQUIRE(parse_acclaim(small_asf, small_amc, clip).ok());
  check_small_asf(clip);
  const std::string asf(small_asf);
  const std::string amc(small_amc);
  const std::pair<std::string, std::string> guises[] = {
      {replaced(asf, "\n", "\r\n"), replaced(amc, "\n", "\r\n")},
      {replaced(asf, "\n", "\r"), replaced(amc, "\n", "\r")},
      {replaced(asf, "    root thigh\n    thigh shin\n", "    thigh shin\n    root thigh\n"), amc},
      {replaced(asf, "dof rx rz", "DOF RX rz"), replaced(amc, ":DEGREES", ":degrees")},
      {replaced(asf, "dof rx rz", "dof rz rx l"),
       replaced(replaced(amc, "thigh 90 0", "thigh 0 90 3"), "thigh 0 0", "thigh 0 0 1")},
      {replaced(asf, "order TX TY TZ RX RY RZ", "order RX RY RZ TX TY TZ"),
       replaced(replaced(amc, "root 0 9 0 0 0 0", "root 0 0 0 0 9 0"), "root 1 9 0 0 90 0", "root 0 90 0 1 9 0")},
      {asf, replaced(amc, "thigh 0 0\n", "")},  // at rest where left out
      {asf, replaced(amc, "root 1 9 0 0 90 0\nthigh 90 0\n", "thigh 90 0\nshin\nroot 1 9 0 0 90 0")},
      {asf, replaced(amc, ":DEGREES\n", "")},
      {asf, replaced(replaced(amc, ":DEGREES", ":RADIANS"), " 90 0\n", " 1.5707963267948966 0\n")},
      {asf, replaced(replaced(amc, "thigh", "Thigh"), "root", "ROOT")},
      {replaced(asf, "root thigh\n    thigh shin", "ROOT Thigh\n    THIGH shin"), amc},
  };
  for (const auto& guise_texts : guises) {
    const std::string& skeleton = guise_texts.first;
    const std::string& motion = guise_texts.second;
    CAPTURE(skeleton);
    CAPTURE(motion);
    Clip<double> guise;
    REQUIRE(parse_acclaim<double>(skeleton, motion, guise).ok());
    check_small_asf(guise);
  }
  const std::string radians =
      replaced(replaced(asf, "angle deg", "angle rad"), "0 0 90 XYZ", "0 0 1.5707963267948966 XYZ");
  REQUIRE(parse_acclaim<double>(radians, amc, clip).ok());
  check_small_asf(clip);
}

TEST_CASE("dofs turn first to last about the bone's own axes") {
  const std::string asf = replaced(replaced(small_asf, "0 0 90 XYZ", "0 0 0 XYZ"), "rx rz", "rx ry rz");
  Clip<double> clip;
  const std::string amc = "1\nroot 0 0 0 0 0 0\nthigh 90 90 0\n";
  REQUIRE(parse_acclaim<double>(asf, amc, clip).ok());
  CHECK(clip.at(0, 1).isApprox(8 * unit * Vec3<double>(-1, 0, 0)));  // x: -y to -z; y: -z to -x
}

TEST_CASE("frames that are cut or sparse") {
  const std::string amc(small_amc);
  Clip<double> clip;
  ParseNotes notes;
  REQUIRE(parse_acclaim<double>(small_asf, amc.substr(0, amc.size() - 3), clip, &notes).ok());  // "thigh 90"
  CHECK(clip.frames == 1);
  CHECK(notes.frame_cut);
  REQUIRE(parse_acclaim<double>(small_asf, amc.substr(0, amc.size() - 11), clip, &notes).ok());  // no thigh
  CHECK(clip.frames == 1);
  CHECK(notes.frame_cut);
  REQUIRE(parse_acclaim<double>(small_asf, amc + "3\nthigh 0 0\nshin\n", clip, &notes).ok());  // no root: it stays
  REQUIRE(clip.frames == 3);
  CHECK(clip.at(2, 0).isApprox(clip.at(1, 0)));
  REQUIRE(parse_acclaim<double>(replaced(small_asf, "dof rx rz", "dof rx rz l"),
                                replaced(replaced(amc, "thigh 0 0", "thigh 0 0 0"), "thigh 90 0", "thigh 90 0 0"), clip,
                                &notes)
              .ok());
  CHECK(notes.lengths_ignored == 1);
  REQUIRE(parse_acclaim<double>(small_asf, replaced(amc, ":DEGREES", ":SAMPLES-PER-SECOND 60\n:DEGREES"), clip).ok());
  CHECK(clip.fps == 60);
  REQUIRE(parse_acclaim<double>(small_asf, amc, clip, &notes).ok());
  CHECK((clip.fps == 120 && notes.frame_time_assumed));
}

TEST_CASE("malformed ASF/AMC files say what and where, and leave the outputs alone") {
  struct Case {
    std::string text;
    Error error;
    std::int32_t where;
  };
  const std::string asf(small_asf);
  const Case skeletons[] = {
      {"\n", Error::empty_input, -1},
      {std::string(small_bvh), Error::not_this_format, 1},
      {std::string(small_amc), Error::not_this_format, 1},
      {asf.substr(0, asf.find("    dof")), Error::unexpected_end, 21},
      {asf.substr(0, asf.find(":hierarchy")), Error::unexpected_end, 32},
      {asf.substr(0, asf.rfind("  end")), Error::unexpected_end, 36},
      {replaced(asf, "length 8", "length eight"), Error::bad_number, 20},
      {replaced(asf, "length 0.45", "length 0"), Error::bad_number, 6},
      {replaced(asf, "0 0 90 XYZ", "0 0 90 XYW"), Error::bad_syntax, 21},
      {replaced(asf, "name shin", "name thigh"), Error::duplicate_joint, 28},
      {replaced(asf, "thigh shin", "thigh shank"), Error::unknown_joint, 36},
      {replaced(asf, "root thigh", "shin thigh"), Error::bad_syntax, 35},  // a ring that no root holds
      {replaced(asf, "thigh shin", "root shin\n root shin"), Error::bad_syntax, 37},
  };
  for (const Case& c : skeletons) {
    CAPTURE(c.text);
    AcclaimSkeleton skeleton;
    skeleton.length_unit = 77;
    const Status status = parse_asf(c.text, skeleton);
    CHECK(static_cast<int>(status.error) == static_cast<int>(c.error));
    CHECK(status.where == c.where);
    CHECK(skeleton.length_unit == 77);
  }

  AcclaimSkeleton skeleton;
  REQUIRE(parse_asf(small_asf, skeleton).ok());
  const std::string amc(small_amc);
  const Case motions[] = {
      {"", Error::empty_input, -1},
      {":FULLY-SPECIFIED\n", Error::no_frames, -1},
      {asf, Error::not_this_format, 2},
      {std::string(small_bvh), Error::not_this_format, 1},
      {replaced(amc, "thigh 90", "lfemur 90"), Error::unknown_joint, 9},
      {replaced(amc, "thigh 90 0", "thigh 90 nan"), Error::bad_number, 9},
      {replaced(amc, "thigh 0 0", "thigh 0"), Error::bad_syntax, 6},
      {replaced(amc, "thigh 0 0", "thigh 0 0 0"), Error::bad_syntax, 6},
      {replaced(amc, "thigh 0 0", "shin 0"), Error::bad_syntax, 6},
  };
  for (const Case& c : motions) {
    CAPTURE(c.text);
    Clip<double> clip;
    clip.frames = 77;
    const Status status = parse_amc(c.text, skeleton, clip);
    CHECK(static_cast<int>(status.error) == static_cast<int>(c.error));
    CHECK(status.where == c.where);
    CHECK(clip.frames == 77);
  }
}

TEST_CASE("no text crashes the Acclaim parsers") {
  const std::string asf(small_asf);
  const std::string amc(small_amc);
  AcclaimSkeleton whole;
  REQUIRE(parse_asf(asf, whole).ok());
  for (std::size_t n = 0; n < asf.size(); ++n) {
    AcclaimSkeleton skeleton;
    const Status cut = parse_asf(asf.substr(0, n), skeleton);
    CHECK(cut.ok() == !skeleton.order.empty());
    for (const char c : {'9', ' ', '\0', '\xff', ':', '\n'}) {
      std::string changed = asf;
      changed[n] = c;
      AcclaimSkeleton other;
      if (!parse_asf(changed, other).ok()) continue;
      Clip<float> clip;
      const Status status = parse_amc(amc, other, clip);
      CHECK(status.ok() == (clip.frames > 0));
    }
  }
  for (std::size_t n = 0; n < amc.size(); ++n) {
    Clip<float> clip;
    const Status status = parse_amc(std::string_view(amc).substr(0, n), whole, clip);
    CHECK(status.ok() == (clip.frames > 0));
  }
}
