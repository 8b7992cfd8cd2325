// Laplacian editing: the surface that keeps its Laplacian coordinates as well as its controls let it. One linear solve,
// blind to rotation; the deformers build on it, the thesis' own literally.
#pragma once

#include "rigless/mesh/detail/shells.h"
#include "rigless/thesis/position_constraints.h"

namespace rigless {

// Constraint: SoftRows, SoftDiagonal, ColumnElimination or RowReplacement.
template <class S, class Constraint>
class LaplacianEditor {
 public:
  // Binds V rest vertices with their ring, a weight per directed edge (> 0; symmetric, or symmetric but for a factor
  // per row, as 1 / |N(i)|) and C control vertices. Allocates. On failure the old binding stays.
  // Errors: size_mismatch; not_finite (vertex); index_out_of_range (control); no_controls (a vertex of a shell that
  // nothing holds); infeasible (two hard controls on one vertex, where: control); factorization_failed (row).
  Status bind(Span<const Vec3<S>> rest, const OneRing& ring, Span<const S> weight, Span<const std::int32_t> controls,
              const Constraint& constraint = {});

  // The edit with the Laplacian coordinates of the rest: C targets -> V vertices. No allocation.
  // Source: thesis section 2.1.2.
  void edit(Span<const Vec3<S>> targets, Span<Vec3<S>> out) { solve(delta_, targets, out); }

  // The same for other Laplacian coordinates delta (V), which may alias out. No allocation.
  void solve(Span<const Vec3<S>> delta, Span<const Vec3<S>> targets, Span<Vec3<S>> out);

  // V: Laplacian coordinates of the rest. Source: thesis Eq 2.2.
  Span<const Vec3<S>> delta() const { return delta_; }
  Span<const std::int32_t> controls() const { return controls_; }

 private:
  typename Constraint::Equations equations_;
  typename Constraint::Hold hold_ = Constraint{}.hold();
  detail::SparseLdlt<S> ldlt_;
  std::vector<std::int32_t> controls_;  // C
  std::vector<Vec3<S>> delta_;          // V
  std::vector<detail::Rhs4<S>> x_;      // V
};

namespace detail {

// A vertex of the first shell without a control, or -1. Allocates.
inline std::int32_t loose_vertex(const OneRing& ring, Span<const std::int32_t> controls) {
  const Shells shells = find_shells(ring);
  std::vector<bool> held(to_size(shells.count), false);
  const auto shell = [&](std::int32_t v) { return to_size(nth(shells.of_vertex, v)); };
  for (const std::int32_t v : controls) held[shell(v)] = true;
  for (std::int32_t v = 0; v < ring.vertices(); ++v) {
    if (!held[shell(v)]) return v;
  }
  return -1;
}

template <class S>
Status check_editor_input(Span<const Vec3<S>> rest, const OneRing& ring, Span<const S> weight,
                          Span<const std::int32_t> controls) {
  if (rest.size() + 1 != ring.first.size() || weight.size() != ring.neighbor.size()) return {Error::size_mismatch, -1};
  for (std::size_t v = 0; v < rest.size(); ++v) {
    if (!rest[v].allFinite()) return {Error::not_finite, v};
  }
  for (std::size_t c = 0; c < controls.size(); ++c) {
    if (controls[c] < 0 || controls[c] >= ring.vertices()) {
      return {Error::index_out_of_range, c};
    }
  }
  const std::int32_t loose = loose_vertex(ring, controls);
  return loose >= 0 ? Status{Error::no_controls, loose} : Status{};
}

}  // namespace detail

template <class S, class Constraint>
Status LaplacianEditor<S, Constraint>::bind(Span<const Vec3<S>> rest, const OneRing& ring, Span<const S> weight,
                                            Span<const std::int32_t> controls, const Constraint& constraint) {
  if (const Status s = detail::check_editor_input(rest, ring, weight, controls); !s.ok()) return s;
  LaplacianEditor next;
  next.controls_.assign(controls.begin(), controls.end());
  next.hold_ = constraint.hold();
  const SparseMatrix<S> M = next.equations_.bind(ring, weight);
  SparseMatrix<S> system;
  if (const Status s = next.hold_.bind(next.equations_, M, controls, system); !s.ok()) return s;
  const SparseMatrix<S> lower = system.template triangularView<Eigen::Lower>();
  if (const Status s = next.ldlt_.analyze(lower); !s.ok()) return s;
  if (const Status s = next.ldlt_.factorize(lower); !s.ok()) return s;
  next.delta_.assign(rest.size(), Vec3<S>::Zero());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    for (auto k = to_size(ring.first[i]); k < to_size(ring.first[i + 1]); ++k) {
      next.delta_[i] += weight[k] * (rest[i] - nth(rest, ring.neighbor[k]));
    }
  }
  next.x_.resize(rest.size());
  *this = std::move(next);
  return {};
}

template <class S, class Constraint>
void LaplacianEditor<S, Constraint>::solve(Span<const Vec3<S>> delta, Span<const Vec3<S>> targets, Span<Vec3<S>> out) {
  RIGLESS_ASSERT(delta.size() == x_.size() && out.size() == x_.size() && targets.size() == controls_.size());
  equations_.right_side(delta, x_);
  hold_.right_side(controls_, targets, x_);
  ldlt_.solve(x_);
  for (std::size_t v = 0; v < x_.size(); ++v) out[v] = x_[v].template head<3>().matrix();
}

}  // namespace rigless
