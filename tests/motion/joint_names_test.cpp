#include "rigless/motion/joint_names.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "support/json.h"

using namespace rigless;

namespace {

std::string part_word(BodyPart part) {
  constexpr const char* words[] = {"none",      "hips",      "spine",     "chest", "neck",   "head",
                                   "shoulder",  "upper_arm", "lower_arm", "hand",  "finger", "upper_leg",
                                   "lower_leg", "foot",      "toe",       "tip",   "end"};
  return words[static_cast<std::size_t>(part)];
}

std::string side_word(BodySide side) {
  constexpr const char* words[] = {"none", "left", "right"};
  return words[static_cast<std::size_t>(side)];
}

}  // namespace

TEST_CASE("joint names say side, part and label in every vocabulary of the golden table") {
  const json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/joint-names.json");
  REQUIRE(golden["skeletons"].size() >= 27);
  for (const json::Value& skeleton : golden["skeletons"].array()) {
    CAPTURE(skeleton["vocabulary"].string());
    std::vector<std::string> names;
    for (const json::Value& joint : skeleton["joints"].array()) names.push_back(joint[0].string());
    const std::vector<JointName> read = read_joint_names(names);
    REQUIRE(read.size() == names.size());
    for (std::size_t j = 0; j < names.size(); ++j) {
      CAPTURE(names[j]);
      const json::Value& joint = skeleton["joints"][j];
      CHECK(side_word(read[j].side) == joint[1].string());
      CHECK(part_word(read[j].part) == joint[2].string());
      CHECK(read[j].label == joint[3].string());
    }
  }
}
