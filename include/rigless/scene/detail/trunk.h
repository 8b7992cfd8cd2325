// A trunk does not spin: what slabs of it hold turns with the way from one to the other, and about that way not at all.
#pragma once

#include <vector>

#include "rigless/deform/deformer.h"
#include "rigless/math/detail/rotation.h"

namespace rigless::detail {

// Where a trunk goes from rest: p to `to` + R (p - from).
template <class S>
struct TrunkMotion {
  Mat3<S> R = Mat3<S>::Identity();
  Vec3<S> from = Vec3<S>::Zero(), to = Vec3<S>::Zero();

  Vec3<S> carry(const Vec3<S>& p) const { return to + R * (p - from); }
};

template <class S>
class Trunk {
 public:
  // C controls and where they rest. Allocates.
  RIGLESS_COLD void bind(Span<const Control<S>> controls, Span<const Vec3<S>> rest) {
    slabs_.clear();
    for (std::size_t c = 0; c < controls.size(); ++c)
      if (controls[c].slab) slabs_.push_back(static_cast<std::int32_t>(c));
    along_ = slabs_.size() > 1 ? Vec3<S>(way(rest).normalized()) : Vec3<S>(Vec3<S>::UnitY());
    middle_ = middle(rest);
  }

  // Before the deformer goes to C finite targets. A trunk of one slab stays as it rests; one of none is where its
  // controls are. No allocation.
  TrunkMotion<S> turn(Deformer<S>& deformer, Span<const Vec3<S>> targets) const {
    TrunkMotion<S> motion;
    if (slabs_.size() > 1) motion.R = shortest_arc<S>(along_, way(targets).normalized());
    motion.from = middle_;
    motion.to = middle(targets);
    for (const std::int32_t c : slabs_) deformer.turn(c, motion.R);
    return motion;
  }

 private:
  Vec3<S> way(Span<const Vec3<S>> controls) const {
    return nth(controls, slabs_.back()) - nth(controls, slabs_.front());
  }

  // Of the slabs, else of all controls.
  RIGLESS_COLD Vec3<S> middle(Span<const Vec3<S>> controls) const {
    Vec3<S> sum = Vec3<S>::Zero();
    for (const std::int32_t c : slabs_) sum += nth(controls, c);
    if (!slabs_.empty()) return sum / static_cast<S>(slabs_.size());
    for (const Vec3<S>& p : controls) sum += p;
    return sum / static_cast<S>(controls.size());
  }

  std::vector<std::int32_t> slabs_;  // controls
  Vec3<S> along_ = Vec3<S>::UnitY();
  Vec3<S> middle_ = Vec3<S>::Zero();  // at rest
};

}  // namespace rigless::detail
