// How a solid takes the vertices of a model along. The formulas stand in solid.h.
#pragma once

#include "rigless/math/detail/simd.h"
#include "rigless/mesh/solid.h"

namespace rigless {

namespace detail {

// Factors of the weights of the eight corners at a vertex, and what is between it and them: [1] for the far side.
template <class S>
struct Hats {
  S away[3][2];  // v - rest
  S hat[3][2];
  S slope[3];  // of hat[a][1]; that of hat[a][0] is opposite

  RIGLESS_INNER Hats(const Vec3<S>& v, const Vec3<S>& rest_0, S cell) {
    const S inverse = S(1) / cell;
    for (int a = 0; a < 3; ++a) {
      away[a][0] = v[a] - rest_0[a];
      away[a][1] = away[a][0] - cell;
      const S x = std::min(std::max(away[a][0] * inverse, S(0)), S(1));
      hat[a][1] = x * x * (S(3) - S(2) * x);
      hat[a][0] = S(1) - hat[a][1];
      slope[a] = S(6) * x * (S(1) - x) * inverse;
    }
  }
};

// By reference, since compilers disagree on how such a vector of double is returned.
template <class S>
RIGLESS_INNER void load(const S* numbers, simd::Quad<S>& out) {
  std::memcpy(&out, numbers, sizeof out);
}

// Sums over the corners, four numbers at a time, of which three count: the columns of A begin at 0, 3 and 6, and 8 is
// one before p. Columns are summed by the side of their axis the corner is on: all there have the same v - rest along
// it.
template <class S>
struct PointSum {
  simd::Quad<S> column[3][2] = {}, moved = {};

  template <int x, int y, int z>
  RIGLESS_INNER void add(const Hats<S>& hats, const S* numbers) {
    const S w = hats.hat[0][x] * hats.hat[1][y] * hats.hat[2][z];
    simd::Quad<S> A[3], p;
    for (int a = 0; a < 3; ++a) load(numbers + 3 * a, A[a]);
    load(numbers + 8, p);
    column[0][x] += w * A[0];
    column[1][y] += w * A[1];
    column[2][z] += w * A[2];
    moved += w * p;
  }
  RIGLESS_INNER Vec3<S> point(const Hats<S>& hats) const {
    simd::Quad<S> turned = {};
    for (int a = 0; a < 3; ++a) turned += hats.away[a][0] * column[a][0] + hats.away[a][1] * column[a][1];
    return {turned[0] + moved[1], turned[1] + moved[2], turned[2] + moved[3]};
  }
};

// Columns of F. The slopes sum to 0, so positions may count from that of corner 0.
template <class S>
struct GradientSum {
  simd::Quad<S> origin, column[3] = {}, moved[3] = {};

  template <int x, int y, int z>
  RIGLESS_INNER void add(const Hats<S>& hats, const S* numbers) {
    const S yz = hats.hat[1][y] * hats.hat[2][z], w = hats.hat[0][x] * yz;
    const S slope[3] = {(x ? hats.slope[0] : -hats.slope[0]) * yz,
                        (y ? hats.slope[1] : -hats.slope[1]) * (hats.hat[0][x] * hats.hat[2][z]),
                        (z ? hats.slope[2] : -hats.slope[2]) * (hats.hat[0][x] * hats.hat[1][y])};
    simd::Quad<S> A[3], p;
    for (int a = 0; a < 3; ++a) load(numbers + 3 * a, A[a]);
    load(numbers + 8, p);
    p -= origin;
    const simd::Quad<S> q = hats.away[0][x] * A[0] + hats.away[1][y] * A[1] + hats.away[2][z] * A[2];
    for (int a = 0; a < 3; ++a) {
      column[a] += w * A[a] + slope[a] * q;
      moved[a] += slope[a] * p;
    }
  }
  RIGLESS_INNER Vec3<S> gradient(int a) const {
    return {column[a][0] + moved[a][1], column[a][1] + moved[a][2], column[a][2] + moved[a][3]};
  }
};

template <class S, class Sum>
RIGLESS_INNER void sum_corners(const Hats<S>& hats, const std::array<std::int32_t, 8>& corner,
                               const NodeTransform<S>* transforms, Sum& sum) {
  sum.template add<0, 0, 0>(hats, transforms[corner[0]].A.data());
  sum.template add<1, 0, 0>(hats, transforms[corner[1]].A.data());
  sum.template add<0, 1, 0>(hats, transforms[corner[2]].A.data());
  sum.template add<1, 1, 0>(hats, transforms[corner[3]].A.data());
  sum.template add<0, 0, 1>(hats, transforms[corner[4]].A.data());
  sum.template add<1, 0, 1>(hats, transforms[corner[5]].A.data());
  sum.template add<0, 1, 1>(hats, transforms[corner[6]].A.data());
  sum.template add<1, 1, 1>(hats, transforms[corner[7]].A.data());
}

template <class S>
RIGLESS_INNER Vec3<S> carried_point(const Solid<S>& solid, std::int32_t element, const Vec3<S>& v,
                                    const NodeTransform<S>* transforms) {
  const auto& corner = solid.element[static_cast<std::size_t>(element)];
  const Hats<S> hats(v, solid.rest[static_cast<std::size_t>(corner[0])], solid.cell);
  PointSum<S> sum;
  sum_corners(hats, corner, transforms, sum);
  return sum.point(hats);
}

template <class S>
RIGLESS_INNER GradientSum<S> carried_gradient(const Solid<S>& solid, std::int32_t element, const Vec3<S>& v,
                                              const NodeTransform<S>* transforms) {
  const auto& corner = solid.element[static_cast<std::size_t>(element)];
  const Hats<S> hats(v, solid.rest[static_cast<std::size_t>(corner[0])], solid.cell);
  GradientSum<S> sum;
  load(transforms[corner[0]].A.data() + 8, sum.origin);
  sum_corners(hats, corner, transforms, sum);
  return sum;
}

template <class S>
RIGLESS_INNER Vec3<S> unit_or(const Vec3<S>& v, const Vec3<S>& otherwise) {
  const S length2 = v.squaredNorm();
  return length2 > std::numeric_limits<S>::min() && std::isfinite(length2) ? Vec3<S>(v / std::sqrt(length2))
                                                                           : otherwise;
}

}  // namespace detail

template <class S>
void carry_points(const Solid<S>& solid, Span<const Vec3<S>> vertices, Span<const NodeTransform<S>> transforms,
                  Span<Vec3<S>> out) {
  RIGLESS_ASSERT(vertices.size() == solid.element_of.size() && out.size() == vertices.size());
  RIGLESS_ASSERT(transforms.size() == solid.rest.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::int32_t e = solid.element_of[v];
    out[v] = e < 0 ? vertices[v] : detail::carried_point(solid, e, vertices[v], transforms.data());
  }
}

template <class S>
void carry_normals(const Solid<S>& solid, Span<const Vec3<S>> vertices, Span<const NodeTransform<S>> transforms,
                   Span<const Vec3<S>> normals, Span<Vec3<S>> out) {
  RIGLESS_ASSERT(vertices.size() == solid.element_of.size() && normals.size() == vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::int32_t e = solid.element_of[v];
    const Vec3<S> n = normals[v];
    out[v] = n;
    if (e < 0) continue;
    const auto sum = detail::carried_gradient(solid, e, vertices[v], transforms.data());
    const Vec3<S> f0 = sum.gradient(0), f1 = sum.gradient(1), f2 = sum.gradient(2);
    out[v] = detail::unit_or<S>(n[0] * f1.cross(f2) + n[1] * f2.cross(f0) + n[2] * f0.cross(f1), n);
  }
}

template <class S>
void carry_tangents(const Solid<S>& solid, Span<const Vec3<S>> vertices, Span<const NodeTransform<S>> transforms,
                    Span<const Vec3<S>> tangents, Span<Vec3<S>> out) {
  RIGLESS_ASSERT(vertices.size() == solid.element_of.size() && tangents.size() == vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::int32_t e = solid.element_of[v];
    const Vec3<S> t = tangents[v];
    out[v] = t;
    if (e < 0) continue;
    const auto sum = detail::carried_gradient(solid, e, vertices[v], transforms.data());
    out[v] = detail::unit_or<S>(t[0] * sum.gradient(0) + t[1] * sum.gradient(1) + t[2] * sum.gradient(2), t);
  }
}

}  // namespace rigless
