// Few shapes that are mixed, for a mesh that moves.
#include "rigless/skin/detail/morph_builder.h"

#include <doctest/doctest.h>

#include "support/advance.h"
#include "support/cylinder.h"

using namespace rigless;
using namespace rigless::test;
using rigless::detail::MorphBuilder;
using rigless::detail::MorphOptions;
using rigless::detail::Morphs;

namespace {

template <class S>
struct MovingMesh {
  std::vector<Vec3<S>> rest;
  std::vector<std::vector<Vec3<S>>> frames;
};

// A pole that squashes, bulges and sways while it travels and turns; each is one shape, mixed in by a curve of its own.
template <class S>
MovingMesh<S> squashed(int frames, int shapes = 3) {
  MovingMesh<S> out;
  const Cylinder c(12, 17);
  for (const auto& v : c.vertices) out.rest.push_back(v.cast<S>());
  for (int f = 0; f < frames; ++f) {
    const double angle = 0.2 * f;
    const Mat3<double> whole = Eigen::AngleAxisd(angle, Vec3<double>::UnitY()).toRotationMatrix();
    out.frames.emplace_back();
    for (const Vec3<double>& v : c.vertices) {
      Vec3<double> p = v;
      for (int k = 1; k <= shapes; ++k) {
        const double much = 0.3 * std::sin(0.7 * k * f + k) / k, wave = std::sin(k * v.y());
        p += much * Vec3<double>(v.x() * wave, k == 1 ? -0.5 * (v.y() - 2) : 0, v.z() * wave);
      }
      out.frames.back().push_back((whole * p + Vec3<double>(0.3 * f, 1, 0)).cast<S>());
    }
  }
  return out;
}

template <class S>
Status build_morphs(const MovingMesh<S>& dance, Morphs<S>& out, const MorphOptions& options = {}) {
  MorphBuilder<S> builder;
  if (const Status s = builder.begin(dance.rest, options); !s.ok()) return s;
  if (const Status s = build_from<S>(builder, dance.frames); !s.ok()) return s;
  out = builder.morphs();
  return {};
}

// In diagonals, as an engine plays it: what Morphs promises, worked out anew.
template <class S>
std::pair<double, double> morph_likeness(const Morphs<S>& m, const MovingMesh<S>& dance) {
  double sum = 0, worst = 0;
  const std::size_t V = dance.rest.size(), K = to_size(m.targets);
  for (std::size_t f = 0; f < dance.frames.size(); ++f) {
    for (std::size_t v = 0; v < V; ++v) {
      Vec3<S> p = dance.rest[v];
      for (std::size_t k = 0; k < K; ++k) p += m.weight[f * K + k] * m.way[k * V + v];
      p = m.root[f].turn * p + m.root[f].place;
      const double missed = static_cast<double>((p - dance.frames[f][v]).squaredNorm());
      sum += missed;
      worst = std::max(worst, missed);
    }
  }
  const double diagonal = Vec3<double>(1, 4, 1).norm();
  return {std::sqrt(sum / static_cast<double>(dance.frames.size() * V)) / diagonal, std::sqrt(worst) / diagonal};
}

}  // namespace

TEST_CASE_TEMPLATE("a mix of three shapes gets few targets, which play it", S, float, double) {
  const MovingMesh<S> dance = squashed<S>(40);
  Morphs<S> morphs;
  REQUIRE(build_morphs(dance, morphs).ok());
  CHECK(morphs.targets >= 2);
  CHECK(morphs.targets <= 5);
  CHECK(morphs.weight.size() == 40 * to_size(morphs.targets));
  S most = 0;
  for (const S w : morphs.weight) most = std::max(most, std::abs(w));
  CHECK(most == doctest::Approx(1));
  const auto [rms, worst] = morph_likeness(morphs, dance);
  CHECK(rms <= 0.0013);
  CHECK(worst <= 0.008);
  CHECK(morphs.rms == doctest::Approx(rms).epsilon(0.02));
  CHECK(morphs.worst == doctest::Approx(worst).epsilon(0.02));
}

TEST_CASE("more targets are more alike, never more than were asked for") {
  const MovingMesh<double> dance = squashed<double>(60, 12);
  double last = 1;
  for (const std::int32_t targets : {1, 2, 4, 8}) {
    Morphs<double> morphs;
    MorphOptions options;
    options.targets = targets;
    options.rms = options.worst = 0;
    REQUIRE(build_morphs(dance, morphs, options).ok());
    CHECK(morphs.targets == targets);
    CHECK(morph_likeness(morphs, dance).first < last);
    last = morph_likeness(morphs, dance).first;
  }
}

TEST_CASE("what only travels and turns needs no shape of its own") {
  const MovingMesh<double> dance = squashed<double>(20, 0);
  Morphs<double> morphs;
  REQUIRE(build_morphs(dance, morphs).ok());
  CHECK(morphs.targets == 1);
  CHECK(morph_likeness(morphs, dance).second < 1e-9);
}

TEST_CASE("bad input ends with an error, none with nothing") {
  MorphBuilder<double> builder;
  CHECK(builder.begin({}).error == Error::empty_input);
  const MovingMesh<double> dance = squashed<double>(1);
  REQUIRE(builder.begin(dance.rest).ok());
  CHECK_FALSE(builder.advance());
  const std::vector<Vec3<double>> few(3, Vec3<double>::Zero());
  CHECK(builder.add_frame(few).error == Error::size_mismatch);
  std::vector<Vec3<double>> bad = dance.rest;
  bad[5].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(builder.add_frame(bad).error == Error::not_finite);
}
