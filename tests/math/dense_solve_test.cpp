#include "rigless/math/detail/dense_solve.h"

#include <doctest/doctest.h>

#include <vector>

using namespace rigless;
using namespace rigless::detail;

namespace {

// Entries that follow no pattern, in [-1, 1].
template <class S>
Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> scattered(Eigen::Index rows, Eigen::Index cols, std::uint32_t seed) {
  Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> A(rows, cols);
  for (Eigen::Index i = 0; i < A.size(); ++i) {
    seed = seed * 1664525U + 1013904223U;
    A(i) = static_cast<S>(seed >> 8) / static_cast<S>(1 << 23) - S(1);
  }
  return A;
}

}  // namespace

TEST_CASE_TEMPLATE("Cholesky factors solve positive definite systems", S, float, double) {
  const S tolerance = sizeof(S) == 4 ? S(2e-4) : S(1e-11);
  for (Eigen::Index n = 1; n <= 12; ++n) {
    const auto G = scattered<S>(n + 3, n, 7);
    const Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> A =
        G.transpose() * G + S(0.1) * Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>::Identity(n, n);
    const auto X = scattered<S>(n, 4, 11);
    auto L = A;
    Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> B = A * X;
    REQUIRE(cholesky_in_place(L));
    solve_lower(L, B);
    solve_lower_transposed(L, B);
    CHECK((B - X).cwiseAbs().maxCoeff() < tolerance);
  }
}

TEST_CASE("Cholesky refuses what is not positive definite") {
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(4, 4);
  A(2, 2) = -1;
  CHECK_FALSE(cholesky_in_place(A));
  Eigen::MatrixXd none(0, 0);
  CHECK(cholesky_in_place(none));
}

TEST_CASE_TEMPLATE("LU factors solve what needs its rows exchanged", S, float, double) {
  const S tolerance = sizeof(S) == 4 ? S(1e-3) : S(1e-11);
  for (Eigen::Index n = 1; n <= 8; ++n) {
    auto A = scattered<S>(n, n, 23);
    if (n > 1) A(0, 0) = S(0);
    const auto X = scattered<S>(n, 3, 5);
    Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> B = A * X;
    std::vector<std::int32_t> exchange(static_cast<std::size_t>(n));
    lu_in_place(A, exchange.data());
    solve_lu(A, exchange.data(), B);
    CHECK((B - X).cwiseAbs().maxCoeff() < tolerance);
  }
}
