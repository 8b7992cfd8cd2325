#include "rigless/math/detail/rotation_lanes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

using namespace rigless;
using namespace rigless::detail;

namespace {

// Rank 3 with det > 0 and det < 0; rank 2; rank 1; rank 1 but for noise of any size; det < 0 with s1 ~ s2, where the
// best rotation is all but free.
enum class Kind { random, reflected, flat, needle, near_needle, torn };
constexpr int kinds = 6;
const std::string kind_names[kinds] = {"random", "reflected", "rank 2", "rank 1", "near rank 1", "reflected, s1 ~ s2"};

Eigen::Quaterniond random_turn(double most, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, most);
  const Vec3<double> axis(normal(random), normal(random), normal(random));
  return Eigen::Quaterniond(Eigen::AngleAxisd(uniform(random), axis.normalized()));
}

// Factors are small dyadic numbers where `exact`, so that the rank survives rounding to float; scales from 1e-6
// to 1e6 otherwise.
Mat3<double> sample(Kind kind, bool exact, std::mt19937& random) {
  std::uniform_int_distribution<int> sixteenth(-16, 16);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Mat3<double> A, B;
  for (int k = 0; k < 9; ++k) {
    A(k) = exact ? sixteenth(random) / 16.0 : uniform(random);
    B(k) = exact ? sixteenth(random) / 16.0 : uniform(random);
  }
  const double scale = exact ? 1 : std::pow(10.0, 6 * uniform(random));
  switch (kind) {
    case Kind::flat:
      return scale * A.leftCols<2>() * B.topRows<2>();
    case Kind::needle:
      return scale * A.col(0) * B.row(0);
    case Kind::near_needle:
    case Kind::torn: {
      const double a = std::pow(10.0, -4 + 4 * uniform(random)), b = std::pow(10.0, -4 + 4 * uniform(random));
      const Vec3<double> sigma = kind == Kind::torn ? Vec3<double>(1, 0.5, -0.5 * (1 - a)) : Vec3<double>(1, a, a * b);
      return scale * random_turn(3.14, random).toRotationMatrix() * sigma.asDiagonal() *
             random_turn(3.14, random).toRotationMatrix();
    }
    default:
      if ((A.determinant() < 0) != (kind == Kind::reflected)) A.col(1) = -A.col(1);
      return scale * A;
  }
}

template <class S>
struct Batch {
  static constexpr int width = simd::width<S>;
  MatrixLanes<S> C;
  QuaternionLanes<S> q;

  void set(int lane, const Mat3<double>& c, const Eigen::Quaterniond& start) {
    for (int k = 0; k < 9; ++k) C.m[k][lane] = static_cast<S>(c(k / 3, k % 3));
    q.w[lane] = static_cast<S>(start.w());
    q.x[lane] = static_cast<S>(start.x());
    q.y[lane] = static_cast<S>(start.y());
    q.z[lane] = static_cast<S>(start.z());
  }
  Mat3<double> matrix(int lane) const {
    Mat3<double> c;
    for (int k = 0; k < 9; ++k) c(k / 3, k % 3) = static_cast<double>(C.m[k][lane]);
    return c;
  }
  Eigen::Quaterniond quaternion(int lane) const {
    return Eigen::Quaternion<S>(q.w[lane], q.x[lane], q.y[lane], q.z[lane]).template cast<double>();
  }
};

// What was lost against the best rotation, for one kind of matrix and one kind of start.
struct Losses {
  std::vector<double> deficit;  // (tr(R* C) - tr(R C)) / sum of singular values
  double unit = 0;              // worst ||q| - 1|
  double worst = -1;
  Mat3<double> worst_C;
  Eigen::Quaterniond worst_start;
};

// tr(R* C) = s0 + s1 + sign(det C) s2, by the double SVD.
double best_trace(const Svd3<double>& svd) {
  return svd.sigma[0] + svd.sigma[1] + (svd.U.determinant() < 0 ? -svd.sigma[2] : svd.sigma[2]);
}

template <class S>
void measure(Kind kind, bool warm, int count, Losses& out) {
  std::mt19937 random(static_cast<unsigned>(11 + 2 * static_cast<int>(kind) + (warm ? 1 : 0)));
  Batch<S> batch{};
  Mat3<double> C[Batch<S>::width];
  Eigen::Quaterniond start[Batch<S>::width];
  for (int b = 0; b < count; b += Batch<S>::width) {
    for (int lane = 0; lane < Batch<S>::width; ++lane) {
      C[lane] = sample(kind, (b / Batch<S>::width) % 2 == 0, random);
      start[lane] = Eigen::Quaterniond::Identity();
      if (warm) start[lane] = random_turn(0.2, random) * Eigen::Quaterniond(nearest_rotation(C[lane]));
      batch.set(lane, C[lane], start[lane]);
    }
    fit_rotations(batch.C, batch.q);
    for (int lane = 0; lane < Batch<S>::width; ++lane) {
      const Mat3<double> c = batch.matrix(lane);  // as rounded to S
      const Eigen::Quaterniond q = batch.quaternion(lane);
      out.unit = std::max(out.unit, std::abs(q.norm() - 1));
      const Svd3<double> svd = svd3(c);
      const double size = svd.sigma.sum();
      if (!(size > 0)) continue;
      const double deficit = (best_trace(svd) - (q.normalized().toRotationMatrix() * c).trace()) / size;
      out.deficit.push_back(deficit);
      if (deficit <= out.worst) continue;
      out.worst = deficit;
      out.worst_C = c;
      out.worst_start = start[lane];
    }
  }
}

}  // namespace

TEST_CASE_TEMPLATE("fit_rotations finds the nearest rotation of a million matrices, warm and cold", S, float, double) {
  constexpr int count = 125000;  // times two starts: a million of the four plain kinds, half of one of the others
  const bool single = sizeof(S) == 4;
  const double eps = static_cast<double>(std::numeric_limits<S>::epsilon());
  const double median_bound = single ? 1e-8 : 1e-15;
  // Where s1 <= 8 eps s0 nearest_rotation takes any turn about the axis: 2 (s1 + s2) <= 32 eps s0.
  const double worst_bound = 32 * eps;
  for (const bool warm : {true, false}) {
    for (int k = 0; k < kinds; ++k) {
      Losses losses;
      measure<S>(static_cast<Kind>(k), warm, count, losses);
      const auto middle = losses.deficit.begin() + static_cast<std::ptrdiff_t>(losses.deficit.size() / 2);
      std::nth_element(losses.deficit.begin(), middle, losses.deficit.end());
      MESSAGE(std::string(single ? "float, " : "double, "), std::string(warm ? "warm, " : "cold, "), kind_names[k],
              ": median ", *middle, ", worst ", losses.worst, ", |q| - 1 at most ", losses.unit);
      CAPTURE(losses.worst_C);
      CAPTURE(losses.worst_start.coeffs().transpose());
      CHECK(losses.deficit.size() > 0.9 * count);
      CHECK(*middle <= median_bound);
      CHECK(losses.worst <= worst_bound);
      CHECK(losses.unit <= (single ? 1e-6 : 1e-14));
    }
  }
}
