// Files whose hips hang on a "Reference", an "Armature" or a "root": the unit was guessed from the floor to the head
// (.0028 to .0055 for .01), yaw stayed 0 through turns, and the dancer did not travel.
#include <doctest/doctest.h>

#include <string>

#include "rigless/motion/detail/body_frame.h"
#include "rigless/motion/parse_bvh.h"
#include "rigless/motion/standardise.h"
#include "support/json.h"

using namespace rigless;
using namespace rigless::detail;

namespace {

std::string motion_text(const char* name) {
  return json::read_text(std::string(RIGLESS_TEST_DIR "../web/assets/motions/") + name);
}

// The file with joints above its root. If they move, they carry the root's way and turns, and the hips keep theirs.
std::string with_joints_above(std::string text, const std::vector<std::string>& above, const std::string& values) {
  std::string head;
  std::string tail;
  for (const std::string& name : above) {
    head += (head.empty() ? "ROOT " : "JOINT ") + name + "\n{\nOFFSET 0 0 0\nCHANNELS ";
    head += values.empty() ? "0\n" : "6 Xposition Yposition Zposition Yrotation Xrotation Zrotation\n";
    tail += "}\n";
  }
  text.replace(text.find("ROOT"), 4, head + "JOINT");
  text.insert(text.find("MOTION"), tail);
  if (values.empty()) return text;
  std::string line;
  for (std::size_t k = 0; k < above.size(); ++k) line += values + " ";
  for (std::size_t at = text.find('\n', text.find("Frame Time")) + 1; at < text.size(); at = text.find('\n', at) + 1) {
    text.insert(at, line);
    if (text.find('\n', at) == text.npos) break;
  }
  return text;
}

struct Read {
  Clip<double> clip;
  ParseNotes notes;
  Standardised<double> done;
};

Read read(const std::string& text) {
  Read read;
  REQUIRE(parse_bvh(text, read.clip, &read.notes).ok());
  read.done = standardise<double>(read.clip, read.notes.rest);
  return read;
}

}  // namespace

TEST_CASE("joints above the hips change nothing") {
  for (const char* file : {"walk.bvh", "turn.bvh", "jump.bvh"}) {
    const Read plain = read(motion_text(file));
    REQUIRE(plain.notes.joints_folded == 0);
    const std::vector<double> yaw = body_yaw(plain.clip);
    const std::vector<std::vector<std::string>> aboves = {
        {"Reference"}, {"Armature", "root"}, {"joint_Root", "Ground", "CenterOfMass"}};
    for (const auto& above : aboves) {
      // At rest; carried along; carried along and turned.
      for (const std::string values : {"", "0 0 0 0 0 0", "30 0 -20 0 0 0", "5 0 7 40 0 0"}) {
        CAPTURE(file);
        CAPTURE(values);
        const Read folded = read(with_joints_above(motion_text(file), above, values));
        CHECK(folded.notes.joints_folded == static_cast<std::int32_t>(above.size()));
        CHECK(folded.clip.skeleton.names == plain.clip.skeleton.names);
        CHECK(folded.clip.skeleton.parents == plain.clip.skeleton.parents);
        CHECK(folded.done.unit.metres_per_unit == plain.done.unit.metres_per_unit);
        CHECK(folded.done.up == plain.done.up);
        CHECK(folded.done.roles.root == 0);
        CHECK(folded.notes.rest.size() == plain.notes.rest.size());
        const std::vector<double> turned = body_yaw(folded.clip);
        const std::int32_t last = plain.clip.frames - 1;
        const auto way = [&](const Clip<double>& clip) { return (clip.at(last, 0) - clip.at(0, 0)).norm(); };
        CHECK(way(folded.clip) == doctest::Approx(way(plain.clip)).epsilon(1e-9));
        for (std::size_t f = 0; f < yaw.size(); ++f) {
          REQUIRE(turned[f] - turned[0] == doctest::Approx(yaw[f] - yaw[0]).epsilon(1e-9));
        }
      }
    }
  }
}

TEST_CASE("what hangs beside the hips goes with the joint above them, and a numbered skeleton is folded too") {
  std::string text = with_joints_above(motion_text("walk.bvh"), {"root"}, "");
  text.insert(text.find("}\nMOTION"),
              "JOINT ik_foot_l\n{\nOFFSET 9 0 0\nCHANNELS 0\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n");
  const Read plain = read(motion_text("walk.bvh"));
  CHECK(read(text).clip.skeleton.names == plain.clip.skeleton.names);
  Clip<double> clip;
  REQUIRE(parse_bvh(motion_text("walk.bvh"), clip).ok());
  for (std::size_t j = 0; j < clip.skeleton.names.size(); ++j) {
    const std::string& name = clip.skeleton.names[j];
    if (name.find("_end") != name.npos) continue;
    for (const char* key : {"ROOT ", "JOINT "}) {
      const std::size_t at = text.find(key + name + "\n");
      if (at != text.npos) text.replace(at, (key + name).size(), key + ("joint_" + std::to_string(j)));
    }
  }
  const Read numbered = read(text);
  CHECK(numbered.notes.joints_folded == 1);
  CHECK(numbered.clip.positions == plain.clip.positions);
}
