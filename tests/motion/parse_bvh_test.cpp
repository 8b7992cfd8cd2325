#include "rigless/motion/parse_bvh.h"

#include <doctest/doctest.h>

#include <string>

#include "sample_motions.h"
#include "support/json.h"

using namespace rigless;

namespace {

std::string bvh(const std::string& root_body, const std::string& motion) {
  return "HIERARCHY\nROOT Hips\n{\n" + root_body + "}\nMOTION\n" + motion;
}

Status parse(const std::string& text) {
  Clip<double> clip;
  return parse_bvh<double>(text, clip);
}

void check_small_bvh(const Clip<double>& clip) {
  REQUIRE(clip.frames == 2);
  REQUIRE(clip.joints() == 4);
  CHECK(clip.skeleton.parents == std::vector<std::int32_t>{-1, 0, 1, 0});
  CHECK(clip.at(0, 2).isApprox(Vec3<double>(1, 2, 0)));
  // The root turned a quarter about z, the knee another: its bone points down.
  CHECK(clip.at(1, 0).isApprox(Vec3<double>(10, 20, 30)));
  CHECK(clip.at(1, 1).isApprox(Vec3<double>(10, 21, 30)));
  CHECK(clip.at(1, 2).isApprox(Vec3<double>(10, 19, 30)));
  CHECK(clip.at(1, 3).isApprox(Vec3<double>(10, 20, 33)));
}

}  // namespace

TEST_CASE_TEMPLATE("BVH joints match the golden motion" * test::needs_shared(), S, float, double) {
  const json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/motion.json")["bvh"];
  REQUIRE(golden["pos"].size() == 4);
  const std::string text = shared_motion("131_03.bvh");
  Clip<S> clip;
  ParseNotes notes;
  REQUIRE(parse_bvh(text, clip, &notes).ok());
  CHECK(clip.frames == golden["frames_total"].integer());
  CHECK(notes.frames_declared == clip.frames);
  CHECK_FALSE(notes.frame_cut);
  CHECK(clip.fps == doctest::Approx(golden["fps"].number()).epsilon(1e-7));
  CHECK(clip.metres_per_unit == 1);
  CHECK(clip.skeleton.names == golden["names"].strings());
  CHECK(clip.skeleton.parents == golden["parents"].integers());
  const double tolerance = std::is_same_v<S, float> ? 1e-5 : 1e-6;  // units of 0.056 m, up to 40 from the origin
  for (std::size_t k = 0; k < golden["frames"].size(); ++k) {
    const auto expected = golden["pos"][k].vec3s<double>();
    for (std::int32_t j = 0; j < clip.joints(); ++j) {
      const Vec3<double> p = clip.at(golden["frames"][k].integer(), j).template cast<double>();
      CHECK((p - expected[static_cast<std::size_t>(j)]).norm() < tolerance);
    }
  }
}

TEST_CASE("BVH files met elsewhere parse whole" * test::needs_shared()) {
  for (const auto& [name, frames] : {std::pair("jumping_jacks.bvh", 125), std::pair("zombie.bvh", 779)}) {
    const std::string text = shared_motion(name);
    Clip<float> clip;
    REQUIRE(parse_bvh(text, clip).ok());
    CHECK(clip.frames == frames);
    CHECK(clip.fps == doctest::Approx(30).epsilon(1e-3));
  }
}

TEST_CASE("the small BVH file, in every guise") {
  Clip<double> clip;
  REQUIRE(parse_bvh(small_bvh, clip).ok());
  check_small_bvh(clip);
  CHECK(clip.fps == doctest::Approx(25));
  CHECK(clip.skeleton.names == std::vector<std::string>{"Hips", "Knee", "Knee_end", "Tail"});

  const std::string guises[] = {
      replaced(small_bvh, "\n", "\r\n"),
      replaced(small_bvh, "\n", "\r"),
      "\xEF\xBB\xBF" + std::string(small_bvh),
      replaced(small_bvh, " ", "\t "),
      replaced(small_bvh, "\n", "\n\n"),
      replaced(small_bvh, "\n", " # note\n// another\n"),
      replaced(replaced(small_bvh, "\n  ", " "), "\n}", " }"),  // braces beside words
      replaced(replaced(small_bvh, "JOINT", "Joint"), "CHANNELS", "channels"),
      replaced(replaced(small_bvh, "rotation", "ROTATION"), "End Site", "END SITE"),
      replaced(small_bvh, "Frame Time: 0.04", "Frame Time:\t4.0e-02"),
      replaced(small_bvh, "Frame Time: 0.04", "FRAME TIME :0,04"),
      replaced(small_bvh, "Frames: 2\nFrame Time: 0.04", "Frame Time: 0.04\nFrames:2"),
      replaced(small_bvh, "10 20 30 90 0 0 90\n", "10 20 30\n90 0\n0 90"),  // wrapped, no final line end
      replaced(small_bvh, "10 20 30 90 0 0 90", "1e1 2.E+01 +30 90.0 -0 1e-16 90"),
      replaced(small_bvh, "End Site", "End Site Knee_Nub"),
      "The title: a hierarchy\n; a note\n" + std::string(small_bvh),
      replaced(replaced(small_bvh, "rotation", "rot"), "position", "pos"),
      replaced(small_bvh, "Frames: 2\n", ""),
      replaced(small_bvh, "Frames: 2\nFrame Time: 0.04", "Frames 2\nFrame Time 0.04"),
      replaced(small_bvh, "Time: 0.04", "Time: 40"),                                                    // milliseconds
      replaced(small_bvh, "Time: 0.04", "Time: 25"),                                                    // a second
      replaced(replaced(small_bvh, "0 0 0 0 0 0 0\n", "1 0 0 0 0 0 0 0\n"), "10 20 30", "2 10 20 30"),  // numbered
  };
  for (const std::string& text : guises) {
    CAPTURE(text);
    Clip<double> guise;
    REQUIRE(parse_bvh(text, guise).ok());
    check_small_bvh(guise);
  }
}

TEST_CASE("rotations multiply in the order of the channels") {
  const std::string body = "OFFSET 0 0 0\nCHANNELS 2 Xrotation Yrotation\nEnd Site { OFFSET 0 0 1 }\n";
  Clip<double> clip;
  REQUIRE(parse_bvh(bvh(body, "Frames: 1\nFrame Time: 1\n90 90"), clip).ok());
  CHECK(clip.at(0, 1).isApprox(Vec3<double>(1, 0, 0)));  // y first, from z to x, which x leaves alone
  REQUIRE(
      parse_bvh(bvh(replaced(body, "Xrotation Yrotation", "Yrotation Xrotation"), "Frames: 1\nFrame Time: 1\n90 90"),
                clip)
          .ok());
  CHECK(clip.at(0, 1).isApprox(Vec3<double>(0, -1, 0)));
  CHECK(clip.at(0, 0).isZero());  // a root without position stands on its OFFSET
}

TEST_CASE("position channels below the root stand for OFFSET or come on top of it") {
  const std::string body =
      "OFFSET 5 0 0\nCHANNELS 3 Xposition Yposition Zposition\n"
      "JOINT A\n{\nOFFSET 0 2 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n}\n";
  Clip<double> clip;
  REQUIRE(parse_bvh(bvh(body, "Frames: 2\nFrame Time: .1\n1 1 1 0 2.1 0 0 0 0\n1 1 1 0 1.9 0 0 0 0"), clip).ok());
  CHECK(clip.at(0, 0).isApprox(Vec3<double>(1, 1, 1)));
  CHECK(clip.at(0, 1).isApprox(Vec3<double>(1, 3.1, 1)));
  REQUIRE(parse_bvh(bvh(body, "Frames: 2\nFrame Time: .1\n1 1 1 0 .1 0 0 0 0\n1 1 1 0 0 0 0 0 0"), clip).ok());
  CHECK(clip.at(0, 1).isApprox(Vec3<double>(1, 3.1, 1)));
}

TEST_CASE("what is odd but usable is used, and noted") {
  Clip<double> clip;
  ParseNotes notes;
  REQUIRE(parse_bvh(replaced(small_bvh, "Frames: 2", "Frames: 2000000000"), clip, &notes).ok());
  CHECK(clip.frames == 2);
  CHECK(notes.frames_declared == 2000000000);
  CHECK(notes.frames_read == 2);
  CHECK(notes.rest[2] == Vec3<double>(1, 2, 0));

  REQUIRE(parse_bvh(std::string(small_bvh) + "1 2 3", clip, &notes).ok());
  CHECK(notes.text_after_end);
  REQUIRE(parse_bvh(replaced(small_bvh, " 0 0 90\n", " 0 0"), clip, &notes).ok());
  CHECK(clip.frames == 1);
  CHECK(notes.frame_cut);
  REQUIRE(parse_bvh(replaced(small_bvh, "Frames: 2", "Frames: 0"), clip, &notes).ok());
  CHECK(clip.frames == 2);
  REQUIRE(parse_bvh(replaced(small_bvh, "Time: 0.04", "Time: 0"), clip, &notes).ok());
  CHECK(clip.fps == doctest::Approx(30));
  CHECK(notes.frame_time_assumed);

  const std::string second = "ROOT Prop\n{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\n}\nMOTION";
  std::string two = replaced(small_bvh, "MOTION", second);
  two = replaced(replaced(two, "0 0 0 0 0 0 0\n", "0 0 0 0 0 0 0 7\n"), "0 0 90\n", "0 0 90 7\n");
  REQUIRE(parse_bvh(two, clip, &notes).ok());
  CHECK(notes.roots == 2);
  check_small_bvh(clip);

  REQUIRE(parse_bvh(replaced(replaced(small_bvh, "Tail", "Knee"), "ROOT Hips", "ROOT"), clip, &notes).ok());
  CHECK(clip.skeleton.names == std::vector<std::string>{"joint", "Knee", "Knee_end", "Knee_2"});
  CHECK(notes.renamed == 2);
  REQUIRE(parse_bvh(replaced(small_bvh, "Knee", "Bip01 L: Knee"), clip, &notes).ok());
  CHECK(clip.skeleton.names[2] == "Bip01 L: Knee_end");
}

TEST_CASE("what lines of a BVH file lack or have too much is noted") {
  const std::string head = replaced(small_bvh, "0 0 0 0 0 0 0\n10 20 30 90 0 0 90\n", "");
  const std::string row = "0 0 0 0 0 0 0\n", last = "10 20 30 90 0 0 90\n";
  Clip<double> clip;
  ParseNotes notes;
  for (const char* bad : {"1 2 3 4 5 6\n", "1 2 3 4 5 6 7 8\n"}) {
    const std::string frames = row + row + bad + last;
    REQUIRE(parse_bvh(replaced(head, "Frames: 2", "Frames: 4") + frames, clip, &notes).ok());
    CHECK(clip.frames == 4);
    CHECK(notes.rows_replaced == 1);
    CHECK(notes.row_replaced == 25);
    CHECK(clip.at(2, 0) == clip.at(1, 0));
    CHECK(clip.at(3, 1).isApprox(Vec3<double>(10, 21, 30)));
  }
  REQUIRE(parse_bvh(head + "1 " + row + "2 " + last, clip, &notes).ok());
  check_small_bvh(clip);
  CHECK(notes.frame_numbers);
  CHECK(notes.rows_replaced == 0);
  REQUIRE(parse_bvh(replaced(head, "Frames: 2", "Frames: 3") + row + last + "1 2 3", clip, &notes).ok());
  check_small_bvh(clip);
  CHECK(notes.frame_cut);

  REQUIRE(parse_bvh(replaced(small_bvh, "Time: 0.04", "Time: 40"), clip, &notes).ok());
  CHECK(notes.frame_time_unit == FrameTimeUnit::milliseconds);
  REQUIRE(parse_bvh(replaced(small_bvh, "Time: 0.04", "Time: 29.97"), clip, &notes).ok());
  CHECK(notes.frame_time_unit == FrameTimeUnit::rate);
  CHECK(clip.fps == doctest::Approx(29.97));

  const std::string scaled = replaced(small_bvh, "CHANNELS 1 Zrotation", "CHANNELS 2 Zrotation Xscale");
  for (const int stretched : {0, 1}) {
    const std::string frames = "0 0 0 0 0 0 0 1\n10 20 30 90 0 0 90 " + std::to_string(1 + stretched) + "\n";
    REQUIRE(parse_bvh(replaced(scaled, row + last, frames), clip, &notes).ok());
    check_small_bvh(clip);
    CHECK(notes.lengths_ignored == stretched);
  }
}

TEST_CASE("angles in radians are told by a skeleton that would hardly move") {
  std::string hierarchy = "HIERARCHY\nROOT a\n{\nCHANNELS 1 Xrotation\n";
  for (int j = 1; j < 12; ++j) hierarchy += "JOINT b {\nOFFSET 0 1 0\nCHANNELS 1 Xrotation\n";
  hierarchy += std::string(12, '}') + "\nMOTION\nFrames: 1\nFrame Time: 1\n7 0 0 0 0 0 0 0 0 0 ";
  Clip<double> clip;
  ParseNotes notes;
  REQUIRE(parse_bvh(hierarchy + "1.57 0", clip, &notes).ok());
  CHECK(notes.radians);
  CHECK((clip.at(0, 11) - clip.at(0, 10)).dot(clip.at(0, 1) - clip.at(0, 0)) == doctest::Approx(0).epsilon(1e-3));
  for (const char* degrees : {"90 0", ".5 0", "0 -3.2"}) {
    REQUIRE(parse_bvh(hierarchy + degrees, clip, &notes).ok());
    CHECK_FALSE(notes.radians);
  }
}

TEST_CASE("malformed BVH files say what and where, and leave the clip alone") {
  struct Case {
    std::string text;
    Error error;
    std::int32_t where;
  };
  const std::string small(small_bvh);
  const Case cases[] = {
      {"", Error::empty_input, -1},
      {" \r\n# only a note\n", Error::empty_input, -1},
      {"solid cube\nfacet", Error::not_this_format, 1},
      {std::string("\x89PNG\r\n\x1a\n\0\0", 10), Error::not_this_format, 1},
      {std::string(small_asf), Error::not_this_format, 2},
      {small.substr(0, small.find("End Site")), Error::unexpected_end, 9},
      {small.substr(0, small.find("MOTION")), Error::unexpected_end, 19},
      {small.substr(0, small.find("Frame Time")), Error::unexpected_end, 21},
      {small.substr(0, small.find("0 0 0 0 0 0 0")), Error::no_frames, -1},
      {replaced(small, "20 30 90", "20 nan 90"), Error::bad_number, 24},
      {replaced(small, "20 30 90", "20 -1.#IND 90"), Error::bad_number, 24},
      {replaced(small, "20 30 90", "20 inf 90"), Error::bad_number, 24},
      {replaced(small, "20 30 90", "20 1e999 90"), Error::bad_number, 24},
      {replaced(small, "20 30 90", "20 3o 90"), Error::bad_number, 24},
      {replaced(small, "OFFSET 1 0 0", "OFFSET 1 0"), Error::bad_number, 9},
      {replaced(small, "CHANNELS 1 Zrotation", "CHANNELS 2 Zrotation"), Error::unsupported, 10},
      {replaced(small, "CHANNELS 1 Zrotation", "CHANNELS 1 Zspin"), Error::unsupported, 9},
      {replaced(small, "CHANNELS 1 Zrotation", "CHANNELS 1e30 Zrotation"), Error::unsupported, 10},
      {replaced(small, "CHANNELS 1 Zrotation", "CHANNELS -1 Zrotation"), Error::bad_number, 9},
      {replaced(small, "CHANNELS 1", "CHANNEL 1"), Error::bad_syntax, 9},
      {replaced(small, "JOINT Knee\n  {", "JOINT Knee\n"), Error::bad_syntax, 8},
      {replaced(small, "Frames:", "Pictures:"), Error::bad_syntax, 21},
      {replaced(small, "Frames: 2", "Frames two"), Error::bad_number, 21},
      {replaced(replaced(small, "0 0 0 0 0 0 0\n", "0 0 0 0 0 0\n"), "0 0 90\n", "0 90\n"), Error::bad_syntax, 23},
      {replaced(small, "}\nMOTION", "}\n}\nMOTION"), Error::bad_syntax, 20},
      {replaced(small, "10 20 30", "1e300 1e300 1e300"), Error::none, -1},
      {"HIERARCHY\nMOTION\nFrames: 1\n", Error::bad_syntax, 2},
  };
  for (const Case& c : cases) {
    CAPTURE(c.text);
    Clip<double> clip;
    clip.frames = 77;
    const Status status = parse_bvh<double>(c.text, clip);
    CHECK(static_cast<int>(status.error) == static_cast<int>(c.error));
    CHECK(status.where == c.where);
    if (!status.ok()) CHECK(clip.frames == 77);
  }
  Clip<float> single;
  CHECK(parse_bvh(replaced(small, "10 20 30", "1e300 0 0"), single).error == Error::not_finite);
}

TEST_CASE("no text crashes the parser or makes it allocate what is not there") {
  const std::string small(small_bvh);
  for (std::size_t n = 0; n < small.size(); ++n) {
    Clip<double> clip;
    const Status status = parse_bvh<double>(small.substr(0, n), clip);
    CHECK(status.ok() == (clip.frames > 0));
  }
  for (std::size_t n = 0; n < small.size(); ++n) {
    for (const char c : {'{', '}', '9', ' ', '\0', '\xff', '-', '\n'}) {
      std::string changed = small;
      changed[n] = c;
      Clip<float> clip;
      const Status status = parse_bvh<float>(changed, clip);
      CHECK(status.ok() == (clip.frames > 0));
    }
  }
  // Deeper than any stack, and more joints times frames than any memory.
  std::string deep = "HIERARCHY\nROOT a {";
  for (int i = 0; i < 200000; ++i) deep += "JOINT a{";
  CHECK(parse(deep).error == Error::unexpected_end);
  std::string wide = "HIERARCHY ROOT a { CHANNELS 1 Xrotation\n";
  for (int i = 0; i < 50000; ++i) wide += "JOINT a{}\n";
  wide += "}\nMOTION\nFrames: 100000\nFrame Time: 1\n";
  for (int i = 0; i < 100000; ++i) wide += "0\n";
  CHECK(parse(wide).error == Error::out_of_memory);
}
