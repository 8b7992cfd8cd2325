// A trunk does not spin: what slabs of it hold turns with the way from one to the other, and about that way not at all.
#pragma once

#include <vector>

#include "rigless/deform/deformer.h"
#include "rigless/math/detail/rotation.h"

namespace rigless::detail {

template <class S>
class Trunk {
 public:
  // C controls and where they rest. Allocates.
  void bind(Span<const Control<S>> controls, Span<const Vec3<S>> rest) {
    slabs_.clear();
    for (std::size_t c = 0; c < controls.size(); ++c)
      if (controls[c].slab) slabs_.push_back(static_cast<std::int32_t>(c));
    along_ = slabs_.size() > 1 ? Vec3<S>(way(rest).normalized()) : Vec3<S>(Vec3<S>::UnitY());
  }

  // Before the deformer goes to C finite targets. A trunk of one slab stays as it rests. No allocation.
  void turn(Deformer<S>& deformer, Span<const Vec3<S>> targets) const {
    Mat3<S> R = Mat3<S>::Identity();
    if (slabs_.size() > 1) R = shortest_arc<S>(along_, way(targets).normalized());
    for (const std::int32_t c : slabs_) deformer.turn(c, R);
  }

 private:
  Vec3<S> way(Span<const Vec3<S>> controls) const {
    return nth(controls, slabs_.back()) - nth(controls, slabs_.front());
  }

  std::vector<std::int32_t> slabs_;  // controls
  Vec3<S> along_ = Vec3<S>::UnitY();
};

}  // namespace rigless::detail
