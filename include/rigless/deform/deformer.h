// Cartoon deformation of a surface by a few control points: bind a mesh, set handles, then targets and steps per frame.
#pragma once

#include "rigless/deform/discs.h"
#include "rigless/deform/pose_state.h"
#include "rigless/math/sparse_ldlt.h"
#include "rigless/mesh/shells.h"

namespace rigless {

// Cotangent weights, clamped; ties between shells get weight 1, about the mean of a well-shaped mesh.
struct CotangentWeights {
  template <class S>
  static std::vector<S> of(Span<const Vec3<S>> vertices, Span<const Face> faces, const OneRing& ring) {
    return cotangent_weights<S>(vertices, faces, ring);
  }
};

struct UniformWeights {
  template <class S>
  static std::vector<S> of(Span<const Vec3<S>>, Span<const Face>, const OneRing& ring) {
    return uniform_weights<S>(ring);
  }
};

template <class S>
struct DeformerOptions {
  S elastic = S(0.5);  // mu of ElasticScale
};

// Two states, after Fig 3.4 of the thesis. step() iterates the scaled shape state; pose() derives the surface that is
// shown from it, and never feeds back. A frame depends on its targets and on the shape surface it starts from, only.
template <class S, class Weights = CotangentWeights>
class Deformer {
 public:
  // Binds V rest vertices and F faces; forgets handles. Allocates. Broken meshes are accepted: shells are tied to what
  // is nearest, isolated vertices too. On failure the old binding stays. Errors: no_faces; index_out_of_range (face);
  // not_finite (vertex); factorization_failed.
  Status bind(Span<const Vec3<S>> rest, Span<const Face> faces, const DeformerOptions<S>& options = {});

  // Chooses C controls; targets start at rest, the shape too. Allocates. On failure the old handles stay.
  // Errors: no_controls; index_out_of_range (control); factorization_failed.
  Status set_handles(Span<const Handle<S>> handles);

  // C target positions of the controls. No allocation.
  void set_targets(Span<const Vec3<S>> targets);

  // Shape state and disc rotations back to rest. No allocation.
  void reset();

  // Starts from nothing but the targets: rest, moved rigidly to fit them best, then bent by one solve until every
  // control is met. Frames that start here depend on their targets alone. No allocation.
  void start();

  // Starts the next step() from this surface (V) with unturned discs. No allocation.
  void set_shape(Span<const Vec3<S>> surface);

  // Local-global iterations of the scaled shape state. Each lowers energy() or keeps it. No allocation.
  // Source: thesis Eq 3.2-3.7, hard rows as in Eq 2.8.
  void step(int iterations);

  // Pose state from the present shape. `volume` is lambda_v: 0 rotations only, 1 natural, 3 exaggerated. No allocation.
  void pose(S volume) { pose(PowerLaw<S>{volume}); }
  template <class Law>
  void pose(const Law& law);

  Span<const Vec3<S>> shape() const { return shape_; }
  Span<const Vec3<S>> positions() const { return positions_; }
  Span<const Mat3<S>> disc_rotations() const { return disc_rotation_; }
  const Discs& discs() const { return discs_; }
  const Cells<S>& cells() const { return cells_; }
  std::int32_t vertices() const { return static_cast<std::int32_t>(cells_.size()); }
  std::int32_t handles() const { return static_cast<std::int32_t>(discs_.size()); }

  // Of the shape state, at its present surface.
  S energy() const { return shape_energy<S>(cells_, shape_, elastic_); }

 private:
  using Matrix = typename SparseLdlt<S>::Matrix;

  static Matrix system_matrix(const Cells<S>& cells, const Discs& discs);
  void place_discs(Span<Vec3<S>> surface);
  void solve(Span<Vec3<S>> surface);

  Cells<S> cells_;
  ElasticScale<S> elastic_;
  Discs discs_;
  SparseLdlt<S> ldlt_;
  std::vector<Vec3<S>> targets_;        // C
  std::vector<Mat3<S>> disc_rotation_;  // C
  std::vector<Vec3<S>> shape_;          // V
  std::vector<Vec3<S>> positions_;      // V
  std::vector<Mat3<S>> transform_;      // V: s_i R_i, or V_i R_i in the pose state
  std::vector<Rhs4<S>> rhs_;            // V
};

template <class S, class Weights>
Status Deformer<S, Weights>::bind(Span<const Vec3<S>> rest, Span<const Face> faces, const DeformerOptions<S>& options) {
  const auto count = static_cast<std::int32_t>(rest.size());
  if (const Status s = check_faces(faces, count); !s.ok()) return s;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    if (!rest[v].allFinite()) return {Error::not_finite, static_cast<std::int32_t>(v)};
  }
  Cells<S> cells;
  cells.rest.assign(rest.begin(), rest.end());
  cells.ring = one_ring(faces, count);
  const auto ties = tie_shells<S>(rest, cells.ring);
  if (!ties.empty()) {
    std::vector<std::array<std::int32_t, 2>> pairs = ties;
    for (const Face& f : faces) {
      for (std::size_t k = 0; k < 3; ++k) pairs.push_back({f[k], f[(k + 1) % 3]});
    }
    cells.ring = one_ring_from_pairs(std::move(pairs), count);
  }
  cells.weight = Weights::template of<S>(rest, faces, cells.ring);
  for (const auto& [a, b] : ties) {
    cells.weight[static_cast<std::size_t>(cells.ring.slot(a, b))] = S(1);
    cells.weight[static_cast<std::size_t>(cells.ring.slot(b, a))] = S(1);
  }
  measure_cells(cells);

  Discs free;  // the pattern does not depend on who holds what
  free.owner.assign(cells.size(), -1);
  SparseLdlt<S> ldlt;
  if (const Status s = ldlt.analyze(system_matrix(cells, free)); !s.ok()) return s;

  cells_ = std::move(cells);
  ldlt_ = std::move(ldlt);
  elastic_.mu = options.elastic;
  discs_ = {};
  targets_.clear();
  disc_rotation_.clear();
  shape_ = positions_ = cells_.rest;
  transform_.assign(cells_.size(), Mat3<S>::Identity());
  rhs_.assign(cells_.size(), Rhs4<S>::Zero());
  return {};
}

// The Laplacian with hard rows: held vertices keep a unit diagonal and no coupling, so that the pattern, and with it
// the permutation, never changes. Lower triangle.
template <class S, class Weights>
auto Deformer<S, Weights>::system_matrix(const Cells<S>& cells, const Discs& discs) -> Matrix {
  const auto n = static_cast<std::int32_t>(cells.size());
  std::vector<Eigen::Triplet<S, std::int32_t>> entries;
  entries.reserve(cells.size() + static_cast<std::size_t>(cells.ring.edges()) / 2);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    S diagonal = S(0);
    for (auto k = static_cast<std::size_t>(cells.ring.first[i]); k < static_cast<std::size_t>(cells.ring.first[i + 1]);
         ++k) {
      const std::int32_t j = cells.ring.neighbor[k];
      diagonal += cells.weight[k];
      if (j > static_cast<std::int32_t>(i)) continue;
      const bool coupled = !discs.holds(i) && !discs.holds(static_cast<std::size_t>(j));
      entries.emplace_back(static_cast<std::int32_t>(i), j, coupled ? -cells.weight[k] : S(0));
    }
    entries.emplace_back(static_cast<std::int32_t>(i), static_cast<std::int32_t>(i), discs.holds(i) ? S(1) : diagonal);
  }
  Matrix A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

template <class S, class Weights>
Status Deformer<S, Weights>::set_handles(Span<const Handle<S>> handles) {
  Discs discs;
  if (const Status s = make_discs(cells_, handles, discs); !s.ok()) return s;
  if (const Status s = ldlt_.factorize(system_matrix(cells_, discs)); !s.ok()) {
    if (!discs_.center.empty()) {
      const Status restored = ldlt_.factorize(system_matrix(cells_, discs_));
      RIGLESS_ASSERT(restored.ok());
      static_cast<void>(restored);
    }
    return s;
  }
  discs_ = std::move(discs);
  targets_.clear();
  for (std::int32_t v : discs_.center) targets_.push_back(cells_.rest[static_cast<std::size_t>(v)]);
  disc_rotation_.assign(handles.size(), Mat3<S>::Identity());
  reset();
  return {};
}

template <class S, class Weights>
void Deformer<S, Weights>::set_targets(Span<const Vec3<S>> targets) {
  RIGLESS_ASSERT(targets.size() == targets_.size());
  std::copy(targets.begin(), targets.end(), targets_.begin());
}

template <class S, class Weights>
void Deformer<S, Weights>::reset() {
  set_shape(cells_.rest);
}

template <class S, class Weights>
void Deformer<S, Weights>::set_shape(Span<const Vec3<S>> surface) {
  RIGLESS_ASSERT(surface.size() == shape_.size());
  std::copy(surface.begin(), surface.end(), shape_.begin());
  std::copy(surface.begin(), surface.end(), positions_.begin());
  std::fill(disc_rotation_.begin(), disc_rotation_.end(), Mat3<S>::Identity());
}

template <class S, class Weights>
void Deformer<S, Weights>::start() {
  Vec3<S> from = Vec3<S>::Zero(), to = Vec3<S>::Zero();
  for (std::size_t c = 0; c < targets_.size(); ++c) {
    from += cells_.rest[static_cast<std::size_t>(discs_.center[c])];
    to += targets_[c];
  }
  from /= static_cast<S>(targets_.size());
  to /= static_cast<S>(targets_.size());
  Mat3<S> C = Mat3<S>::Zero();
  for (std::size_t c = 0; c < targets_.size(); ++c) {
    C += (cells_.rest[static_cast<std::size_t>(discs_.center[c])] - from) * (targets_[c] - to).transpose();
  }
  const Mat3<S> R = nearest_rotation(C);
  std::fill(transform_.begin(), transform_.end(), R);
  std::fill(disc_rotation_.begin(), disc_rotation_.end(), R);
  solve(shape_);
}

template <class S, class Weights>
void Deformer<S, Weights>::step(int iterations) {
  RIGLESS_ASSERT(ldlt_.factored());
  for (int it = 0; it < iterations; ++it) {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const CellFit<S> fit = fit_cell<S>(cells_, shape_, i, elastic_);
      transform_[i] = fit.s * fit.R;
    }
    for (std::size_t c = 0; c < discs_.size(); ++c) {
      if (discs_.first[c + 1] - discs_.first[c] < 2) continue;  // a single vertex has no turn
      disc_rotation_[c] = fit_disc<S>(cells_, discs_, c, transform_, shape_, targets_[c]);
    }
    solve(shape_);
  }
}

template <class S, class Weights>
template <class Law>
void Deformer<S, Weights>::pose(const Law& law) {
  RIGLESS_ASSERT(ldlt_.factored());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Mat3<S> R = nearest_rotation(covariance<S>(cells_, shape_, i));
    transform_[i] = volume_transform(fit_stretch<S>(cells_, shape_, R, i), R, law);
  }
  solve(positions_);
}

template <class S, class Weights>
void Deformer<S, Weights>::place_discs(Span<Vec3<S>> surface) {
  for (std::size_t c = 0; c < discs_.size(); ++c) {
    place_disc<S>(cells_, discs_, c, disc_rotation_[c], targets_[c], surface);
  }
}

// Solves Eq 3.7 for the free vertices with the present transforms; held ones go where their discs put them.
template <class S, class Weights>
void Deformer<S, Weights>::solve(Span<Vec3<S>> surface) {
  place_discs(surface);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (discs_.holds(i)) {
      rhs_[i].template head<3>() = surface[i].array();
      continue;
    }
    Vec3<S> b = Vec3<S>::Zero();
    for_each_edge(cells_, i, [&](S w, const Vec3<S>& e, std::size_t j) {
      b.noalias() += (w / S(2)) * ((transform_[i] + transform_[j]) * e);
      if (discs_.holds(j)) b += w * surface[j];
    });
    rhs_[i].template head<3>() = b.array();
  }
  ldlt_.solve(rhs_);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (!discs_.holds(i)) surface[i] = rhs_[i].template head<3>().matrix();
  }
}

}  // namespace rigless
