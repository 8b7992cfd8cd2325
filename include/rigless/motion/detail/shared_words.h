// What most names of a skeleton have in common at either end: "mixamorig", "CC_Base", "Character1", "_JNT".
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "rigless/motion/detail/name_senses.h"
#include "rigless/motion/detail/name_words.h"

namespace rigless::detail {

// Whether a word says something of its joint, however many names have it. Not all can be helpers.
inline bool says_something(const std::string& word) {
  const std::string text = plain(word);
  const NameSense sense = sense_of(text);
  return (sense != NameSense::none && sense != NameSense::helper) || among(left_words, text) ||
         among(right_words, text) || among(end_words, text);
}

// Takes away, as long as there is one, the word with which more than half of the names begin or end; numbers only after
// such a word. A name of which numbers alone would be left keeps its words. Allocates.
inline void drop_shared_words(std::vector<std::vector<std::string>>& names) {
  if (names.size() < 4) return;
  for (const bool at_end : {false, true}) {
    const std::vector<std::vector<std::string>> whole = names;
    for (bool first = true;; first = false) {
      const auto at = [&](const auto& words) {
        return words.empty() ? std::string() : at_end ? words.back() : words.front();
      };
      std::string most;  // the only word that can be that of more than half
      std::size_t votes = 0;
      for (const auto& words : names) {
        if (votes == 0) most = at(words);
        votes = at(words) == most ? votes + 1 : votes - 1;
      }
      const auto has_it = [&](const auto& words) { return at(words) == most; };
      const auto count = static_cast<std::size_t>(std::count_if(names.begin(), names.end(), has_it));
      if (most.empty() || 2 * count <= names.size() || says_something(most)) break;
      if (is_number(most) && (first || at_end)) break;
      for (auto& words : names) {
        if (has_it(words)) words.erase(at_end ? words.end() - 1 : words.begin());
      }
    }
    for (std::size_t j = 0; j < names.size(); ++j) {
      const bool numbers = !names[j].empty() && std::all_of(names[j].begin(), names[j].end(), is_number);
      if (numbers) names[j] = whole[j];
    }
  }
}

}  // namespace rigless::detail
