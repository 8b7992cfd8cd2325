// The HIERARCHY part of a BVH file.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/motion/detail/text_scanner.h"

namespace rigless::detail {

// One value of a frame: a position, a rotation (degrees) or a scale along or about axis 0, 1, 2.
struct BvhChannel {
  enum class Kind : std::int32_t { position, rotation, scale };
  Kind kind;
  std::int32_t axis;
};

struct BvhNode {
  std::string name;
  std::int32_t parent = -1;
  Vec3<double> offset = Vec3<double>::Zero();
  std::vector<BvhChannel> channels;  // in the order of a frame's values
};

struct BvhHierarchy {
  std::vector<BvhNode> nodes;  // a parent before its children; End Sites are nodes too, named <parent>_end
  std::int32_t joints = 0;     // nodes of the first hierarchy; those of further ROOTs follow
  std::int32_t roots = 0;
  std::int32_t renamed = 0;   // names that were taken or empty
  std::int32_t channels = 0;  // values per frame, over all nodes
};

// Reads up to and including the word MOTION. Braces may stand anywhere, keywords in any case, OFFSET and CHANNELS in
// any order or missing; a title may stand in front. Does not recurse. Allocates in proportion to the text. Errors:
// empty_input; not_this_format: no HIERARCHY, and the first word is not ROOT; unexpected_end; bad_syntax; bad_number;
// unsupported: a channel that is no position, rotation or scale. `hierarchy` is then unspecified.
Status parse_bvh_hierarchy(TextScanner& scanner, BvhHierarchy& hierarchy);

// ---------------------------------------------------------------------------------------------------------------------

// Makes names unique with _2, _3, ...
class UniqueNames {
 public:
  std::string operator()(std::string_view wanted, std::int32_t& renamed) {
    std::string name(wanted.empty() ? std::string_view("joint") : wanted);
    const bool free = last_.emplace(name, 1).second;
    renamed += free && !wanted.empty() ? 0 : 1;
    if (free) return name;
    std::int32_t& last = last_[name];
    while (true) {
      std::string candidate = name + "_" + std::to_string(++last);
      if (last_.find(candidate) == last_.end()) {
        last_.emplace(candidate, 1);
        return candidate;
      }
    }
  }

 private:
  std::unordered_map<std::string, std::int32_t> last_;
};

// "Xrotation", "Yrot", "zpos".
inline bool read_bvh_channel(std::string_view word, BvhChannel& channel) {
  using Kind = BvhChannel::Kind;
  static constexpr std::pair<std::string_view, Kind> kinds[] = {
      {"rotation", Kind::rotation}, {"rot", Kind::rotation},         {"position", Kind::position},
      {"pos", Kind::position},      {"translation", Kind::position}, {"scale", Kind::scale},
  };
  if (word.size() < 2) return false;
  channel.axis = (word[0] | 0x20) - 'x';
  for (const auto& [said, kind] : kinds) {
    if (!same_word(word.substr(1), said)) continue;
    channel.kind = kind;
    return channel.axis >= 0 && channel.axis < 3;
  }
  return false;
}

inline Status read_bvh_channels(TextScanner& scanner, BvhNode& node) {
  double count = 0;
  if (const Status status = scanner.number(count); !status.ok()) return status;
  if (count < 0 || count != std::floor(count)) return scanner.fail(Error::bad_number);
  for (double i = 0; i < count; ++i) {
    const std::string_view word = scanner.word();
    BvhChannel channel{};
    if (word.empty()) return scanner.fail(Error::unexpected_end);
    if (!read_bvh_channel(word, channel)) return scanner.fail(Error::unsupported);
    node.channels.push_back(channel);
  }
  return {};
}

// Appends a node and reads its name and opening brace.
inline Status open_bvh_node(TextScanner& scanner, bool end_site, std::int32_t parent, UniqueNames& unique,
                            BvhHierarchy& hierarchy) {
  std::string name(scanner.rest_of_line('{'));
  if (end_site) name = hierarchy.nodes[static_cast<std::size_t>(parent)].name + "_end";
  BvhNode node;
  node.name = unique(name, hierarchy.renamed);
  node.parent = parent;
  hierarchy.nodes.push_back(std::move(node));
  const std::string_view brace = scanner.word();
  if (brace.empty()) return scanner.fail(Error::unexpected_end);
  return brace == "{" ? Status{} : scanner.fail(Error::bad_syntax);
}

// One entry inside the braces of node `open`, which moves to the child or back to the parent.
inline Status read_bvh_entry(TextScanner& scanner, std::string_view word, UniqueNames& unique, std::int32_t& open,
                             BvhHierarchy& hierarchy) {
  BvhNode& node = hierarchy.nodes[static_cast<std::size_t>(open)];
  if (word == "}") {
    open = node.parent;
  } else if (same_word(word, "OFFSET")) {
    for (std::int32_t k = 0; k < 3; ++k) {
      if (const Status status = scanner.number(node.offset[k]); !status.ok()) return status;
    }
  } else if (same_word(word, "CHANNELS")) {
    return read_bvh_channels(scanner, node);
  } else if (same_word(word, "JOINT") || same_word(word, "End") || same_word(word, "EndSite")) {
    const std::int32_t parent = open;
    open = static_cast<std::int32_t>(hierarchy.nodes.size());
    return open_bvh_node(scanner, !same_word(word, "JOINT"), parent, unique, hierarchy);
  } else {
    return scanner.fail(Error::bad_syntax);
  }
  return {};
}

inline Status parse_bvh_hierarchy(TextScanner& scanner, BvhHierarchy& hierarchy) {
  std::string_view word = scanner.word();
  if (word.empty()) return {Error::empty_input, -1};
  const Status other_format = scanner.fail(Error::not_this_format);
  const bool bare = same_word(word, "ROOT");
  for (std::int32_t line = 0; !bare && (!same_word(word, "HIERARCHY") || scanner.line() == line);) {
    line = scanner.line();  // of a title
    word = scanner.word();
    if (word.empty()) return other_format;
  }
  if (same_word(word, "HIERARCHY")) word = scanner.word();

  UniqueNames unique;
  std::int32_t open = -1;
  for (;; word = scanner.word()) {
    if (word.empty()) return scanner.fail(Error::unexpected_end);
    Status status;
    if (open >= 0) {
      status = read_bvh_entry(scanner, word, unique, open, hierarchy);
    } else if (same_word(word, "ROOT")) {
      open = static_cast<std::int32_t>(hierarchy.nodes.size());
      if (hierarchy.roots++ == 1) hierarchy.joints = open;
      status = open_bvh_node(scanner, false, -1, unique, hierarchy);
    } else if (same_word(word, "MOTION") && hierarchy.roots > 0) {
      break;
    } else {
      status = scanner.fail(Error::bad_syntax);
    }
    if (!status.ok()) return status;
  }
  if (hierarchy.roots == 1) hierarchy.joints = static_cast<std::int32_t>(hierarchy.nodes.size());
  for (const BvhNode& node : hierarchy.nodes) hierarchy.channels += static_cast<std::int32_t>(node.channels.size());
  return {};
}

}  // namespace rigless::detail
