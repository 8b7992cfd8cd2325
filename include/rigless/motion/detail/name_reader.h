// The names of one skeleton, read together.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/name_parts.h"
#include "rigless/motion/detail/name_senses.h"
#include "rigless/motion/detail/shared_words.h"

namespace rigless::detail {

class NameReader {
 public:
  explicit NameReader(const std::vector<std::string>& names) {
    std::vector<std::vector<std::string>> words;
    for (const std::string& name : names) words.push_back(name_words(name));
    const std::vector<std::vector<std::string>> whole = words;
    drop_shared_words(words);
    keep_vertebrae(words);
    for (std::size_t j = 0; j < words.size(); ++j) {
      names_.push_back(read_name(words[j]));
      NameParts& name = names_.back();
      name.bare = words[j].empty() && !whole[j].empty();
      if (name.bare) name.sense = NameSense::root;
      if (name.words.empty()) name.words = whole[j];
      if (name.words.empty()) name.words.emplace_back("joint");
    }
    find_twins();
    for (const NameParts& name : names_) {
      has_[static_cast<std::size_t>(name.side)][static_cast<std::size_t>(name.sense)] = true;
    }
    bone_ends_ = has_bone_ends();
  }

  // Whether joints are the ends of their bones: Acclaim's bones, and no end sites.
  bool bone_ends() const { return bone_ends_; }

  // Whether the joint is called hips, and not just "root" for want of a better word.
  bool says_hips(std::size_t joint) const {
    const NameParts& name = names_[joint];
    return !name.end && (name.sense == NameSense::hips || (name.sense == NameSense::hip && name.side == BodySide::none));
  }

  std::vector<JointName> read() const {
    std::vector<JointName> result;
    for (std::size_t j = 0; j < names_.size(); ++j) result.push_back({names_[j].side, part(j), {}});
    read_rigify(result);
    for (std::size_t j = 0; j < names_.size(); ++j) {  // what was passed over a word yields to what says it plainly
      for (std::size_t k = 0; k < names_.size() && names_[j].guess; ++k) {
        const bool same = result[k].part == result[j].part && result[k].side == result[j].side;
        if (same && !names_[k].guess && result[j].part < BodyPart::tip && result[j].part != BodyPart::finger) {
          result[j].part = BodyPart::none;
        }
      }
    }
    label(result);
    return result;
  }

 private:
  using Words = std::vector<std::string>;

  // "L5" and "T12" are vertebrae, unless there is an "R5".
  static void keep_vertebrae(std::vector<Words>& names) {
    const auto numbered = [](const Words& words, char letter) {
      return words.size() == 2 && words[0].size() == 1 && words[0][0] == letter && is_number(words[1]);
    };
    for (const Words& words : names) {
      if (numbered(words, 'r')) return;
    }
    for (Words& words : names) {
      if (numbered(words, 'l') || numbered(words, 't')) words = {words[0] + words[1]};
    }
  }

  // "lwing": a side grown together with a word that only its twin "rwing" explains.
  void find_twins() {
    const auto unknown = [](const NameParts& name, char letter) {
      return name.side == BodySide::none && name.sense == NameSense::none && name.words[0].size() > 2 &&
             name.words[0][0] == letter;
    };
    for (NameParts& left : names_) {
      for (NameParts& right : names_) {
        if (!unknown(left, 'l') || !unknown(right, 'r')) continue;
        Words twin = right.words;
        twin[0][0] = 'l';
        if (twin != left.words) continue;
        for (NameParts* name : {&left, &right}) name->words[0].erase(0, 1);
        left.side = BodySide::left;
        right.side = BodySide::right;
      }
    }
  }

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

  BodyPart part(std::size_t joint) const {
    const NameParts& name = names_[joint];
    const BodyPart meant = bone_ends_ ? part_at_bone_end(name) : part_by_context(joint);
    if (!name.end) return meant;
    return meant == BodyPart::toe || meant == BodyPart::foot ? BodyPart::tip : BodyPart::end;
  }

  BodyPart part_at_bone_end(const NameParts& name) const {
    switch (name.sense) {
      case NameSense::hip_joint: return BodyPart::upper_leg;
      case NameSense::femur: return BodyPart::lower_leg;
      case NameSense::tibia: return BodyPart::foot;
      case NameSense::foot: return BodyPart::toe;
      case NameSense::toe: return BodyPart::tip;
      case NameSense::collar: return BodyPart::upper_arm;
      case NameSense::humerus: return BodyPart::lower_arm;
      case NameSense::radius: return BodyPart::hand;
      default: return part_by_sense(name);
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
      case NameSense::hip_joint: return upper_leg ? BodyPart::none : BodyPart::upper_leg;
      case NameSense::leg:
        return upper_leg || (!lower_leg && !first_of_its_words(joint)) ? BodyPart::lower_leg : BodyPart::upper_leg;
      case NameSense::arm:
        return upper_arm ? (lower_arm ? BodyPart::upper_arm : BodyPart::lower_arm)
               : !lower_arm && !first_of_its_words(joint) ? BodyPart::lower_arm
                                                          : BodyPart::upper_arm;
      case NameSense::shoulder:
        return upper_arm || has(side, NameSense::arm) ? BodyPart::shoulder : BodyPart::upper_arm;
      case NameSense::foot:
        return has(side, NameSense::ankle) && !has(side, NameSense::toe) ? BodyPart::toe : BodyPart::foot;
      default: return part_by_sense(name);
    }
  }

  BodyPart part_by_sense(const NameParts& name) const {
    const auto unless = [&](bool other, BodyPart part) { return other ? BodyPart::none : part; };
    switch (name.sense) {
      case NameSense::hips:
      case NameSense::hip: return BodyPart::hips;
      case NameSense::root:
        return unless(has_anywhere(NameSense::hips) || has(BodySide::none, NameSense::hip), BodyPart::hips);
      case NameSense::spine: return BodyPart::spine;
      case NameSense::upper_back: return has_anywhere(NameSense::chest) ? BodyPart::spine : BodyPart::chest;
      case NameSense::chest: return BodyPart::chest;
      case NameSense::neck: return BodyPart::neck;
      case NameSense::head: return BodyPart::head;
      case NameSense::nose: return unless(has_anywhere(NameSense::head), BodyPart::head);
      case NameSense::collar: return BodyPart::shoulder;
      case NameSense::shoulder:
      case NameSense::upper_arm:
      case NameSense::arm:
      case NameSense::humerus: return BodyPart::upper_arm;
      case NameSense::lower_arm:
      case NameSense::radius: return BodyPart::lower_arm;
      case NameSense::hand: return BodyPart::hand;
      case NameSense::finger: return BodyPart::finger;
      case NameSense::upper_leg:
      case NameSense::femur: return BodyPart::upper_leg;
      case NameSense::lower_leg:
      case NameSense::leg:
      case NameSense::tibia: return BodyPart::lower_leg;
      case NameSense::ankle: return BodyPart::foot;
      case NameSense::foot: return BodyPart::foot;
      case NameSense::toe: return BodyPart::toe;
      case NameSense::big_toe: return unless(has(name.side, NameSense::toe), BodyPart::toe);
      default: return BodyPart::none;
    }
  }

  bool first_of_its_words(std::size_t joint) const {
    for (std::size_t j = 0; j < joint; ++j) {
      if (names_[j].side == names_[joint].side && names_[j].sense == names_[joint].sense && !names_[j].end) return false;
    }
    return true;
  }

  // Blender's Rigify calls everything from the hips to the head "spine", numbered to 6.
  void read_rigify(std::vector<JointName>& result) const {
    constexpr std::array<BodyPart, 7> parts = {BodyPart::hips, BodyPart::spine, BodyPart::spine, BodyPart::chest,
                                               BodyPart::neck, BodyPart::neck,  BodyPart::head};
    std::array<std::size_t, parts.size()> joints;
    joints.fill(names_.size());
    for (std::size_t j = 0; j < names_.size(); ++j) {
      if (result[j].part == BodyPart::hips || result[j].part == BodyPart::chest || result[j].part == BodyPart::neck ||
          result[j].part == BodyPart::head) {
        return;
      }
      if (names_[j].sense != NameSense::spine) continue;
      const std::string& last = names_[j].words.back();
      const std::size_t number = is_number(last) ? static_cast<std::size_t>(std::atoi(last.c_str())) : 0;
      if (number < joints.size()) joints[number] = j;
    }
    if (std::find(joints.begin(), joints.end(), names_.size()) != joints.end()) return;
    for (std::size_t k = 0; k < joints.size(); ++k) result[joints[k]].part = parts[k];
  }

  static std::string_view part_label(BodyPart part) {
    constexpr std::string_view labels[] = {"",      "hips",  "spine", "chest", "neck", "head", "collar", "shoulder",
                                           "elbow", "hand",  "",      "hip",   "knee", "foot", "toes",   "toe tip",
                                           ""};
    return labels[static_cast<std::size_t>(part)];
  }

  std::string own_words(const NameParts& name) const {
    std::string text;
    for (const std::string& word : name.words) {
      const bool grows = word == "arm" && ends_with(text, "fore");
      text += (text.empty() || grows ? "" : " ") + word;
    }
    return text;
  }

  void label(std::vector<JointName>& result) const {
    std::map<std::string, int> taken;
    for (std::size_t j = 0; j < result.size(); ++j) {
      std::string text(part_label(result[j].part));
      if (text.empty()) text = own_words(names_[j]);
      if (result[j].side == BodySide::left) text = "left " + text;
      if (result[j].side == BodySide::right) text = "right " + text;
      if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
      int& last = taken[text];  // 0: free
      std::string unique = text;
      if (last++ > 0) {
        for (unique += ' ' + std::to_string(last); taken.count(unique) > 0;) unique = text + ' ' + std::to_string(++last);
        taken[unique] = 1;
      }
      result[j].label = unique;
    }
  }

  std::vector<NameParts> names_;
  std::array<std::array<bool, static_cast<std::size_t>(NameSense::helper) + 1>, 3> has_{};
  bool bone_ends_ = false;
};

}  // namespace rigless::detail
