#include "rigless/math/detail/sparse_ldlt.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <random>

#include "support/alloc_count.h"

using namespace rigless;
using namespace rigless::detail;

namespace {

// Laplacian of an n x n grid plus a diagonal, lower triangle.
template <class S>
typename SparseLdlt<S>::Matrix grid_matrix(int n, S diagonal) {
  std::vector<Eigen::Triplet<S, std::int32_t>> t;
  const auto id = [n](int x, int y) { return y * n + x; };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      S d = diagonal;
      for (const auto [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        if (x + dx < 0 || y + dy < 0 || x + dx >= n || y + dy >= n) continue;
        d += S(1);
        if (id(x + dx, y + dy) < id(x, y)) t.emplace_back(id(x, y), id(x + dx, y + dy), S(-1));
      }
      t.emplace_back(id(x, y), id(x, y), d);
    }
  }
  typename SparseLdlt<S>::Matrix A(n * n, n * n);
  A.setFromTriplets(t.begin(), t.end());
  return A;
}

}  // namespace

TEST_CASE_TEMPLATE("solve agrees with a dense factorisation and allocates nothing", S, float, double) {
  const auto A = grid_matrix<S>(9, S(0.1));
  SparseLdlt<S> ldlt;
  REQUIRE(ldlt.analyze(A).ok());
  REQUIRE(ldlt.factorize(A).ok());
  std::mt19937 random(1);
  std::uniform_real_distribution<S> uniform(-1, 1);
  std::vector<Rhs4<S>> x(81);
  for (auto& row : x) row = Rhs4<S>(uniform(random), uniform(random), uniform(random), 0);
  const std::vector<Rhs4<S>> b = x;

  const auto before = test::allocation_count;
  ldlt.solve(x);
  CHECK(test::allocation_count == before);

  const Eigen::MatrixXd lower = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>(A).template cast<double>();
  const Eigen::MatrixXd dense = lower.selfadjointView<Eigen::Lower>();
  const double tolerance = std::is_same_v<S, double> ? 1e-12 : 2e-5;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::VectorXd rhs(81), got(81);
    for (std::size_t i = 0; i < 81; ++i) {
      rhs[static_cast<int>(i)] = static_cast<double>(b[i][axis]);
      got[static_cast<int>(i)] = static_cast<double>(x[i][axis]);
    }
    CHECK((dense * got - rhs).cwiseAbs().maxCoeff() < tolerance);
  }
}

TEST_CASE("a second factorisation keeps the order of the first") {
  SparseLdlt<double> ldlt;
  REQUIRE(ldlt.analyze(grid_matrix(7, 0.1)).ok());
  REQUIRE(ldlt.factorize(grid_matrix(7, 0.1)).ok());
  REQUIRE(ldlt.factorize(grid_matrix(7, 5.0)).ok());
  std::vector<Rhs4<double>> x(49, Rhs4<double>::Constant(5.0));  // rows of the Laplacian sum to nothing
  ldlt.solve(x);
  for (const auto& row : x) CHECK(row[0] == doctest::Approx(1));
}

TEST_CASE("a singular or indefinite matrix is an error, not a wrong answer") {
  SparseLdlt<double> ldlt;
  REQUIRE(ldlt.analyze(grid_matrix(5, 1.0)).ok());
  CHECK(ldlt.factorize(grid_matrix(5, -3.0)).error == Error::factorization_failed);
  CHECK_FALSE(ldlt.factored());
  CHECK(ldlt.factorize(grid_matrix(4, 1.0)).error == Error::size_mismatch);
  CHECK(ldlt.factorize(grid_matrix(5, 1.0)).ok());
}
