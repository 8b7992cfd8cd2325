// A dog whose head is farther before its hind feet than above them was taken for a man in a file in which Z points up.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>

#include "rigless/motion/parse_bvh.h"
#include "rigless/motion/standardise.h"

using namespace rigless;

namespace {

// A dog of .5 m that trots two metres ahead, along Z or X, of a file with Y up.
std::string dog(bool along_x) {
  const auto at = [&](double side, double up, double ahead) {
    if (along_x) std::swap(side, ahead), ahead = -ahead;
    return std::to_string(side) + " " + std::to_string(up) + " " + std::to_string(ahead) + "\n";
  };
  std::string text = "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n";
  int open = 1;
  const auto joint = [&](const char* name, const std::string& offset, bool turns = false) {
    text += std::string("JOINT ") + name + "\n{\nOFFSET " + offset + "CHANNELS " +
            (turns ? "3 Xrotation Yrotation Zrotation\n" : "0\n");
    ++open;
  };
  const auto end = [&](const std::string& offset) { text += "End Site\n{\nOFFSET " + offset + "}\n"; };
  const auto close = [&](int joints) {
    for (; joints > 0; --joints, --open) text += "}\n";
  };
  for (const bool left : {true, false}) {
    const double side = left ? 0.1 : -0.1;
    joint(left ? "LeftUpLeg" : "RightUpLeg", at(side, 0, 0), true);
    joint(left ? "LeftLeg" : "RightLeg", at(0, -0.22, 0));
    joint(left ? "LeftFoot" : "RightFoot", at(0, -0.2, 0));
    end(at(0, -0.05, 0.08));
    close(3);
  }
  joint("Spine", at(0, 0.02, 0.3));
  joint("Neck", at(0, 0, 0.3));
  joint("Head", at(0, -0.05, 0.25));
  end(at(0, 0, 0.15));
  close(2);
  for (const bool left : {true, false}) {
    joint(left ? "LeftArm" : "RightArm", at(left ? 0.1 : -0.1, 0, 0.3), true);
    joint(left ? "LeftForeArm" : "RightForeArm", at(0, -0.22, 0));
    joint(left ? "LeftHand" : "RightHand", at(0, -0.22, 0));
    end(at(0, -0.05, 0.05));
    close(3);
  }
  close(open);
  text += "MOTION\nFrames: 60\nFrame Time: 0.033333\n";
  for (int f = 0; f < 60; ++f) {
    std::string row = at(0, 0.5, f / 30.0);
    for (const double phase : {0.0, 3.14, 3.14, 0.0}) {  // the legs swing about the axis that points sideways
      const double swing = 25 * std::sin(f * 0.5 + phase);
      row += along_x ? "0 0 " + std::to_string(swing) + "\n" : std::to_string(swing) + " 0 0\n";
    }
    for (char& c : row) c = c == '\n' ? ' ' : c;
    text += row + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("a dog is not turned because its head is before it") {
  for (const bool along_x : {false, true}) {
    CAPTURE(along_x);
    Clip<double> clip;
    ParseNotes notes;
    REQUIRE(parse_bvh(dog(along_x), clip, &notes).ok());
    const Standardised<double> done = standardise<double>(clip, notes.rest);
    REQUIRE(done.roles.head >= 0);
    CHECK(done.up == UpAxis::y);
  }
}
