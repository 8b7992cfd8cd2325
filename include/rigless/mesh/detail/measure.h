// Sizes of a triangle mesh.
#pragma once

#include "rigless/math/span.h"
#include "rigless/math/types.h"

namespace rigless::detail {

template <class S>
struct Bounds {
  Vec3<S> low = Vec3<S>::Zero();
  Vec3<S> high = Vec3<S>::Zero();

  Vec3<S> extent() const { return high - low; }
  S height() const { return high.y() - low.y(); }
  S diagonal() const { return extent().norm(); }
};

// Axis-aligned bounds; zeros for no vertices. No allocation.
template <class S>
Bounds<S> bounds(Span<const Vec3<S>> vertices) {
  Bounds<S> b;
  if (vertices.empty()) return b;
  b.low = b.high = vertices[0];
  for (const Vec3<S>& v : vertices) {
    b.low = b.low.cwiseMin(v);
    b.high = b.high.cwiseMax(v);
  }
  return b;
}

// sum over faces a.(b x c) / 6: the volume of a closed surface with outward faces; meaningless for an open one.
// Summed in double, from the first vertex, so that float coordinates far from the origin lose nothing. No allocation.
template <class S>
S signed_volume(Span<const Vec3<S>> vertices, Span<const Face> faces) {
  if (vertices.empty()) return S(0);
  const Eigen::Vector3d origin = vertices[0].template cast<double>();
  double six = 0;
  for (const Face& f : faces) {
    const Eigen::Vector3d a = nth(vertices, f[0]).template cast<double>() - origin;
    const Eigen::Vector3d b = nth(vertices, f[1]).template cast<double>() - origin;
    const Eigen::Vector3d c = nth(vertices, f[2]).template cast<double>() - origin;
    six += a.dot(b.cross(c));
  }
  return static_cast<S>(six / 6);
}

// Sum of the face areas. No allocation.
template <class S>
S surface_area(Span<const Vec3<S>> vertices, Span<const Face> faces) {
  double twice = 0;
  for (const Face& f : faces) {
    const Vec3<S>& a = nth(vertices, f[0]);
    twice += static_cast<double>((nth(vertices, f[1]) - a).cross(nth(vertices, f[2]) - a).norm());
  }
  return static_cast<S>(twice / 2);
}

}  // namespace rigless::detail
