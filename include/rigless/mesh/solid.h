// A solid inside any model: cubes that fill it, whatever its triangles are. The solid is deformed; the model rides
// along.
#pragma once

#include "rigless/math/status.h"
#include "rigless/mesh/detail/build_solid.h"

namespace rigless {

struct SolidOptions {
  std::int32_t nodes = 3000;  // about that many come out: 2,000 to 4,000 are fine for a body, fewer fuse its fingers
};

// N nodes, the corners of E elements, which are cubes at rest. Elements share nodes where they hang together; where two
// sheets of a model nearly touch, each has elements of its own at the same place.
template <class S>
struct Solid {
  S cell = S(0);              // edge of an element
  std::vector<Vec3<S>> rest;  // N
  // E: the node at corner k, which lies (k & 1, k >> 1 & 1, k >> 2 & 1) cells from the corner 0
  std::vector<std::array<std::int32_t, 8>> element;
  std::vector<char> inside;              // E: 1 where no triangle passes
  std::vector<std::int32_t> element_of;  // V: the element that carries a vertex, or -1: it stays where it is
  // The graph that is solved: edges of elements with weight 1, and bridges to parts that float.
  detail::SolidRing ring;
  std::vector<S> weight;  // of directed edges, symmetric, above 0

  static constexpr S bridge = S(0.02);  // weight of a bridge

  std::int32_t nodes() const { return count_of(rest); }
  std::int32_t elements() const { return count_of(element); }
};

// A solid from V vertices and F faces: soup, open, wound either way, many shells. What is far from the rest and a
// ground under it stay out. The same on every machine. Allocates; `out` stays as it was on failure. Errors: no_faces
// (also when they have no size); index_out_of_range (face); not_finite (vertex, also one so far out that its square is
// no number). Source: Zollhoefer, Sert, Greiner and Suessmuth 2012, "GPU based ARAP deformation using volumetric
// lattices".
template <class S>
RIGLESS_COLD Status build_solid(Span<const Vec3<S>> vertices, Span<const Face> faces, const SolidOptions& options,
                                Solid<S>& out) {
  if (const Status s = check_faces(faces, count_of(vertices)); !s.ok()) return s;
  Vec3<S> low = nth(vertices, faces[0][0]), high = low;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (!std::isfinite(vertices[v].squaredNorm())) return {Error::not_finite, v};
  }
  for (const Face& f : faces) {
    for (const std::int32_t v : f) {
      low = low.cwiseMin(nth(vertices, v));
      high = high.cwiseMax(nth(vertices, v));
    }
  }
  const S size = (high - low).maxCoeff(), far = low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff();
  constexpr S least = S(1e6) * std::numeric_limits<S>::min(), precise = S(1e3) * std::numeric_limits<S>::epsilon();
  if (!(size * size > least && size > precise * far)) return {Error::no_faces, -1};
  const detail::Lattice lattice = detail::build_lattice<S>(vertices, faces, options.nodes);
  Solid<S> solid;
  solid.cell = static_cast<S>(lattice.grid.cell);
  for (const Vec3<double>& p : lattice.node) solid.rest.push_back(p.template cast<S>());
  solid.element = lattice.element;
  solid.inside = lattice.inside;
  solid.element_of = lattice.element_of;
  auto pairs = lattice.edges;
  pairs.insert(pairs.end(), lattice.bridges.begin(), lattice.bridges.end());
  solid.ring = one_ring_from_pairs(pairs, solid.nodes());
  solid.weight.assign(solid.ring.neighbor.size(), S(1));
  for (const auto& [a, b] : lattice.bridges) {
    nth(solid.weight, solid.ring.slot(a, b)) = Solid<S>::bridge;
    nth(solid.weight, solid.ring.slot(b, a)) = Solid<S>::bridge;
  }
  out = std::move(solid);
  return {};
}

}  // namespace rigless
