#include "rigless/motion/joint_roles.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "rigless/motion/parse_acclaim.h"
#include "rigless/motion/parse_bvh.h"
#include "sample_motions.h"

using namespace rigless;

namespace {

// A hip, knee, ankle, ball and End Site chain per side, a trunk and a head, with the names given.
struct Vocabulary {
  const char* root;
  const char* head;
  std::vector<const char*> left;  // hip, knee, ankle, toe, hand
  std::vector<const char*> right;
};

Skeleton skeleton(const Vocabulary& words) {
  Skeleton s;
  const auto add = [&](const std::string& name, std::int32_t parent) {
    s.names.push_back(name);
    s.parents.push_back(parent);
    return static_cast<std::int32_t>(s.names.size()) - 1;
  };
  add(words.root, -1);
  for (const auto* side : {&words.left, &words.right}) {
    std::int32_t joint = 0;
    for (std::size_t k = 0; k < 4; ++k) joint = add((*side)[k], joint);
    add(std::string((*side)[3]) + "_end", joint);
  }
  const std::int32_t head = add(words.head, add("Spine", 0));
  add(std::string(words.head) + "_end", head);
  add(words.left[4], head - 1);
  add(words.right[4], head - 1);
  return s;
}

}  // namespace

TEST_CASE("joint roles by the usual names") {
  const Vocabulary vocabularies[] = {
      {"Hips",
       "Head",
       {"LeftHip", "LeftKnee", "LeftAnkle", "LeftToe", "LeftWrist"},
       {"RightHip", "RightKnee", "RightAnkle", "RightToe", "RightWrist"}},
      {"mixamorig:Hips",
       "mixamorig:Head",
       {"mixamorig:LeftUpLeg", "mixamorig:LeftLeg", "mixamorig:LeftFoot", "mixamorig:LeftToeBase",
        "mixamorig:LeftHand"},
       {"mixamorig:RightUpLeg", "mixamorig:RightLeg", "mixamorig:RightFoot", "mixamorig:RightToeBase",
        "mixamorig:RightHand"}},
      {"Bip01",
       "Bip01 Head",
       {"Bip01 L Thigh", "Bip01 L Calf", "Bip01 L Foot", "Bip01 L Toe0", "Bip01 L Hand"},
       {"Bip01 R Thigh", "Bip01 R Calf", "Bip01 R Foot", "Bip01 R Toe0", "Bip01 R Hand"}},
      {"pelvis",
       "head",
       {"thigh_l", "calf_l", "foot_l", "ball_l", "hand_l"},
       {"thigh_r", "calf_r", "foot_r", "ball_r", "hand_r"}},
      {"hips",
       "head",
       {"thigh.L", "shin.L", "foot.L", "toe.L", "hand.L"},
       {"thigh.R", "shin.R", "foot.R", "toe.R", "hand.R"}},
      {"hip", "head", {"lThigh", "lShin", "lFoot", "lToe", "lHand"}, {"rThigh", "rShin", "rFoot", "rToe", "rHand"}},
      {"Pelvis",
       "Head",
       {"L_Hip", "L_Knee", "L_Ankle", "L_Foot", "L_Wrist"},
       {"R_Hip", "R_Knee", "R_Ankle", "R_Foot", "R_Wrist"}},
      {"root",
       "head",
       {"lfemur", "ltibia", "lfoot", "ltoes", "lhand"},
       {"rfemur", "rtibia", "rfoot", "rtoes", "rhand"}},
      {"J_Bip_C_Hips",
       "J_Bip_C_Head",
       {"J_Bip_L_UpperLeg", "J_Bip_L_LowerLeg", "J_Bip_L_Foot", "J_Bip_L_ToeBase", "J_Bip_L_Hand"},
       {"J_Bip_R_UpperLeg", "J_Bip_R_LowerLeg", "J_Bip_R_Foot", "J_Bip_R_ToeBase", "J_Bip_R_Hand"}},
  };
  for (const Vocabulary& words : vocabularies) {
    CAPTURE(words.left[2]);
    const JointRoles roles = find_joint_roles(skeleton(words));
    CHECK(roles.has_feet());
    CHECK(roles.root == 0);
    CHECK(roles.head == 12);
    for (const auto& [limb, first] : {std::pair(roles.left, 1), std::pair(roles.right, 6)}) {
      CHECK(limb.hip == first);
      CHECK(limb.knee == first + 1);
      CHECK(limb.ankle == first + 2);
      CHECK(limb.toe == first + 3);
      CHECK(limb.tip == first + 4);
    }
    CHECK(roles.left.hand == 14);
    CHECK(roles.right.hand == 15);
  }
}

TEST_CASE("an ankle with nothing but an end below it has that as its toe") {
  Skeleton s = skeleton({"Hips",
                         "Head",
                         {"LeftHip", "LeftKnee", "LeftAnkle", "x", "LeftWrist"},
                         {"RightHip", "RightKnee", "RightAnkle", "y", "RightWrist"}});
  s.names[1 + 3] = "LeftAnkle_end";
  const JointRoles roles = find_joint_roles(s);
  CHECK(roles.left.ankle == 3);
  CHECK(roles.left.toe == 4);
  CHECK(roles.right.toe == 9);
}

TEST_CASE("Acclaim joints are the ends of their bones" * test::needs_shared()) {
  const std::string asf = shared_motion("02.asf");
  const std::string amc = shared_motion("02_01.amc");
  Clip<float> clip;
  REQUIRE(parse_acclaim(asf, amc, clip).ok());
  const JointRoles roles = find_joint_roles(clip);
  const auto name = [&](std::int32_t j) { return clip.skeleton.names[static_cast<std::size_t>(j)]; };
  REQUIRE(roles.has_feet());
  CHECK(name(roles.left.hip) == "lhipjoint");
  CHECK(name(roles.left.knee) == "lfemur");
  CHECK(name(roles.left.ankle) == "ltibia");
  CHECK(name(roles.left.toe) == "lfoot");
  CHECK(name(roles.right.tip) == "rtoes");
  CHECK(name(roles.right.hand) == "rhand");
  CHECK(name(roles.head) == "head");
}

TEST_CASE_TEMPLATE("without names the lowest two chains are the legs" * test::needs_shared(), S, float, double) {
  for (const char* file : {"131_03.bvh", "jumping_jacks.bvh"}) {
    const std::string text = shared_motion(file);
    Clip<S> clip;
    REQUIRE(parse_bvh(text, clip).ok());
    const JointRoles named = find_joint_roles(clip);
    REQUIRE(named.has_feet());
    for (std::size_t j = 0; j < clip.skeleton.names.size(); ++j) {
      const bool end = ends_with(clip.skeleton.names[j], "_end");
      clip.skeleton.names[j] = "n" + std::to_string(j) + (end ? "_end" : "");
    }
    const JointRoles found = find_joint_roles(clip);
    CHECK(found.left.toe == named.left.toe);
    CHECK(found.left.tip == named.left.tip);
    CHECK(found.right.toe == named.right.toe);
    CHECK(found.right.ankle == named.right.ankle);
    CHECK(found.right.hip == named.right.hip);
  }
}

TEST_CASE("bodies without legs have none") {
  Clip<double> clip;
  CHECK_FALSE(find_joint_roles(clip).has_feet());
  REQUIRE(parse_bvh(small_bvh, clip).ok());
  CHECK_FALSE(find_joint_roles(clip).has_feet());
}
