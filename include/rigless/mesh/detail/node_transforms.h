// The affine maps of the nodes of a deformed solid, as many at once as a register holds, and its volume.
#pragma once

#include "rigless/math/detail/rotation_lanes.h"
#include "rigless/mesh/solid.h"

namespace rigless {

namespace detail {

// Mean present edges of a node along the three axes, in cells: columns of E.
template <class S>
Mat3<S> mean_edges(const Solid<S>& solid, Span<const Vec3<S>> now, std::size_t node) {
  Mat3<S> E = Mat3<S>::Zero();
  int count[3] = {0, 0, 0};
  for (auto k = to_size(solid.ring.first[node]); k < to_size(solid.ring.first[node + 1]); ++k) {
    if (solid.weight[k] < S(1)) continue;
    const auto j = to_size(solid.ring.neighbor[k]);
    const Vec3<S> along = solid.rest[j] - solid.rest[node];
    const Vec3<S> edge = now[j] - now[node];
    for (int a = 0; a < 3; ++a) {
      if (S(2) * std::abs(along[a]) < solid.cell) continue;
      E.col(a) += along[a] > S(0) ? edge : Vec3<S>(-edge);
      ++count[a];
    }
  }
  for (int a = 0; a < 3; ++a) E.col(a) *= S(1) / (static_cast<S>(count[a]) * solid.cell);
  return E;
}

// The rotation nearest to each matrix, from itself: the mean with its inverse transposed, again and again. Lanes that
// are inverted, nearly flat or not there after eight rounds are marked by a 0. Source: Higham 1986, "Computing the
// polar decomposition".
template <class S>
RIGLESS_INNER simd::Lanes<S> polar_rotation(MatrixLanes<S>& X) {
  using L = simd::Lanes<S>;
  const L one = simd::splat<L>(S(1));
  L fine = one, length2 = {};
  for (int round = 0; round < 8; ++round) {
    L cofactor[9];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        cofactor[3 * i + a] = X.m[3 * j + b] * X.m[3 * k + c] - X.m[3 * j + c] * X.m[3 * k + b];
      }
    }
    const L det = X.m[0] * cofactor[0] + X.m[1] * cofactor[1] + X.m[2] * cofactor[2];
    if (round == 0) fine = simd::select(det > S(0.01), one, L{});
    const L half = S(0.5) / simd::select(det > S(0.01), det, one);
    length2 = L{};
    for (int i = 0; i < 9; ++i) {
      X.m[i] = S(0.5) * X.m[i] + half * cofactor[i];
      length2 += X.m[i] * X.m[i];
    }
    if (!simd::any(length2 - S(3) > S(1e-6))) break;
  }
  return simd::select(length2 - S(3) < S(1e-3), fine, L{});
}

}  // namespace detail

template <class S>
void node_transforms(const Solid<S>& solid, Span<const Vec3<S>> now, Span<NodeTransform<S>> out) {
  RIGLESS_ASSERT(now.size() == solid.rest.size() && out.size() == now.size());
  constexpr auto width = static_cast<std::size_t>(detail::simd::width<S>);
  constexpr S to_rotation = S(0.02);
  for (std::size_t begin = 0; begin < now.size(); begin += width) {
    const std::size_t count = std::min(width, now.size() - begin);
    detail::MatrixLanes<S> R = {};
    for (std::size_t k = 0; k < count; ++k) {
      NodeTransform<S>& t = out[begin + k];
      t.A = detail::mean_edges(solid, now, begin + k);
      t.p = now[begin + k];
      for (int i = 0; i < 9; ++i) R.m[i][static_cast<int>(k)] = t.A(i / 3, i % 3);
    }
    const detail::simd::Lanes<S> fine = detail::polar_rotation(R);
    for (std::size_t k = 0; k < count; ++k) {
      const int lane = static_cast<int>(k);
      Mat3<S>& A = out[begin + k].A;
      Mat3<S> rotation;
      if (fine[lane] > S(0)) {
        for (int i = 0; i < 9; ++i) rotation(i / 3, i % 3) = R.m[i][lane];
      } else {
        rotation = detail::nearest_rotation<S>(A.transpose());
      }
      A += to_rotation * (rotation - A);
    }
  }
}

template <class S>
S volume(const Solid<S>& solid, Span<const Vec3<S>> now) {
  constexpr int ways[6][2] = {{1, 2}, {2, 4}, {4, 1}, {2, 1}, {4, 2}, {1, 4}};  // from corner 0 to 7 over two others
  double six = 0;
  for (const auto& corner : solid.element) {
    const auto from_low = [&](int k) -> Vec3<double> {
      return (nth(now, nth(corner, k)) - nth(now, corner[0])).template cast<double>();
    };
    for (int k = 0; k < 6; ++k) {
      const Vec3<double> a = from_low(ways[k][0]), b = from_low(ways[k][0] | ways[k][1]), c = from_low(7);
      six += (k < 3 ? 1 : -1) * a.cross(b).dot(c);
    }
  }
  return static_cast<S>(six / 6);
}

}  // namespace rigless
