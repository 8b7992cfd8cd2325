#include "rigless/motion/detail/mirror_joints.h"

#include <doctest/doctest.h>

#include <string>

#include "rigless/motion/parse_acclaim.h"
#include "rigless/motion/parse_bvh.h"
#include "sample_motions.h"

using namespace rigless;
using namespace rigless::detail;

namespace {

void check_named(const Skeleton& skeleton, const char* joint, const char* twin) {
  const auto index = [&](const std::string& name) {
    return static_cast<std::int32_t>(std::find(skeleton.names.begin(), skeleton.names.end(), name) -
                                     skeleton.names.begin());
  };
  CAPTURE(joint);
  const auto mirror = mirror_joints(skeleton, find_joint_roles(skeleton));
  CHECK(mirror[static_cast<std::size_t>(index(joint))] == index(twin));
  CHECK(mirror[static_cast<std::size_t>(index(twin))] == index(joint));
}

}  // namespace

TEST_CASE("left and right joints are each other's mirror images, whatever way they are written") {
  const Skeleton skeleton = {
      {"Hips", "mixamorig:LeftFoot", "mixamorig:RightFoot", "foot_L", "foot_R", "Bip01 L Thigh", "Bip01 R Thigh",
       "lclavicle", "rclavicle", "LeftArm_end", "RightArm_end", "LeftArm", "RightArm", "ladder", "LeftEye"},
      {-1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}};
  check_named(skeleton, "Hips", "Hips");
  check_named(skeleton, "mixamorig:LeftFoot", "mixamorig:RightFoot");
  check_named(skeleton, "Bip01 L Thigh", "Bip01 R Thigh");
  check_named(skeleton, "lclavicle", "rclavicle");
  check_named(skeleton, "LeftArm_end", "RightArm_end");
  check_named(skeleton, "LeftArm", "RightArm");
  check_named(skeleton, "ladder", "ladder");
  check_named(skeleton, "LeftEye", "LeftEye");
}

TEST_CASE("legs without names for their sides are paired by their roles") {
  const Skeleton skeleton = {{"a", "b", "c", "d", "e", "f", "g"}, {-1, 0, 1, 2, 0, 4, 5}};
  JointRoles roles;
  roles.left = {1, 2, 3, -1, -1, -1, -1, -1, -1};
  roles.right = {4, 5, 6, -1, -1, -1, -1, -1, -1};
  CHECK(mirror_joints(skeleton, roles) == std::vector<std::int32_t>{0, 4, 5, 6, 1, 2, 3});
}

TEST_CASE("real skeletons have a twin for every joint beside the spine, and mirroring twice gives the joint" *
          test::needs_shared()) {
  const std::string asf = shared_motion("02.asf"), bvh = shared_motion("131_03.bvh");
  AcclaimSkeleton acclaim;
  REQUIRE(parse_asf(asf, acclaim).ok());
  Clip<double> clip, other;
  REQUIRE(parse_acclaim(asf, shared_motion("02_01.amc"), clip).ok());
  REQUIRE(parse_bvh(bvh, other).ok());
  for (const Skeleton* skeleton : {&clip.skeleton, &other.skeleton}) {
    const auto mirror = mirror_joints(*skeleton, find_joint_roles(*skeleton));
    std::int32_t single = 0;
    for (std::size_t j = 0; j < mirror.size(); ++j) {
      CHECK(mirror[static_cast<std::size_t>(mirror[j])] == static_cast<std::int32_t>(j));
      single += mirror[j] == static_cast<std::int32_t>(j) ? 1 : 0;
    }
    CHECK(single <= 8);
  }
}
