// A name taken apart into words, in any script.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rigless::detail {

// The code point that begins at `i`, which moves behind it; full-width letters and digits become plain ones. A byte
// that is no UTF-8 stands for itself. Does not allocate.
inline std::uint32_t next_code_point(std::string_view text, std::size_t& i) {
  const auto byte = [&](std::size_t k) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[k])); };
  std::uint32_t c = byte(i++);
  if (c < 0xc0) return c;
  std::uint32_t more = c < 0xe0 ? 1u : c < 0xf0 ? 2u : 3u;
  c &= 0x3fu >> more;
  for (; more > 0 && i < text.size() && (byte(i) & 0xc0u) == 0x80u; --more) c = c << 6 | (byte(i++) & 0x3fu);
  return c >= 0xff01 && c <= 0xff5e ? c - 0xfee0 : c;
}

inline void append_code_point(std::uint32_t c, std::string& text) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (c >= 0x10000) {
    add(0xf0 | c >> 18);
    add(0x80 | (c >> 12 & 0x3f));
  } else if (c >= 0x800) {
    add(0xe0 | c >> 12);
  } else if (c >= 0x80) {
    add(0xc0 | c >> 6);
  } else {
    return add(c);
  }
  if (c >= 0x800) add(0x80 | (c >> 6 & 0x3f));
  add(0x80 | (c & 0x3f));
}

enum class Letter : std::int32_t { none, digit, small, capital, wide };

// `wide`: scripts that are written without spaces.
inline Letter letter_kind(std::uint32_t c) {
  if (c >= '0' && c <= '9') return Letter::digit;
  if ((c >= 'a' && c <= 'z') || (c >= 0xdf && c < 0x410) || (c >= 0x430 && c < 0x2000)) return Letter::small;
  if ((c >= 'A' && c <= 'Z') || (c >= 0xc0 && c < 0xdf) || (c >= 0x410 && c < 0x430)) return Letter::capital;
  return c >= 0x2e80 && !(c >= 0x3000 && c < 0x3005) && !(c >= 0x3008 && c < 0x3030) ? Letter::wide : Letter::none;
}

// Split at what is no letter or digit, between letters and digits, and where a capital begins a word: "LHipJoint2" is l
// hip joint 2. A name space in front is left out. Latin letters become small. Allocates.
inline std::vector<std::string> name_words(std::string_view name) {
  const std::size_t space = name.find_last_of(":|");
  if (space != name.npos && space + 1 < name.size()) name = name.substr(space + 1);
  std::vector<std::string> words(1);
  Letter before = Letter::none;
  for (std::size_t i = 0; i < name.size();) {
    const std::uint32_t c = next_code_point(name, i);
    const Letter kind = letter_kind(c);
    std::size_t ahead = i;
    const Letter after = i < name.size() ? letter_kind(next_code_point(name, ahead)) : Letter::none;
    const bool word_goes_on = kind == before || (before == Letter::capital && kind == Letter::small);
    const bool last_capital = kind == Letter::capital && before == Letter::capital && after == Letter::small;
    if (!word_goes_on || last_capital) words.emplace_back();
    if (kind != Letter::none) append_code_point(c >= 'A' && c <= 'Z' ? c + 32 : c, words.back());
    before = kind;
  }
  std::vector<std::string> filled;
  for (std::string& word : words) {
    if (!word.empty()) filled.push_back(std::move(word));
  }
  return filled;
}

// For comparing: small letters, Latin ones without accents. Allocates.
inline std::string plain(std::string_view word) {
  constexpr std::string_view base = "aaaaaaaceeeeiiiidnooooo/ouuuuypy";  // U+00E0 to U+00FF
  std::string text;
  for (std::size_t i = 0; i < word.size();) {
    std::uint32_t c = next_code_point(word, i);
    if ((c >= 0xc0 && c < 0xdf) || (c >= 0x410 && c < 0x430)) c += 32;
    if (c == 0xdf) text += 's';
    if (c == 0xdf) c = 's';
    if (c >= 0xe0 && c <= 0xff) c = static_cast<std::uint32_t>(base[c - 0xe0]);
    append_code_point(c, text);
  }
  return text;
}

inline bool is_number(std::string_view word) { return !word.empty() && word[0] >= '0' && word[0] <= '9'; }

}  // namespace rigless::detail
