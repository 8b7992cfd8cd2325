// ASF (Acclaim skeleton file): the bones that an AMC file moves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/motion/detail/acclaim_skeleton.h"
#include "rigless/motion/detail/asf_words.h"
#include "rigless/motion/detail/euler.h"
#include "rigless/motion/detail/text_scanner.h"

namespace rigless::detail {

// Sections in any order; what is unknown (limits, masses, comments) is skipped.
class AsfParser {
 public:
  explicit AsfParser(std::string_view text) : scanner_(text) {
    skeleton_.bones.emplace_back();
    skeleton_.bones[0].name = "root";
    skeleton_.index.emplace("root", 0);
  }

  Status parse();
  AcclaimSkeleton& skeleton() { return skeleton_; }

 private:
  struct Link {
    std::int32_t parent;
    std::int32_t child;
    std::int32_t line;
  };

  bool in_section() {
    const std::string_view next = scanner_.peek();
    return !next.empty() && next[0] != ':';
  }
  Status numbers(Vec3<double>& v) {
    for (std::int32_t k = 0; k < 3; ++k) {
      if (const Status status = scanner_.number(v[k]); !status.ok()) return status;
    }
    return {};
  }
  Mat3<double> rotation(const Vec3<double>& angles, const std::array<std::int32_t, 3>& order) const;

  Status read_units();
  Status read_root();
  Status read_bonedata();
  Status read_bone();
  Status read_bone_entry(std::string_view word, AcclaimBone& bone);
  Status read_hierarchy();
  Status arrange();

  TextScanner scanner_;
  AcclaimSkeleton skeleton_;
  std::vector<Link> links_;
  bool has_root_ = false;
  bool has_bones_ = false;
  bool has_hierarchy_ = false;
};

// "XYZ" turns about x first: C = Rz Ry Rx. The angles stand in the order x, y, z whatever the order is.
inline Mat3<double> AsfParser::rotation(const Vec3<double>& angles, const std::array<std::int32_t, 3>& order) const {
  Mat3<double> r = Mat3<double>::Identity();
  for (std::size_t k = 3; k-- > 0;) {
    turn_about_axis(order[k], angles[order[k]] * (skeleton_.degrees ? radians_per_degree : 1.0), r);
  }
  return r;
}

inline Status AsfParser::read_units() {
  while (in_section()) {
    const std::string_view word = scanner_.word();
    if (same_word(word, "length")) {
      if (const Status status = scanner_.number(skeleton_.length_unit); !status.ok()) return status;
      if (!(skeleton_.length_unit > 0)) return scanner_.fail(Error::bad_number);
    } else if (same_word(word, "angle")) {
      skeleton_.degrees = same_word(scanner_.word().substr(0, 3), "deg");
    }
  }
  return {};
}

inline Status AsfParser::read_root() {
  AcclaimBone& root = skeleton_.bones[0];
  std::array<std::int32_t, 3> order = {0, 1, 2};
  Vec3<double> orientation = Vec3<double>::Zero();
  has_root_ = true;
  while (in_section()) {
    const std::string_view word = scanner_.word();
    Status status;
    AcclaimChannel channel{};
    if (same_word(word, "order")) {
      while (in_section() && read_asf_channel(scanner_.peek(), channel)) {
        root.channels.push_back(channel);
        scanner_.word();
      }
    } else if (same_word(word, "axis")) {
      if (!read_asf_order(scanner_.word(), order)) status = scanner_.fail(Error::bad_syntax);
    } else if (same_word(word, "position")) {
      status = numbers(skeleton_.root_position);
    } else if (same_word(word, "orientation")) {
      status = numbers(orientation);
    }
    if (!status.ok()) return status;
  }
  root.axis = rotation(orientation, order);
  return {};
}

inline Status AsfParser::read_bone_entry(std::string_view word, AcclaimBone& bone) {
  if (same_word(word, "name")) {
    bone.name = std::string(scanner_.word());
    if (bone.name.empty()) return scanner_.fail(Error::unexpected_end);
    const std::int32_t next = static_cast<std::int32_t>(skeleton_.bones.size());
    if (!skeleton_.index.emplace(bone.name, next).second) return scanner_.fail(Error::duplicate_joint);
  } else if (same_word(word, "direction")) {
    if (const Status status = numbers(bone.direction); !status.ok()) return status;
    if (bone.direction.norm() > 0) bone.direction.normalize();
  } else if (same_word(word, "length")) {
    return scanner_.number(bone.length);
  } else if (same_word(word, "axis")) {
    Vec3<double> angles;
    std::array<std::int32_t, 3> order{};
    if (const Status status = numbers(angles); !status.ok()) return status;
    if (!read_asf_order(scanner_.word(), order)) return scanner_.fail(Error::bad_syntax);
    bone.axis = rotation(angles, order);
  } else if (same_word(word, "dof")) {
    AcclaimChannel channel{};
    while (in_section() && read_asf_channel(scanner_.peek(), channel)) {
      bone.channels.push_back(channel);
      scanner_.word();
    }
  }
  return {};  // anything else is of no use here: id, limits, masses
}

inline Status AsfParser::read_bone() {
  AcclaimBone bone;
  while (true) {
    const std::string_view word = scanner_.word();
    if (word.empty()) return scanner_.fail(Error::unexpected_end);
    if (word[0] == ':') return scanner_.fail(Error::bad_syntax);
    if (same_word(word, "end")) break;
    if (const Status status = read_bone_entry(word, bone); !status.ok()) return status;
  }
  if (bone.name.empty()) return scanner_.fail(Error::bad_syntax);
  if (skeleton_.bones.size() >= 4096) return scanner_.fail(Error::unsupported);
  skeleton_.bones.push_back(std::move(bone));
  return {};
}

inline Status AsfParser::read_bonedata() {
  has_bones_ = true;
  while (in_section()) {
    if (!same_word(scanner_.word(), "begin")) return scanner_.fail(Error::bad_syntax);
    if (const Status status = read_bone(); !status.ok()) return status;
  }
  return {};
}

// Lines of a parent and its children between `begin` and `end`.
inline Status AsfParser::read_hierarchy() {
  has_hierarchy_ = true;
  std::int32_t parent = -1;
  std::int32_t parent_line = -1;
  while (true) {
    const std::string_view word = scanner_.word();
    if (word.empty()) return scanner_.fail(Error::unexpected_end);
    if (same_word(word, "begin")) continue;
    if (same_word(word, "end")) return {};
    const std::int32_t found = skeleton_.find(word);
    if (found < 0) return scanner_.fail(Error::unknown_joint);
    if (scanner_.line() != parent_line) {
      parent = found;
      parent_line = scanner_.line();
    } else {
      links_.push_back({parent, found, parent_line});
    }
  }
}

// Puts the bones in an order with parents first. Lines may come in any order, so this goes over what is left until
// nothing more can be placed; a bone that is its own ancestor, or has two parents, never can.
inline Status AsfParser::arrange() {
  std::vector<char> placed(skeleton_.bones.size(), 0);
  placed[0] = 1;
  skeleton_.order.assign(1, 0);
  for (std::size_t before = links_.size() + 1; !links_.empty() && links_.size() < before;) {
    before = links_.size();
    std::vector<Link> left;
    for (const Link& link : links_) {
      const std::size_t child = static_cast<std::size_t>(link.child);
      if (placed[child] != 0) return {Error::bad_syntax, link.line};
      if (placed[static_cast<std::size_t>(link.parent)] == 0) {
        left.push_back(link);
        continue;
      }
      placed[child] = 1;
      skeleton_.bones[child].parent = link.parent;
      skeleton_.order.push_back(link.child);
    }
    links_ = std::move(left);
  }
  return links_.empty() ? Status{} : Status{Error::bad_syntax, links_[0].line};
}

inline Status AsfParser::parse() {
  if (!scanner_.more()) return {Error::empty_input, -1};
  if (in_section()) return scanner_.fail(Error::not_this_format);
  while (scanner_.more()) {
    const std::string_view word = scanner_.word();
    Status status;
    if (same_word(word, ":units")) status = read_units();
    if (same_word(word, ":root")) status = read_root();
    if (same_word(word, ":bonedata")) status = read_bonedata();
    if (same_word(word, ":hierarchy")) status = read_hierarchy();
    if (!status.ok()) return status;
  }
  if (!has_root_ && !has_bones_) return {Error::not_this_format, 1};
  if (!has_root_ || !has_bones_ || !has_hierarchy_) return scanner_.fail(Error::unexpected_end);
  return arrange();
}

}  // namespace rigless::detail
