// Where a stranger's model should be held: its head, hands, feet and trunk, told apart by where they are.
#pragma once

#include "rigless/mesh/detail/body_tips.h"
#include "rigless/mesh/detail/limb.h"

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
    head_ = find_head();
    for (const Landmark<S>& hand : named_)
      if (hand.role == BodyRole::hand) add(take(hand), BodyRole::hand, true, hand.side);
    if (is_named(BodyRole::foot)) {
      add_named_feet();
    } else {
      add_feet();
      if (!is_named(BodyRole::hand)) add_hands();
    }
    add(head_, BodyRole::head, true, 0);
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

  // Of two that belong together one is on each side, however near they are to the middle.
  std::int32_t side_of(const Tip<S>& tip) const {
    return body_.place(tip.node).x() > body_.place(nth(tips_, tip.partner).node).x() ? 1 : -1;
  }

  // The tip that a landmark means, or where there is none what is nearest to it; nothing that another limb means.
  std::int32_t take(const Landmark<S>& landmark) {
    const auto off = [&](const Vec3<S>& p, const Landmark<S>& from) { return (p - from.position).norm(); };
    const auto is_its = [&](const Vec3<S>& p) {
      return std::none_of(named_.begin(), named_.end(), [&](const Landmark<S>& other) {
        return is_limb(other) && &other != &landmark && off(p, other) < off(p, landmark);
      });
    };
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

  static bool is_limb(const Landmark<S>& one) { return one.role == BodyRole::hand || one.role == BodyRole::foot; }

  // Nodes that are nearer to another named place than to the head; none where no head is named or nothing is left.
  std::vector<char> beside_head() const {
    std::vector<char> beside(body_.places.size(), 0);
    if (!is_named(BodyRole::head)) return beside;
    for (std::size_t i = 0; i < body_.places.size(); ++i) {
      const auto off = [&](const Landmark<S>& one) { return (one.position - body_.places[i]).squaredNorm(); };
      const auto nearest =
          std::min_element(named_.begin(), named_.end(), [&](const auto& a, const auto& b) { return off(a) < off(b); });
      beside[i] = nearest->role == BodyRole::head ? 0 : 1;
    }
    if (std::find(beside.begin(), beside.end(), 0) == beside.end()) beside.assign(body_.places.size(), 0);
    return beside;
  }

  // High, in front and in the middle; not a crest, a horn or the tip of a hat, which are thin.
  std::int32_t find_head() const {
    const std::vector<char> beside = beside_head();
    std::vector<char> thin(body_.places.size(), 0);
    std::int32_t head = center_;
    for (int tries = 0; tries < 6; ++tries) {
      head = body_.best_middle([&](const Vec3<S>& p) {
        return p.y() + S(0.4) * p.z() - S(0.5) * std::abs(p.x()) - (thin[body_.index(p)] != 0 ? S(20) : S(0)) -
               (beside[body_.index(p)] != 0 ? S(40) : S(0));
      });
      const S thick = body_.thickness(head);
      if (thick >= S(0.055) * body_.tall) break;
      for (const auto& reached : vertices_within<S>(body_.graph.position, body_.graph.ring, head, S(2) * thick))
        nth(thin, reached.vertex) = 1;
    }
    return head;
  }

  // A head keeps its shape as a whole, faces being what one looks at.
  void add(std::int32_t node, BodyRole role, bool wanted, std::int32_t side) {
    if (node < 0) return;
    for (const BodyPoint<S>& p : points_)
      if (body_.apart(p.vertex, node) < (wanted ? S(0.05) : S(0.14))) return;
    const bool head = role == BodyRole::head;
    const S radius = head ? std::clamp(S(2) * body_.thickness(node), S(0.08) * body_.tall, S(0.2) * body_.tall)
                          : std::clamp(body_.thickness(node), S(0.04) * body_.tall, S(0.1) * body_.tall);
    points_.push_back({node, role, side, -1, radius, wanted});
  }

  // Tips on the ground, by pairs; those before the middle are forelegs. A body without any stands on the edges of its
  // base.
  void add_feet() {
    std::vector<std::size_t> feet;
    S middle = 0;
    for (std::size_t t = 0; t < tips_.size(); ++t) {
      if (tips_[t].used || body_.place(tips_[t].node).y() > S(0.12) || tips_[t].partner < 0) continue;
      if (body_.place(nth(tips_, tips_[t].partner).node).y() > S(0.12)) continue;
      feet.push_back(t);
    }
    if (feet.empty()) feet = four_feet();
    for (const std::size_t t : feet) middle += body_.place(tips_[t].node).z();
    legs_ = feet.size();
    for (const std::size_t t : feet) {
      const bool fore = legs_ >= 4 && body_.place(tips_[t].node).z() > middle / static_cast<S>(legs_);
      tips_[t].used = true;
      add(tips_[t].node, fore ? BodyRole::foreleg : BodyRole::foot, true, side_of(tips_[t]));
    }
    if (legs_ > 0) return;
    for (const S sign : {S(1), S(-1)})
      add(body_.best_node([&](const Vec3<S>& p) {
        return sign * p.x() - S(0.2) * std::abs(p.z()) - (p.y() > S(0.06) ? S(10) : S(0));
      }),
          BodyRole::foot, true, sign > S(0) ? 1 : -1);
  }

  // Of a body that gallops or looks round, whose legs are no mirror images: the ends of four slender limbs that hang.
  std::vector<std::size_t> four_feet() {
    std::vector<std::size_t> feet;
    for (std::size_t t = 0; t < tips_.size(); ++t) {
      const Limb<S> limb = find_limb(body_.graph, tips_[t].node, S(0.7) * body_.tall);
      const S rise = body_.posture.up.dot(limb.base - nth(body_.graph.position, tips_[t].node));
      if (body_.place(tips_[t].node).y() < S(0.3) && limb.length > S(1.3) * limb.girth && rise > S(0.45) * limb.length)
        feet.push_back(t);
    }
    if (feet.size() != 4) return {};
    const auto at = [&](std::size_t t) -> const Vec3<S>& { return body_.place(tips_[t].node); };
    std::sort(feet.begin(), feet.end(), [&](std::size_t a, std::size_t b) { return at(a).z() < at(b).z(); });
    for (std::size_t k = 0; k < 4; ++k) tips_[feet[k]].partner = static_cast<std::int32_t>(feet[k ^ 1]);
    return feet;
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

  // The most prominent pair that is no ears and no horns: slender, else well nearer to the middle than to the head.
  void add_hands() {
    const std::vector<S> from_head = node_distances(body_.graph, head_),
                         from_center = node_distances(body_.graph, center_);
    const auto is_arm = [&](const Tip<S>& t, bool slender) {
      const auto node = to_size(t.node);
      if (t.used || from_head[node] < (slender ? S(0.75) : S(0.9)) * from_center[node]) return false;
      if (!slender) return true;
      const Limb<S> limb = find_limb(body_.graph, t.node, S(0.7) * body_.tall);
      return limb.length > S(0.3) * body_.tall && limb.length > S(2) * limb.girth;
    };
    for (const bool slender : {true, false}) {
      for (std::size_t t = 0; t < tips_.size() && legs_ < 4; ++t) {
        if (tips_[t].partner < 0) continue;
        Tip<S>& other = nth(tips_, tips_[t].partner);
        if (!is_arm(tips_[t], slender) || !is_arm(other, slender)) continue;
        for (Tip<S>* hand : {&tips_[t], &other}) {
          hand->used = true;
          add(hand->node, BodyRole::hand, true, side_of(*hand));
        }
        return;
      }
    }
  }

  // On two legs the belly and the chest above it; on four the rump and the withers. They are offered only: what the
  // limbs and the head do to a trunk looks better than what a human's trunk does to a stranger's.
  void add_trunk() {
    if (legs_ >= 4) {
      add(back_over(BodyRole::foot), BodyRole::hips, true, 0);
      add(back_over(BodyRole::foreleg), BodyRole::chest, true, 0);
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

  std::int32_t back_over(BodyRole legs) const {
    S z = 0, count = 0;
    for (const BodyPoint<S>& p : points_) {
      if (p.role != legs) continue;
      z += body_.place(p.vertex).z();
      count += S(1);
    }
    if (!(count > S(0))) return -1;
    return body_.best_middle([=](const Vec3<S>& p) { return p.y() - S(3) * std::abs(p.z() - z / count); });
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
        const Limb<S> limb = find_limb(body_.graph, end.vertex, S(0.7) * body_.tall);
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
  std::vector<BodyPoint<S>> points_;  // `vertex` is a node until read() ends
  std::size_t legs_ = 0;
  std::int32_t center_ = 0, head_ = 0;
};

}  // namespace rigless::detail
