// Which tips of a body are its legs: fins, flukes and the ends of wings may touch the ground as well.
#pragma once

#include "rigless/mesh/detail/body_tips.h"

namespace rigless::detail {

template <class S>
class LegFinder {
 public:
  // Keeps both; tips that are found to be a pair become partners.
  LegFinder(const StandingBody<S>& body, std::vector<Tip<S>>& tips) : body_(body), tips_(tips) {}

  // Indices of tips on the ground by pairs, else of limbs in mid stride; none where a body lies on its belly.
  // Allocates.
  RIGLESS_COLD std::vector<std::size_t> find() {
    std::vector<std::size_t> feet;
    for (std::size_t t = 0; t < tips_.size(); ++t)
      if (stands(t) && stands(partner(t))) feet.push_back(t);
    if (body_.lies() && feet.size() <= 4)
      feet.erase(std::remove_if(feet.begin(), feet.end(), [&](std::size_t t) { return !is_leg(t); }), feet.end());
    if (!feet.empty() && !(body_.lies() && feet.size() < 4)) return feet;
    std::vector<std::size_t> posed = four_on_the_ground();
    if (posed.empty()) posed = four_that_hang();
    if (posed.empty()) posed = two_in_mid_stride();
    if (posed.empty()) return feet;
    for (std::size_t k = 0; k < posed.size(); k += 2) pair_up(tips_, posed[k], posed[k + 1]);
    return posed;
  }

 private:
  const Vec3<S>& at(std::size_t t) const { return body_.place(tips_[t].node); }
  bool stands(std::size_t t) const { return !tips_[t].used && tips_[t].partner >= 0 && at(t).y() < S(0.12); }
  std::size_t partner(std::size_t t) const { return to_size(tips_[t].partner); }
  Limb<S> limb(std::size_t t) const { return body_.limb(tips_[t].node); }

  // Of a body that lies: what rises to the trunk more than it goes aside, or is a claw's toe below it.
  bool is_leg(std::size_t t) const { return rises(t) || rises(partner(t)); }
  bool rises(std::size_t t) const {
    const Limb<S> own = limb(t);
    const Vec3<S> base = body_.stand(own.base);
    const S rise = base.y() - at(t).y(), aside = std::abs(at(t).x()) - std::abs(base.x());
    const S length = body_.high.z() - body_.low.z(), behind = at(t).z() - body_.low.z();
    if (behind < S(0.06) * length && rise < S(0.25)) return false;  // a fluke
    return (rise > S(0.03) && aside < S(0.7) * rise) || (own.length > S(2) * own.girth && aside < S(0.05));
  }

  bool on_the_ground(std::size_t t) const { return !tips_[t].used && at(t).y() < S(0.15); }
  bool hangs(std::size_t t, S slenderness) const {
    const Limb<S> own = limb(t);
    const S rise = body_.posture.up.dot(own.base - nth(body_.graph.position, tips_[t].node));
    return own.length > slenderness * own.girth && rise > S(0.45) * own.length;
  }

  // By pairs from behind to before, if they are as many as wanted.
  std::vector<std::size_t> in_order(std::vector<std::size_t> feet, std::size_t wanted) const {
    if (feet.size() != wanted) return {};
    std::sort(feet.begin(), feet.end(), [&](std::size_t a, std::size_t b) { return at(a).z() < at(b).z(); });
    return feet;
  }

  // Of a body that walks on four legs, which are no mirror images: one of each pair is on each side.
  std::vector<std::size_t> four_on_the_ground() const {
    std::vector<std::size_t> feet;
    for (std::size_t t = 0; t < tips_.size(); ++t)
      if (body_.lies() && on_the_ground(t)) feet.push_back(t);
    feet = in_order(feet, 4);
    if (std::count_if(feet.begin(), feet.end(), [&](std::size_t t) { return rises(t); }) < 3) return {};  // fins
    for (std::size_t k = 0; k < feet.size(); k += 2)
      if (body_.side(tips_[feet[k]].node) * body_.side(tips_[feet[k + 1]].node) >= 0) return {};
    return feet;
  }

  // Of a body that gallops or looks round.
  std::vector<std::size_t> four_that_hang() const {
    std::vector<std::size_t> feet;
    for (std::size_t t = 0; t < tips_.size(); ++t)
      if (at(t).y() < S(0.3) && hangs(t, S(1.3))) feet.push_back(t);
    return in_order(feet, 4);
  }

  // Of a body that strides on two legs.
  std::vector<std::size_t> two_in_mid_stride() const {
    std::vector<std::size_t> feet;
    for (std::size_t t = 0; t < tips_.size(); ++t)
      if (!body_.symmetric() && !body_.lies() && on_the_ground(t) && hangs(t, S(1.2))) feet.push_back(t);
    return in_order(feet, 2);
  }

  const StandingBody<S>& body_;
  std::vector<Tip<S>>& tips_;
};

}  // namespace rigless::detail
