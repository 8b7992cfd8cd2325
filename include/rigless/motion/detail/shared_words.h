// What most names of a skeleton have in common at either end: "mixamorig", "CC_Base", "Character1", "_JNT".
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "rigless/motion/detail/name_senses.h"
#include "rigless/motion/detail/name_words.h"

namespace rigless::detail {

// Whether a word says something of its joint, however many names have it.
inline bool says_something(const std::string& word) {
  const std::string text = plain(word);
  return sense_of(text) != NameSense::none || among(left_words, text) || among(right_words, text) ||
         among(end_words, text);
}

// Takes away, as long as there is one, the word with which more than half of the names begin or end; numbers only after
// such a word. A name of which numbers alone would be left keeps its words. Allocates.
inline void drop_shared_words(std::vector<std::vector<std::string>>& names) {
  if (names.size() < 4) return;
  for (const bool at_end : {false, true}) {
    const std::vector<std::vector<std::string>> whole = names;
    for (bool first = true;; first = false) {
      std::map<std::string, std::size_t> count;
      for (const auto& words : names) {
        if (!words.empty()) ++count[at_end ? words.back() : words.front()];
      }
      const auto most =
          std::max_element(count.begin(), count.end(), [](auto& a, auto& b) { return a.second < b.second; });
      if (most == count.end() || 2 * most->second <= names.size() || says_something(most->first)) break;
      if (is_number(most->first) && (first || at_end)) break;
      for (auto& words : names) {
        if (words.empty() || (at_end ? words.back() : words.front()) != most->first) continue;
        words.erase(at_end ? words.end() - 1 : words.begin());
      }
    }
    for (std::size_t j = 0; j < names.size(); ++j) {
      const bool numbers = !names[j].empty() && std::all_of(names[j].begin(), names[j].end(), is_number);
      if (numbers) names[j] = whole[j];
    }
  }
}

}  // namespace rigless::detail
