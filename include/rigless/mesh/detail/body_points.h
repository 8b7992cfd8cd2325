// Where a stranger's model should be held: its head, hands, feet and trunk, told apart by where they are.
#pragma once

#include "rigless/mesh/detail/body_arms.h"
#include "rigless/mesh/detail/body_head.h"
#include "rigless/mesh/detail/body_legs.h"

namespace rigless::detail {

// Points of a body, at most 32; the wanted ones come first.
template <class S>
class BodyReader {
 public:
  // Keeps what it is given. average: of average_geodesic(). Allocates.
  BodyReader(const SurfaceGraph<S>& graph, Span<const S> average, const Posture<S>& posture,
             const SymmetryPlane<S>& plane, Span<const Landmark<S>> landmarks)
      : average_(average), body_(graph, posture, plane), named_(landmarks.begin(), landmarks.end()) {
    for (Landmark<S>& one : named_) one.position = body_.stand(one.position);
  }

  // Allocates.
  std::vector<BodyPoint<S>> read() {
    if (body_.graph.size() == 0) return {};
    tips_ = find_tips<S>(body_, average_);
    center_ = static_cast<std::int32_t>(std::min_element(average_.begin(), average_.end()) - average_.begin());
    for (const Landmark<S>& hand : named_)
      if (hand.role == BodyRole::hand) add(take(hand), BodyRole::hand, true, hand.side);
    if (is_named(BodyRole::foot)) {
      add_named_feet();
    } else {
      add_feet();
    }
    tails_ = find_tails(body_, tips_);
    head_ = HeadFinder<S>(body_, tails_, named_).find(swims_);
    if (!is_named(BodyRole::foot) && !is_named(BodyRole::hand)) add_hands();
    add(head_, BodyRole::head, true, 0);
    if (swims_) add_tail();
    add_trunk();
    add_bends();
    add_rest();
    match_partners();
    for (BodyPoint<S>& p : points_) p.vertex = nth(body_.graph.vertex, p.vertex);
    return points_;
  }

 private:
  const Landmark<S>* named(BodyRole role) const {
    const auto found = std::find_if(named_.begin(), named_.end(), [=](const auto& one) { return one.role == role; });
    return found == named_.end() ? nullptr : &*found;
  }
  bool is_named(BodyRole role) const { return named(role) != nullptr; }
  bool is_near(BodyRole role, const Vec3<S>& p, S within) const {
    return std::any_of(named_.begin(), named_.end(),
                       [&](const Landmark<S>& one) { return one.role == role && (p - one.position).norm() < within; });
  }

  // Of two that belong together one is on each side, however near they are to the middle; those of a body in mid stride
  // may cross it, but begin well apart.
  std::int32_t side_of(const Tip<S>& tip) const {
    const std::int32_t other = nth(tips_, tip.partner).node;
    S apart = body_.place(tip.node).x() - body_.place(other).x();
    if (!body_.symmetric()) {
      const auto base = [&](std::int32_t node) { return body_.stand(body_.limb(node).base).x(); };
      const S bases = base(tip.node) - base(other);
      if (std::abs(bases) > S(0.1)) apart = bases;
    }
    return apart > S(0) ? 1 : -1;
  }

  // The tip that a landmark means, or where there is none what is nearest to it; nothing that another limb means.
  std::int32_t take(const Landmark<S>& landmark) {
    const auto off = [&](const Vec3<S>& p, const Landmark<S>& from) { return (p - from.position).norm(); };
    const auto is_its = [&](const Vec3<S>& p) {
      return std::none_of(named_.begin(), named_.end(), [&](const Landmark<S>& other) {
        return is_limb(other) && &other != &landmark && off(p, other) < off(p, landmark);
      });
    };
    if (landmark.role == BodyRole::hand && std::abs(landmark.position.x()) < S(0.15)) {
      if (Tip<S>* end = end_of(landmark)) {
        end->used = true;
        return end->node;
      }
    }
    Tip<S>* tip = nullptr;
    S nearest = S(0.1);
    for (Tip<S>& t : tips_) {
      if (t.used || !(off(body_.place(t.node), landmark) < nearest) || !is_its(body_.place(t.node))) continue;
      nearest = off(body_.place(t.node), landmark);
      tip = &t;
    }
    if (tip == nullptr)
      return body_.best_node([&](const Vec3<S>& p) { return -off(p, landmark) - (is_its(p) ? S(0) : S(20)); });
    for (Tip<S>& t : tips_)
      if (off(body_.place(t.node), landmark) < S(0.12) && is_its(body_.place(t.node))) t.used = true;
    return tip->node;
  }

  // Of a wing that is one joint long: the most prominent tip, far away and no foot, of a limb that begins there.
  Tip<S>* end_of(const Landmark<S>& base) {
    for (Tip<S>& t : tips_) {
      if (is_near(BodyRole::foot, body_.place(t.node), S(0.12))) continue;
      const Limb<S> limb = body_.limb(t.node);
      const bool begins =
          (body_.stand(limb.base) - base.position).norm() < S(0.15) && limb.length > S(1.5) * limb.girth;
      const bool far = (body_.place(t.node) - base.position).norm() > S(0.3);
      if (!t.used && begins && far && body_.place(t.node).x() * static_cast<S>(base.side) > S(0)) return &t;
    }
    return nullptr;
  }

  static bool is_limb(const Landmark<S>& one) { return one.role == BodyRole::hand || one.role == BodyRole::foot; }

  bool is_free(std::int32_t node, S from = S(0.05)) const {
    return std::none_of(points_.begin(), points_.end(),
                        [&](const BodyPoint<S>& p) { return body_.apart(p.vertex, node) < from; });
  }

  // A head keeps its shape as a whole, faces being what one looks at.
  void add(std::int32_t node, BodyRole role, bool wanted, std::int32_t side) {
    if (node < 0) return;
    if (!is_free(node, wanted ? S(0.05) : S(0.14))) return;
    const bool head = role == BodyRole::head;
    const S radius = head ? std::clamp(S(2) * body_.thickness(node), S(0.08) * body_.tall, S(0.2) * body_.tall)
                          : std::clamp(body_.thickness(node), S(0.04) * body_.tall, S(0.1) * body_.tall);
    points_.push_back({node, role, side, -1, radius, wanted});
  }

  // Legs by pairs; those before the middle are forelegs. A body without any stands on the edges of its base, unless it
  // lies on its belly.
  void add_feet() {
    const std::vector<std::size_t> feet = LegFinder<S>(body_, tips_).find();
    S middle = 0;
    for (const std::size_t t : feet) middle += body_.place(tips_[t].node).z();
    legs_ = feet.size();
    for (const std::size_t t : feet) {
      const bool fore = legs_ >= 4 && body_.place(tips_[t].node).z() > middle / static_cast<S>(legs_);
      tips_[t].used = true;
      add(tips_[t].node, fore ? BodyRole::foreleg : BodyRole::foot, true, side_of(tips_[t]));
    }
    if (legs_ == 2) add_near_forelegs(middle / S(2));
    swims_ = legs_ == 0 && (body_.lies() || is_named(BodyRole::tail));
    if (legs_ > 0 || swims_) return;
    const auto is_base = [&](const Vec3<S>& p) { return !(p.y() > S(0.06)) && !is_near(BodyRole::hand, p, S(0.3)); };
    if (std::none_of(body_.places.begin(), body_.places.end(), is_base)) return;  // it hangs in the air by its hands
    for (const S sign : {S(1), S(-1)})
      add(body_.best_node(
              [&](const Vec3<S>& p) { return sign * p.x() - S(0.2) * std::abs(p.z()) - (is_base(p) ? S(0) : S(10)); }),
          BodyRole::foot, true, sign > S(0) ? 1 : -1);
  }

  // Forelegs side by side end in one tip, far before the hind legs.
  void add_near_forelegs(S hind) {
    for (Tip<S>& tip : tips_) {
      const Vec3<S> end = body_.place(tip.node);
      if (tip.used || tip.partner >= 0 || std::abs(end.x()) > S(2) * body_.middle) continue;
      if (end.y() > S(0.12) || end.z() < hind + S(0.35)) continue;
      tip.used = true;
      legs_ = 4;
      for (const S sign : {S(1), S(-1)})
        add(body_.best_node(
                [&](const Vec3<S>& p) { return sign * p.x() - p.y() - ((p - end).norm() > S(0.12) ? S(10) : S(0)); }),
            BodyRole::foreleg, true, sign > S(0) ? 1 : -1);
      return;
    }
  }

  void add_named_feet() {
    S middle = 0;
    for (const Landmark<S>& one : named_) {
      if (one.role != BodyRole::foot) continue;
      middle += one.position.z();
      ++legs_;
    }
    for (const Landmark<S>& one : named_) {
      if (one.role != BodyRole::foot) continue;
      const bool fore = legs_ >= 4 && one.position.z() > middle / static_cast<S>(legs_);
      add(take(one), fore ? BodyRole::foreleg : BodyRole::foot, true, one.side);
    }
  }

  void add_hands() {
    if (legs_ >= 4 && legs_ < 6) return;
    ArmFinder<S> arms(body_, tips_, head_, center_);
    const std::int32_t hand = swims_ ? arms.find_fins() : legs_ >= 6 ? arms.find_claws() : arms.find();
    if (hand < 0) return;
    const std::int32_t one = nth(tips_, hand).node, other = nth(tips_, nth(tips_, hand).partner).node;
    if (!is_free(one) || !is_free(other) || body_.apart(one, other) < S(0.05)) return;
    for (const std::int32_t t : {hand, nth(tips_, hand).partner}) {
      nth(tips_, t).used = true;
      add(nth(tips_, t).node, BodyRole::hand, true, side_of(nth(tips_, t)));
    }
  }

  // The end of a body that swims or crawls; of one that is coiled what is named so, and the tip there.
  void add_tail() {
    const Landmark<S>* last = nullptr;
    const auto off = [&](const Vec3<S>& p) { return (p - body_.place(head_)).norm(); };
    for (const Landmark<S>& one : named_)
      if (one.role == BodyRole::tail && (last == nullptr || off(one.position) > off(last->position))) last = &one;
    std::int32_t end = body_.lies() || last == nullptr ? section(2, S(0.08)) : beside(*last);
    for (Tip<S>& t : tips_) {
      if (body_.lies() || t.partner >= 0 || body_.apart(t.node, end) > S(0.2)) continue;
      t.used = true;
      end = t.node;
      break;
    }
    add(end, BodyRole::tail, true, 0);
  }

  // What is nearest to the middle of a cross section, `share` of the way along an axis of the body.
  std::int32_t section(int axis, S share) const {
    const S length = body_.high[axis] - body_.low[axis], at = body_.low[axis] + share * length;
    Landmark<S> inner;
    S count = 0;
    for (S slack = S(0.04); !(count > S(0)) && slack < S(1); slack *= S(2)) {
      for (std::size_t i = 0; i < body_.places.size(); ++i) {
        if (std::abs(body_.places[i][axis] - at) > slack * length) continue;
        inner.position += body_.graph.area[i] * body_.places[i];
        count += body_.graph.area[i];
      }
    }
    if (!(count > S(0))) return -1;
    inner.position /= count;
    return beside(inner);
  }

  // On two legs the belly and the chest above it; on four the rump and the withers. They are offered only: what the
  // limbs and the head do to a trunk looks better than what a human's trunk does to a stranger's.
  void add_trunk() {
    if (legs_ >= 4) {
      add(back_over(BodyRole::foot), BodyRole::hips, true, 0);
      add(back_over(BodyRole::foreleg), BodyRole::chest, true, 0);
      return;
    }
    if (swims_) {
      const int along = body_.lies() ? 2 : 1;
      add(section(along, S(0.36)), BodyRole::hips, true, 0);
      add(section(along, S(0.68)), BodyRole::chest, true, 0);
      return;
    }
    // The middle of all is above the belly, since arms and head count.
    const S belly = S(0.72) * body_.place(center_).y();
    const Landmark<S>*hips = named(BodyRole::hips), *chest = named(BodyRole::chest);
    add(hips != nullptr ? beside(*hips) : front_at(belly), BodyRole::hips, true, 0);
    add(chest != nullptr ? beside(*chest) : front_at((belly + body_.place(head_).y()) / S(2)), BodyRole::chest, true,
        0);
  }

  // On the surface around a place within the trunk, before it or behind it.
  std::int32_t beside(const Landmark<S>& inner) const {
    return body_.best_node([&](const Vec3<S>& p) {
      const Vec3<S> off = p - inner.position;
      return -off.norm() - (std::abs(off.x()) > body_.middle ? S(10) : S(0));
    });
  }

  std::int32_t front_at(S height) const {
    return body_.best_middle([=](const Vec3<S>& p) { return p.z() - S(3) * std::abs(p.y() - height); });
  }

  // Over the feet, or where many legs that spread leave the trunk; not on a tail that is held over it.
  std::int32_t back_over(BodyRole legs) const {
    S z = 0, count = 0;
    for (const BodyPoint<S>& p : points_) {
      if (p.role != legs) continue;
      const Vec3<S> base = body_.stand(body_.limb(p.vertex).base);
      z += legs_ > 4 ? base.z() : body_.place(p.vertex).z();
      count += S(1);
    }
    if (!(count > S(0))) return -1;
    return body_.best_middle([&](const Vec3<S>& p) {
      return p.y() - S(3) * std::abs(p.z() - z / count) - (tails_[body_.index(p)] != 0 ? S(5) : S(0));
    });
  }

  // Elbows and knees of limbs that are long for how thick they are, on both sides; a stump looks better in one piece.
  // They are offered only: a limb that follows its end alone bends like rubber, which is what one comes for.
  void add_bends() {
    const std::size_t ends = points_.size();
    for (const BodyRole role : {BodyRole::hand, BodyRole::foot}) {
      std::vector<std::pair<std::int32_t, std::int32_t>> bends;  // node, side
      for (std::size_t n = 0; n < ends; ++n) {
        const BodyPoint<S>& end = points_[n];
        if (end.role != role || legs_ > 2) continue;
        const Limb<S> limb = body_.limb(end.vertex);
        if (limb.length > limb.girth && limb.length > S(0.2) * body_.tall)
          bends.push_back({body_.nearest_node(limb.middle), end.side});
      }
      if (bends.size() != 2) continue;
      for (const auto& [node, side] : bends)
        add(node, role == BodyRole::hand ? BodyRole::elbow : BodyRole::knee, false, side);
    }
  }

  void add_rest() {
    for (const Tip<S>& t : tips_) {
      if (t.used) continue;
      const bool tail = body_.side(t.node) == 0 && body_.place(t.node).z() < body_.place(center_).z() - S(0.15);
      add(t.node, tail ? BodyRole::tail : BodyRole::tip, false, body_.side(t.node));
    }
  }

  void match_partners() {
    for (std::size_t a = 0; a < points_.size() && body_.symmetric(); ++a) {
      if (points_[a].side == 0) points_[a].partner = static_cast<std::int32_t>(a);
      if (points_[a].partner >= 0) continue;
      S nearest = S(0.2);
      std::size_t match = points_.size();
      for (std::size_t b = a + 1; b < points_.size(); ++b) {
        const S off = (body_.flipped(points_[a].vertex) - body_.place(points_[b].vertex)).norm();
        if (points_[b].partner >= 0 || points_[a].side + points_[b].side != 0 || points_[a].role != points_[b].role ||
            off >= nearest)
          continue;
        nearest = off;
        match = b;
      }
      if (match == points_.size()) continue;
      points_[a].partner = static_cast<std::int32_t>(match);
      points_[match].partner = static_cast<std::int32_t>(a);
    }
  }

  Span<const S> average_;
  StandingBody<S> body_;
  std::vector<Landmark<S>> named_;  // as the body stands
  std::vector<Tip<S>> tips_;
  std::vector<char> tails_;           // of each node: whether it is on one
  std::vector<BodyPoint<S>> points_;  // `vertex` is a node until read() ends
  std::size_t legs_ = 0;
  bool swims_ = false;  // or crawls: it has no legs, and its back is level
  std::int32_t center_ = 0, head_ = 0;
};

}  // namespace rigless::detail
