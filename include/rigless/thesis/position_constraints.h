// What ties a Laplacian system to its control points. A constraint is a way to read the equations and a way to hold the
// controls; the thesis has three of the four combinations, and the energy's own gradient is the fourth.
#pragma once

#include "rigless/thesis/laplacian_system.h"

namespace rigless {

// Controls are drawn to their targets: (M + weight I_c) V' = P delta + weight T.
template <class S>
class SoftHold {
 public:
  explicit SoftHold(S weight) : weight_(weight) {}

  // M with the controls held. Allocates.
  template <class Equations>
  Status bind(const Equations& equations, const SparseMatrix<S>& M, Span<const std::int32_t> controls,
              SparseMatrix<S>& system) {
    system = M;
    for (const std::int32_t v : controls) {
      gain_.push_back(weight_ * equations.row_factor(to_size(v)));
      system.coeffRef(v, v) += gain_.back();
    }
    return {};
  }

  // No allocation.
  void right_side(Span<const std::int32_t> controls, Span<const Vec3<S>> targets, Span<detail::Rhs4<S>> b) const {
    for (std::size_t c = 0; c < controls.size(); ++c) {
      nth(b, controls[c]).template head<3>() += gain_[c] * targets[c].array();
    }
  }

 private:
  S weight_;
  std::vector<S> gain_;  // C
};

// Controls are where their targets are: their columns are known, so they move to the right side, subtracted.
template <class S>
class HardHold {
 public:
  // M without the controls' rows and columns; a unit diagonal stays, so that nothing is renumbered. Allocates.
  // Errors: infeasible (where: control), two controls on one vertex.
  template <class Equations>
  Status bind(const Equations&, const SparseMatrix<S>& M, Span<const std::int32_t> controls, SparseMatrix<S>& system) {
    std::vector<bool> held(to_size(M.rows()), false);
    for (std::size_t c = 0; c < controls.size(); ++c) {
      if (nth(held, controls[c])) return {Error::infeasible, c};
      nth(held, controls[c]) = true;
    }
    M_ = M;
    system = M;
    system.prune([&](Eigen::Index row, Eigen::Index column, S) {
      return row == column || !(nth(held, row) || nth(held, column));
    });
    for (const std::int32_t v : controls) system.coeffRef(v, v) = S(1);
    return {};
  }

  // No allocation.
  void right_side(Span<const std::int32_t> controls, Span<const Vec3<S>> targets, Span<detail::Rhs4<S>> b) const {
    for (std::size_t c = 0; c < controls.size(); ++c) {
      for (typename SparseMatrix<S>::InnerIterator it(M_, controls[c]); it; ++it) {
        nth(b, it.row()).template head<3>() -= it.value() * targets[c].array();
      }
    }
    for (std::size_t c = 0; c < controls.size(); ++c) {
      nth(b, controls[c]).template head<3>() = targets[c].array();
    }
  }

 private:
  SparseMatrix<S> M_;
};

// Rows lambda I_c under L, all in the least-squares sense, so lambda counts squared.
// Source: thesis Eq 2.5 as printed; its Eq 2.4 has lambda unsquared.
template <class S>
struct SoftRows {
  using Equations = LeastSquaresEquations<S>;
  using Hold = SoftHold<S>;
  S lambda = S(10);

  Hold hold() const { return Hold(lambda * lambda); }
};

// The minimum over V' of the energy of Eq 2.9, every edge counted from both ends, plus lambda |v'_c - t_c|^2:
// (L + lambda/2 I_c) V' = delta + lambda/2 T.
template <class S>
struct SoftDiagonal {
  using Equations = SquareEquations<S>;
  using Hold = SoftHold<S>;
  S lambda = S(1000);

  Hold hold() const { return Hold(lambda / S(2)); }
};

// Known columns leave L, all rows stay: least squares over the free columns. Source: thesis Eq 2.7. Its text adds the
// known columns to delta; its figures subtract them, and so must everyone.
template <class S>
struct ColumnElimination {
  using Equations = LeastSquaresEquations<S>;
  using Hold = HardHold<S>;

  Hold hold() const { return {}; }
};

// Rows of the controls give way to v'_c = t_c; the others are met exactly. Source: thesis Eq 2.8.
template <class S>
struct RowReplacement {
  using Equations = SquareEquations<S>;
  using Hold = HardHold<S>;

  Hold hold() const { return {}; }
};

}  // namespace rigless
