// A mesh that can be held by its controls: the rest surface, what is known of it, and what is solved in its stead.
#pragma once

#include <limits>

#include "rigless/deform/detail/solid_pieces.h"
#include "rigless/mesh/detail/measure.h"
#include "rigless/mesh/detail/node_maps.h"
#include "rigless/mesh/inspect.h"
#include "rigless/mesh/solid.h"
#include "rigless/retarget/detail/rests_on_ground.h"
#include "rigless/scene/detail/clearance.h"
#include "rigless/scene/detail/drag.h"
#include "rigless/scene/detail/limb_turns.h"
#include "rigless/scene/detail/soles.h"
#include "rigless/scene/detail/trunk.h"
#include "rigless/scene/detail/twist.h"

namespace rigless {

// What is solved: the mesh's own surface, as in the paper, or a solid inside it that carries the mesh along, whatever
// it is made of.
enum class Solve : std::int32_t { surface, solid };

template <class S>
struct BodyOptions {
  Span<const S> rigidity = {};  // of a surface: V as in DeformerOptions, or empty; a solid's weights have it already
  bool paper = false;           // as in the paper: cells scale freely, and discs stay turned as they rest
};

template <class S>
class Body {
 public:
  // V rest positions and F faces; forgets controls. Allocates. Errors: those of Deformer::bind() and build_solid(). On
  // failure the old mesh and its controls stay.
  Status set_mesh(Span<const Vec3<S>> rest, Span<const Face> faces, Solve solve = Solve::surface) {
    Solid<S> solid;
    if (solve == Solve::surface) return set_mesh(rest, faces, std::move(solid));
    if (const Status status = build_solid(rest, faces, {}, solid); !status.ok()) return status;
    return set_mesh(rest, faces, std::move(solid));
  }

  // The same with a solid that was built from this mesh; an empty one: the surface is solved.
  Status set_mesh(Span<const Vec3<S>> rest, Span<const Face> faces, Solid<S> solid,
                  const BodyOptions<S>& options = {}) {
    DeformerOptions<S> cells;
    if (options.paper) cells.elastic = 0;
    cells.rigidity = options.rigidity;
    const Status status = solid.rest.empty() ? bind_surface(rest, faces, cells) : bind_solid(rest, solid, cells);
    if (!status.ok()) return status;
    paper_ = options.paper;
    solid_ = std::move(solid);
    rest_.assign(rest.begin(), rest.end());
    faces_.assign(faces.begin(), faces.end());
    controls_.clear();
    limbs_.clear();
    topology_ = inspect_mesh(faces, count_of(rest));
    volume_ = is_solid() ? rigless::volume<S>(solid_, solid_.rest) : detail::signed_volume(rest, faces);
    return {};
  }

  // C controls. Allocates. Errors: those of Deformer::set_controls(). On failure the old controls stay.
  Status set_controls(Span<const Control<S>> controls) {
    if (const Status status = is_solid() ? hold_solid(controls) : deformer_.set_controls(controls); !status.ok())
      return status;
    controls_ = at_rest(controls);
    drag_.bind(deformer_);
    return {};
  }

  // Moves the mesh, see positions(), towards C targets from where the last drag left it, or from rest. turns: C
  // rotation vectors by which controls turn beyond what surrounds them, or none. No allocation. Errors: size_mismatch;
  // not_finite (where: control).
  Status drag(Span<const Vec3<S>> targets, S volume, bool restart, Span<const Vec3<S>> turns = {}) {
    if (targets.empty() || targets.size() != controls_.size()) return {Error::size_mismatch, -1};
    for (std::size_t c = 0; c < targets.size(); ++c) {
      if (!targets[c].allFinite()) return {Error::not_finite, c};
    }
    const Span<const Mat3<S>> turned = begin_towards(targets);
    drag_.move(deformer_, targets, volume, restart, turned);
    detail::twist_controls<S>(deformer_, turns, volume);
    take_shape();
    return {};
  }

  // The mesh for these C finite targets and turns; depends on nothing but them. No allocation.
  void act(Span<const Vec3<S>> targets, S volume, Span<const Vec3<S>> turns = {}) {
    const Span<const Mat3<S>> turned = begin_towards(targets);
    detail::deform_from_rest(deformer_, targets, volume, turned);
    detail::twist_controls<S>(deformer_, turns, volume);
    take_shape();
  }

  // C: the limb of the solid at whose tip each control lies; none where the surface is solved.
  Span<const detail::Limb<S>> limbs() const { return limbs_; }
  // As ModelLimb has it: the shortest stump swings half way.
  double swing(const detail::Limb<S>& limb) const {
    return std::clamp(0.5 + 0.25 * (static_cast<double>(detail::slenderness(limb, solid_.cell)) - 0.5), 0.5, 1.0);
  }

  // V, as the last drag() or act() left them; a solid carries them when they are asked for. No allocation.
  Span<const Vec3<S>> positions() {
    if (!is_solid()) return deformer_.positions();
    if (!carried_is_new_) carry_points<S>(solid_, rest_, transforms_, carried_);
    carried_is_new_ = true;
    return carried_;
  }

  // N: by which maps a solid carries the vertices, then turned and moved, as the last drag() or act() left it; none
  // where the surface is solved. No allocation.
  Span<const detail::NodeMap<S>> maps(const Mat3<S>& turn = Mat3<S>::Identity(),
                                      const Vec3<S>& move = Vec3<S>::Zero()) {
    detail::node_maps<S>(solid_, transforms_, turn, move, maps_);
    return maps_;
  }

  // y of the lowest vertex that is not of a thing in a hand, as the last drag() or act() left them. No allocation.
  S lowest() const {
    S lowest = std::numeric_limits<S>::max();
    if (is_solid()) {
      for (const std::int32_t v : supports_)
        lowest = std::min(
            lowest, detail::carried_point(solid_, nth(solid_.element_of, v), nth(rest_, v), transforms_.data()).y());
      return lowest;
    }
    for (const Vec3<S>& p : deformer_.positions()) lowest = std::min(lowest, p.y());
    return lowest;
  }

  // Volume now over that at rest; NaN where an open surface has none. No allocation.
  S volume_ratio() const {
    if (is_solid()) return rigless::volume<S>(solid_, deformer_.positions()) / volume_;
    if (!closed()) return std::numeric_limits<S>::quiet_NaN();
    return detail::signed_volume<S>(deformer_.positions(), faces_) / volume_;
  }

  // Cubic units; NaN where an open surface has none.
  S volume() const { return is_solid() || closed() ? std::abs(volume_) : std::numeric_limits<S>::quiet_NaN(); }

  const Solid<S>& solid() const { return solid_; }  // empty when the surface is solved
  const MeshTopology& topology() const { return topology_; }
  Span<const Vec3<S>> rest() const { return rest_; }
  Span<const Vec3<S>> rest_controls() const { return controls_; }  // C
  std::int32_t vertices() const { return count_of(rest_); }
  std::int32_t controls() const { return count_of(controls_); }
  Deformer<S>& deformer() { return deformer_; }
  const Deformer<S>& deformer() const { return deformer_; }

 private:
  bool is_solid() const { return !solid_.rest.empty(); }
  bool closed() const { return topology_.closed() && volume_ != S(0); }

  Status bind_surface(Span<const Vec3<S>> rest, Span<const Face> faces, const DeformerOptions<S>& options) {
    if (const Status status = deformer_.bind(rest, faces, options); !status.ok()) return status;
    carried_ = {};
    transforms_ = {};
    maps_ = {};
    return {};
  }

  RIGLESS_COLD Status bind_solid(Span<const Vec3<S>> rest, const Solid<S>& solid, DeformerOptions<S> options) {
    options.rigidity = {};
    if (const Status status = deformer_.bind_graph(solid.rest, solid.ring, solid.weight, options); !status.ok())
      return status;
    supports_ = outermost_ = outermost_vertices(solid, rest);
    carried_.assign(rest.begin(), rest.end());
    transforms_.resize(solid.rest.size());
    maps_.resize(solid.rest.size());
    return {};
  }

  RIGLESS_COLD Status hold_solid(Span<const Control<S>> controls) {
    if (const Status status = detail::check_controls(solid_, controls); !status.ok()) return status;
    const std::vector<Vec3<S>> rest = at_rest(controls);
    const detail::Bounds<S> box = detail::bounds<S>(rest_);
    std::vector<detail::Limb<S>> limbs = detail::find_limbs<S>(solid_, controls, rest, box.height());
    detail::LimbTurns<S> turns;
    turns.bind(solid_, controls, rest, limbs, box.low.y(), box.height());
    Discs<S> pieces = detail::make_solid_pieces<S>(solid_, rest_, controls, turns.on_limb(S(0.5)), turns.in_hand());
    if (const Status status = deformer_.set_discs(std::move(pieces)); !status.ok()) return status;
    soles_.bind(limbs, turns, rest, box.low.y(), box.height());
    clearance_.bind(solid_, controls, limbs, turns, rest, box.low.y(), box.height());
    find_supports(turns.beyond_hand(), rest, box);
    limbs_ = std::move(limbs);
    turns_ = std::move(turns);
    trunk_.bind(controls, rest);
    return {};
  }

  // A body stands on its feet, not on the sword in its hand.
  RIGLESS_COLD void find_supports(Span<const std::int32_t> beyond_hand, Span<const Vec3<S>> rest,
                                  const detail::Bounds<S>& box) {
    supports_.clear();
    for (const std::int32_t v : outermost_) {
      const std::int32_t c = nth(beyond_hand, nth(solid_.element, nth(solid_.element_of, v))[0]);
      if (c < 0 || detail::rests_on_ground(nth(rest, c), box.low.y(), box.height())) supports_.push_back(v);
    }
  }

  RIGLESS_COLD std::vector<Vec3<S>> at_rest(Span<const Control<S>> controls) const {
    std::vector<Vec3<S>> rest;
    for (const Control<S>& c : controls) rest.push_back(nth(rest_, c.vertex));
    return rest;
  }

  // How nodes begin to turn, none where the surface is solved; leads hands of the targets around the body.
  Span<const Mat3<S>> begin_towards(Span<const Vec3<S>>& targets) {
    for (std::int32_t c = 0; paper_ && c < controls(); ++c) deformer_.turn(c, Mat3<S>::Identity());
    if (!is_solid()) return {};
    const detail::TrunkMotion<S> trunk = trunk_.turn(deformer_, targets);
    targets = clearance_.clear(trunk, targets);
    const Span<const Mat3<S>> turned = turns_.turn(trunk, targets);
    soles_.lay(deformer_, targets, turns_);
    return turned;
  }

  void take_shape() {
    if (is_solid()) node_transforms<S>(solid_, deformer_.positions(), transforms_);
    carried_is_new_ = false;
  }

  std::vector<Vec3<S>> rest_;           // V
  std::vector<Face> faces_;             // F
  std::vector<Vec3<S>> controls_;       // C, at rest
  std::vector<detail::Limb<S>> limbs_;  // C
  MeshTopology topology_;
  S volume_ = 0;
  Deformer<S> deformer_;
  detail::Drag<S> drag_;
  detail::Trunk<S> trunk_;
  detail::LimbTurns<S> turns_;
  detail::Soles<S> soles_;
  detail::Clearance<S> clearance_;
  Solid<S> solid_;
  std::vector<NodeTransform<S>> transforms_;  // N
  std::vector<detail::NodeMap<S>> maps_;      // N
  std::vector<std::int32_t> outermost_;       // vertices of a solid's mesh, of which one is lowest
  std::vector<std::int32_t> supports_;        // those that may stand on the ground
  std::vector<Vec3<S>> carried_;              // V
  bool carried_is_new_ = false;
  bool paper_ = false;
};

}  // namespace rigless
