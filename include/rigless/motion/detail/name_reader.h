// The names of one skeleton, read together.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/name_parts.h"
#include "rigless/motion/detail/name_senses.h"
#include "rigless/motion/detail/part_reader.h"
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
  }

  // Whether joints are the ends of their bones: Acclaim's bones, and no end sites.
  bool bone_ends() const { return PartReader(names_).bone_ends(); }

  // Whether the joint is called hips, and not just "root" for want of a better word.
  bool says_hips(std::size_t joint) const {
    const NameParts& name = names_[joint];
    return !name.end &&
           (name.sense == NameSense::hips || (name.sense == NameSense::hip && name.side == BodySide::none));
  }

  const std::vector<NameParts>& names() const { return names_; }

  // Without labels.
  std::vector<JointName> read() const {
    const PartReader parts(names_);
    std::vector<JointName> result;
    for (std::size_t j = 0; j < names_.size(); ++j) result.push_back({names_[j].side, parts.part(j), {}});
    read_rigify(result);
    for (std::size_t j = 0; j < names_.size(); ++j) {  // what was passed over a word yields to what says it plainly
      for (std::size_t k = 0; k < names_.size() && names_[j].guess; ++k) {
        const bool same = result[k].part == result[j].part && result[k].side == result[j].side;
        if (same && !names_[k].guess && result[j].part < BodyPart::tip && result[j].part != BodyPart::finger) {
          result[j].part = BodyPart::none;
        }
      }
    }
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

  // Blender's Rigify calls everything from the hips to the head "spine", numbered to 6; 2 and 5 may be missing.
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
    for (const std::size_t k : {0u, 1u, 3u, 4u, 6u}) {
      if (joints[k] == names_.size()) return;
    }
    for (std::size_t k = 0; k < joints.size(); ++k) {
      if (joints[k] < names_.size()) result[joints[k]].part = parts[k];
    }
  }

  std::vector<NameParts> names_;
};

}  // namespace rigless::detail
