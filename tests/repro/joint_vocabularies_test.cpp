// Names that were not read: a VRM leg had no side, "rclavicle" no part, and so neither was paired nor mirrored.
#include <doctest/doctest.h>

#include "rigless/motion/joint_names.h"

using namespace rigless;

TEST_CASE("a side inside the name, and one grown together with a collarbone") {
  const std::vector<JointName> vrm = read_joint_names({"J_Bip_C_Hips", "J_Bip_L_UpperLeg", "J_Bip_R_UpperLeg"});
  CHECK(vrm[1].side == BodySide::left);
  CHECK(vrm[1].part == BodyPart::upper_leg);
  CHECK(vrm[1].label == "Left hip");
  const std::vector<JointName> collar = read_joint_names({"rclavicle"});
  CHECK(collar[0].side == BodySide::right);
  CHECK(collar[0].part == BodyPart::shoulder);
}
