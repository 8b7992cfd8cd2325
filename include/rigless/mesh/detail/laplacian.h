// Edge weights: how strongly each vertex holds each of its neighbours.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "rigless/mesh/detail/one_ring.h"

namespace rigless::detail {

// Bounds on a cotangent weight. Below: negative weights make the energy unbounded (obtuse triangles). Above: a needle
// triangle must not drown its neighbours in single precision.
template <class S>
struct WeightBounds {
  S lowest = S(1e-3);
  S highest = S(1e3);
};

// Cotangent of the angle at a in triangle a b c; 0 for a triangle without area.
template <class S>
S corner_cotangent(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& c) {
  const Vec3<S> u = b - a;
  const Vec3<S> v = c - a;
  const S area2 = u.cross(v).norm();
  return area2 > std::numeric_limits<S>::min() ? u.dot(v) / area2 : S(0);
}

// w_ij = (cot alpha + cot beta) / 2, clamped; one per directed edge of the ring, symmetric. Edges that no face uses get
// the lowest weight. Allocates the result.
// Source: Pinkall and Polthier 1993; thesis section 2.1.1; the clamp: negative weights let the energy run away.
template <class S>
RIGLESS_COLD std::vector<S> cotangent_weights(Span<const Vec3<S>> vertices, Span<const Face> faces, const OneRing& ring,
                                              const WeightBounds<S>& bounds = {}) {
  std::vector<S> w(to_size(ring.edges()), S(0));
  const auto at = [&](std::int32_t v) -> const Vec3<S>& { return nth(vertices, v); };
  for (const Face& f : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t i = f[(k + 1) % 3], j = f[(k + 2) % 3];
      if (i == j) continue;
      const S half = corner_cotangent<S>(at(f[k]), at(i), at(j)) / S(2);
      nth(w, ring.slot(i, j)) += half;
      nth(w, ring.slot(j, i)) += half;
    }
  }
  for (S& x : w) x = std::min(std::max(x, bounds.lowest), bounds.highest);
  return w;
}

// w_ij = 1: symmetric, the plain graph Laplacian. Allocates the result.
template <class S>
std::vector<S> uniform_weights(const OneRing& ring) {
  return std::vector<S>(to_size(ring.edges()), S(1));
}

}  // namespace rigless::detail
