// The part of the body that a name means among the other names of its skeleton.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/name_parts.h"
#include "rigless/motion/detail/name_senses.h"

namespace rigless::detail {

class PartReader {
 public:
  // `names` must outlive the reader.
  explicit PartReader(const std::vector<NameParts>& names) : names_(names) {
    for (const NameParts& name : names_) {
      has_[static_cast<std::size_t>(name.side)][static_cast<std::size_t>(name.sense)] = true;
    }
    bone_ends_ = has_bone_ends();
  }

  bool bone_ends() const { return bone_ends_; }

  BodyPart part(std::size_t joint) const {
    const NameParts& name = names_[joint];
    const BodyPart meant = bone_ends_ ? part_at_bone_end(name) : part_by_context(joint);
    if (!name.end) return meant;
    return meant == BodyPart::toe || meant == BodyPart::foot ? BodyPart::tip : BodyPart::end;
  }

 private:
  bool has_bone_ends() const {
    const auto grown = [&](NameSense sense) {
      return std::any_of(names_.begin(), names_.end(), [&](auto& name) { return name.grown && name.sense == sense; });
    };
    const bool ends = std::any_of(names_.begin(), names_.end(), [](auto& name) { return name.end; });
    return !ends && grown(NameSense::femur) && grown(NameSense::tibia);
  }

  bool has(BodySide side, NameSense sense) const {
    return has_[static_cast<std::size_t>(side)][static_cast<std::size_t>(sense)];
  }
  bool has_anywhere(NameSense sense) const {
    return has(BodySide::none, sense) || has(BodySide::left, sense) || has(BodySide::right, sense);
  }

  BodyPart part_at_bone_end(const NameParts& name) const {
    switch (name.sense) {
      case NameSense::hip_joint:
        return BodyPart::upper_leg;
      case NameSense::femur:
        return BodyPart::lower_leg;
      case NameSense::tibia:
        return BodyPart::foot;
      case NameSense::foot:
        return BodyPart::toe;
      case NameSense::toe:
        return BodyPart::tip;
      case NameSense::collar:
        return BodyPart::upper_arm;
      case NameSense::humerus:
        return BodyPart::lower_arm;
      case NameSense::radius:
        return BodyPart::hand;
      default:
        return part_by_sense(name);
    }
  }

  // Words that mean one thing here and another there.
  BodyPart part_by_context(std::size_t joint) const {
    const NameParts& name = names_[joint];
    const BodySide side = name.side;
    const bool thigh = has(side, NameSense::upper_leg) || has(side, NameSense::femur);
    const bool upper_leg = thigh || (side != BodySide::none && has(side, NameSense::hip));
    const bool lower_leg = has(side, NameSense::lower_leg) || has(side, NameSense::tibia);
    const bool upper_arm = has(side, NameSense::upper_arm) || has(side, NameSense::humerus);
    const bool lower_arm = has(side, NameSense::lower_arm) || has(side, NameSense::radius);
    switch (name.sense) {
      case NameSense::hip:
        if (side == BodySide::none) return BodyPart::hips;
        return thigh ? BodyPart::none : BodyPart::upper_leg;
      case NameSense::hip_joint:
        return upper_leg ? BodyPart::none : BodyPart::upper_leg;
      case NameSense::leg:  // one word in Japanese for leg and foot
        if (upper_leg && lower_leg && !has(side, NameSense::foot) && !has(side, NameSense::ankle))
          return BodyPart::foot;
        return upper_leg || (!lower_leg && !first_of_its_words(joint)) ? BodyPart::lower_leg : BodyPart::upper_leg;
      case NameSense::arm:
        return upper_arm                                  ? (lower_arm ? BodyPart::upper_arm : BodyPart::lower_arm)
               : !lower_arm && !first_of_its_words(joint) ? BodyPart::lower_arm
                                                          : BodyPart::upper_arm;
      case NameSense::shoulder:
        return upper_arm || has(side, NameSense::arm) ? BodyPart::shoulder : BodyPart::upper_arm;
      case NameSense::foot:
        return has(side, NameSense::ankle) && !has(side, NameSense::toe) ? BodyPart::toe : BodyPart::foot;
      default:
        return part_by_sense(name);
    }
  }

  BodyPart part_by_sense(const NameParts& name) const {
    const auto unless = [&](bool other, BodyPart part) { return other ? BodyPart::none : part; };
    switch (name.sense) {
      case NameSense::hips:
      case NameSense::hip:
        return BodyPart::hips;
      case NameSense::root:
        return unless(has_anywhere(NameSense::hips) || has(BodySide::none, NameSense::hip), BodyPart::hips);
      case NameSense::spine:
        return BodyPart::spine;
      case NameSense::upper_back:
        return has_anywhere(NameSense::chest) ? BodyPart::spine : BodyPart::chest;
      case NameSense::chest:
        return BodyPart::chest;
      case NameSense::neck:
        return BodyPart::neck;
      case NameSense::head:
        return BodyPart::head;
      case NameSense::nose:
        return unless(has_anywhere(NameSense::head), BodyPart::head);
      case NameSense::collar:
        return BodyPart::shoulder;
      case NameSense::shoulder:
      case NameSense::upper_arm:
      case NameSense::arm:
      case NameSense::humerus:
        return BodyPart::upper_arm;
      case NameSense::lower_arm:
      case NameSense::radius:
        return BodyPart::lower_arm;
      case NameSense::hand:
        return BodyPart::hand;
      case NameSense::finger:
        return BodyPart::finger;
      case NameSense::upper_leg:
      case NameSense::femur:
        return BodyPart::upper_leg;
      case NameSense::lower_leg:
      case NameSense::leg:
      case NameSense::tibia:
        return BodyPart::lower_leg;
      case NameSense::ankle:
        return BodyPart::foot;
      case NameSense::foot:
        return BodyPart::foot;
      case NameSense::toe:
        return BodyPart::toe;
      case NameSense::big_toe:
        return unless(has(name.side, NameSense::toe), BodyPart::toe);
      default:
        return BodyPart::none;
    }
  }

  bool first_of_its_words(std::size_t joint) const {
    for (std::size_t j = 0; j < joint; ++j) {
      if (names_[j].side == names_[joint].side && names_[j].sense == names_[joint].sense && !names_[j].end)
        return false;
    }
    return true;
  }

  const std::vector<NameParts>& names_;
  std::array<std::array<bool, static_cast<std::size_t>(NameSense::helper) + 1>, 3> has_{};
  bool bone_ends_ = false;
};

}  // namespace rigless::detail
