// What people read: "Left elbow", "Spine 2", "Left forearm roll".
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/name_parts.h"

namespace rigless::detail {

inline std::string_view part_label(BodyPart part) {
  constexpr std::string_view labels[] = {"",       "hips",     "spine", "chest",   "neck", "head",
                                         "collar", "shoulder", "elbow", "hand",    "",     "hip",
                                         "knee",   "foot",     "toes",  "toe tip", ""};
  return labels[static_cast<std::size_t>(part)];
}

// A joint without a word for its part keeps its own.
inline std::string own_words(const NameParts& name) {
  std::string text;
  for (const std::string& word : name.words) {
    const bool grows = word == "arm" && ends_with(text, "fore");
    text += (text.empty() || grows ? "" : " ") + word;
  }
  return text;
}

// `result`: side and part of each of `names`. Allocates.
inline void label_joints(const std::vector<NameParts>& names, std::vector<JointName>& result) {
  std::map<std::string, int> taken;
  for (std::size_t j = 0; j < result.size(); ++j) {
    std::string text(part_label(result[j].part));
    if (text.empty()) text = own_words(names[j]);
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

}  // namespace rigless::detail
