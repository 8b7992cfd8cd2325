// Words and numbers of a text file, with their lines: what the motion parsers read from.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "rigless/math/status.h"

namespace rigless::detail {

// Decimal text to double, independent of the locale. Takes a point or a comma before the fraction, and exponents.
// Exact up to 15 digits, within a few units in the last place beyond. Returns the characters used, 0 if there is no
// finite number. (std::from_chars for double is missing in the standard library of some WebAssembly toolchains.)
std::size_t scan_number(std::string_view text, double& value);

// ASCII, ignoring case.
bool same_word(std::string_view a, std::string_view b);

// Reads a text once, front to back. Line ends are LF, CR LF or CR; `#` and `//` at the start of a word begin a comment;
// a byte order mark is skipped; braces are words of their own. Keeps a view: the text must outlive the scanner.
// Does not allocate.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : text_(text) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
  }

  // Moves to the next word; false at the end of the text.
  bool more();

  // The next word, left in place or taken; empty at the end.
  std::string_view peek();
  std::string_view word();

  // What is left of the line before `stop`, without white space around it: names may hold spaces.
  std::string_view rest_of_line(char stop);

  // Takes one character if it comes next.
  bool skip(char c) {
    const bool found = at_ < text_.size() && text_[at_] == c;
    at_ += found ? 1 : 0;
    return found;
  }

  // Takes characters of the word that was looked at; takes spaces up to the end of the line.
  void take(std::size_t characters) { at_ += characters; }
  void skip_space() {
    while (at_ < text_.size() && is_space(text_[at_]) && !is_line_end(text_[at_])) ++at_;
  }

  // Errors: unexpected_end; bad_number: not a number, or not a finite one.
  Status number(double& value);

  // The line, from 1, of the word that was read or looked at last.
  std::int32_t line() const { return word_line_; }

  Status fail(Error error) const { return {error, word_line_}; }
  std::size_t remaining() const { return text_.size() - at_; }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  bool at_comment() const {
    const char c = text_[at_];
    return c == '#' || (c == '/' && text_.substr(at_, 2) == "//");
  }
  std::size_t word_end() const;

  std::string_view text_;
  std::size_t at_ = 0;
  std::int32_t line_ = 1;
  std::int32_t word_line_ = 1;
};

// ---------------------------------------------------------------------------------------------------------------------

inline double scale_by_power_of_ten(double value, std::int32_t exponent) {
  static constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                      1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  for (; exponent > 22; exponent -= 22) value *= powers[22];
  for (; exponent < -22; exponent += 22) value /= powers[22];
  return exponent < 0 ? value / powers[-exponent] : value * powers[exponent];
}

inline std::size_t scan_number(std::string_view text, double& value) {
  std::size_t i = 0;
  const auto digit_at = [&](std::size_t k) { return k < text.size() && text[k] >= '0' && text[k] <= '9'; };
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) ++i;

  std::uint64_t mantissa = 0;
  std::int32_t exponent = 0;
  bool any = false;
  constexpr std::uint64_t full = 1000000000000000000u;  // one more digit still fits 64 bits
  for (; digit_at(i); ++i, any = true) {
    if (mantissa < full) {
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(text[i] - '0');
    } else if (exponent < 1000) {
      ++exponent;
    }
  }
  if (i < text.size() && (text[i] == '.' || text[i] == ',')) {
    for (++i; digit_at(i); ++i, any = true) {
      if (mantissa >= full) continue;
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(text[i] - '0');
      if (exponent > -1000) --exponent;
    }
  }
  if (!any) return 0;

  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t k = i + 1;
    const bool small = k < text.size() && text[k] == '-';
    if (k < text.size() && (text[k] == '-' || text[k] == '+')) ++k;
    std::int32_t power = 0;
    if (digit_at(k)) {
      for (; digit_at(k); ++k) {
        if (power < 1000) power = power * 10 + (text[k] - '0');
      }
      exponent += small ? -power : power;
      i = k;
    }
  }
  const double magnitude = mantissa == 0 ? 0.0 : scale_by_power_of_ten(static_cast<double>(mantissa), exponent);
  if (!std::isfinite(magnitude)) return 0;
  value = negative ? -magnitude : magnitude;
  return i;
}

inline bool same_word(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; };
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (lower(a[i]) != lower(b[i])) return false;
  }
  return true;
}

inline bool TextScanner::more() {
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '\n' || (c == '\r' && text_.substr(at_ + 1, 1) != "\n")) ++line_;
    if (is_space(c)) continue;
    if (!at_comment()) {
      word_line_ = line_;
      return true;
    }
    while (at_ + 1 < text_.size() && !is_line_end(text_[at_ + 1])) ++at_;
  }
  return false;
}

inline std::size_t TextScanner::word_end() const {
  std::size_t end = at_;
  const auto brace = [](char c) { return c == '{' || c == '}'; };
  if (end < text_.size() && brace(text_[end])) return end + 1;
  while (end < text_.size() && !is_space(text_[end]) && !brace(text_[end])) ++end;
  return end;
}

inline std::string_view TextScanner::peek() {
  if (!more()) return {};
  return text_.substr(at_, word_end() - at_);
}

inline std::string_view TextScanner::word() {
  const std::string_view next = peek();
  at_ += next.size();
  return next;
}

inline std::string_view TextScanner::rest_of_line(char stop) {
  skip_space();
  const std::size_t begin = at_;
  std::size_t end = at_;
  for (; at_ < text_.size() && !is_line_end(text_[at_]) && text_[at_] != stop; ++at_) {
    if (is_space(text_[at_])) continue;
    if (at_comment() && (at_ == begin || is_space(text_[at_ - 1]))) break;
    end = at_ + 1;
  }
  return text_.substr(begin, end - begin);
}

inline Status TextScanner::number(double& value) {
  if (!more()) return fail(Error::unexpected_end);
  const std::size_t used = scan_number(text_.substr(at_), value);
  if (used == 0) return fail(Error::bad_number);
  std::size_t end = at_ + used;
  if (end < text_.size() && text_[end] == ',') ++end;  // a list with commas
  if (end < text_.size() && !is_space(text_[end]) && text_[end] != '}' && text_[end] != '{') {
    return fail(Error::bad_number);
  }
  at_ = end;
  return {};
}

}  // namespace rigless::detail
