#include "rigless/math/detail/rotation.h"

#include <doctest/doctest.h>

#include <random>

#include "support/json.h"

using namespace rigless;
using namespace rigless::detail;

TEST_CASE("nearest_rotation agrees with the golden rotations") {
  const json::Value golden = json::parse_file(RIGLESS_TEST_DIR "golden/rotations.json");
  REQUIRE(golden["items"].size() > 5);
  for (const json::Value& item : golden["items"].array()) {
    CAPTURE(item["note"].string());
    Mat3<double> C, expected;
    for (int r = 0; r < 3; ++r) {
      C.row(r) = item["C"][r].vec3<double>().transpose();
      expected.row(r) = item["R"][r].vec3<double>().transpose();
    }
    const Mat3<double> R = nearest_rotation(C);
    CHECK((R * C).trace() == doctest::Approx(item["trace_RC"].number()).epsilon(1e-9));
    CHECK(R.determinant() == doctest::Approx(1).epsilon(1e-9));
    CHECK((R.transpose() * R - Mat3<double>::Identity()).norm() < 1e-12);
    if (item["unique"].boolean()) CHECK((R - expected).cwiseAbs().maxCoeff() < 1e-9);

    const Mat3<float> single = nearest_rotation<float>(C.cast<float>());
    if (item["unique"].boolean()) CHECK((single.cast<double>() - expected).cwiseAbs().maxCoeff() < 1e-5);
  }
}

TEST_CASE_TEMPLATE("svd3 rebuilds random, flat, thin and tiny matrices", S, float, double) {
  std::mt19937 random(7);
  std::uniform_real_distribution<S> uniform(-1, 1);
  const S eps = std::numeric_limits<S>::epsilon();
  for (int trial = 0; trial < 3000; ++trial) {
    Mat3<S> A;
    for (int k = 0; k < 9; ++k) A(k) = uniform(random);
    if (trial % 5 == 1) A.col(2) = A.col(0) - S(0.5) * A.col(1);
    if (trial % 5 == 2) A = A.col(0) * A.row(1);
    if (trial % 5 == 3) A *= S(1e-18);
    if (trial % 5 == 4) A = A * A.transpose();
    const Svd3<S> svd = svd3(A);
    const S size = A.norm();
    CHECK((svd.U * svd.sigma.asDiagonal() * svd.V.transpose() - A).norm() <= S(20) * eps * size);
    CHECK((svd.U.transpose() * svd.U - Mat3<S>::Identity()).norm() <= S(200) * eps);
    CHECK((svd.V.transpose() * svd.V - Mat3<S>::Identity()).norm() <= S(20) * eps);
    CHECK(svd.V.determinant() > S(0.9));
    CHECK(svd.sigma[0] >= svd.sigma[1]);
    CHECK(svd.sigma[1] >= svd.sigma[2]);
    CHECK(svd.sigma[2] >= S(0));
  }
}

TEST_CASE("svd3 of zero is the identity") {
  const Svd3<double> svd = svd3<double>(Mat3<double>::Zero());
  CHECK(svd.U == Mat3<double>::Identity());
  CHECK(svd.sigma.norm() == 0);
}
