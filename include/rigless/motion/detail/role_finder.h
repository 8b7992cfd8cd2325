// Names first, the tree where they are silent or where the bones contradict them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/body_sides.h"
#include "rigless/motion/detail/body_tree.h"
#include "rigless/motion/detail/named_roles.h"
#include "rigless/motion/detail/skeleton_tree.h"

namespace rigless::detail {

// Without an answer for skeletons of more joints than any body has.
class RoleFinder {
 public:
  static constexpr std::size_t max_joints = 4096;

  explicit RoleFinder(const Skeleton& skeleton)
      : tree_(skeleton.names.size() > max_joints ? Skeleton{} : skeleton),
        named_(skeleton.names.size() > max_joints ? Skeleton{} : skeleton, tree_) {}

  JointRoles find() const {
    JointRoles roles = named_.find();
    roles.root = named_.find_hips(roles);
    return roles;
  }

  JointRoles find(const Poses& poses) const {
    JointRoles roles = named_.find();
    const BodyTree body(tree_, poses);
    for (LimbRoles* limb : {&roles.left, &roles.right}) {
      correct(body, poses, limb->hip, limb->knee, limb->ankle, nullptr);
      correct(body, poses, limb->shoulder, limb->elbow, limb->hand, &limb->collar);
    }
    const bool whole = has_legs(roles.left) && has_legs(roles.right) && has_arms(roles.left) && has_arms(roles.right) &&
                       roles.head >= 0 && roles.chest >= 0;
    if (!whole) fill(body, poses, roles);
    roles.root = named_.find_hips(roles);
    drop_doubles(roles);
    return roles;
  }

 private:
  static bool has_legs(const LimbRoles& limb) { return limb.hip >= 0 && limb.knee >= 0 && limb.ankle >= 0; }
  static bool has_arms(const LimbRoles& limb) { return limb.shoulder >= 0 && limb.elbow >= 0 && limb.hand >= 0; }

  // Names that are shifted by a joint (an elbow called wrist) leave the limb's two long bones; the joints there are the
  // limb then.
  void correct(const BodyTree& body, const Poses& poses, std::int32_t& top, std::int32_t& middle, std::int32_t& end,
               std::int32_t* before) const {
    if (top < 0 || middle < 0 || end < 0 || !tree_.below(end, middle) || !tree_.below(middle, top)) return;
    const double named = std::min(poses.distance(top, middle), poses.distance(middle, end));
    std::vector<std::int32_t> chain = {top};
    for (const std::int32_t joint : tree_.path_to(end)) {
      if (tree_.below(joint, top)) chain.push_back(joint);
    }
    const std::vector<std::int32_t> rest = body.farthest(end);
    chain.insert(chain.end(), rest.begin() + 1, rest.end());
    double found = 0;
    const std::int32_t k = body.long_bones(chain, found);
    if (k <= 0 || !(found > 1.5 * named)) return;
    const auto at = [&](std::int32_t i) { return chain[static_cast<std::size_t>(i)]; };
    if (before != nullptr) *before = at(k - 1);
    top = at(k);
    middle = at(k + 1);
    end = at(k + 2);
  }

  // Which side the names give a branch's joints, if any.
  BodySide named_side(std::int32_t top) const {
    for (std::int32_t j = 0; j < tree_.joints(); ++j) {
      if (tree_.within(j, top) && named_.name(j).side != BodySide::none) return named_.name(j).side;
    }
    return BodySide::none;
  }

  static void swap_arms(JointRoles& roles) {
    std::swap(roles.left.collar, roles.right.collar);
    std::swap(roles.left.shoulder, roles.right.shoulder);
    std::swap(roles.left.elbow, roles.right.elbow);
    std::swap(roles.left.hand, roles.right.hand);
  }
  static void swap_sides(JointRoles& roles) { std::swap(roles.left, roles.right); }

  // Turns the tree's guess so that left is left, for legs and arms alike.
  void tell_sides(const Poses& poses, JointRoles& tree) const {
    const LimbRoles &l = tree.left, &r = tree.right;
    const auto across = [&](std::int32_t a, std::int32_t b) { return from_right_to_left(poses, a, b); };
    if (across(l.hip, r.hip).dot(across(l.shoulder, r.shoulder)) < 0) swap_arms(tree);
    for (const std::int32_t joint : {l.hip, l.shoulder}) {
      const BodySide side = named_side(joint);
      if (side == BodySide::right) swap_sides(tree);
      if (side != BodySide::none) return;
    }
    if (!is_left_left(poses, tree)) swap_sides(tree);
  }

  // A limb whose names are not complete is the tree's, on both sides; of the trunk only what is missing.
  void fill(const BodyTree& body, const Poses& poses, JointRoles& roles) const {
    JointRoles tree = body.find([&](std::int32_t joint) { return named_.name(joint).part >= BodyPart::tip; });
    if (tree.left.hip < 0) return;
    tell_sides(poses, tree);
    const bool legs = has_legs(roles.left) && has_legs(roles.right);
    const bool arms = has_arms(roles.left) && has_arms(roles.right);
    for (const auto& [limb, found] : {std::pair(&roles.left, &tree.left), std::pair(&roles.right, &tree.right)}) {
      LimbRoles merged = *found;
      if (legs) {
        merged.hip = limb->hip;
        merged.knee = limb->knee;
        merged.ankle = limb->ankle;
        merged.toe = limb->toe;
        merged.tip = limb->tip;
      }
      if (arms) {
        merged.collar = limb->collar;
        merged.shoulder = limb->shoulder;
        merged.elbow = limb->elbow;
        merged.hand = limb->hand;
      }
      *limb = merged;
    }
    const auto complete = [](std::int32_t& role, std::int32_t joint) { role = role >= 0 ? role : joint; };
    if (tree.spine >= 0 && tree_.below(roles.spine, tree.spine)) roles.spine = tree.spine;
    complete(roles.spine, tree.spine);
    complete(roles.chest, tree.chest);
    complete(roles.head, tree.head);
    complete(roles.neck, tree.neck);
  }

  // What the names call spine may be the hips or the chest to the tree.
  static void drop_doubles(JointRoles& roles) {
    if (roles.spine == roles.root || roles.spine == roles.chest) roles.spine = -1;
    if (roles.chest == roles.root) roles.chest = -1;
    if (roles.neck == roles.head || roles.neck == roles.chest || roles.neck == roles.root) roles.neck = -1;
  }

  SkeletonTree tree_;
  NamedRoles named_;
};

}  // namespace rigless::detail
