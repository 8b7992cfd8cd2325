// One joint's name: its side, its own words, and what they mean by themselves.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/name_senses.h"
#include "rigless/motion/detail/name_words.h"

namespace rigless::detail {

struct NameParts {
  std::vector<std::string> words;  // without the side and what all names share
  BodySide side = BodySide::none;
  NameSense sense = NameSense::none;
  bool end = false;    // the end of a bone
  bool guess = false;  // words beside those of the sense were passed over
  bool grown = false;  // the side was one word with the rest: "lfemur"
  bool bare = false;   // nothing but what all names share: "Bip01"
};

inline bool begins_with(std::string_view text, std::string_view head) { return text.substr(0, head.size()) == head; }
inline bool ends_with(std::string_view text, std::string_view tail) {
  return text.size() >= tail.size() && text.substr(text.size() - tail.size()) == tail;
}

inline bool beside_the_spine(NameSense sense) { return sense == NameSense::hip || sense >= NameSense::collar; }

// Takes the side out of the words; of several the longest counts: "R_LeftFoot" is left. A letter alone is no side.
inline void take_side(NameParts& name) {
  if (name.words.size() == 1 && name.words[0].size() == 1) return;
  std::size_t taken = 0;
  std::size_t length = 0;
  for (std::size_t k = 0; k < name.words.size(); ++k) {
    const std::string word = plain(name.words[k]);
    const bool left = among(left_words, word);
    if ((!left && !among(right_words, word)) || word.size() <= length) continue;
    name.side = left ? BodySide::left : BodySide::right;
    taken = k;
    length = word.size();
  }
  if (length > 0) name.words.erase(name.words.begin() + static_cast<std::ptrdiff_t>(taken));
  for (std::string& word : name.words) {  // scripts without spaces
    for (const std::string_view mark : {"左", "왼쪽", "右", "오른쪽"}) {
      if (name.side != BodySide::none || !begins_with(word, mark)) continue;
      name.side = mark == "左" || mark == "왼쪽" ? BodySide::left : BodySide::right;
      word.erase(0, mark.size());
    }
  }
}

// "lfoot", "LeftFoot" in small letters, "footl": a side that is one word with a part that has sides.
inline bool take_grown_side(NameParts& name, std::string_view word, NameSense& sense) {
  for (const std::string_view mark : {"left", "right", "l", "r"}) {
    if (name.side != BodySide::none || word.size() <= mark.size() + 1) continue;
    std::string_view rest;
    if (begins_with(word, mark)) rest = word.substr(mark.size());
    NameSense found = sense_of(rest);
    if (!beside_the_spine(found) && ends_with(word, mark)) {
      rest = word.substr(0, word.size() - mark.size());
      found = sense_of(rest);
    }
    if (!beside_the_spine(found)) continue;
    sense = found;
    name.side = mark[0] == 'l' ? BodySide::left : BodySide::right;
    name.grown = true;
    for (std::string& own : name.words) {
      if (own == word) own = std::string(rest);
    }
  }
  return name.grown;
}

inline std::string joined(const std::vector<std::string>& words, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t k = begin; k < end; ++k) text += words[k];
  return text;
}

// The sense of words among others: any that names a finger, else the last ones, else for the trunk the first ones.
inline NameSense guess_sense(const std::vector<std::string>& words, BodySide side) {
  bool finger = false;
  for (const std::string& word : words) {
    const NameSense sense = sense_of(word);
    if (sense == NameSense::helper) return NameSense::none;
    finger = finger || sense == NameSense::finger || ends_with(word, "指") ||
             (side != BodySide::none && (word == "mid" || word == "middle"));
  }
  if (finger) return NameSense::finger;
  for (std::size_t k = 1; k < words.size(); ++k) {
    const NameSense sense = sense_of(joined(words, k, words.size()));
    if (sense != NameSense::none) return sense;
  }
  for (std::size_t k = words.size(); k-- > 1;) {
    const NameSense sense = sense_of(joined(words, 0, k));
    if (sense == NameSense::spine || sense == NameSense::chest || sense == NameSense::neck) return sense;
  }
  return NameSense::none;
}

// `words` as of name_words(), without what all names share.
inline NameParts read_name(std::vector<std::string> words) {
  NameParts name;
  name.words = std::move(words);
  take_side(name);
  std::vector<std::string> telling;
  std::vector<std::string> all;
  for (const std::string& own : name.words) {
    std::string word = plain(own);
    if (is_number(word)) continue;
    if (among(end_words, word)) {
      name.end = true;
      continue;
    }
    all.push_back(word);
    if (!among(noise_words, word)) telling.push_back(std::move(word));
  }
  name.sense = sense_of(joined(all, 0, all.size()));
  const std::string core = joined(telling, 0, telling.size());
  if (name.sense == NameSense::none) name.sense = sense_of(core);
  if (name.sense == NameSense::helper) name.sense = NameSense::none;
  if (name.sense != NameSense::none || take_grown_side(name, core, name.sense)) return name;
  for (std::string& word : telling) {
    NameSense sense = NameSense::none;
    if (take_grown_side(name, word, sense)) break;
  }
  if (name.grown) {  // once more without it
    const BodySide side = name.side;
    name = read_name(std::move(name.words));
    name.side = side;
    name.grown = true;
    return name;
  }
  name.sense = guess_sense(telling, name.side);
  name.guess = name.sense != NameSense::none;
  return name;
}

}  // namespace rigless::detail
