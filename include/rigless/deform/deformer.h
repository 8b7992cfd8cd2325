// Cartoon deformation of a surface by a few control points: bind a mesh, set controls, then targets and steps per
// frame.
#pragma once

#include "rigless/deform/control.h"
#include "rigless/deform/detail/build_cells.h"
#include "rigless/deform/detail/discs.h"
#include "rigless/deform/detail/hard_rows.h"
#include "rigless/deform/detail/local_step.h"
#include "rigless/deform/detail/pose_step.h"
#include "rigless/deform/detail/volume_law.h"
#include "rigless/math/detail/bytes.h"
#include "rigless/math/detail/rotation.h"

namespace rigless {

template <class S>
struct DeformerOptions {
  S elastic = S(0.5);           // mu of ElasticScale
  Span<const S> rigidity = {};  // V, or empty for 1 everywhere: an edge is as stiff as the softer of its ends. 10 keeps
                                // the shape of a head or of armour; 1000 makes its seam ugly.
};

// What an iteration goes on from: a surface and the rotations that were last fitted to it.
template <class S>
struct ShapeState {
  std::vector<simd::Quad<S>> x;              // V + 1, in elimination order
  std::vector<QuaternionLanes<S>> rotation;  // of cells
  std::vector<Mat3<S>> disc_rotation;        // C
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

  // Binds a graph of V nodes as a surface is bound: neighbours, and a weight above 0 for each directed edge, the same both
  // ways. Allocates. On failure the old binding stays.
  // Errors: not_finite (node, also for a rigidity that is not above 0); size_mismatch (weights, rigidity).
  RIGLESS_COLD Status bind_graph(Span<const Vec3<S>> rest, const OneRing& ring, Span<const S> weight,
                                 const DeformerOptions<S>& options = {});

  // Chooses C controls; targets start at rest, the shape too. Allocates. On failure the old controls stay.
  // Errors: no_controls; index_out_of_range (control); factorization_failed.
  RIGLESS_COLD Status set_controls(Span<const Control<S>> controls);

  // The same with controls that hold these vertices (see solid_pieces.h): at least one each.
  // Errors: factorization_failed.
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

  // Starts from nothing but the targets: rest, moved rigidly to fit them best, then bent by one solve until every
  // control is met. Frames that start here depend on their targets alone. No allocation.
  void start();

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
  Span<const Mat3<S>> disc_rotations() const { return disc_rotation_; }
  const Discs<S>& discs() const { return discs_; }
  const Cells<S>& cells() const { return cells_; }
  std::int32_t vertices() const { return count_of(cells_); }
  std::int32_t controls() const { return count_of(discs_); }

  // Of the shape state, at its present surface. No allocation.
  double energy() { return shape_energy(slices_, x_.data(), elastic_); }

  // Of everything bound here.
  std::int64_t bytes() const;

 private:
  using Quad = simd::Quad<S>;

  void begin(const DeformerOptions<S>& options);
  Quad& row(Span<Quad> rows, std::size_t vertex) { return nth(rows, system_.place()[vertex]); }
  Vec3<S> position(std::size_t vertex);
  template <bool with_energy>
  double fit_residual();
  void solve_update();
  void unturn_discs(const Mat3<S>& rotation);
  void turn_discs();
  void hold();
  void show(Span<const Quad> update, Span<Vec3<S>> out) const;

  Cells<S> cells_;
  ElasticScale<S> elastic_;
  Discs<S> discs_;
  HardRows<S> system_;
  CellSlices<S> slices_;
  std::vector<Vec3<S>> targets_;        // C
  std::vector<Mat3<S>> disc_rotation_;  // C
  DiscSeams<S> seams_;
  std::vector<Quad> moved_;         // per held vertex: its last move
  std::vector<char> turned_;        // C: the caller has set its rotation
  std::vector<Quad> x_;             // V + 1: shape state, in elimination order
  std::vector<Quad> r_;             // V + 1: residual, then update
  std::vector<Quad> solved_;        // V + 1: the last iterate before momentum carried it on
  std::vector<Vec3<S>> shape_;      // V, as the caller numbers them
  std::vector<Vec3<S>> positions_;  // V
};

template <class S, class Weights>
Status Deformer<S, Weights>::bind(Span<const Vec3<S>> rest, Span<const Face> faces, const DeformerOptions<S>& options) {
  if (const Status s = build_cells<Weights, S>(rest, faces, options.rigidity, cells_); !s.ok()) return s;
  begin(options);
  return {};
}

template <class S, class Weights>
Status Deformer<S, Weights>::bind_graph(Span<const Vec3<S>> rest, const OneRing& ring, Span<const S> weight,
                                        const DeformerOptions<S>& options) {
  if (const Status s = graph_cells<S>(rest, ring, weight, options.rigidity, cells_); !s.ok()) return s;
  begin(options);
  return {};
}

// With new cells and no controls.
template <class S, class Weights>
void Deformer<S, Weights>::begin(const DeformerOptions<S>& options) {
  elastic_.mu = options.elastic;
  system_.bind(cells_);
  slices_ = slice_cells(cells_, system_.place(), system_.vertex_at());
  discs_ = {};
  seams_ = {};
  discs_.owner.assign(cells_.size(), -1);
  targets_.clear();
  disc_rotation_.clear();
  turned_.clear();
  for (auto* rows : {&x_, &r_, &solved_}) rows->assign(cells_.size() + 1, Quad{});
  shape_.resize(cells_.size());
  positions_.resize(cells_.size());
  reset();
}

template <class S, class Weights>
Status Deformer<S, Weights>::set_controls(Span<const Control<S>> controls) {
  Discs<S> discs;
  if (const Status s = make_discs(cells_, controls, discs); !s.ok()) return s;
  return set_discs(std::move(discs));
}

template <class S, class Weights>
Status Deformer<S, Weights>::set_discs(Discs<S> discs) {
  if (const Status s = system_.hold(cells_, discs_, discs); !s.ok()) return s;
  discs_ = std::move(discs);
  seams_ = find_seams(cells_, discs_);
  moved_.assign(discs_.member.size(), Quad{});
  targets_ = discs_.center;
  disc_rotation_.assign(discs_.size(), Mat3<S>::Identity());
  turned_.assign(discs_.size(), 0);
  reset();
  return {};
}

template <class S, class Weights>
void Deformer<S, Weights>::set_targets(Span<const Vec3<S>> targets) {
  RIGLESS_ASSERT(targets.size() == targets_.size());
  for (std::size_t c = 0; c < targets.size(); ++c) {
    if (targets[c].allFinite()) targets_[c] = targets[c];
  }
}

template <class S, class Weights>
void Deformer<S, Weights>::reset() {
  set_shape(cells_.rest);
}

template <class S, class Weights>
void Deformer<S, Weights>::set_shape(Span<const Vec3<S>> surface) {
  RIGLESS_ASSERT(surface.size() == shape_.size());
  for (std::size_t v = 0; v < surface.size(); ++v)
    row(x_, v) = Quad{surface[v].x(), surface[v].y(), surface[v].z(), S(0)};
  std::copy(surface.begin(), surface.end(), shape_.begin());
  std::copy(surface.begin(), surface.end(), positions_.begin());
  unturn_discs(Mat3<S>::Identity());
  slices_.set_rotations(Mat3<S>::Identity());
}

template <class S, class Weights>
void Deformer<S, Weights>::keep(ShapeState<S>& state) const {
  state.x.assign(x_.begin(), x_.end());
  state.rotation.resize(slices_.size());
  for (std::size_t s = 0; s < slices_.size(); ++s) state.rotation[s] = slices_.cell[s].q;
  state.disc_rotation.assign(disc_rotation_.begin(), disc_rotation_.end());
}

template <class S, class Weights>
void Deformer<S, Weights>::resume(const ShapeState<S>& state) {
  RIGLESS_ASSERT(state.x.size() == x_.size() && state.disc_rotation.size() == discs_.size());
  std::copy(state.x.begin(), state.x.end(), x_.begin());
  for (std::size_t s = 0; s < slices_.size(); ++s) slices_.cell[s].q = state.rotation[s];
  for (std::size_t c = 0; c < discs_.size(); ++c) {
    if (!turned_[c]) disc_rotation_[c] = state.disc_rotation[c];
  }
}

template <class S, class Weights>
void Deformer<S, Weights>::turn(std::int32_t c, const Mat3<S>& rotation) {
  nth(disc_rotation_, c) = rotation;
  nth(turned_, c) = 1;
}

template <class S, class Weights>
void Deformer<S, Weights>::free_turn(std::int32_t c) {
  nth(turned_, c) = 0;
}

// Where free discs begin.
template <class S, class Weights>
void Deformer<S, Weights>::unturn_discs(const Mat3<S>& rotation) {
  for (std::size_t c = 0; c < discs_.size(); ++c) {
    if (!turned_[c]) disc_rotation_[c] = rotation;
  }
}

template <class S, class Weights>
std::int64_t Deformer<S, Weights>::bytes() const {
  return system_.bytes() + slices_.bytes() +
         bytes_of(cells_.ring.first, cells_.ring.neighbor, cells_.weight, cells_.rest, cells_.weighted_size,
                  discs_.owner, discs_.member, x_, r_, solved_, shape_, positions_);
}

}  // namespace rigless

#include "rigless/deform/detail/iterate.h"
