// Feet on the ground lie flat, whatever their legs do: without it a knee that bends lifts the heel, and a body dances
// on the tips of its toes.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "rigless/deform/deformer.h"
#include "rigless/math/detail/smooth_step.h"
#include "rigless/scene/detail/limb_turns.h"

namespace rigless::detail {

template <class S>
class Soles {
 public:
  // C controls, the limb at whose tip each lies and where they rest; floor: y of the lowest vertex at rest; height: of
  // the mesh. Allocates.
  RIGLESS_COLD void bind(Span<const Limb<S>> limbs, const LimbTurns<S>& turns, Span<const Vec3<S>> rest, S floor,
                         S height) {
    feet_.clear();
    lifted_ = S(0.08) * height;
    for (std::int32_t c = 0; c < count_of(rest); ++c)
      if (turns.has(c) && is_leg(nth(limbs, c), nth(rest, c), floor, height)) feet_.push_back({c, nth(rest, c).y()});
  }

  // Before the deformer goes to C finite targets, for legs that are turned so: the lowest foot is on the ground, and
  // what is lifted turns with its leg the more the higher it is. No allocation.
  void lay(Deformer<S>& deformer, Span<const Vec3<S>> targets, const LimbTurns<S>& turns) const {
    S ground = std::numeric_limits<S>::max();
    for (const Foot& foot : feet_) ground = std::min(ground, nth(targets, foot.control).y() - foot.rest);
    for (const Foot& foot : feet_) {
      const S lift = (nth(targets, foot.control).y() - foot.rest - ground) / lifted_;
      deformer.turn(foot.control, turns.at_tip(foot.control, smooth_step(lift)));
    }
  }

 private:
  struct Foot {
    std::int32_t control;
    S rest;  // y
  };

  std::vector<Foot> feet_;
  S lifted_ = 1;  // so much above the ground a foot turns with its leg alone
};

}  // namespace rigless::detail
