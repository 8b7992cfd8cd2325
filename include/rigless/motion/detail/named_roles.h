// Which joints carry the parts of a body, by names that the tree confirms and completes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/name_reader.h"
#include "rigless/motion/detail/skeleton_tree.h"

namespace rigless::detail {

class NamedRoles {
 public:
  NamedRoles(const Skeleton& skeleton, const SkeletonTree& tree)
      : tree_(tree), reader_(skeleton.names), names_(reader_.read()) {}

  // `root` is left to find_hips().
  JointRoles find() const {
    JointRoles roles;
    roles.left = limbs(BodySide::left);
    roles.right = limbs(BodySide::right);
    roles.head = first(BodySide::none, BodyPart::head);
    name_trunk(roles);
    complete(roles);
    return roles;
  }

  // The lowest joint that carries the legs and the rest, or one above it that is called so; 0 without legs.
  std::int32_t find_hips(const JointRoles& roles) const {
    const auto top = [](const LimbRoles& limb) {
      return limb.hip >= 0 ? limb.hip : limb.knee >= 0 ? limb.knee : limb.ankle;
    };
    const std::int32_t l = top(roles.left), r = top(roles.right);
    if (l < 0 || r < 0) return 0;
    std::int32_t fork = tree_.meeting(l, r);
    for (const std::int32_t joint : {roles.head, roles.left.hand, roles.right.hand}) fork = tree_.meeting(joint, fork);
    for (std::int32_t joint = fork; joint >= 0; joint = tree_.parent(joint)) {
      if (reader_.says_hips(static_cast<std::size_t>(joint))) return joint;
    }
    return std::max(fork, 0);
  }

  const JointName& name(std::int32_t joint) const { return names_[static_cast<std::size_t>(joint)]; }

 private:
  static constexpr std::array<BodyPart, 5> leg_parts = {BodyPart::upper_leg, BodyPart::lower_leg, BodyPart::foot,
                                                        BodyPart::toe, BodyPart::tip};
  static constexpr std::array<BodyPart, 4> arm_parts = {BodyPart::shoulder, BodyPart::upper_arm, BodyPart::lower_arm,
                                                        BodyPart::hand};

  bool is(std::int32_t joint, BodySide side, BodyPart part) const {
    return name(joint).side == side && name(joint).part == part;
  }
  std::int32_t first(BodySide side, BodyPart part) const {
    for (std::int32_t j = 0; j < tree_.joints(); ++j) {
      if (is(j, side, part)) return j;
    }
    return -1;
  }

  // The joints of a limb along one path from the root to an end: that which meets most of the parts in their order, so
  // that a second joint of the same name elsewhere is passed over. Where the tree is none (all joints hang on the root)
  // the first of each name.
  template <std::size_t N>
  std::array<std::int32_t, N> chain(BodySide side, const std::array<BodyPart, N>& parts) const {
    std::array<std::int32_t, N> best;
    best.fill(-1);
    std::int32_t most = 0;
    for (std::int32_t end = 0; end < tree_.joints(); ++end) {
      if (!tree_.children(end).empty()) continue;
      std::array<std::int32_t, N> found;
      found.fill(-1);
      std::int32_t score = 0;
      std::size_t next = 0;  // of the parts
      for (const std::int32_t joint : tree_.path_to(end)) {
        const std::size_t part = static_cast<std::size_t>(
            std::find_if(parts.begin(), parts.end(), [&](BodyPart p) { return is(joint, side, p); }) - parts.begin());
        if (part == N) continue;
        const bool again = next > 0 && part == next - 1;
        score += again ? 1 : part >= next ? 64 : 0;
        if (part < next && !(again && parts[part] == BodyPart::hand && reader_.bone_ends())) continue;
        found[part] = joint;
        next = part + 1;
      }
      if (score > most) best = found;
      most = std::max(most, score);
    }
    std::array<std::int32_t, N> anywhere;
    for (std::size_t k = 0; k < N; ++k) anywhere[k] = first(side, parts[k]);
    const auto count = [](const auto& joints) {
      return std::count_if(joints.begin(), joints.end(), [](std::int32_t joint) { return joint >= 0; });
    };
    return count(best) == 1 && count(anywhere) >= 3 ? anywhere : best;
  }

  LimbRoles limbs(BodySide side) const {
    const auto leg = chain(side, leg_parts);
    const auto arm = chain(side, arm_parts);
    LimbRoles limb;
    limb.hip = leg[0];
    limb.knee = leg[1];
    limb.ankle = leg[2];
    limb.toe = leg[3];
    limb.tip = leg[4];
    limb.collar = arm[0];
    limb.shoulder = arm[1];
    limb.elbow = arm[2];
    limb.hand = arm[3];
    return limb;
  }

  static std::int32_t top_of_arm(const LimbRoles& limb) {
    for (const std::int32_t joint : {limb.collar, limb.shoulder, limb.elbow, limb.hand}) {
      if (joint >= 0) return joint;
    }
    return -1;
  }

  // Along the way from the hips to the head: the first spine, chest and neck. Without a chest the last of several
  // spines is it.
  void name_trunk(JointRoles& roles) const {
    const std::int32_t arms = tree_.meeting(top_of_arm(roles.left), top_of_arm(roles.right));
    const std::int32_t hips = find_hips(roles);
    std::int32_t last = -1;
    for (const std::int32_t joint : tree_.path_to(roles.head >= 0 ? roles.head : arms)) {
      if (name(joint).side != BodySide::none) continue;
      const BodyPart part = name(joint).part;
      if (part == BodyPart::spine && roles.spine < 0 && joint != hips) roles.spine = joint;
      if (part == BodyPart::spine) last = joint;
      if (part == BodyPart::chest && roles.chest < 0) roles.chest = joint;
      if (part == BodyPart::neck && roles.neck < 0) roles.neck = joint;
    }
    if (roles.chest < 0 && last != roles.spine) roles.chest = last;
    if (roles.spine < 0) roles.spine = first(BodySide::none, BodyPart::spine);
    if (roles.chest < 0) roles.chest = first(BodySide::none, BodyPart::chest);
    if (roles.neck < 0) roles.neck = first(BodySide::none, BodyPart::neck);
  }

  // Gaps from the joints above and below, as far as they belong to one limb.
  void complete(JointRoles& roles) const {
    const LimbRoles &l = roles.left, &r = roles.right;
    const auto shared = [&](std::int32_t joint) {  // by both sides, or with the head
      const auto carries = [&](std::initializer_list<std::int32_t> joints) {
        return std::any_of(joints.begin(), joints.end(), [&](std::int32_t j) { return tree_.within(j, joint); });
      };
      const bool left = carries({l.hip, l.knee, l.ankle, l.toe, l.elbow, l.hand});
      const bool right = carries({r.hip, r.knee, r.ankle, r.toe, r.elbow, r.hand});
      return (left && right) || carries({roles.head, roles.neck});
    };
    const auto above = [&](std::int32_t joint) {
      const std::int32_t parent = tree_.parent(joint);
      return parent < 0 || shared(parent) ? -1 : parent;
    };
    const auto fill = [](std::int32_t& role, std::int32_t joint) { role = role >= 0 ? role : joint; };
    for (LimbRoles* limb : {&roles.left, &roles.right}) {
      fill(limb->ankle, above(limb->toe));
      if (limb->toe < 0 && tree_.parent(limb->tip) == limb->ankle) std::swap(limb->toe, limb->tip);
      fill(limb->toe, tree_.first_child(limb->ankle));
      fill(limb->tip, tree_.first_child(limb->toe));
      fill(limb->knee, above(limb->ankle) == limb->hip ? -1 : above(limb->ankle));
      fill(limb->hip, above(limb->knee));
      fill(limb->hand, tree_.first_child(limb->elbow));
      fill(limb->elbow, above(limb->hand) == limb->shoulder ? -1 : above(limb->hand));
      fill(limb->shoulder, above(limb->elbow) == limb->collar ? -1 : above(limb->elbow));
      fill(limb->collar, above(limb->shoulder));
    }
  }

  const SkeletonTree& tree_;
  NameReader reader_;
  std::vector<JointName> names_;
};

}  // namespace rigless::detail
