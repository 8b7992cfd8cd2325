// How the limbs of a solid are turned before it is solved. A few iterations bend a limb, but do not turn it as a whole:
// an arm that rests level and is to hang would hang by its hand and stretch. So a limb begins where its ends ask it to
// be, bent at its middle when they are nearer than it is long.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "rigless/math/detail/rotation.h"
#include "rigless/math/detail/smooth_step.h"
#include "rigless/scene/detail/held_things.h"
#include "rigless/scene/detail/limbs.h"
#include "rigless/scene/detail/trunk.h"

namespace rigless::detail {

template <class S>
class LimbTurns {
 public:
  // C controls, where they rest, and the limb at whose tip each lies; floor: y of the lowest vertex at rest; height: of
  // the mesh. A stump is no limb that turns. Allocates.
  RIGLESS_COLD void bind(const Solid<S>& solid, Span<const Control<S>> controls, Span<const Vec3<S>> rest,
                         Span<const Limb<S>> limbs, S floor, S height) {
    chains_.clear();
    nodes_.clear();
    rotations_.assign(solid.rest.size(), Mat3<S>::Identity());
    std::vector<S> nearest(solid.rest.size(), std::numeric_limits<S>::max());
    std::vector<Node> found(solid.rest.size());
    std::vector<LimbBones<S>> bones;
    for (std::size_t c = 0; c < controls.size(); ++c) {
      const Limb<S>& limb = limbs[c];
      if (!(limb.length > S(0)) || is_stump(limb, solid.cell)) continue;
      bones.push_back(limb_bones(solid, limb, controls, c, rest[c]));
      const S reach = limb.reach * (S(1) + blur);
      for (const auto& [node, distance] : vertices_within<S>(solid.rest, solid.ring, bones.back().node, reach)) {
        if (!(limb.reach > S(0)) || distance >= nth(nearest, node)) continue;
        nth(nearest, node) = distance;
        nth(found, node) = node_at(node, count_of(chains_), distance / limb.reach);
      }
      chains_.push_back(make_chain(limb, static_cast<std::int32_t>(c), rest[c], is_leg(limb, rest[c], floor, height)));
    }
    // What is known to be a limb was not followed from its tip.
    const TrunkShape<S> trunk = find_trunk(solid, controls, rest);
    in_hand_.assign(solid.rest.size(), -1);
    beyond_.assign(solid.rest.size(), -1);
    for (const auto& [node, chain, along] : find_limb_nodes<S>(solid, bones, trunk, S(1) + blur)) {
      const std::int32_t c = nth(chains_, chain).control;
      if (nth(limbs, c).reach > S(0)) continue;
      nth(found, node) = node_at(node, chain, along);
      const S far = (nth(solid.rest, node) - nth(rest, c)).norm();
      if (along < hand && far > S(1.5) * nth(bones, chain).thickness) nth(beyond_, node) = c;
    }
    for (const auto& [node, chain, along] : find_held_things<S>(solid, bones, trunk, S(1) + blur)) {
      nth(found, node) = node_at(node, chain, along);
      if (along < hand) nth(in_hand_, node) = nth(beyond_, node) = nth(chains_, chain).control;
    }
    for (const Node& node : found)
      if (node.chain >= 0) nodes_.push_back(node);
  }

  // N: not 0 for nodes that take more than a share of a limb's turn. Allocates.
  RIGLESS_COLD std::vector<char> on_limb(S share) const {
    std::vector<char> on(rotations_.size(), 0);
    for (const Node& node : nodes_) nth(on, node.node) = node.upper > share ? 1 : 0;
    return on;
  }

  // N: the control at the tip of the limb that holds a node as a hand does, or -1.
  Span<const std::int32_t> in_hand() const { return in_hand_; }
  // The same, also for what of such a thing is as near to the hand as the hand itself.
  Span<const std::int32_t> beyond_hand() const { return beyond_; }

  // Whether control c lies at the tip of a limb that turns.
  bool has(std::int32_t c) const { return find(c) != chains_.end(); }

  // Of the turn of a limb's tip, a share; after turn(). No allocation.
  Mat3<S> at_tip(std::int32_t c, S share) const { return part_of(find(c)->at_tip, share).toRotationMatrix(); }

  // N: how each node is turned from rest for these C targets, and for a trunk that is there. No allocation.
  Span<const Mat3<S>> turn(const TrunkMotion<S>& trunk, Span<const Vec3<S>> targets) {
    std::fill(rotations_.begin(), rotations_.end(), trunk.R);
    for (Chain& chain : chains_) {
      bend(chain, trunk, nth(targets, chain.control));
      chain.at_tip = chain.lower * chain.upper * Turn(trunk.R);
    }
    for (const Node& node : nodes_) {
      const Chain& chain = nth(chains_, node.chain);
      nth(rotations_, node.node) =
          (part_of(chain.lower, node.lower) * part_of(chain.upper, node.upper)).toRotationMatrix() * trunk.R;
    }
    return rotations_;
  }

 private:
  using Turn = Eigen::Quaternion<S>;

  static constexpr S blur = S(0.15);  // of a limb's reach: over so much its turn begins, and changes at its middle

  static constexpr S hand = S(0.2);  // of a limb: what hangs on it there is held as one piece

  struct Chain {
    std::int32_t control;
    Vec3<S> base, middle, tip;  // at rest
    Vec3<S> bulge;              // from the middle of base and tip to where it bends, at rest; unit
    Turn upper, lower;          // of the half at the base from the trunk, of the other from that
    Turn at_tip;                // of both, and the trunk
  };
  struct Node {
    std::int32_t node = -1, chain = -1;
    S upper = 0, lower = 0;  // shares of those turns
  };

  typename std::vector<Chain>::const_iterator find(std::int32_t c) const {
    return std::find_if(chains_.begin(), chains_.end(), [c](const Chain& chain) { return chain.control == c; });
  }

  static Node node_at(std::int32_t node, std::int32_t chain, S along) {
    return {node, chain, until(S(1), along), until(S(0.5), along)};
  }

  // From 1 at the tip to 0 where `end` is passed.
  static S until(S end, S along) { return smooth_step((end + blur - along) / (S(2) * blur)); }

  // About as much of a turn; no sine, which machines tell differently.
  static Turn part_of(const Turn& turn, S share) {
    const S sign = turn.w() < S(0) ? S(-1) : S(1);
    Turn part((S(1) - share) + share * sign * turn.w(), share * sign * turn.x(), share * sign * turn.y(),
              share * sign * turn.z());
    part.normalize();
    return part;
  }

  // Bends as it rests bent; a straight leg as a knee does, and what does not stand as an elbow of an arm that hangs.
  RIGLESS_COLD static Chain make_chain(const Limb<S>& limb, std::int32_t control, const Vec3<S>& tip, bool leg) {
    Chain chain{control,          limb.base,        limb.middle,      tip,
                Vec3<S>::UnitZ(), Turn::Identity(), Turn::Identity(), Turn::Identity()};
    const Vec3<S> way = (tip - limb.base).normalized(), half = limb.middle - limb.base;
    const Vec3<S> off_line = half - way * way.dot(half);
    Vec3<S> off = off_line;
    if (leg) {  // whose foot points forward: it may be straight seen from there or straight down
      const Vec3<S> aside(half.x(), S(0), half.z());
      if (aside.squaredNorm() < off.squaredNorm()) off = aside;
    }
    if (off.norm() > S(0.08) * limb.length) {
      chain.bulge = off.normalized();
    } else {
      chain.middle -= off_line;
      const Vec3<S> hanging = leg ? Vec3<S>(Vec3<S>::UnitZ()) : Vec3<S>(-Vec3<S>::UnitZ());
      chain.bulge = shortest_arc<S>(-Vec3<S>::UnitY(), way) * hanging;
    }
    return chain;
  }

  // Two bones whose ends are told. Farther away than they reach they are straight.
  RIGLESS_COLD static void bend(Chain& chain, const TrunkMotion<S>& trunk, const Vec3<S>& target) {
    const Vec3<S> base = trunk.carry(chain.base), way = target - base;
    const Vec3<S> upper = trunk.R * (chain.middle - chain.base), lower = trunk.R * (chain.tip - chain.middle);
    const S a = upper.norm(), b = lower.norm(), d = std::max(way.norm(), S(1e-6) * (a + b));
    const Mat3<S> swing = shortest_arc<S>((trunk.R * (chain.tip - chain.base)).normalized(), way / d);
    const S along = std::clamp((a * a - b * b + d * d) / (S(2) * d), -a, a);  // the way, as far as the bend
    const S off = d < a + b ? std::sqrt(std::max(a * a - along * along, S(0))) : S(0);
    const Vec3<S> middle = base + (way / d) * along + swing * (trunk.R * chain.bulge) * off;
    const Mat3<S> to_middle = shortest_arc<S>((swing * upper) / a, (middle - base).normalized()) * swing;
    const Mat3<S> from_there = shortest_arc<S>((to_middle * lower) / b, (target - middle).normalized());
    chain.upper = Turn(to_middle);
    chain.lower = Turn(from_there);
  }

  std::vector<Chain> chains_;
  std::vector<Node> nodes_;                     // those that limbs turn
  std::vector<std::int32_t> in_hand_, beyond_;  // N
  std::vector<Mat3<S>> rotations_;              // N
};

}  // namespace rigless::detail
