#include "rigless/math/detail/supernodal_ldlt.h"

#include <doctest/doctest.h>

#include <random>

#include "rigless/math/detail/sparse_ldlt.h"
#include "support/alloc_count.h"

using namespace rigless;
using namespace rigless::detail;

namespace {

// A random planar-ish graph: a grid with diagonals and some far links, symmetric positive couplings, and a few vertices
// that are held (unit diagonal, no coupling).
template <class S>
struct System {
  std::vector<std::int32_t> first, neighbor;
  std::vector<S> weight, diagonal, coupling;
  std::vector<char> held;

  System(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::vector<std::pair<std::int32_t, S>>> lists(static_cast<std::size_t>(n * n));
    const auto link = [&](int a, int b) {
      if (a == b) return;
      for (const auto& [j, w] : lists[static_cast<std::size_t>(a)]) {
        if (j == b) return;
      }
      const S w = S(0.1) + static_cast<S>(random() % 100) / S(50);
      lists[static_cast<std::size_t>(a)].push_back({b, w});
      lists[static_cast<std::size_t>(b)].push_back({a, w});
    };
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        if (x + 1 < n) link(y * n + x, y * n + x + 1);
        if (y + 1 < n) link(y * n + x, y * n + n + x);
        if (x + 1 < n && y + 1 < n) link(y * n + x, y * n + n + x + 1);
      }
    }
    for (int k = 0; k < n; ++k)
      link(static_cast<int>(random() % unsigned(n * n)), static_cast<int>(random() % unsigned(n * n)));
    first.push_back(0);
    for (auto& list : lists) {
      std::sort(list.begin(), list.end());
      for (const auto& [j, w] : list) {
        neighbor.push_back(j);
        weight.push_back(w);
      }
      first.push_back(static_cast<std::int32_t>(neighbor.size()));
    }
    held.assign(lists.size(), 0);
    for (int k = 0; k < 5; ++k) held[random() % held.size()] = 1;
    fill();
  }

  void fill() {
    diagonal.assign(held.size(), S(0));
    coupling.assign(weight.size(), S(0));
    for (std::size_t i = 0; i < held.size(); ++i) {
      for (auto k = static_cast<std::size_t>(first[i]); k < static_cast<std::size_t>(first[i + 1]); ++k) {
        diagonal[i] += weight[k];
        if (!held[i] && !held[static_cast<std::size_t>(neighbor[k])]) coupling[k] = -weight[k];
      }
      if (held[i]) diagonal[i] = S(1);
    }
  }

  // Largest residual of A x = b over rows and axes, relative to b.
  double residual(const SupernodalLdlt<S>& ldlt, const std::vector<simd::Quad<S>>& x,
                  const std::vector<simd::Quad<S>>& b) const {
    double worst = 0;
    for (std::size_t i = 0; i < held.size(); ++i) {
      const auto at = [&](std::size_t v) { return static_cast<std::size_t>(ldlt.place()[v]); };
      simd::Quad<S> r = b[at(i)] - diagonal[i] * x[at(i)];
      for (auto k = static_cast<std::size_t>(first[i]); k < static_cast<std::size_t>(first[i + 1]); ++k) {
        r -= coupling[k] * x[at(static_cast<std::size_t>(neighbor[k]))];
      }
      for (int axis = 0; axis < 3; ++axis) worst = std::max(worst, static_cast<double>(std::abs(r[axis])));
    }
    return worst;
  }

  std::vector<simd::Quad<S>> random_rhs(unsigned seed) const {
    std::mt19937 random(seed);
    std::vector<simd::Quad<S>> b(held.size());
    for (auto& q : b) {
      for (int axis = 0; axis < 3; ++axis) q[axis] = static_cast<S>(static_cast<int>(random() % 2001) - 1000) / S(1000);
    }
    return b;
  }
};

}  // namespace

TEST_CASE_TEMPLATE("solves graphs of many shapes, without allocating", S, float, double) {
  for (const int n : {1, 2, 3, 7, 20, 45}) {
    CAPTURE(n);
    System<S> system(n, static_cast<unsigned>(n));
    SupernodalLdlt<S> ldlt;
    ldlt.analyze(system.first, system.neighbor);
    const auto before = test::allocation_count;
    REQUIRE(ldlt.factorize(system.diagonal, system.coupling).ok());
    CHECK(test::allocation_count == before);
    const auto b = system.random_rhs(3);
    auto x = b;
    const auto solving = test::allocation_count;
    ldlt.solve(x.data());
    CHECK(test::allocation_count == solving);
    CHECK(system.residual(ldlt, x, b) < (std::is_same_v<S, double> ? 1e-11 : 5e-4));
  }
}

TEST_CASE("agrees with the simplicial factor, and stores little more") {
  System<double> system(40, 9);
  SupernodalLdlt<double> ldlt;
  ldlt.analyze(system.first, system.neighbor);
  REQUIRE(ldlt.factorize(system.diagonal, system.coupling).ok());
  const auto b = system.random_rhs(5);
  auto x = b;
  ldlt.solve(x.data());

  std::vector<Eigen::Triplet<double, std::int32_t>> t;
  for (std::size_t i = 0; i < system.held.size(); ++i) {
    t.emplace_back(static_cast<int>(i), static_cast<int>(i), system.diagonal[i]);
    for (auto k = static_cast<std::size_t>(system.first[i]); k < static_cast<std::size_t>(system.first[i + 1]); ++k) {
      if (system.neighbor[k] < static_cast<int>(i))
        t.emplace_back(static_cast<int>(i), system.neighbor[k], system.coupling[k]);
    }
  }
  SparseLdlt<double>::Matrix A(1600, 1600);
  A.setFromTriplets(t.begin(), t.end());
  SparseLdlt<double> simplicial;
  REQUIRE(simplicial.analyze(A).ok());
  REQUIRE(simplicial.factorize(A).ok());
  std::vector<Rhs4<double>> y(1600);
  for (std::size_t i = 0; i < 1600; ++i) {
    const auto& q = b[static_cast<std::size_t>(ldlt.place()[i])];
    y[i] = Rhs4<double>(q[0], q[1], q[2], 0);
  }
  simplicial.solve(y);
  for (std::size_t i = 0; i < 1600; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double found = x[static_cast<std::size_t>(ldlt.place()[i])][axis];  // clang: no reference to a lane
      CHECK(found == doctest::Approx(y[i][axis]));
    }
  }
  CHECK(ldlt.stored() < 2 * (simplicial.nonzeros() + 1600));  // padding zeros and square blocks included
}

TEST_CASE_TEMPLATE("a partial refactorisation equals a whole one, bit by bit", S, float, double) {
  System<S> system(30, 4);
  SupernodalLdlt<S> partial, whole;
  partial.analyze(system.first, system.neighbor);
  whole.analyze(system.first, system.neighbor);
  REQUIRE(partial.factorize(system.diagonal, system.coupling).ok());
  std::mt19937 random(2);
  for (int change = 0; change < 10; ++change) {
    std::vector<std::int32_t> changed;
    for (int k = 0; k < 3; ++k) {
      const auto v = static_cast<std::int32_t>(random() % system.held.size());
      system.held[static_cast<std::size_t>(v)] ^= 1;
      changed.push_back(v);
    }
    system.held[17] = 1;  // something always holds
    changed.push_back(17);
    system.fill();
    const auto before = test::allocation_count;
    REQUIRE(partial.refactorize(system.diagonal, system.coupling, changed).ok());
    CHECK(test::allocation_count == before);
    REQUIRE(whole.factorize(system.diagonal, system.coupling).ok());
    const auto b = system.random_rhs(static_cast<unsigned>(change));
    auto x = b, y = b;
    partial.solve(x.data());
    whole.solve(y.data());
    CHECK(std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0);
  }
}

TEST_CASE("a singular system names a row") {
  System<double> system(12, 1);
  std::fill(system.held.begin(), system.held.end(), 0);
  system.fill();
  system.diagonal[30] = -1;
  SupernodalLdlt<double> ldlt;
  ldlt.analyze(system.first, system.neighbor);
  const Status s = ldlt.factorize(system.diagonal, system.coupling);
  CHECK(s.error == Error::factorization_failed);
  CHECK(s.where >= 0);
}
