// Which joint is which in the mirror.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "rigless/motion/joint_roles.h"

namespace rigless {

// J: the joint on the other side of the body, itself on the middle line and where there is none. By the words for left
// and right in the names; legs whose names say nothing by their roles. Mirroring twice gives the joint again.
// Allocates.
inline std::vector<std::int32_t> mirror_joints(const Skeleton& skeleton, const JointRoles& roles) {
  const auto count = static_cast<std::int32_t>(skeleton.names.size());
  std::vector<std::int32_t> mirror;
  std::vector<JointName> names;
  for (std::int32_t j = 0; j < count; ++j) {
    mirror.push_back(j);
    names.push_back(read_joint_name(skeleton.names[static_cast<std::size_t>(j)]));
  }
  const auto single = [&](std::int32_t j) { return mirror[static_cast<std::size_t>(j)] == j; };
  const auto pair = [&](std::int32_t a, std::int32_t b) {
    if (a < 0 || b < 0 || a == b || !single(a) || !single(b)) return;
    mirror[static_cast<std::size_t>(a)] = b;
    mirror[static_cast<std::size_t>(b)] = a;
  };
  // "lclavicle": a side grown together with a word that only its twin "rclavicle" explains.
  const auto grown = [&](const JointName& l, const JointName& r) {
    return l.side == BodySide::none && r.side == BodySide::none && !l.core.empty() && l.core[0] == 'l' &&
           !r.core.empty() && r.core[0] == 'r' && l.core.compare(1, l.core.npos, r.core, 1, r.core.npos) == 0;
  };
  for (std::int32_t a = 0; a < count; ++a) {
    const JointName& left = names[static_cast<std::size_t>(a)];
    for (std::int32_t b = 0; b < count && single(a); ++b) {
      const JointName& right = names[static_cast<std::size_t>(b)];
      const bool named = left.side == BodySide::left && right.side == BodySide::right && left.core == right.core;
      if (left.end == right.end && (named || grown(left, right))) pair(a, b);
    }
  }
  const LimbRoles &l = roles.left, &r = roles.right;
  pair(l.hip, r.hip);
  pair(l.knee, r.knee);
  pair(l.ankle, r.ankle);
  pair(l.toe, r.toe);
  pair(l.tip, r.tip);
  pair(l.hand, r.hand);
  return mirror;
}

}  // namespace rigless
