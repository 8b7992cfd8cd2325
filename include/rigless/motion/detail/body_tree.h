// Which joints carry the parts of a body, by the tree and its bones alone: two pairs of equal chains, legs and arms.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/skeleton_tree.h"

namespace rigless::detail {

// Joint positions of some frames, J each, in any axes and lengths.
class Poses {
 public:
  Poses(std::vector<Vec3<double>> positions, std::size_t joints) : positions_(std::move(positions)), joints_(joints) {}

  std::size_t count() const { return joints_ == 0 ? 0 : positions_.size() / joints_; }
  const Vec3<double>& at(std::size_t pose, std::int32_t joint) const {
    return positions_[pose * joints_ + static_cast<std::size_t>(joint)];
  }
  double distance(std::int32_t a, std::int32_t b) const { return (at(0, a) - at(0, b)).norm(); }
  // The mean over the poses of what `vector` gives for each.
  template <class F>
  Vec3<double> mean(F vector) const {
    Vec3<double> sum = Vec3<double>::Zero();
    for (std::size_t pose = 0; pose < count(); ++pose) sum += vector(pose);
    return sum / static_cast<double>(std::max<std::size_t>(count(), 1));
  }

 private:
  std::vector<Vec3<double>> positions_;
  std::size_t joints_;
};

// Two branches of one joint that are each other's mirror images.
struct LimbPair {
  std::int32_t fork = -1;
  std::int32_t a = -1;
  std::int32_t b = -1;
  double reach = 0;  // how far the shorter one reaches from the fork
};

class BodyTree {
 public:
  BodyTree(const SkeletonTree& tree, const Poses& poses) : tree_(tree), poses_(poses) {
    reach_.assign(static_cast<std::size_t>(tree.joints()), 0);
    total_ = reach_;
    for (std::int32_t j = tree.joints(); j-- > 0;) {
      for (const std::int32_t child : tree.children(j)) {
        reach_[at(j)] = std::max(reach_[at(j)], reach_[at(child)]);
        total_[at(j)] += total_[at(child)];
      }
      if (tree.parent(j) < 0) continue;
      reach_[at(j)] += poses.distance(j, tree.parent(j));
      total_[at(j)] += poses.distance(j, tree.parent(j));
    }
  }

  // Everything, or nothing where there are no two pairs. The sides are a guess that tell_sides() replaces; the root is
  // left to the caller. `is_end`: whether a joint is called the end of a bone.
  template <class IsEnd>
  JointRoles find(IsEnd is_end) const {
    JointRoles roles;
    const std::array<LimbPair, 2> pairs = limb_pairs();
    if (pairs[1].fork < 0) return roles;
    const bool swapped = !first_are_legs(pairs[0], pairs[1]);
    const LimbPair legs = pairs[swapped ? 1 : 0];
    const LimbPair arms = pairs[swapped ? 0 : 1];
    set_leg(farthest(legs.a), roles.left);
    set_leg(farthest(legs.b), roles.right);
    set_arm(farthest(arms.a), roles.left);
    set_arm(farthest(arms.b), roles.right);
    const std::int32_t hips = tree_.meeting(legs.fork, arms.fork);
    if (arms.fork != hips) roles.chest = arms.fork;
    for (const std::int32_t joint : tree_.path_to(arms.fork)) {
      if (tree_.parent(joint) == hips && joint != arms.fork) roles.spine = joint;
    }
    set_head(arms, is_end, roles);
    return roles;
  }

  // The joints from `joint` on along which its branch reaches farthest.
  std::vector<std::int32_t> farthest(std::int32_t joint) const {
    std::vector<std::int32_t> chain;
    while (joint >= 0) {
      chain.push_back(joint);
      const std::vector<std::int32_t>& next = tree_.children(joint);
      const auto most =
          std::max_element(next.begin(), next.end(), [&](auto a, auto b) { return reach_[at(a)] < reach_[at(b)]; });
      joint = most == next.end() ? -1 : *most;
    }
    return chain;
  }

  // Where in a chain its two long bones begin: the last two that are nearly as long as any, since a collarbone may be
  // as long as a forearm. -1 if it has no two bones. shorter: length of the shorter one.
  std::int32_t long_bones(const std::vector<std::int32_t>& chain, double& shorter) const {
    const auto both = [&](std::size_t k) {
      return std::min(poses_.distance(chain[k], chain[k + 1]), poses_.distance(chain[k + 1], chain[k + 2]));
    };
    double longest = 0;
    for (std::size_t k = 0; k + 2 < chain.size(); ++k) longest = std::max(longest, both(k));
    for (std::size_t k = chain.size(); k-- > 2;) {
      shorter = both(k - 2);
      if (shorter >= 0.75 * longest) return static_cast<std::int32_t>(k) - 2;
    }
    return -1;
  }

 private:
  static std::size_t at(std::int32_t joint) { return static_cast<std::size_t>(joint); }

  bool equal(std::int32_t a, std::int32_t b) const {
    const auto near = [](double x, double y, double share) { return std::abs(x - y) <= share * std::max(x, y); };
    return near(reach_[at(a)], reach_[at(b)], 0.08) && near(total_[at(a)], total_[at(b)], 0.2) &&
           near(tree_.size(a), tree_.size(b), 0.25) && farthest(a).size() >= 3 && farthest(b).size() >= 3;
  }

  // The two pairs that reach farthest, none on a limb of the other.
  std::array<LimbPair, 2> limb_pairs() const {
    std::vector<LimbPair> pairs;
    for (std::int32_t fork = 0; fork < tree_.joints(); ++fork) {
      const std::vector<std::int32_t>& branches = tree_.children(fork);
      for (std::size_t i = 0; i < branches.size(); ++i) {
        for (std::size_t k = i + 1; k < branches.size(); ++k) {
          const std::int32_t a = branches[i], b = branches[k];
          if (equal(a, b)) pairs.push_back({fork, a, b, std::min(reach_[at(a)], reach_[at(b)])});
        }
      }
    }
    std::array<LimbPair, 2> best;
    for (LimbPair& found : best) {
      for (const LimbPair& pair : pairs) {
        const bool apart = best[0].fork < 0 || (!on_limb(pair, best[0]) && !on_limb(best[0], pair));
        if (apart && pair.reach > found.reach) found = pair;
      }
    }
    return best;
  }
  bool on_limb(const LimbPair& pair, const LimbPair& other) const {
    const auto touches = [&](std::int32_t joint) {
      return tree_.within(joint, other.a) || tree_.within(joint, other.b);
    };
    return touches(pair.fork) || touches(pair.a) || touches(pair.b);
  }

  // The pair nearer to the root; side by side, that beside which nothing grows, and at one joint that which hangs
  // lower.
  bool first_are_legs(const LimbPair& first, const LimbPair& second) const {
    if (first.fork != second.fork) {
      if (tree_.within(second.fork, first.fork)) return true;
      if (tree_.within(first.fork, second.fork)) return false;
      const auto more = [&](const LimbPair& pair) { return tree_.children(pair.fork).size() > 2; };
      if (more(first) != more(second)) return more(second);
    }
    const auto height = [&](const LimbPair& pair) {
      return poses_.mean([&](std::size_t f) { return poses_.at(f, farthest(pair.a).back()); }).y();
    };
    return height(first) < height(second);
  }

  void set_leg(const std::vector<std::int32_t>& chain, LimbRoles& limb) const {
    double length = 0;
    const auto hip = static_cast<std::size_t>(std::max(long_bones(chain, length), 0));
    const auto joint = [&](std::size_t k) { return hip + k < chain.size() ? chain[hip + k] : -1; };
    limb.hip = joint(0);
    limb.knee = joint(1);
    limb.ankle = joint(2);
    limb.toe = joint(3);
    limb.tip = joint(4);
  }

  void set_arm(const std::vector<std::int32_t>& chain, LimbRoles& limb) const {
    double length = 0;
    const auto shoulder = static_cast<std::size_t>(std::max(long_bones(chain, length), 0));
    limb.collar = shoulder > 0 ? chain[shoulder - 1] : -1;
    limb.shoulder = chain[shoulder];
    limb.elbow = chain[shoulder + 1];
    limb.hand = chain[shoulder + 2];
  }

  // What grows between the arms: up to where a face begins, or to the last joint that is no mere end.
  template <class IsEnd>
  void set_head(const LimbPair& arms, IsEnd is_end, JointRoles& roles) const {
    std::int32_t top = -1;
    for (const std::int32_t child : tree_.children(arms.fork)) {
      const bool other = child != arms.a && child != arms.b && !tree_.within(roles.left.hip, child);
      if (other && (top < 0 || reach_[at(child)] > reach_[at(top)])) top = child;
    }
    if (top < 0) return;
    roles.head = top;
    for (const std::int32_t joint : farthest(top)) {
      if (!is_end(joint)) roles.head = joint;
      if (tree_.children(joint).size() > 1) break;
    }
    if (roles.head != top) roles.neck = top;
  }

  const SkeletonTree& tree_;
  const Poses& poses_;
  std::vector<double> reach_;  // from the parent to the end that is farthest along the bones
  std::vector<double> total_;  // all bones of the branch, with that from the parent
};

}  // namespace rigless::detail
