// Parts and sides of a body, and what a joint's name says of them. Public through joint_names.h and joint_roles.h.
#pragma once

#include <cstdint>
#include <string>

namespace rigless {

// A joint is named after where it is: upper_leg is the hip joint, lower_leg the knee, foot the ankle, toe the ball;
// shoulder is the collar, upper_arm the shoulder joint, lower_arm the elbow, hand the wrist. tip is the end of the
// foot, end any other end.
enum class BodyPart : std::int32_t {
  none,
  hips,
  spine,
  chest,
  neck,
  head,
  shoulder,
  upper_arm,
  lower_arm,
  hand,
  finger,
  upper_leg,
  lower_leg,
  foot,
  toe,
  tip,
  end
};

enum class BodySide : std::int32_t { none, left, right };

struct JointName {
  BodySide side = BodySide::none;
  BodyPart part = BodyPart::none;
  std::string label;  // "Left elbow"; the joint's own words where the part is none, finger or end; unique in the list
};

}  // namespace rigless
