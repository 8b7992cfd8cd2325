// A solid inside any model: cubes that fill it, whatever its triangles are. The solid is deformed; the model rides
// along.
#pragma once

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
  if (const Status s = detail::check_faces(faces, count_of(vertices)); !s.ok()) return s;
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
  solid.ring = detail::one_ring_from_pairs(pairs, solid.nodes());
  solid.weight.assign(solid.ring.neighbor.size(), S(1));
  for (const auto& [a, b] : lattice.bridges) {
    nth(solid.weight, solid.ring.slot(a, b)) = Solid<S>::bridge;
    nth(solid.weight, solid.ring.slot(b, a)) = Solid<S>::bridge;
  }
  out = std::move(solid);
  return {};
}

// How a node and what is around it have moved: a point near node i goes to p + A (point - rest_i). 12 numbers, A column
// by column and then p, and nothing else.
template <class S>
struct NodeTransform {
  Mat3<S> A;
  Vec3<S> p;
};
static_assert(sizeof(NodeTransform<float>) == 12 * sizeof(float));

// N transforms from N present positions: p is the node's, A = .98 E + .02 R, where column a of E is the mean of the
// node's present edges along axis a (those of the elements, turned to point along +a, bridges aside) divided by `cell`,
// and R the rotation nearest to E. No allocation.
template <class S>
void node_transforms(const Solid<S>& solid, Span<const Vec3<S>> now, Span<NodeTransform<S>> out);

// Where the V vertices that the solid was built from go. With rest_k and (A_k, p_k) of the node at corner k of a
// vertex' element, in this order:
//   x = (v - rest_0) / cell, clamped to 0 .. 1 on each axis       h(x) = x x (3 - 2 x)
//   w_k = product over the axes a of (k >> a & 1 ? h(x_a) : 1 - h(x_a))       the eight sum to 1
//   v'  = sum_k w_k (p_k + A_k (v - rest_k))
// Vertices without an element stay. `out` may be `vertices`. No allocation.
// Source: Sumner, Schmid and Pauly 2007, "Embedded deformation for shape manipulation", with hats for weights.
template <class S>
void carry_points(const Solid<S>& solid, Span<const Vec3<S>> vertices, Span<const NodeTransform<S>> transforms,
                  Span<Vec3<S>> out);

// The gradient of that map at each vertex,
//   F = sum_k (w_k A_k + (p_k + A_k (v - rest_k)) grad_k^T)
//   grad_k along a = (k >> a & 1 ? 1 : -1) h'(x_a) / cell times the other two factors of w_k,   h'(x) = 6 x (1 - x)
// takes tangents with it, and its cofactors (column a: the cross product of the columns a + 1 and a + 2 of F) take
// normals. What comes out has length 1, or is what went in where F has no such direction. `vertices` are at rest; `out`
// may be what goes in. No allocation.
template <class S>
void carry_normals(const Solid<S>& solid, Span<const Vec3<S>> vertices, Span<const NodeTransform<S>> transforms,
                   Span<const Vec3<S>> normals, Span<Vec3<S>> out);
template <class S>
void carry_tangents(const Solid<S>& solid, Span<const Vec3<S>> vertices, Span<const NodeTransform<S>> transforms,
                    Span<const Vec3<S>> tangents, Span<Vec3<S>> out);

// Volume of all elements at N present positions of the nodes; duplicates count each. No allocation.
template <class S>
S volume(const Solid<S>& solid, Span<const Vec3<S>> now);

// Vertices among which the lowest of the carried model is, in any pose and to within a few hundredths of a cell: those
// that stand out of their element in one of 26 directions, and not less than what is around. Some thousands, whatever V
// is. Allocates.
template <class S>
std::vector<std::int32_t> outermost_vertices(const Solid<S>& solid, Span<const Vec3<S>> vertices);

}  // namespace rigless

#include "rigless/mesh/detail/carry.h"
#include "rigless/mesh/detail/node_transforms.h"
#include "rigless/mesh/detail/outermost.h"
