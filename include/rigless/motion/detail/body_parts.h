// Parts and sides of a body: what a joint's name says of them, and which joints carry them. Public through
// JointRoles and read_joint_names().
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

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

// Joint indices of one side; -1 where there is none. `hip` is the top of the thigh, `toe` the ball of the foot, where
// the toes bend, `tip` their end. A foot without a ball has its end as `toe` and no `tip`. `collar` lies before the
// shoulder, `hand` is the wrist.
struct LimbRoles {
  std::int32_t hip = -1;
  std::int32_t knee = -1;
  std::int32_t ankle = -1;
  std::int32_t toe = -1;
  std::int32_t tip = -1;
  std::int32_t collar = -1;
  std::int32_t shoulder = -1;
  std::int32_t elbow = -1;
  std::int32_t hand = -1;
};

// Side and part of a joint.
struct BodyPlace {
  BodySide side = BodySide::none;
  BodyPart part = BodyPart::none;
};

struct JointRoles {
  std::int32_t root = 0;  // the hips
  std::int32_t spine = -1;
  std::int32_t chest = -1;
  std::int32_t neck = -1;
  std::int32_t head = -1;
  LimbRoles left;
  LimbRoles right;

  // Whether the joints of this body can be told: both feet, and the head or a hand.
  bool known() const { return left.ankle >= 0 && right.ankle >= 0 && (head >= 0 || left.hand >= 0 || right.hand >= 0); }
  // -1 where there is none, and for fingers and ends, of which there are many.
  std::int32_t find(BodySide side, BodyPart part) const;
  // J: what each joint is; no place has two joints. Allocates.
  std::vector<BodyPlace> places(std::int32_t joints) const;
};

// ---------------------------------------------------------------------------------------------------------------------

inline std::int32_t JointRoles::find(BodySide side, BodyPart part) const {
  const LimbRoles& limb = side == BodySide::left ? left : right;
  const bool middle = side == BodySide::none;
  switch (part) {
    case BodyPart::hips:
      return middle ? root : -1;
    case BodyPart::spine:
      return middle ? spine : -1;
    case BodyPart::chest:
      return middle ? chest : -1;
    case BodyPart::neck:
      return middle ? neck : -1;
    case BodyPart::head:
      return middle ? head : -1;
    case BodyPart::shoulder:
      return middle ? -1 : limb.collar;
    case BodyPart::upper_arm:
      return middle ? -1 : limb.shoulder;
    case BodyPart::lower_arm:
      return middle ? -1 : limb.elbow;
    case BodyPart::hand:
      return middle ? -1 : limb.hand;
    case BodyPart::upper_leg:
      return middle ? -1 : limb.hip;
    case BodyPart::lower_leg:
      return middle ? -1 : limb.knee;
    case BodyPart::foot:
      return middle ? -1 : limb.ankle;
    case BodyPart::toe:
      return middle ? -1 : limb.toe;
    case BodyPart::tip:
      return middle ? -1 : limb.tip;
    default:
      return -1;
  }
}

inline std::vector<BodyPlace> JointRoles::places(std::int32_t joints) const {
  std::vector<BodyPlace> places(static_cast<std::size_t>(joints));
  for (const BodySide side : {BodySide::none, BodySide::left, BodySide::right}) {
    for (std::int32_t part = 1; part < static_cast<std::int32_t>(BodyPart::end); ++part) {
      const std::int32_t joint = find(side, static_cast<BodyPart>(part));
      if (joint < 0 || joint >= joints) continue;
      BodyPlace& place = places[static_cast<std::size_t>(joint)];
      if (place.part == BodyPart::none) place = {side, static_cast<BodyPart>(part)};
    }
  }
  return places;
}

}  // namespace rigless
