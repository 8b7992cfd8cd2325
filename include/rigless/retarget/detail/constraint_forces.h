// What hard constraints pull with, once every track is solved without them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "rigless/math/detail/dense_solve.h"
#include "rigless/math/span.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/constraint_rows.h"

namespace rigless::detail {

// R equations over C tracks of T frames: the Schur complement that the tracks leave behind, its multipliers, and which
// constraints contradict each other. bind(), every response(), solve(), then measure() the tracks under these forces.
template <class S>
class ConstraintForces {
 public:
  using Tracks = std::vector<std::vector<Vec3<S>>>;  // C x T

  // Forgets the old ones. Allocates.
  void bind(std::size_t rows, std::size_t constraints) {
    const auto size = static_cast<Eigen::Index>(rows);
    schur_ = Matrix::Zero(size, size);
    residuals_.assign(constraints, S(0));
    opponents_.assign(constraints, -1);
  }

  // By how much a unit force along row `col` moves row `row` back; 0 at first.
  S& response(std::size_t row, std::size_t col) {
    return schur_(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(col));
  }

  // The multipliers that bring the free tracks to the targets, and the opponents. Allocates.
  void solve(const std::vector<ConstraintRow<S>>& rows, const Tracks& tracks, S compliance) {
    const auto size = static_cast<Eigen::Index>(rows.size());
    Vector excess(size);
    for (std::size_t r = 0; r < rows.size(); ++r)
      excess[static_cast<Eigen::Index>(r)] = value(rows[r], tracks) - rows[r].target;
    const S rounding = S(16) * std::numeric_limits<S>::epsilon() * schur_.diagonal().cwiseAbs().maxCoeff();
    const S give = std::max({compliance, rounding, std::numeric_limits<S>::min()});
    Matrix system = (schur_ + schur_.transpose()) / S(2) + give * Matrix::Identity(size, size);
    std::vector<std::int32_t> exchange(rows.size());
    lu_in_place(system, exchange.data());
    solve_lu(system, exchange.data(), excess);
    multipliers_ = excess;
    find_opponents(rows, system, exchange, give);
  }

  // How far the tracks miss the targets. No allocation.
  void measure(const std::vector<ConstraintRow<S>>& rows, const Tracks& tracks) {
    for (const auto& row : rows) {
      S& worst = nth(residuals_, row.constraint);
      worst = std::max(worst, std::abs(value(row, tracks) - row.target));
    }
  }

  S multiplier(std::size_t row) const { return multipliers_[static_cast<Eigen::Index>(row)]; }
  Span<const S> residuals() const { return residuals_; }
  Span<const std::int32_t> opponents() const { return opponents_; }

 private:
  using Matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

  static S value(const ConstraintRow<S>& row, const Tracks& tracks) {
    S sum = 0;
    for (const auto& term : row.terms) sum += term.factor * nth(nth(tracks, term.track), term.frame)[term.axis];
    return sum;
  }

  // What is missed, give * multipliers, lies in the null space of the Schur complement. The column of its projector,
  // give (schur + give I)^-1, that belongs to a missed equation names those that depend on it.
  void find_opponents(const std::vector<ConstraintRow<S>>& rows, const Matrix& factors,
                      const std::vector<std::int32_t>& exchange, S give) {
    std::vector<S> worst(opponents_.size(), std::sqrt(std::numeric_limits<S>::epsilon()) * S(10));
    for (Eigen::Index r = 0; r < multipliers_.size(); ++r) {
      const std::int32_t own = nth(rows, r).constraint;
      const S missed = give * std::abs(multipliers_[r]);
      if (missed <= nth(worst, own)) continue;
      nth(worst, own) = missed;
      Vector column = Vector::Unit(multipliers_.size(), r);
      solve_lu(factors, exchange.data(), column);
      S most = S(1e-3);
      for (Eigen::Index s = 0; s < column.size(); ++s) {
        const std::int32_t other = nth(rows, s).constraint;
        if (other == own || give * std::abs(column[s]) <= most) continue;
        most = give * std::abs(column[s]);
        nth(opponents_, own) = other;
      }
    }
  }

  Matrix schur_;        // R x R
  Vector multipliers_;  // R
  std::vector<S> residuals_;
  std::vector<std::int32_t> opponents_;
};

}  // namespace rigless::detail
