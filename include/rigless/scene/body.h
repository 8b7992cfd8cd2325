// A mesh that can be held by its controls: the rest surface, what is known of it, and its deformer.
#pragma once

#include <limits>

#include "rigless/mesh/detail/measure.h"
#include "rigless/mesh/inspect.h"
#include "rigless/scene/detail/drag.h"

namespace rigless {

template <class S>
class Body {
 public:
  // V rest positions and F faces; forgets controls. Allocates. Errors: those of Deformer::bind(). On failure the old
  // mesh and its controls stay.
  Status set_mesh(Span<const Vec3<S>> rest, Span<const Face> faces) {
    if (const Status status = deformer_.bind(rest, faces); !status.ok()) return status;
    rest_.assign(rest.begin(), rest.end());
    faces_.assign(faces.begin(), faces.end());
    controls_.clear();
    topology_ = inspect_mesh(faces, count_of(rest));
    volume_ = detail::signed_volume(rest, faces);
    return {};
  }

  // C controls. Allocates. Errors: those of Deformer::set_controls(). On failure the old controls stay.
  Status set_controls(Span<const Control<S>> controls) {
    if (const Status status = deformer_.set_controls(controls); !status.ok()) return status;
    controls_.clear();
    for (const Control<S>& c : controls) controls_.push_back(nth(rest_, c.vertex));
    drag_.bind(deformer_);
    return {};
  }

  // Moves the surface, see deformer().positions(), towards C targets from where the last drag left it, or from rest. No
  // allocation. Errors: size_mismatch; not_finite (where: control).
  Status drag(Span<const Vec3<S>> targets, S volume, bool restart) {
    if (targets.empty() || targets.size() != controls_.size()) return {Error::size_mismatch, -1};
    for (std::size_t c = 0; c < targets.size(); ++c) {
      if (!targets[c].allFinite()) return {Error::not_finite, c};
    }
    drag_.move(deformer_, targets, volume, restart);
    return {};
  }

  // Volume of a deformed surface (V) over that of the rest mesh; NaN where an open mesh has none. No allocation.
  S volume_ratio(Span<const Vec3<S>> surface) const {
    if (!closed()) return std::numeric_limits<S>::quiet_NaN();
    return detail::signed_volume<S>(surface, faces_) / volume_;
  }

  bool closed() const { return topology_.closed() && volume_ != S(0); }
  S volume() const { return closed() ? std::abs(volume_) : std::numeric_limits<S>::quiet_NaN(); }
  const MeshTopology& topology() const { return topology_; }
  Span<const Vec3<S>> rest() const { return rest_; }
  Span<const Vec3<S>> rest_controls() const { return controls_; }  // C
  Deformer<S>& deformer() { return deformer_; }
  const Deformer<S>& deformer() const { return deformer_; }

 private:
  std::vector<Vec3<S>> rest_;      // V
  std::vector<Face> faces_;        // F
  std::vector<Vec3<S>> controls_;  // C, at rest
  MeshTopology topology_;
  S volume_ = 0;
  Deformer<S> deformer_;
  detail::Drag<S> drag_;
};

}  // namespace rigless
