// Hands stay out of the head and the trunk: a short arm that is to point up passes beside a large head, not through it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "rigless/retarget/detail/rests_on_ground.h"
#include "rigless/scene/detail/limb_turns.h"

namespace rigless::detail {

template <class S>
class Clearance {
 public:
  // C controls, the limb at whose tip each lies and where they rest; floor: y of the lowest vertex at rest; height: of
  // the mesh. Allocates.
  RIGLESS_COLD void bind(const Solid<S>& solid, Span<const Control<S>> controls, Span<const Limb<S>> limbs,
                         const LimbTurns<S>& turns, Span<const Vec3<S>> rest, S floor, S height) {
    find_head(controls, turns, rest);
    std::vector<char> on_limb = turns.on_limb(S(0));
    std::vector<std::int32_t> hands;
    for (std::int32_t c = 0; c < count_of(rest) && chest_ >= 0; ++c) {
      const Limb<S>& limb = nth(limbs, c);
      if (c == head_ || !(limb.length > S(0)) || rests_on_ground(nth(rest, c), floor, height)) continue;
      hands.push_back(c);
      if (turns.has(c)) continue;
      const std::int32_t tip = nth(solid.element, nth(solid.element_of, controls[to_size(c)].vertex))[0];
      for (const auto& near : vertices_within<S>(solid.rest, solid.ring, tip, limb.length))
        nth(on_limb, near.vertex) = 1;
    }
    find_outline(solid, on_limb);
    hands_.clear();
    for (const std::int32_t c : hands) {
      const Limb<S>& limb = nth(limbs, c);
      const S gap = std::min(solid.cell, -depth(nth(rest, c), S(0)));
      hands_.push_back({c, limb.base, axis_ - level(limb.base - axis_) / S(2), limb.length, gap});
    }
    cleared_.assign(rest.begin(), rest.end());
  }

  // C finite targets, those of hands where nothing of the body is, for a trunk that is there; no hand is led farther
  // away than its arm is long. No allocation.
  RIGLESS_COLD Span<const Vec3<S>> clear(const TrunkMotion<S>& trunk, Span<const Vec3<S>> targets) {
    std::copy(targets.begin(), targets.end(), cleared_.begin());
    const Mat3<S> back = trunk.R.transpose();
    const auto at_rest = [&](std::int32_t c) -> Vec3<S> { return trunk.from + back * (nth(targets, c) - trunk.to); };
    const Vec3<S> nod = head_ >= 0 ? Vec3<S>(at_rest(head_) - head_rest_) : Vec3<S>(Vec3<S>::Zero());
    for (const Hand& hand : hands_) {
      const Vec3<S> asked = at_rest(hand.control);
      const S rise = head_ >= 0 ? smooth_step((asked.y() - neck_) / (head_rest_.y() - neck_)) : S(0);
      const Vec3<S> from = asked - rise * nod, to = led_out(hand, from);
      nth(cleared_, hand.control) += trunk.R * (to - from);
    }
    return cleared_;
  }

 private:
  static constexpr int rows = 32, columns = 16;  // of heights, of directions about the axis

  struct Hand {
    std::int32_t control;
    Vec3<S> base, inside;  // of its limb; what it is led away from
    S reach, gap;          // how far from the base; how far from the outline
  };

  // The highest slab, and the highest of what is no limb above it.
  RIGLESS_COLD void find_head(Span<const Control<S>> controls, const LimbTurns<S>& turns, Span<const Vec3<S>> rest) {
    head_ = chest_ = -1;
    const auto take_higher = [&](std::int32_t c, std::int32_t& highest) {
      if (highest < 0 || nth(rest, c).y() > nth(rest, highest).y()) highest = c;
    };
    for (std::int32_t c = 0; c < count_of(rest); ++c)
      if (controls[to_size(c)].slab || !turns.has(c)) take_higher(c, controls[to_size(c)].slab ? chest_ : head_);
    if (head_ >= 0 && chest_ >= 0 && nth(rest, head_).y() - nth(rest, chest_).y() > S(0)) {
      head_rest_ = nth(rest, head_);
      neck_ = nth(rest, chest_).y();
    } else {
      head_ = -1;
    }
  }

  static Vec3<S> level(const Vec3<S>& way) { return {way.x(), S(0), way.z()}; }

  // From 0 to `columns` once around; no angle, which machines tell differently.
  RIGLESS_COLD static S direction(const Vec3<S>& way) {
    const S sum = std::abs(way.x()) + std::abs(way.z());
    if (!(sum > S(0))) return S(0);
    const S quarter = way.z() / sum;  // 0, 1, 0, -1
    const S turns = way.x() < S(0) ? S(2) - quarter : (quarter < S(0) ? S(4) + quarter : quarter);
    return turns * S(columns / 4);
  }

  S outline(int row, int column) const { return outline_[to_size(row * columns + (column % columns))]; }

  // N: not 0 for nodes from which no place two cells deep is within four edges, as far as the edge of a box.
  // Allocates.
  RIGLESS_COLD static std::vector<char> find_thin(const Solid<S>& solid) {
    const auto any_near = [&](std::int32_t i, const auto& is) {
      const auto first = solid.ring.neighbor.begin();
      return std::any_of(first + solid.ring.first[to_size(i)], first + solid.ring.first[to_size(i) + 1], is);
    };
    const auto is_surface = [&](std::int32_t i) {
      return solid.ring.first[to_size(i) + 1] - solid.ring.first[to_size(i)] < 6;
    };
    std::vector<char> thin(solid.rest.size(), 1);
    for (std::int32_t i = 0; i < solid.nodes(); ++i)
      if (!is_surface(i) && !any_near(i, is_surface)) nth(thin, i) = 0;
    for (int step = 0; step < 4; ++step) {
      const std::vector<char> before = thin;
      for (std::int32_t i = 0; i < solid.nodes(); ++i)
        if (any_near(i, [&](std::int32_t j) { return nth(before, j) == 0; })) nth(thin, i) = 0;
    }
    return thin;
  }

  // How far the body reaches from its axis, by height and direction, without its limbs, what is in its hands and what
  // is as thin as a cape or the brim of a hat.
  RIGLESS_COLD void find_outline(const Solid<S>& solid, Span<const char> on_limb) {
    Vec3<S> sum = Vec3<S>::Zero();
    S low = std::numeric_limits<S>::max(), high = std::numeric_limits<S>::lowest(), count = 0;
    for (std::size_t i = 0; i < solid.rest.size(); ++i) {
      low = std::min(low, solid.rest[i].y());
      high = std::max(high, solid.rest[i].y());
      if (on_limb[i] != 0) continue;
      sum += solid.rest[i];
      count += S(1);
    }
    axis_ = sum / std::max(count, S(1));
    const S half = solid.cell / S(2);
    low_ = low - half;
    row_ = std::max((high - low + solid.cell) / S(rows), S(1e-6));
    const std::vector<char> thin = find_thin(solid);
    std::array<std::uint64_t, to_size(rows * columns)> reached{};  // in which cells away from the axis nodes are
    std::array<int, to_size(rows * columns)> last;                 // of these before a gap
    outline_.fill(S(0));
    for (const bool second : {false, true}) {
      for (std::size_t i = 0; i < solid.rest.size(); ++i) {
        if (on_limb[i] != 0 || thin[i] != 0) continue;
        const Vec3<S> away = level(solid.rest[i] - axis_);
        // Cubes reach beyond the surface, which a hand may graze at a hip, but never in the face.
        const bool is_face = head_ >= 0 && solid.rest[i].y() > neck_;
        const S far = std::max(is_face ? away.norm() + half : away.norm(), half);
        const S width = S(columns / 4) * half / std::max(away.norm(), half);
        const S at = direction(away), y = solid.rest[i].y() - low_;
        const int cell = std::min(static_cast<int>(far / solid.cell), 63);
        const int first = static_cast<int>((y - half) / row_), top = static_cast<int>((y + half) / row_);
        for (int row = std::max(first, 0); row <= std::min(top, rows - 1); ++row) {
          for (int k = static_cast<int>(std::floor(at - width)); k <= static_cast<int>(at + width); ++k) {
            const std::size_t one = to_size(row * columns + (k + columns) % columns);
            if (!second) reached[one] |= std::uint64_t{1} << cell;
            if (second && cell <= last[one]) outline_[one] = std::max(outline_[one], far);
          }
        }
      }
      for (std::size_t one = 0; one < reached.size() && !second; ++one) {
        last[one] = static_cast<int>(S(0.25) * (high - low) / solid.cell) - 3;
        for (int cell = 0; cell < 64; ++cell)
          if ((reached[one] >> cell & 1) != 0 && cell <= last[one] + 3) last[one] = std::max(last[one], cell);
      }
    }
  }

  // How deep a place lies in the outline that is `gap` wider; below 0 outside.
  RIGLESS_COLD S depth(const Vec3<S>& p, S gap) const {
    const S y = (p.y() - low_) / row_ - S(0.5);
    if (y < S(-1) || y > S(rows)) return -level(p - axis_).norm();
    const Vec3<S> away = level(p - axis_);
    const S at = direction(away) + S(columns) - S(0.5);
    const int row = static_cast<int>(std::floor(y)), column = static_cast<int>(at);
    const S up = y - static_cast<S>(row), on = at - static_cast<S>(column);
    const auto across = [&](int r) {
      return r < 0 || r >= rows ? S(0) : (S(1) - on) * outline(r, column) + on * outline(r, column + 1);
    };
    const S far = (S(1) - up) * across(row) + up * across(row + 1);
    return far > S(0) ? far + gap - away.norm() : -away.norm();
  }

  // Level away from the body, and down where the arm is too short for that.
  RIGLESS_COLD Vec3<S> led_out(const Hand& hand, const Vec3<S>& asked) const {
    Vec3<S> p = asked;
    const S reach = std::max(hand.reach, (asked - hand.base).norm());
    for (int k = 0; k < 16; ++k) {
      const S in = depth(p, hand.gap);
      if (!(in > S(0))) break;
      const Vec3<S> away = level(p - hand.inside), side = level(hand.base - hand.inside);
      const Vec3<S> way = away.norm() > S(1e-3) * reach ? away : side;
      p += in * way / std::max(way.norm(), S(1e-6));
      const S far = (p - hand.base).norm();
      if (far > reach) p = hand.base + (p - hand.base) * (reach / far);
    }
    return p;
  }

  std::array<S, to_size(rows* columns)> outline_{};
  Vec3<S> axis_ = Vec3<S>::Zero();
  S low_ = 0, row_ = 1;
  std::vector<Hand> hands_;
  std::int32_t head_ = -1, chest_ = -1;
  Vec3<S> head_rest_ = Vec3<S>::Zero();
  S neck_ = 0;
  std::vector<Vec3<S>> cleared_;  // C
};

}  // namespace rigless::detail
