// Which tips of a body are its legs: fins, flukes and the ends of wings may touch the ground as well.
#pragma once

#include "rigless/mesh/detail/body_tips.h"
#include "rigless/mesh/detail/limb.h"

namespace rigless::detail {

template <class S>
class LegFinder {
 public:
  // Keeps both; tips that are found to be a pair become partners.
  LegFinder(const StandingBody<S>& body, std::vector<Tip<S>>& tips) : body_(body), tips_(tips) {}

  // Indices of tips on the ground by pairs, else of four limbs that hang; none where a body lies on its belly.
  // Allocates.
  RIGLESS_COLD std::vector<std::size_t> find() {
    std::vector<std::size_t> feet;
    for (std::size_t t = 0; t < tips_.size(); ++t)
      if (stands(t) && stands(partner(t))) feet.push_back(t);
    if (body_.lies() && feet.size() <= 4)
      feet.erase(std::remove_if(feet.begin(), feet.end(), [&](std::size_t t) { return !is_leg(t); }), feet.end());
    return feet.empty() ? four_that_hang() : feet;
  }

 private:
  const Vec3<S>& at(std::size_t t) const { return body_.place(tips_[t].node); }
  bool stands(std::size_t t) const { return !tips_[t].used && tips_[t].partner >= 0 && at(t).y() < S(0.12); }
  std::size_t partner(std::size_t t) const { return to_size(tips_[t].partner); }
  Limb<S> limb(std::size_t t) const { return find_limb(body_.graph, tips_[t].node, S(0.7) * body_.tall); }

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

  // Of a body that gallops or looks round, whose legs are no mirror images.
  std::vector<std::size_t> four_that_hang() {
    std::vector<std::size_t> feet;
    for (std::size_t t = 0; t < tips_.size(); ++t) {
      const Limb<S> own = limb(t);
      const S rise = body_.posture.up.dot(own.base - nth(body_.graph.position, tips_[t].node));
      if (at(t).y() < S(0.3) && own.length > S(1.3) * own.girth && rise > S(0.45) * own.length) feet.push_back(t);
    }
    if (feet.size() != 4) return {};
    std::sort(feet.begin(), feet.end(), [&](std::size_t a, std::size_t b) { return at(a).z() < at(b).z(); });
    for (std::size_t k = 0; k < 4; ++k) tips_[feet[k]].partner = static_cast<std::int32_t>(feet[k ^ 1]);
    return feet;
  }

  const StandingBody<S>& body_;
  std::vector<Tip<S>>& tips_;
};

}  // namespace rigless::detail
