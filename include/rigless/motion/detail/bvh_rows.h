// The rows of a BVH file: whole frames, whatever the lines of the file hold.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rigless/math/status.h"
#include "rigless/motion/clip.h"
#include "rigless/motion/detail/text_scanner.h"

namespace rigless::detail {

struct BvhMotion {
  double frame_time = 0;
  std::vector<double> values;  // whole frames
};

// The numbers of a text, and where its lines begin among them.
struct NumberRows {
  std::vector<double> values;
  std::vector<std::size_t> starts;  // and the end
  std::vector<std::int32_t> lines;

  std::size_t rows() const { return lines.size(); }
  std::size_t length(std::size_t row) const { return starts[row + 1] - starts[row]; }
};

// Reads to the end, or to what is no number once there are `enough`, 0: never. Errors: bad_number.
inline Status read_number_rows(TextScanner& scanner, std::uint64_t enough, NumberRows& rows) {
  const std::size_t present = scanner.remaining() / 2 + 1;
  rows.values.reserve(enough == 0 || enough > present ? present / 4 : static_cast<std::size_t>(enough));
  while (scanner.more()) {
    double value = 0;
    const Status status = scanner.number(value);
    if (!status.ok() && enough > 0 && rows.values.size() >= enough) break;
    if (!status.ok()) return status;
    if (rows.lines.empty() || rows.lines.back() != scanner.line()) {
      rows.lines.push_back(scanner.line());
      rows.starts.push_back(rows.values.size());
    }
    rows.values.push_back(value);
  }
  rows.starts.push_back(rows.values.size());
  return {};
}

// A frame a row, `from` its first number that counts. A row of another length is a copy of the one before it, the last
// one is cut.
inline void take_rows(const NumberRows& rows, std::size_t channels, std::size_t from, BvhMotion& motion,
                      ParseNotes& notes) {
  const std::size_t declared = static_cast<std::size_t>(notes.frames_declared);
  const std::size_t taken = declared == 0 ? rows.rows() : std::min(declared, rows.rows());
  notes.text_after_end = taken < rows.rows();
  for (std::size_t r = 0; r < taken; ++r) {
    const bool whole = rows.length(r) == channels + from;
    if (!whole && r + 1 == rows.rows() && rows.length(r) < channels + from) {
      notes.frame_cut = true;
      break;
    }
    if (!whole) {
      if (notes.rows_replaced++ == 0) notes.row_replaced = rows.lines[r];
      if (motion.values.empty()) continue;
    }
    const auto begin = whole ? rows.values.begin() + static_cast<std::ptrdiff_t>(rows.starts[r] + from)
                             : motion.values.end() - static_cast<std::ptrdiff_t>(channels);
    const std::vector<double> frame(begin, begin + static_cast<std::ptrdiff_t>(channels));
    motion.values.insert(motion.values.end(), frame.begin(), frame.end());
  }
}

// The frames of `channels` values each. Lines end anywhere, unless that gives no whole frames and most lines are
// frames, of which some lack a number or have one too many, or all begin with their own number. Errors: bad_number;
// bad_syntax: as many lines as frames, and all of them of a wrong length; no_frames.
inline Status read_bvh_values(TextScanner& scanner, std::size_t channels, BvhMotion& motion, ParseNotes& notes) {
  const std::uint64_t declared = static_cast<std::uint64_t>(notes.frames_declared);
  NumberRows rows;
  if (const Status status = read_number_rows(scanner, declared * channels, rows); !status.ok()) return status;
  std::size_t exact = 0, numbered = 0, alike = 0;
  for (std::size_t r = 0; r < rows.rows(); ++r) {
    const double first = rows.values[rows.starts[r]];
    exact += rows.length(r) == channels ? 1 : 0;
    numbered += rows.length(r) == channels + 1 && first == rows.values[0] + static_cast<double>(r) ? 1 : 0;
    alike += rows.length(r) == rows.length(0) ? 1 : 0;
  }
  const std::uint64_t all = declared == 0 || channels == 0 ? rows.values.size() : declared * channels;
  const bool flows =
      channels > 0 && all % channels == 0 && std::binary_search(rows.starts.begin(), rows.starts.end(), all);
  const bool even = exact == rows.rows();  // nothing to mend: the numbers are the frames
  const bool frame_a_row = !even && 2 * exact > rows.rows() && (!flows || rows.rows() == declared);
  if (rows.rows() > 0 && !flows && 2 * numbered > rows.rows() && rows.values[0] >= 0 && rows.values[0] <= 1) {
    notes.frame_numbers = true;
    take_rows(rows, channels, 1, motion, notes);
  } else if (frame_a_row) {
    take_rows(rows, channels, 0, motion, notes);
  } else if (!even && declared > 1 && rows.rows() == declared && alike == declared) {
    return {Error::bad_syntax, rows.lines[0]};
  } else {
    motion.values = std::move(rows.values);
    notes.text_after_end = motion.values.size() > all;
    if (notes.text_after_end)
      motion.values.resize(static_cast<std::size_t>(std::min<std::uint64_t>(motion.values.size(), all)));
  }
  notes.text_after_end = notes.text_after_end || scanner.more();
  const std::size_t frames = channels == 0 ? 0 : motion.values.size() / channels;
  notes.frame_cut = notes.frame_cut || motion.values.size() != frames * channels;
  motion.values.resize(frames * channels);
  notes.frames_read = static_cast<std::int32_t>(frames);
  return frames == 0 ? Status{Error::no_frames, -1} : Status{};
}

}  // namespace rigless::detail
