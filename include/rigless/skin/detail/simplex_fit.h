// Weights that are not negative and sum to one: a small quadratic problem on a simplex.
#pragma once

#include <cmath>
#include <cstdint>

#include "rigless/math/detail/dense_solve.h"
#include "rigless/math/detail/index.h"

namespace rigless::detail {

// The w >= 0 with sum w = 1 that minimises w^T E w / 2 - b^T w, for a symmetric E that is at least semidefinite.
// N <= Most candidates; how many ask is size. No allocation.
// Source: Lawson and Hanson 1974, "Solving least squares problems", with the sum as a constraint of its own.
template <int Most>
struct SimplexFit {
  double E[Most][Most];
  double b[Most];
  double w[Most];
  int size = 0;

  void solve() {
    int best = 0;
    for (int j = 1; j < size; ++j) {
      if (E[j][j] - 2 * b[j] < E[best][best] - 2 * b[best]) best = j;
    }
    for (int j = 0; j < size; ++j) w[j] = 0;
    w[best] = 1;
    used_ = 1;
    active_[0] = best;
    double scale = 0;
    for (int j = 0; j < size; ++j) scale = std::max(scale, E[j][j]);
    for (int step = 0; step < 3 * size; ++step) {
      if (!let_in(1e-9 * scale)) return;
      while (!go_to_minimum()) {
      }
    }
  }

  double value() const {
    double sum = 0;
    for (int j = 0; j < size; ++j) {
      if (!(w[j] > 0)) continue;
      for (int k = 0; k < size; ++k) sum += w[j] * E[j][k] * w[k];
      sum -= 2 * b[j] * w[j];
    }
    return sum;
  }

 private:
  double gradient(int j) const {
    double g = -b[j];
    for (int a = 0; a < used_; ++a) g += E[j][active_[a]] * w[active_[a]];
    return g;
  }

  // Takes the candidate along which the value falls fastest into the active ones; false when there is none.
  bool let_in(double tiny) {
    double level = 0;
    for (int a = 0; a < used_; ++a) level += w[active_[a]] * gradient(active_[a]);
    double least = level - tiny;
    int best = -1;
    for (int j = 0; j < size; ++j) {
      if (w[j] > 0) continue;
      const double g = gradient(j);
      if (g < least) {
        least = g;
        best = j;
      }
    }
    if (best < 0) return false;
    active_[used_++] = best;
    return true;
  }

  // To the minimum over the active ones, or as far as none turns negative: those that would leave, and it says false.
  bool go_to_minimum() {
    double A[Most * Most], x[2 * Most];
    double trace = 0;
    for (int a = 0; a < used_; ++a) trace += E[active_[a]][active_[a]];
    for (int a = 0; a < used_; ++a) {
      for (int c = 0; c < used_; ++c) A[a * used_ + c] = E[active_[a]][active_[c]];
      A[a * used_ + a] += 1e-10 * trace + 1e-300;
      x[a] = b[active_[a]];
      x[used_ + a] = 1;
    }
    if (!columns::cholesky(A, used_)) return drop(-1);
    columns::lower(A, used_, x, 2);
    columns::lower_transposed(A, used_, x, 2);
    double free = 1, per = 0;
    for (int a = 0; a < used_; ++a) {
      free -= x[a];
      per += x[used_ + a];
    }
    double go = 1;
    int out = -1;
    for (int a = 0; a < used_; ++a) {
      x[a] += free / per * x[used_ + a];
      const double from = w[active_[a]];
      if (x[a] > 0) continue;
      const double reach = from > 0 ? from / (from - x[a]) : 0;
      if (out < 0 || reach < go) {
        go = reach;
        out = a;
      }
    }
    for (int a = 0; a < used_; ++a) w[active_[a]] += go * (x[a] - w[active_[a]]);
    return out < 0 || drop(out);
  }

  bool drop(int at) {
    if (at < 0) at = used_ - 1;
    w[active_[at]] = 0;
    for (int a = at; a + 1 < used_; ++a) active_[a] = active_[a + 1];
    --used_;
    return used_ == 1;
  }

  int active_[Most + 1];
  int used_ = 0;
};

}  // namespace rigless::detail
