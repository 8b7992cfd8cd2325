// Cartoon deformation of a surface by a few control points: bind a mesh, set controls, then targets and steps per
// frame.
#pragma once

#include "rigless/deform/detail/build_cells.h"
#include "rigless/deform/detail/control.h"
#include "rigless/deform/detail/iterate.h"
#include "rigless/deform/detail/volume_law.h"
#include "rigless/math/detail/bytes.h"

namespace rigless {

// Cotangent weights, clamped; ties between shells get weight 1, about the mean of a well-shaped mesh.
struct CotangentWeights {
  template <class S>
  static std::vector<S> of(Span<const Vec3<S>> vertices, Span<const Face> faces, const OneRing& ring) {
    return detail::cotangent_weights<S>(vertices, faces, ring);
  }
};

struct UniformWeights {
  template <class S>
  static std::vector<S> of(Span<const Vec3<S>>, Span<const Face>, const OneRing& ring) {
    return detail::uniform_weights<S>(ring);
  }
};

template <class S>
struct DeformerOptions {
  S elastic = S(0.5);           // mu of ElasticScale
  Span<const S> rigidity = {};  // V, or empty for 1 everywhere: an edge is as stiff as the softer of its ends. 10 keeps
                                // the shape of a head or of armour; 1000 makes its seam ugly.
};

// What an iteration goes on from: a surface and the rotations that were last fitted to it.
template <class S>
struct ShapeState {
  std::vector<detail::simd::Quad<S>> x;              // V + 1, in elimination order
  std::vector<detail::QuaternionLanes<S>> rotation;  // of cells
  std::vector<Mat3<S>> disc_rotation;                // C
};

// Two states, after Fig 3.4 of the thesis. step() iterates the scaled shape state; pose() derives the surface that is
// shown from it, and never feeds back. A frame depends on its targets and on the shape surface it starts from, only.
template <class S, class Weights = CotangentWeights>
class Deformer {
 public:
  // Binds V rest vertices and F faces; forgets controls. Allocates. Broken meshes are accepted: shells are tied to what
  // is nearest, isolated vertices too. On failure the old binding stays.
  // Errors: no_faces; index_out_of_range (face); not_finite (vertex, also for a rigidity that is not above 0);
  // size_mismatch (rigidity).
  RIGLESS_COLD Status bind(Span<const Vec3<S>> rest, Span<const Face> faces, const DeformerOptions<S>& options = {});

  // Binds a graph of V nodes as a surface is bound: neighbours, and a weight above 0 for each directed edge, the same
  // both ways. Allocates. On failure the old binding stays. Errors: not_finite (node, also for a rigidity that is not
  // above 0); size_mismatch (weights, rigidity).
  RIGLESS_COLD Status bind_graph(Span<const Vec3<S>> rest, const OneRing& ring, Span<const S> weight,
                                 const DeformerOptions<S>& options = {});

  // Chooses C controls; targets start at rest, the shape too. Allocates. On failure the old controls stay.
  // Errors: no_controls; index_out_of_range (control); factorization_failed.
  RIGLESS_COLD Status set_controls(Span<const Control<S>> controls);

  // The same with controls that hold these vertices, at least one each. Errors: factorization_failed.
  RIGLESS_COLD Status set_discs(Discs<S> discs);

  // C target positions of the controls. One that is not finite is not taken: its control stays where it was told to be
  // before. No allocation.
  void set_targets(Span<const Vec3<S>> targets);

  // Gives control c an orientation of its own, from rest; free_turn() lets it turn with its surroundings again, as all
  // do at first. Nothing to see on a control of one vertex. No allocation.
  void turn(std::int32_t c, const Mat3<S>& rotation);
  void free_turn(std::int32_t c);

  // Shape state and disc rotations back to rest. No allocation.
  void reset();

  // Starts from nothing but the targets: rest, moved rigidly to fit them best (turned as the first control is that has
  // an orientation of its own), then bent by one solve until every control is met. Frames that start here depend on
  // their targets alone. rotations: V, how each vertex's surroundings are thought to be turned from rest, which the
  // solve then bends towards; or empty. No allocation.
  void start(Span<const Mat3<S>> rotations = {});

  // Starts the next step() from this surface (V) with unturned discs. No allocation.
  void set_shape(Span<const Vec3<S>> surface);

  // Keeps the present shape, and goes on from one that was kept under the same controls, as if nothing had happened
  // since; shape() follows with the next step(). keep() allocates the first time, resume() never.
  void keep(ShapeState<S>& state) const;
  void resume(const ShapeState<S>& state);

  // Local-global iterations of the scaled shape state. Each lowers energy() or keeps it. No allocation.
  // Source: thesis Eq 3.2-3.7, hard rows as in Eq 2.8.
  void step(int iterations);

  // The same with momentum: as near the minimum in a third to a half of the iterations. The energy never rises from one
  // accepted iterate to the next: where the momentum overshoots, the iterate is taken back and the momentum dropped.
  // Starts without momentum. No allocation.
  // Source: Nesterov 1983; restart after O'Donoghue and Candes 2015.
  void relax(int iterations);

  // Pose state from the present shape. `volume` is lambda_v: 0 rotations only, 1 natural, 3 exaggerated. No allocation.
  void pose(S volume) { pose(PowerLaw<S>{volume}); }
  template <class Law, std::enable_if_t<std::is_class_v<Law>, int> = 0>
  void pose(const Law& law);

  Span<const Vec3<S>> shape() const { return shape_; }
  Span<const Vec3<S>> positions() const { return positions_; }
  Span<const Mat3<S>> disc_rotations() const { return iteration_.disc_rotation; }
  const Discs<S>& discs() const { return iteration_.discs; }
  const Cells<S>& cells() const { return iteration_.cells; }
  std::int32_t vertices() const { return count_of(iteration_.cells); }
  std::int32_t controls() const { return count_of(iteration_.discs); }

  // Of the shape state, at its present surface. No allocation.
  double energy() { return detail::shape_energy(iteration_.slices, iteration_.x.data(), iteration_.elastic); }

  // Of everything bound here.
  std::int64_t bytes() const { return iteration_.bytes() + detail::bytes_of(shape_, positions_); }

 private:
  using Quad = detail::simd::Quad<S>;

  void begin(const DeformerOptions<S>& options) {
    iteration_.bind(options.elastic);
    for (auto* rows : {&shape_, &positions_}) rows->resize(iteration_.cells.size());
    reset();
  }

  detail::ShapeIteration<S> iteration_;
  std::vector<Vec3<S>> shape_;      // V, as the caller numbers them
  std::vector<Vec3<S>> positions_;  // V
};

template <class S, class Weights>
Status Deformer<S, Weights>::bind(Span<const Vec3<S>> rest, Span<const Face> faces, const DeformerOptions<S>& options) {
  if (const Status s = detail::build_cells<Weights, S>(rest, faces, options.rigidity, iteration_.cells); !s.ok())
    return s;
  begin(options);
  return {};
}

template <class S, class Weights>
Status Deformer<S, Weights>::bind_graph(Span<const Vec3<S>> rest, const OneRing& ring, Span<const S> weight,
                                        const DeformerOptions<S>& options) {
  if (const Status s = detail::graph_cells<S>(rest, ring, weight, options.rigidity, iteration_.cells); !s.ok())
    return s;
  begin(options);
  return {};
}

template <class S, class Weights>
Status Deformer<S, Weights>::set_controls(Span<const Control<S>> controls) {
  Discs<S> discs;
  if (const Status s = detail::make_discs(iteration_.cells, controls, discs); !s.ok()) return s;
  return set_discs(std::move(discs));
}

template <class S, class Weights>
Status Deformer<S, Weights>::set_discs(Discs<S> discs) {
  if (const Status s = iteration_.set_discs(std::move(discs)); !s.ok()) return s;
  reset();
  return {};
}

template <class S, class Weights>
void Deformer<S, Weights>::set_targets(Span<const Vec3<S>> targets) {
  RIGLESS_ASSERT(targets.size() == iteration_.targets.size());
  for (std::size_t c = 0; c < targets.size(); ++c) {
    if (targets[c].allFinite()) iteration_.targets[c] = targets[c];
  }
}

template <class S, class Weights>
void Deformer<S, Weights>::reset() {
  set_shape(iteration_.cells.rest);
}

template <class S, class Weights>
void Deformer<S, Weights>::set_shape(Span<const Vec3<S>> surface) {
  RIGLESS_ASSERT(surface.size() == shape_.size());
  for (std::size_t v = 0; v < surface.size(); ++v)
    iteration_.row(iteration_.x, v) = Quad{surface[v].x(), surface[v].y(), surface[v].z(), S(0)};
  std::copy(surface.begin(), surface.end(), shape_.begin());
  std::copy(surface.begin(), surface.end(), positions_.begin());
  iteration_.unturn_discs(Mat3<S>::Identity());
  iteration_.slices.set_rotations(Mat3<S>::Identity());
}

template <class S, class Weights>
void Deformer<S, Weights>::keep(ShapeState<S>& state) const {
  state.x.assign(iteration_.x.begin(), iteration_.x.end());
  state.rotation.resize(iteration_.slices.size());
  for (std::size_t s = 0; s < iteration_.slices.size(); ++s) state.rotation[s] = iteration_.slices.cell[s].q;
  state.disc_rotation.assign(iteration_.disc_rotation.begin(), iteration_.disc_rotation.end());
}

template <class S, class Weights>
void Deformer<S, Weights>::resume(const ShapeState<S>& state) {
  RIGLESS_ASSERT(state.x.size() == iteration_.x.size() && state.disc_rotation.size() == iteration_.discs.size());
  std::copy(state.x.begin(), state.x.end(), iteration_.x.begin());
  for (std::size_t s = 0; s < iteration_.slices.size(); ++s) iteration_.slices.cell[s].q = state.rotation[s];
  for (std::size_t c = 0; c < iteration_.discs.size(); ++c) {
    if (!iteration_.turned[c]) iteration_.disc_rotation[c] = state.disc_rotation[c];
  }
}

template <class S, class Weights>
void Deformer<S, Weights>::turn(std::int32_t c, const Mat3<S>& rotation) {
  nth(iteration_.disc_rotation, c) = rotation;
  nth(iteration_.turned, c) = 1;
}

template <class S, class Weights>
void Deformer<S, Weights>::free_turn(std::int32_t c) {
  nth(iteration_.turned, c) = 0;
}

template <class S, class Weights>
void Deformer<S, Weights>::start(Span<const Mat3<S>> rotations) {
  iteration_.start(rotations);
  iteration_.show({}, shape_);
}

template <class S, class Weights>
void Deformer<S, Weights>::step(int iterations) {
  iteration_.step(iterations);
  iteration_.show({}, shape_);
}

template <class S, class Weights>
void Deformer<S, Weights>::relax(int iterations) {
  iteration_.relax(iterations);
  iteration_.show({}, shape_);
}

template <class S, class Weights>
template <class Law, std::enable_if_t<std::is_class_v<Law>, int>>
void Deformer<S, Weights>::pose(const Law& law) {
  iteration_.pose(law);
  iteration_.show(iteration_.r, positions_);
}

}  // namespace rigless
