// Which joint is the left ankle: by name over the usual vocabularies, by hierarchy where names say nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rigless/motion/clip.h"
#include "rigless/motion/detail/body_frame.h"

namespace rigless {

// Joint indices of one side; -1 where there is none. `hip` is the top of the thigh, `toe` the ball of the foot, where
// the toes bend, `tip` their end. A foot without a ball has its end as `toe` and no `tip`.
struct LimbRoles {
  std::int32_t hip = -1;
  std::int32_t knee = -1;
  std::int32_t ankle = -1;
  std::int32_t toe = -1;
  std::int32_t tip = -1;
  std::int32_t hand = -1;
};

struct JointRoles {
  std::int32_t root = 0;
  std::int32_t head = -1;
  LimbRoles left;
  LimbRoles right;

  bool has_feet() const { return left.ankle >= 0 && left.toe >= 0 && right.ankle >= 0 && right.toe >= 0; }
};

// By name alone: CMU's ASF bones (whose joint is the END of the bone: ltibia is the ankle), the BVH, Mixamo, Biped,
// Unreal and VRM ways of writing LeftFoot, L_Foot, foot.L, lfoot, Bip01 L Foot. Gaps in a leg are filled from the
// joints above and below. Allocates scratch.
JointRoles find_joint_roles(const Skeleton& skeleton);

// By name; if that gives no two feet, the legs are the two chains that hang lowest on average, left where the body's
// left
// (+X when it faces +Z) is. Allocates scratch.
template <class S>
JointRoles find_joint_roles(const Clip<S>& clip);

// ---------------------------------------------------------------------------------------------------------------------

enum class BodySide : std::int32_t { none, left, right };

// A joint's name taken apart: "mixamorig:LeftToeBase" is left, "toebase".
struct JointName {
  BodySide side = BodySide::none;
  std::string core;  // lower case letters
  bool end = false;  // the end of a bone rather than a joint
};

inline bool ends_with(std::string_view text, std::string_view tail) {
  return text.size() >= tail.size() && text.substr(text.size() - tail.size()) == tail;
}

// Words of a name, in lower case: split at everything but letters, and where a capital begins a word (LHipJoint: l hip
// joint).
inline std::vector<std::string> name_words(std::string_view name) {
  const auto upper = [](char c) { return c >= 'A' && c <= 'Z'; };
  const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
  name = name.substr(std::min(name.size(), name.find_last_of(":|") + 1));  // name space
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!upper(c) && !lower(c)) {
      words.emplace_back();
      continue;
    }
    const bool after_small = i > 0 && lower(name[i - 1]);
    const bool before_small = i > 0 && upper(name[i - 1]) && i + 1 < name.size() && lower(name[i + 1]);
    if (upper(c) && (after_small || before_small)) words.emplace_back();
    words.back() += static_cast<char>(c | 0x20);
  }
  words.erase(std::remove(words.begin(), words.end(), std::string()), words.end());
  return words;
}

// Words that a side may have grown together with.
inline constexpr std::string_view limb_words[] = {"hip",   "hipjoint", "thigh", "upleg",  "upperleg", "femur",
                                                  "knee",  "shin",     "calf",  "tibia",  "leg",      "lowleg",
                                                  "ankle", "foot",     "toe",   "toes",   "toebase",  "hand",
                                                  "wrist", "arm",      "elbow", "radius", "humerus",  "shoulder"};

inline JointName read_joint_name(std::string_view name) {
  JointName result;
  for (const std::string& word : name_words(name)) {
    const bool left = word == "l" || word == "left" || word == "lt";
    const bool right = word == "r" || word == "right" || word == "rt";
    if (left || right) {
      result.side = left ? BodySide::left : BodySide::right;
    } else if (word == "end" || word == "nub" || word == "site" || word == "tip") {
      result.end = true;
    } else {
      result.core += word;
    }
  }
  // "lfoot", "rtibia", "leftfoot": the side grown together with a known word.
  for (const std::string_view side : {"left", "right", "l", "r"}) {
    if (result.side != BodySide::none || result.core.substr(0, side.size()) != side) continue;
    const std::string rest = result.core.substr(side.size());
    if (std::find(std::begin(limb_words), std::end(limb_words), rest) == std::end(limb_words)) continue;
    result.side = side[0] == 'l' ? BodySide::left : BodySide::right;
    result.core = rest;
  }
  return result;
}

class RoleFinder {
 public:
  explicit RoleFinder(const Skeleton& skeleton) : skeleton_(skeleton), children_(skeleton.names.size(), 0) {
    for (const std::string& name : skeleton.names) names_.push_back(read_joint_name(name));
    for (const std::int32_t parent : skeleton.parents) {
      if (parent >= 0) ++children_[static_cast<std::size_t>(parent)];
    }
  }

  JointRoles find() const {
    JointRoles roles;
    roles.head = find(BodySide::none, {"head"});
    roles.left = limb(BodySide::left);
    roles.right = limb(BodySide::right);
    return roles;
  }

 private:
  using Words = std::initializer_list<std::string_view>;

  // The first joint with one of the words, the earlier word winning, a whole name before the end of a name.
  std::int32_t find(BodySide side, Words words) const {
    for (const bool whole : {true, false}) {
      for (const std::string_view word : words) {
        for (std::size_t j = 0; j < names_.size(); ++j) {
          if (names_[j].side != side || names_[j].end) continue;
          if (whole ? names_[j].core == word : ends_with(names_[j].core, word)) return static_cast<std::int32_t>(j);
        }
      }
    }
    return -1;
  }

  bool leaf(std::int32_t joint) const { return joint >= 0 && children_[static_cast<std::size_t>(joint)] == 0; }
  std::int32_t parent(std::int32_t joint) const {
    return joint < 0 ? -1 : skeleton_.parents[static_cast<std::size_t>(joint)];
  }
  bool below(std::int32_t joint, std::int32_t ancestor) const {
    for (joint = parent(joint); joint >= 0 && joint != ancestor;) joint = parent(joint);
    return joint >= 0;
  }
  std::int32_t first_child(std::int32_t joint) const {
    for (std::size_t j = 0; j < skeleton_.parents.size() && joint >= 0; ++j) {
      if (skeleton_.parents[j] == joint) return static_cast<std::int32_t>(j);
    }
    return -1;
  }

  LimbRoles limb(BodySide side) const {
    LimbRoles limb;
    limb.hand = find(side, {"hand", "wrist"});
    const std::int32_t toes = find(side, {"toes"});
    const std::int32_t tibia = find(side, {"tibia"});
    // Acclaim bones: each joint is the far end, and the toes end in the air. A BVH file with the same names has an End
    // Site there.
    if (tibia >= 0 && leaf(toes)) {
      limb.hip = find(side, {"hipjoint"});
      limb.knee = find(side, {"femur"});
      limb.ankle = tibia;
      limb.toe = find(side, {"foot"});
      limb.tip = toes;
      return limb;
    }
    limb.hip = find(side, {"upleg", "upperleg", "thigh", "femur", "hip", "hipjoint"});
    limb.knee = find(side, {"knee", "lowleg", "lowerleg", "shin", "calf", "tibia", "leg"});
    limb.ankle = find(side, {"ankle", "foot"});
    limb.toe = find(side, {"toebase", "toe", "toes", "ball"});
    if (limb.ankle < 0) limb.ankle = parent(limb.toe);
    if (!below(limb.toe, limb.ankle)) {  // "LeftAnkle" may be followed by "LeftFoot", or by nothing but an end
      const std::int32_t foot = find(side, {"foot"});
      limb.toe = below(foot, limb.ankle) ? foot : first_child(limb.ankle);
    }
    limb.tip = first_child(limb.toe);
    if (limb.knee < 0 || limb.knee == limb.hip) limb.knee = parent(limb.ankle);
    if (limb.hip < 0) limb.hip = parent(limb.knee);
    return limb;
  }

  const Skeleton& skeleton_;
  std::vector<JointName> names_;
  std::vector<std::int32_t> children_;
};

inline JointRoles find_joint_roles(const Skeleton& skeleton) { return RoleFinder(skeleton).find(); }

// Mean body-local position of every joint.
template <class S>
std::vector<Vec3<S>> mean_body_pose(const Clip<S>& clip) {
  const std::vector<S> yaw = body_yaw(clip);
  const std::vector<Vec3<S>> local = body_local_positions(clip, Span<const S>(yaw));
  std::vector<Vec3<S>> mean(clip.skeleton.names.size(), Vec3<S>::Zero());
  for (std::size_t i = 0; i < local.size(); ++i) mean[i % mean.size()] += local[i] / static_cast<S>(clip.frames);
  return mean;
}

// The two lowest leaves that do not hang on the same foot: their paths meet two joints or more above each.
inline std::array<std::int32_t, 2> lowest_chains(const std::vector<std::int32_t>& parents,
                                                 const std::vector<std::int32_t>& leaves_by_height) {
  if (leaves_by_height.empty()) return {-1, -1};
  const std::int32_t first = leaves_by_height[0];
  const auto up = [&](std::int32_t j) { return j < 0 ? -1 : parents[static_cast<std::size_t>(j)]; };
  std::vector<char> above(parents.size(), 0);  // more than one joint above the first leaf
  std::vector<char> foot(parents.size(), 0);
  foot[static_cast<std::size_t>(first)] = 1;
  if (up(first) >= 0) foot[static_cast<std::size_t>(up(first))] = 1;
  for (std::int32_t j = up(up(first)); j >= 0; j = up(j)) above[static_cast<std::size_t>(j)] = 1;
  for (const std::int32_t leaf : leaves_by_height) {
    std::int32_t steps = 0;
    std::int32_t j = leaf;
    for (; j >= 0 && above[static_cast<std::size_t>(j)] == 0 && foot[static_cast<std::size_t>(j)] == 0; j = up(j)) {
      ++steps;
    }
    if (j >= 0 && above[static_cast<std::size_t>(j)] != 0 && steps >= 2) return {first, leaf};
  }
  return {-1, -1};
}

template <class S>
JointRoles find_joint_roles(const Clip<S>& clip) {
  JointRoles roles = find_joint_roles(clip.skeleton);
  if (roles.has_feet() || clip.frames == 0) return roles;

  const std::vector<std::int32_t>& parents = clip.skeleton.parents;
  const std::vector<Vec3<S>> mean = mean_body_pose(clip);
  std::vector<char> inner(parents.size(), 0);
  for (const std::int32_t parent : parents) {
    if (parent >= 0) inner[static_cast<std::size_t>(parent)] = 1;
  }
  std::vector<std::int32_t> leaves;
  for (std::int32_t j = 0; j < clip.joints(); ++j) {
    if (inner[static_cast<std::size_t>(j)] == 0) leaves.push_back(j);
  }
  const auto height = [&](std::int32_t j) { return mean[static_cast<std::size_t>(j)].y(); };
  std::sort(leaves.begin(), leaves.end(),
            [&](auto a, auto b) { return height(a) != height(b) ? height(a) < height(b) : a < b; });
  std::array<std::int32_t, 2> feet = lowest_chains(parents, leaves);
  if (feet[0] < 0) return roles;
  const auto x = [&](std::int32_t j) { return mean[static_cast<std::size_t>(j)].x(); };
  if (x(feet[0]) < x(feet[1])) std::swap(feet[0], feet[1]);
  const auto up = [&](std::int32_t j) { return j < 0 ? -1 : parents[static_cast<std::size_t>(j)]; };
  for (LimbRoles* limb : {&roles.left, &roles.right}) {
    limb->toe = feet[limb == &roles.left ? 0 : 1];
    // An End Site is the tip; the joint before it is the ball if there is enough leg above.
    if (ends_with(clip.skeleton.names[static_cast<std::size_t>(limb->toe)], "_end") && up(up(up(limb->toe))) > 0) {
      limb->tip = limb->toe;
      limb->toe = up(limb->tip);
    }
    limb->ankle = up(limb->toe);
    limb->knee = up(limb->ankle);
    limb->hip = up(limb->knee);
  }
  return roles;
}

}  // namespace rigless
