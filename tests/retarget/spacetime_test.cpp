#include "rigless/retarget/detail/spacetime.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "rigless/retarget/detail/band_solver.h"
#include "support/alloc_count.h"

namespace detail = rigless::detail;
using rigless::Vec3;

namespace {

// Two tracks of 40 frames, five examples of four features.
template <class S>
struct Problem {
  std::vector<S> features, examples;
  std::vector<Vec3<S>> controls;
  std::vector<detail::TrackInput<S>> tracks;

  Problem() {
    for (int i = 0; i < 40 * 4; ++i) features.push_back(static_cast<S>(std::sin(0.1 * i)));
    for (int i = 0; i < 5 * 4; ++i) examples.push_back(static_cast<S>(std::sin(1.3 * i)));
    for (int i = 0; i < 5; ++i) controls.push_back(Vec3<double>(std::cos(i), i, std::sin(2 * i)).template cast<S>());
    tracks.assign(2, {features, examples, controls});
  }
};

}  // namespace

TEST_CASE_TEMPLATE("band solver: agrees with a dense solve, and for one frame too", S, double, float) {
  for (const std::int32_t frames : {1, 2, 3, 9}) {
    detail::BandSolver<S, 3> band;
    band.bind(frames);
    Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> dense =
        Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>::Zero(3 * frames, 3 * frames);
    Eigen::Matrix<S, Eigen::Dynamic, 1> right = Eigen::Matrix<S, Eigen::Dynamic, 1>::LinSpaced(3 * frames, S(-1), S(2));
    std::vector<Vec3<S>> x;
    for (std::int32_t f = 0; f < frames; ++f) {
      typename detail::BandSolver<S, 3>::Row row;
      for (std::int32_t g = 0; g < 5; ++g) {
        auto& block = row[static_cast<std::size_t>(g)];
        block.setZero();
        const std::int32_t other = f + g - 2;
        if (other < 0 || other >= frames) continue;
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b) block(a, b) = static_cast<S>(std::sin(f + 3.0 * g + 5 * a + 7 * b));
        if (g == 2) block.diagonal().array() += S(12);
        dense.template block<3, 3>(3 * f, 3 * other) = block;
      }
      band.append(row);
      x.push_back(right.template segment<3>(3 * f));
    }
    band.solve_in_place(x);
    const Eigen::Matrix<S, Eigen::Dynamic, 1> expected = dense.partialPivLu().solve(right);
    for (std::int32_t f = 0; f < frames; ++f)
      CHECK((x[static_cast<std::size_t>(f)] - expected.template segment<3>(3 * f)).norm() <
            S(100) * std::numeric_limits<S>::epsilon());
  }
}

TEST_CASE("second differences: rows of D2'D2") {
  CHECK(detail::second_difference_row<double>(9, 4) == std::array<double, 5>{1, -4, 6, -4, 1});
  CHECK(detail::second_difference_row<double>(9, 0) == std::array<double, 5>{0, 0, 1, -2, 1});
  CHECK(detail::second_difference_row<double>(9, 1) == std::array<double, 5>{0, -2, 5, -4, 1});
  CHECK(detail::second_difference_row<double>(3, 1) == std::array<double, 5>{0, -2, 4, -2, 0});
  CHECK(detail::second_difference_row<double>(2, 1) == std::array<double, 5>{0, 0, 0, 0, 0});
}

TEST_CASE_TEMPLATE("spacetime: frames and constraint equations allocate nothing", S, double, float) {
  const Problem<S> problem;
  rigless::Constraints<S> constraints;
  constraints.push_back(rigless::position_constraint<S>(0, 8, Vec3<S>(1, 2, 3)));
  detail::SpacetimeOptions<S> options;
  options.track.offset_weight = S(0.05);
  detail::SpacetimeSolver<S> solver;
  REQUIRE(solver.begin(problem.tracks, 40, constraints, options).ok());
  const auto allocations = [&](std::int32_t frames) {
    const auto before = rigless::test::allocation_count;
    (void)solver.advance(frames);
    return rigless::test::allocation_count - before;
  };
  CHECK(allocations(1) > 0);  // the first track is bound
  for (int f = 1; f < 39; ++f) CHECK(allocations(1) == 0);
  CHECK(allocations(1) > 0);  // its solution
  (void)solver.advance(40);
  CHECK(allocations(40) == 0);  // the first two equations
  CHECK(allocations(40) == 0);
}

TEST_CASE("spacetime: what cannot be solved is named") {
  const Problem<double> problem;
  detail::SpacetimeSolver<double> solver;
  CHECK(solver.begin(problem.tracks, 0, {}, {}).error == rigless::Error::no_frames);
  auto tracks = problem.tracks;
  tracks[1].example_controls = {};
  CHECK(solver.begin(tracks, 40, {}, {}).error == rigless::Error::no_examples);
  tracks = problem.tracks;
  tracks[1].example_features = tracks[1].example_features.subspan(0, 19);
  auto status = solver.begin(tracks, 40, {}, {});
  CHECK(status.error == rigless::Error::size_mismatch);
  CHECK(status.where == 1);
  auto features = problem.features;
  features[7] = std::numeric_limits<double>::quiet_NaN();
  tracks = problem.tracks;
  tracks[0].features = features;
  CHECK(solver.begin(tracks, 40, {}, {}).error == rigless::Error::not_finite);
  rigless::Constraints<double> constraints;
  constraints.push_back(rigless::height_constraint<double>(0, 2, 5, 0));
  CHECK(solver.begin(problem.tracks, 40, constraints, {}).error == rigless::Error::bad_constraint);
  constraints[0] = rigless::height_constraint<double>(0, 1, 5, std::numeric_limits<double>::infinity());
  CHECK(solver.begin(problem.tracks, 40, constraints, {}).error == rigless::Error::bad_constraint);
}

TEST_CASE("spacetime: the weights of every frame sum to 1") {
  const Problem<double> problem;
  detail::SpacetimeSolver<double> solver;
  REQUIRE(solver.begin(problem.tracks, 40, {}, {}).ok());
  while (solver.advance(11)) {
  }
  REQUIRE(solver.finish().ok());
  for (std::size_t f = 0; f < 40; ++f) {
    double sum = 0;
    Vec3<double> c(0, 0, 0);
    for (std::size_t n = 0; n < 5; ++n) {
      sum += solver.weights(0)[f * 5 + n];
      c += solver.weights(0)[f * 5 + n] * problem.controls[n];
    }
    CHECK(sum == doctest::Approx(1).epsilon(1e-12));
    CHECK((c - solver.track(0)[f]).norm() < 1e-9);
  }
}
