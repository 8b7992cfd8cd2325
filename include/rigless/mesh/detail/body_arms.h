// Which tips of a body are its hands: those of arms, wings, claws and fins.
#pragma once

#include "rigless/mesh/detail/body_tips.h"
#include "rigless/mesh/detail/geodesic.h"

namespace rigless::detail {

template <class S>
class ArmFinder {
 public:
  // Keeps what it is given; head, center: nodes. Tips that are found to be a pair become partners. Allocates.
  ArmFinder(const StandingBody<S>& body, std::vector<Tip<S>>& tips, std::int32_t head, std::int32_t center)
      : body_(body),
        tips_(tips),
        head_(head),
        from_head_(node_distances(body.graph, head)),
        from_center_(node_distances(body.graph, center)) {}

  // The most prominent pair that is no ears and no horns: slender, else well nearer to the middle than to the head, and
  // most of all so; but wings that are spread reach farther than all. A tip of the pair, or -1. Allocates.
  RIGLESS_COLD std::int32_t find() {
    const std::int32_t arm = find_arm();
    const std::int32_t wing = widest([&](std::size_t t) { return apart(t) > S(0.9) && at(t).y() > S(0.12); });
    if (arm < 0 || wing < 0) return arm;
    return reach(to_size(wing)) > std::max(S(1.5) * reach(to_size(arm)), S(0.45)) ? wing : arm;
  }

  // Of what swims: fins are where it is widest, before its tail.
  RIGLESS_COLD std::int32_t find_fins() const {
    const S length = body_.high.z() - body_.low.z();
    return widest([&](std::size_t t) {
      return at(t).z() > body_.low.z() + S(0.2) * length && body_.apart(tips_[t].node, head_) > S(0.4);
    });
  }

  // Of what has many legs: a pair that reaches out before the head.
  RIGLESS_COLD std::int32_t find_claws() const {
    std::int32_t best = -1;
    for (std::size_t t = 0; t < tips_.size(); ++t) {
      if (!free(t) || !(at(t).z() > body_.place(head_).z() + S(0.2))) continue;
      if (best < 0 || at(t).z() > at(to_size(best)).z()) best = static_cast<std::int32_t>(t);
    }
    return best;
  }

 private:
  const Vec3<S>& at(std::size_t t) const { return body_.place(tips_[t].node); }
  std::size_t partner(std::size_t t) const { return to_size(tips_[t].partner); }
  bool free(std::size_t t) const { return !tips_[t].used && tips_[t].partner >= 0 && !tips_[partner(t)].used; }
  S reach(std::size_t t) const { return std::min(std::abs(at(t).x()), std::abs(at(partner(t)).x())); }

  // How many times as far from the head as from the middle; of a pair the less.
  S ratio(std::size_t t) const {
    return nth(from_head_, tips_[t].node) / std::max(nth(from_center_, tips_[t].node), S(1e-6));
  }
  S apart(std::size_t t) const { return std::min(ratio(t), ratio(partner(t))); }

  std::int32_t find_arm() {
    for (std::size_t t = 0; t < tips_.size(); ++t)
      if (free(t) && slender(t) && slender(partner(t))) return static_cast<std::int32_t>(t);
    std::int32_t best = find_swinging();
    if (best >= 0) return best;
    for (std::size_t t = 0; t < tips_.size(); ++t)
      if (free(t) && apart(t) > S(0.9) && (best < 0 || apart(t) > S(1.3) * apart(to_size(best))))
        best = static_cast<std::int32_t>(t);
    return best;
  }

  // Of a body that is caught in mid stride, whose arms are no mirror images: they begin at one height, one on each
  // side.
  std::int32_t find_swinging() {
    if (body_.symmetric() || body_.lies()) return -1;
    std::vector<std::pair<std::size_t, Vec3<S>>> arms;  // tip, base
    for (std::size_t t = 0; t < tips_.size(); ++t) {
      if (tips_[t].used || at(t).y() < S(0.2) || ratio(t) < S(0.75)) continue;
      const Limb<S> limb = body_.limb(tips_[t].node);
      if (limb.length > S(1.1) * limb.girth) arms.push_back({t, body_.stand(limb.base)});
    }
    for (std::size_t a = 0; a < arms.size(); ++a) {
      for (std::size_t b = a + 1; b < arms.size(); ++b) {
        const Vec3<S>&p = arms[a].second, &q = arms[b].second;
        if (std::abs(p.y() - q.y()) > S(0.1) || !(std::abs(p.x() - q.x()) > S(0.1))) continue;
        pair_up(tips_, arms[a].first, arms[b].first);
        return static_cast<std::int32_t>(arms[a].first);
      }
    }
    return -1;
  }

  bool slender(std::size_t t) const {
    if (apart(t) < S(0.75)) return false;
    const Limb<S> limb = body_.limb(tips_[t].node);
    return limb.length > S(0.3) * body_.tall && limb.length > S(2) * limb.girth;
  }

  template <class May>
  std::int32_t widest(const May& may) const {
    std::int32_t best = -1;
    for (std::size_t t = 0; t < tips_.size(); ++t)
      if (free(t) && may(t) && (best < 0 || reach(t) > reach(to_size(best)))) best = static_cast<std::int32_t>(t);
    return best;
  }

  const StandingBody<S>& body_;
  std::vector<Tip<S>>& tips_;
  std::int32_t head_;
  std::vector<S> from_head_, from_center_;
};

}  // namespace rigless::detail
