#include "rigless/motion/joint_roles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "rigless/motion/parse_acclaim.h"
#include "rigless/motion/parse_bvh.h"
#include "sample_motions.h"

using namespace rigless;

namespace {

bool has_feet(const JointRoles& roles) {
  return roles.left.ankle >= 0 && roles.left.toe >= 0 && roles.right.ankle >= 0 && roles.right.toe >= 0;
}

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

constexpr BodyPart every_part[] = {BodyPart::hips,      BodyPart::spine,     BodyPart::chest,     BodyPart::neck,
                                   BodyPart::head,      BodyPart::shoulder,  BodyPart::upper_arm, BodyPart::hand,
                                   BodyPart::lower_arm, BodyPart::upper_leg, BodyPart::foot,      BodyPart::lower_leg,
                                   BodyPart::toe,       BodyPart::tip};

// The joints of our own motions, in the order of the 21 roles of the vocabularies.
struct RoleJoint {
  const char* name;
  BodySide side;
  BodyPart part;
};
constexpr RoleJoint role_joints[] = {
    {"Hips", BodySide::none, BodyPart::hips},           {"Spine", BodySide::none, BodyPart::spine},
    {"Spine2", BodySide::none, BodyPart::chest},        {"Neck", BodySide::none, BodyPart::neck},
    {"Head", BodySide::none, BodyPart::head},           {"LeftShoulder", BodySide::left, BodyPart::shoulder},
    {"LeftArm", BodySide::left, BodyPart::upper_arm},   {"LeftForeArm", BodySide::left, BodyPart::lower_arm},
    {"LeftHand", BodySide::left, BodyPart::hand},       {"RightShoulder", BodySide::right, BodyPart::shoulder},
    {"RightArm", BodySide::right, BodyPart::upper_arm}, {"RightForeArm", BodySide::right, BodyPart::lower_arm},
    {"RightHand", BodySide::right, BodyPart::hand},     {"LeftUpLeg", BodySide::left, BodyPart::upper_leg},
    {"LeftLeg", BodySide::left, BodyPart::lower_leg},   {"LeftFoot", BodySide::left, BodyPart::foot},
    {"LeftToe", BodySide::left, BodyPart::toe},         {"RightUpLeg", BodySide::right, BodyPart::upper_leg},
    {"RightLeg", BodySide::right, BodyPart::lower_leg}, {"RightFoot", BodySide::right, BodyPart::foot},
    {"RightToe", BodySide::right, BodyPart::toe}};

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
    CHECK(has_feet(roles));
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
  REQUIRE(has_feet(roles));
  CHECK(name(roles.left.hip) == "lhipjoint");
  CHECK(name(roles.left.knee) == "lfemur");
  CHECK(name(roles.left.ankle) == "ltibia");
  CHECK(name(roles.left.toe) == "lfoot");
  CHECK(name(roles.right.tip) == "rtoes");
  CHECK(name(roles.right.hand) == "rhand");
  CHECK(name(roles.head) == "head");
}

TEST_CASE_TEMPLATE("without names the tree tells the whole body" * test::needs_shared(), S, float, double) {
  for (const char* file : {"131_03.bvh", "jumping_jacks.bvh", "zombie.bvh"}) {
    const std::string text = shared_motion(file);
    CAPTURE(file);
    Clip<S> clip;
    REQUIRE(parse_bvh(text, clip).ok());
    const JointRoles named = find_joint_roles(clip);
    REQUIRE(has_feet(named));
    for (std::size_t j = 0; j < clip.skeleton.names.size(); ++j) {
      const std::string& name = clip.skeleton.names[j];
      const bool end = name.size() > 4 && name.substr(name.size() - 4) == "_end";
      clip.skeleton.names[j] = "n" + std::to_string(j) + (end ? "_end" : "");
    }
    const JointRoles found = find_joint_roles(clip);
    CHECK(found.known());
    for (const BodySide side : {BodySide::none, BodySide::left, BodySide::right}) {
      for (const BodyPart part : every_part) {
        if (part == BodyPart::chest || part == BodyPart::spine) continue;  // of several the names may mean another
        CAPTURE(static_cast<int>(side));
        CAPTURE(static_cast<int>(part));
        CHECK(found.find(side, part) == named.find(side, part));
      }
    }
  }
}

TEST_CASE("our own motions have all 21 roles in every vocabulary, and in none") {
  const json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/joint-names.json");
  for (const char* motion : {"walk", "turn", "bow"}) {
    const std::string text = json::read_text(std::string(RIGLESS_TEST_DIR "../web/assets/motions/") + motion + ".bvh");
    Clip<double> clip;
    REQUIRE(parse_bvh(text, clip).ok());
    const std::vector<std::string> own = clip.skeleton.names;
    std::int32_t vocabularies = 0;
    for (const json::Value& skeleton : golden["skeletons"].array()) {
      if (skeleton["joints"].size() != std::size(role_joints)) continue;
      CAPTURE(skeleton["vocabulary"].string());
      clip.skeleton.names = own;
      for (std::size_t k = 0; k < std::size(role_joints); ++k) {
        for (std::size_t j = 0; j < own.size(); ++j) {
          const std::string& name = skeleton["joints"][k][0].string();
          if (own[j] == role_joints[k].name) clip.skeleton.names[j] = name;
          if (own[j] == std::string(role_joints[k].name) + "_end") clip.skeleton.names[j] = name + "_end";
        }
      }
      const JointRoles roles = find_joint_roles(clip);
      CHECK(roles.known());
      const std::vector<BodyPlace> places = roles.places(clip.joints());
      for (const RoleJoint& joint : role_joints) {
        CAPTURE(joint.name);
        const auto at = std::find(own.begin(), own.end(), joint.name) - own.begin();
        CHECK(roles.find(joint.side, joint.part) == at);
        CHECK(places[static_cast<std::size_t>(at)].side == joint.side);
        CHECK(places[static_cast<std::size_t>(at)].part == joint.part);
      }
      ++vocabularies;
    }
    CHECK(vocabularies >= 18);
  }
}

TEST_CASE("a joint has one place and a place one joint") {
  JointRoles roles;
  roles.spine = roles.chest = 3;
  roles.left.hand = 5;
  const std::vector<BodyPlace> places = roles.places(7);
  CHECK(places[0].part == BodyPart::hips);
  CHECK(places[3].part == BodyPart::spine);
  CHECK(places[5].side == BodySide::left);
  CHECK(places[5].part == BodyPart::hand);
  CHECK(places[6].part == BodyPart::none);
}

TEST_CASE("an inverse-kinematics foot or a second hand outside the limb takes no part") {
  Skeleton s = skeleton({"Hips",
                         "Head",
                         {"LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToe", "LeftHand"},
                         {"RightUpLeg", "RightLeg", "RightFoot", "RightToe", "RightHand"}});
  for (const char* name : {"LeftFoot_target", "Foot_L", "RightToe_prop"}) {
    s.names.push_back(name);
    s.parents.push_back(0);
  }
  const JointRoles roles = find_joint_roles(s);
  CHECK(roles.left.ankle == 3);
  CHECK(roles.left.toe == 4);
  CHECK(roles.right.toe == 9);
}

TEST_CASE("bodies without legs have none") {
  Clip<double> clip;
  CHECK_FALSE(has_feet(find_joint_roles(clip)));
  REQUIRE(parse_bvh(small_bvh, clip).ok());
  CHECK_FALSE(has_feet(find_joint_roles(clip)));
}
