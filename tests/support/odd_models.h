// Parts to make models of as people have them: of many shells, torn, far apart, wound any way.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "rigless/math/span.h"
#include "rigless/math/types.h"

namespace rigless::test {

template <class S>
struct Model {
  std::vector<Vec3<S>> vertices;
  std::vector<Face> faces;

  void add(const Model& other) {
    const auto base = static_cast<std::int32_t>(vertices.size());
    vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Face& f : other.faces) faces.push_back({f[0] + base, f[1] + base, f[2] + base});
  }
  Model moved(const Vec3<S>& by) const {
    Model out = *this;
    for (Vec3<S>& v : out.vertices) v += by;
    return out;
  }
};

// n x n quads over a unit square, placed by at(u, v); normals along d/du x d/dv.
template <class S, class At>
Model<S> patch(int n, const At& at) {
  Model<S> m;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) m.vertices.push_back(at(static_cast<S>(i) / S(n), static_cast<S>(j) / S(n)));
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      m.faces.push_back({a, b, b + 1});
      m.faces.push_back({a, b + 1, a + 1});
    }
  }
  return m;
}

// The vertices at one place become one.
template <class S>
Model<S> welded(const Model<S>& m) {
  Model<S> out;
  std::vector<std::int32_t> to;
  for (const Vec3<S>& v : m.vertices) {
    std::size_t k = 0;
    while (k < out.vertices.size() && (out.vertices[k] - v).squaredNorm() > S(1e-10)) ++k;
    if (k == out.vertices.size()) out.vertices.push_back(v);
    to.push_back(static_cast<std::int32_t>(k));
  }
  for (const Face& f : m.faces) {
    const Face g = {nth(to, f[0]), nth(to, f[1]), nth(to, f[2])};
    if (g[0] != g[1] && g[1] != g[2] && g[2] != g[0]) out.faces.push_back(g);
  }
  return out;
}

// A closed ball or egg, a cube whose sides are blown up.
template <class S>
Model<S> ball(const Vec3<S>& center, const Vec3<S>& radii, int n = 12) {
  Model<S> m;
  for (int axis = 0; axis < 3; ++axis) {
    for (const S side : {S(1), S(-1)}) {
      m.add(patch<S>(n, [&](S u, S v) {
        Vec3<S> p;
        p[axis] = side;
        p[(axis + 1) % 3] = (2 * u - 1) * side;
        p[(axis + 2) % 3] = 2 * v - 1;
        return Vec3<S>(center + p.normalized().cwiseProduct(radii));
      }));
    }
  }
  return welded(m);
}

// A closed box of n x n quads a side.
template <class S>
Model<S> box(const Vec3<S>& low, const Vec3<S>& high, int n = 1) {
  Model<S> m;
  for (int axis = 0; axis < 3; ++axis) {
    for (const S side : {S(1), S(-1)}) {
      m.add(patch<S>(n, [&](S u, S v) {
        Vec3<S> p;
        p[axis] = side > 0 ? S(1) : S(0);
        p[(axis + 1) % 3] = side > 0 ? u : 1 - u;
        p[(axis + 2) % 3] = v;
        return Vec3<S>(low + p.cwiseProduct(high - low));
      }));
    }
  }
  return welded(m);
}

// Every triangle with vertices of its own, in any order and wound any way.
template <class S>
Model<S> soup(const Model<S>& m) {
  Model<S> out;
  std::mt19937 random(7);
  for (Face f : m.faces) {
    if (random() % 2 == 0) std::swap(f[1], f[2]);
    const auto base = static_cast<std::int32_t>(out.vertices.size());
    for (const std::int32_t v : f) out.vertices.push_back(nth(m.vertices, v));
    out.faces.push_back({base, base + 1, base + 2});
  }
  return out;
}

// A body of eggs, two units high, standing on y = 0; its legs leave `gap` free between them.
template <class S>
Model<S> mannequin(S gap) {
  Model<S> m;
  m.add(ball<S>({0, S(1.2), 0}, {S(.3), S(.45), S(.2)}));
  m.add(ball<S>({0, S(1.8), 0}, {S(.16), S(.2), S(.16)}));
  for (const S side : {S(1), S(-1)}) {
    m.add(ball<S>({side * S(.65), S(1.4), 0}, {S(.45), S(.09), S(.09)}));
    m.add(ball<S>({side * (S(.12) + gap / 2), S(.5), 0}, {S(.12), S(.5), S(.12)}));
  }
  return m;
}

}  // namespace rigless::test
