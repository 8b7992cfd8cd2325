// The deformation of the thesis to the letter, for comparison: rotations and scales fitted cell by cell, positions by
// any of its Laplacian solves. Deformer is the fast and better behaved path.
#pragma once

#include "rigless/deform/detail/cells.h"
#include "rigless/math/detail/svd3.h"
#include "rigless/thesis/cell_fit.h"
#include "rigless/thesis/laplacian_editor.h"

namespace rigless {

// s' = (s - 1) lambda_v + 1, which turns negative below s = 1 - 1 / lambda_v but for the clamp.
// Source: thesis Eq 3.12; the clamp is ours.
template <class S>
struct LinearLaw {
  S lambda_v = S(1);
  S lowest = S(0.1);
  S highest = S(10);

  S operator()(S s) const { return std::min(std::max((s - S(1)) * lambda_v + S(1), lowest), highest); }
};

// V_i of cell i: squeezes by s'^-1/2 across the axis along which the cell changed most. Identity where it did not
// change, or where no edge goes along that axis. No allocation.
// Source: thesis Eq 3.8-3.11, with edges weighted by sqrt(w_ij) in both 3.9 and 3.11.
template <class S, class Law>
Mat3<S> volume_transform(const Cells<S>& cells, Span<const Vec3<S>> surface, std::size_t i, const Mat3<S>& R,
                         const Law& law) {
  Mat3<S> D = Mat3<S>::Zero();
  detail::for_each_edge(cells, i, [&](S w, const Vec3<S>& e, std::size_t j) {
    const Vec3<S> d = (surface[i] - surface[j]) - R * e;
    D.noalias() += (w * d) * d.transpose();
  });
  const detail::Svd3<S> axes = detail::svd3(D);
  if (axes.sigma[0] < S(1e-12) * cells.weighted_size[i]) return Mat3<S>::Identity();
  const Vec3<S> p = axes.V.col(0);
  S above = S(0), below = S(0);
  detail::for_each_edge(cells, i, [&](S w, const Vec3<S>& e, std::size_t j) {
    const S rotated = p.dot(R * e);
    above += w * p.dot(surface[i] - surface[j]) * rotated;
    below += w * rotated * rotated;
  });
  if (!(below > S(1e-12) * cells.weighted_size[i])) return Mat3<S>::Identity();
  const S across = S(1) / std::sqrt(law(above / below));
  return across * Mat3<S>::Identity() + (S(1) - across) * p * p.transpose();
}

// Constraint as in LaplacianEditor. With least squares (SoftRows, ColumnElimination) the alternation settles, but not
// at a minimum of energy(), which may rise on the way; with SoftDiagonal and RowReplacement it never does.
template <class S, class Constraint>
class ThesisDeformer {
 public:
  // Binds as LaplacianEditor does, with symmetric weights; targets and shape start at rest. Elastic 0 is the thesis,
  // infinity as-rigid-as-possible. Allocates. On failure the old binding stays. Errors: those of LaplacianEditor::bind.
  Status bind(Span<const Vec3<S>> rest, const OneRing& ring, Span<const S> weight, Span<const std::int32_t> controls,
              const Constraint& constraint = {}, const detail::ElasticScale<S>& elastic = {S(0)});

  // C target positions of the controls. No allocation.
  void set_targets(Span<const Vec3<S>> targets);

  // Starts the next step() from this surface (V). No allocation.
  void set_shape(Span<const Vec3<S>> surface);

  // Starts from the naive Laplacian edit, the thesis' first guess. No allocation.
  void start() { editor_.edit(targets_, shape_); }

  // Iterations of the scaled shape state: R and s of every cell, then positions. No allocation.
  // Source: thesis Eq 2.10-2.12 (as-rigid-as-possible), 3.2-3.7.
  void step(int iterations);

  // Pose state from the present shape into positions(); the shape stays. No allocation. Source: thesis Eq 3.7-3.12.
  template <class Law>
  void pose(const Law& law);

  Span<const Vec3<S>> shape() const { return shape_; }
  Span<const Vec3<S>> positions() const { return positions_; }
  Span<const CellFit<S>> fits() const { return fits_; }  // V, of the last step
  const Cells<S>& cells() const { return cells_; }

  // Of the shape, with R and s refitted; without what soft constraints cost. No allocation.
  S energy() const { return shape_energy<S>(cells_, shape_, elastic_); }

 private:
  void solve(Span<Vec3<S>> out);

  Cells<S> cells_;
  detail::ElasticScale<S> elastic_;
  LaplacianEditor<S, Constraint> editor_;
  std::vector<Vec3<S>> targets_;    // C
  std::vector<CellFit<S>> fits_;    // V
  std::vector<Mat3<S>> transform_;  // V: s R or V R
  std::vector<Vec3<S>> delta_;      // V
  std::vector<Vec3<S>> shape_;      // V
  std::vector<Vec3<S>> positions_;  // V
};

template <class S, class Constraint>
Status ThesisDeformer<S, Constraint>::bind(Span<const Vec3<S>> rest, const OneRing& ring, Span<const S> weight,
                                           Span<const std::int32_t> controls, const Constraint& constraint,
                                           const detail::ElasticScale<S>& elastic) {
  if (const Status s = editor_.bind(rest, ring, weight, controls, constraint); !s.ok()) return s;
  cells_.ring = ring;
  cells_.weight.assign(weight.begin(), weight.end());
  cells_.rest.assign(rest.begin(), rest.end());
  detail::measure_cells(cells_);
  elastic_ = elastic;
  targets_.clear();
  for (const std::int32_t v : controls) targets_.push_back(nth(rest, v));
  fits_.assign(rest.size(), {Mat3<S>::Identity(), S(1)});
  transform_.assign(rest.size(), Mat3<S>::Identity());
  delta_.assign(rest.size(), Vec3<S>::Zero());
  shape_ = cells_.rest;
  positions_ = cells_.rest;
  return {};
}

template <class S, class Constraint>
void ThesisDeformer<S, Constraint>::set_targets(Span<const Vec3<S>> targets) {
  RIGLESS_ASSERT(targets.size() == targets_.size());
  std::copy(targets.begin(), targets.end(), targets_.begin());
}

template <class S, class Constraint>
void ThesisDeformer<S, Constraint>::set_shape(Span<const Vec3<S>> surface) {
  RIGLESS_ASSERT(surface.size() == shape_.size());
  std::copy(surface.begin(), surface.end(), shape_.begin());
}

template <class S, class Constraint>
void ThesisDeformer<S, Constraint>::step(int iterations) {
  for (int it = 0; it < iterations; ++it) {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      fits_[i] = fit_cell<S>(cells_, shape_, i, elastic_);
      transform_[i] = fits_[i].s * fits_[i].R;
    }
    solve(shape_);
  }
}

template <class S, class Constraint>
template <class Law>
void ThesisDeformer<S, Constraint>::pose(const Law& law) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Mat3<S> R = detail::nearest_rotation(covariance<S>(cells_, shape_, i));
    transform_[i] = volume_transform<S>(cells_, shape_, i, R, law) * R;
  }
  solve(positions_);
}

// The right side of Eq 3.7 from the transforms, then V'.
template <class S, class Constraint>
void ThesisDeformer<S, Constraint>::solve(Span<Vec3<S>> out) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    delta_[i].setZero();
    detail::for_each_edge(cells_, i, [&](S w, const Vec3<S>& e, std::size_t j) {
      delta_[i] += (w / S(2)) * ((transform_[i] + transform_[j]) * e);
    });
  }
  editor_.solve(delta_, targets_, out);
}

}  // namespace rigless
