// Simplicial LDL^T of a sparse symmetric matrix whose pattern stays while its values change.
// The only header that touches Eigen's sparse solvers: it turns their info() into a Status, and solves without
// allocating.
#pragma once

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/status.h"

namespace rigless::detail {

// Four interleaved right-hand sides: x, y, z and padding, so that the factor is read once for all axes.
template <class S>
using Rhs4 = Eigen::Array<S, 4, 1>;

template <class S>
class SparseLdlt {
 public:
  using Matrix = Eigen::SparseMatrix<S, Eigen::ColMajor, std::int32_t>;

  // Orders (approximate minimum degree) and analyses the pattern of `lower`, n x n with only its lower triangle stored.
  // Allocates. Errors: out_of_memory is not reported, Eigen aborts.
  Status analyze(const Matrix& lower);

  // Factors a matrix of the analysed pattern. On failure the previous factor is gone. Allocates nothing after the
  // first. Errors: factorization_failed; a common reason is a connected part of the mesh that no control holds.
  Status factorize(const Matrix& lower);

  // Solves in place for n rows. Needs a successful factorize(). No allocation.
  void solve(Span<Rhs4<S>> x);

  std::int32_t rows() const { return rows_; }
  std::int64_t nonzeros() const { return solver_->matrixL().nestedExpression().nonZeros(); }
  bool factored() const { return factored_; }

 private:
  using Solver = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<std::int32_t>>;

  std::unique_ptr<Solver> solver_;  // Eigen's solvers cannot be moved
  std::vector<Rhs4<S>> work_;       // n, in elimination order
  std::vector<S> inverse_d_;        // n
  std::int32_t rows_ = 0;
  bool factored_ = false;
};

template <class S>
Status SparseLdlt<S>::analyze(const Matrix& lower) {
  factored_ = false;
  rows_ = static_cast<std::int32_t>(lower.rows());
  solver_ = std::make_unique<Solver>();
  solver_->analyzePattern(lower);
  if (solver_->info() != Eigen::Success) return {Error::factorization_failed, -1};
  work_.resize(to_size(rows_));
  inverse_d_.resize(to_size(rows_));
  return {};
}

template <class S>
Status SparseLdlt<S>::factorize(const Matrix& lower) {
  factored_ = false;
  if (lower.rows() != rows_) return {Error::size_mismatch, -1};
  solver_->factorize(lower);
  if (solver_->info() != Eigen::Success) return {Error::factorization_failed, -1};
  const auto D = solver_->vectorD();
  for (std::int32_t i = 0; i < rows_; ++i) {
    if (!(D[i] > S(0))) return {Error::factorization_failed, solver_->permutationPinv().indices()[i]};
    nth(inverse_d_, i) = S(1) / D[i];
  }
  factored_ = true;
  return {};
}

template <class S>
void SparseLdlt<S>::solve(Span<Rhs4<S>> x) {
  RIGLESS_ASSERT(factored_ && x.size() == work_.size());
  const auto& L = solver_->matrixL().nestedExpression();
  const std::int32_t* outer = L.outerIndexPtr();
  const std::int32_t* inner = L.innerIndexPtr();
  const S* values = L.valuePtr();
  const std::int32_t* to_factor = solver_->permutationP().indices().data();
  const auto n = to_size(rows_);
  for (std::size_t i = 0; i < n; ++i) nth(work_, to_factor[i]) = x[i];
  for (std::size_t j = 0; j < n; ++j) {
    const Rhs4<S> xj = work_[j];
    for (std::int32_t k = outer[j]; k < outer[j + 1]; ++k) nth(work_, inner[k]) -= values[k] * xj;
  }
  for (std::size_t j = n; j-- > 0;) {
    Rhs4<S> xj = work_[j] * inverse_d_[j];
    for (std::int32_t k = outer[j]; k < outer[j + 1]; ++k) xj -= values[k] * nth(work_, inner[k]);
    work_[j] = xj;
  }
  for (std::size_t i = 0; i < n; ++i) x[i] = nth(work_, to_factor[i]);
}

}  // namespace rigless::detail
