// The surface under the hand, and the surface of a single pose: what a deformer is asked for outside a performance.
#pragma once

#include "rigless/deform/deformer.h"

namespace rigless::detail {

// Shape iterations of a frame that begins with nothing but its targets. The scaled shape state gives up volume while it
// converges (cells may shrink at a price), so this number is part of what a frame looks like: on a walking cow the
// volume stays within 0.99 to 1.01 of rest after 5, falls to 0.96 after 10 and to 0.85 after 60. One number, for baked
// frames and for restarts.
inline constexpr int iterations_from_rest = 8;

// Shape iterations of a drag, which begins at the surface of the drag before it. Source: thesis, section 4.1.
inline constexpr int iterations_per_drag = 2;

// The surface for these C targets; depends on nothing but them. lambda_v is `volume`; rotations: see Deformer::start().
// No allocation.
template <class S>
void deform_from_rest(Deformer<S>& deformer, Span<const Vec3<S>> targets, S volume, Span<const Mat3<S>> rotations) {
  deformer.set_targets(targets);
  deformer.start(rotations);
  deformer.relax(iterations_from_rest);
  deformer.pose(volume);
}

// A row of drags. Keeps the shape between them, with its rotations, so that others may use the deformer meanwhile: a
// drag depends on its targets and the drags since the last start from rest, only.
template <class S>
class Drag {
 public:
  // Begins at rest. Call again after the deformer was bound or got other controls. Allocates.
  void bind(const Deformer<S>& deformer) {
    deformer.keep(shape_);
    at_rest_ = true;
  }

  // Towards C targets from where the last drag left the surface, or from rest; see deformer.positions(). No allocation.
  void move(Deformer<S>& deformer, Span<const Vec3<S>> targets, S volume, bool restart,
            Span<const Mat3<S>> rotations = {}) {
    if (restart || at_rest_) {
      deform_from_rest(deformer, targets, volume, rotations);
    } else {
      deformer.resume(shape_);
      deformer.set_targets(targets);
      deformer.step(iterations_per_drag);
      deformer.pose(volume);
    }
    deformer.keep(shape_);
    at_rest_ = false;
  }

 private:
  ShapeState<S> shape_;
  bool at_rest_ = true;
};

}  // namespace rigless::detail
