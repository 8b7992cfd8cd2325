// Where the head of a body is.
#pragma once

#include "rigless/mesh/detail/body_tips.h"

namespace rigless::detail {

// N: not 0 for nodes of a tail, which is slender, in the middle, and leaves the trunk behind. Allocates.
template <class S>
RIGLESS_COLD std::vector<char> find_tails(const StandingBody<S>& body, const std::vector<Tip<S>>& tips) {
  std::vector<char> tails(body.places.size(), 0);
  for (const Tip<S>& tip : tips) {
    if (tip.partner >= 0 || std::abs(body.place(tip.node).x()) > S(2) * body.middle) continue;
    const Limb<S> limb = body.limb(tip.node);
    const Vec3<S> base = body.stand(limb.base);
    const bool behind = base.z() < body.low.z() + S(0.4) * (body.high.z() - body.low.z()) && base.z() < S(-0.1);
    if (!behind || std::abs(base.x()) > S(0.1) || limb.length < S(1.8) * limb.girth) continue;
    for (const auto& on : vertices_within<S>(body.graph.position, body.graph.ring, tip.node, limb.reach))
      nth(tails, on.vertex) = 1;
  }
  return tails;
}

template <class S>
class HeadFinder {
 public:
  // Keeps what it is given; tails: of find_tails(); named: as the body stands.
  HeadFinder(const StandingBody<S>& body, const std::vector<char>& tails, const std::vector<Landmark<S>>& named)
      : body_(body), tails_(tails), named_(named) {}

  // A node: high, in front and in the middle; not a crest, a horn or the tip of a hat, which are thin, and not a tail
  // that is held high. The longer a body that has no legs, the more its front is its head. Allocates.
  RIGLESS_COLD std::int32_t find(bool swims) const {
    std::vector<S> against = named_elsewhere();
    std::int32_t head = -1;
    if (named_.empty())
      for (std::size_t i = 0; i < against.size(); ++i) against[i] += tails_[i] != 0 ? S(20) : S(0);
    const Vec3<S> size = body_.high - body_.low;
    const S before = swims ? std::clamp(S(2) * size.z() / size.y() - S(2), S(0.4), S(1.6)) : S(0.4);
    for (int tries = 0; tries < 6; ++tries) {
      head = body_.best_middle([&](const Vec3<S>& p) {
        return p.y() + before * p.z() - S(0.5) * std::abs(p.x()) - against[body_.index(p)];
      });
      const S thick = body_.thickness(head);
      if (thick >= S(0.055) * body_.tall) break;
      for (const auto& reached : vertices_within<S>(body_.graph.position, body_.graph.ring, head, S(2) * thick))
        nth(against, reached.vertex) += S(20);
    }
    return head;
  }

 private:
  // What speaks against nodes that are nearer to another named place than to the head, or far from it, as what a hand
  // holds up is; nothing where no head is named.
  std::vector<S> named_elsewhere() const {
    std::vector<S> against(body_.places.size(), S(0));
    const auto is_head = [](const Landmark<S>& one) { return one.role == BodyRole::head; };
    if (std::none_of(named_.begin(), named_.end(), is_head)) return against;
    bool any = false;
    for (std::size_t i = 0; i < body_.places.size(); ++i) {
      const auto off = [&](const Landmark<S>& one) { return (one.position - body_.places[i]).squaredNorm(); };
      const auto nearest =
          std::min_element(named_.begin(), named_.end(), [&](const auto& a, const auto& b) { return off(a) < off(b); });
      against[i] = is_head(*nearest) ? S(0.6) * std::max(std::sqrt(off(*nearest)) - S(0.3), S(0)) : S(40);
      any = any || is_head(*nearest);
    }
    if (!any) against.assign(body_.places.size(), S(0));
    return against;
  }

  const StandingBody<S>& body_;
  const std::vector<char>& tails_;
  const std::vector<Landmark<S>>& named_;
};

}  // namespace rigless::detail
