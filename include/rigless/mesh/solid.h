// A solid inside any model: cubes that fill it, whatever its triangles are. The solid is deformed; the model rides
// along.
#pragma once

#include "rigless/mesh/detail/build_solid.h"
#include "rigless/mesh/detail/carry.h"
#include "rigless/mesh/detail/node_transforms.h"
#include "rigless/mesh/detail/outermost.h"

namespace rigless {

struct SolidOptions {
  std::int32_t nodes = 3000;  // about that many come out: 2,000 to 4,000 are fine for a body, fewer fuse its fingers
  // V, or empty: which part a vertex is of, 0 for the trunk, l > 0 for limb l, -l for where that begins. A limb and the
  // trunk, or another limb, get cubes of their own also where they touch or cross, as an arm and the trunk beside it
  // do.
  Span<const std::int32_t> part;
};

// A solid from V vertices and F faces: soup, open, wound either way, many shells. What is far from the rest and a
// ground under it stay out. The same on every machine. Allocates; `out` stays as it was on failure. Errors: no_faces
// (also when they have no size); index_out_of_range (face); not_finite (vertex, also one so far out that its square is
// no number). Source: Zollhoefer, Sert, Greiner and Suessmuth 2012, "GPU based ARAP deformation using volumetric
// lattices".
template <class S>
RIGLESS_COLD Status build_solid(Span<const Vec3<S>> vertices, Span<const Face> faces, const SolidOptions& options,
                                Solid<S>& out) {
  RIGLESS_ASSERT(options.part.empty() || options.part.size() == vertices.size());
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
  const detail::Lattice lattice = detail::build_lattice<S>(vertices, faces, options.part, options.nodes);
  Solid<S> solid;
  solid.cell = static_cast<S>(lattice.grid.cell);
  for (const Vec3<double>& p : lattice.node) solid.rest.push_back(p.template cast<S>());
  solid.element = lattice.element;
  solid.part = lattice.part;
  solid.inside = lattice.inside;
  solid.element_of = lattice.element_of;
  auto pairs = lattice.edges;
  for (const detail::Bridge& bridge : lattice.bridges) pairs.push_back({bridge.a, bridge.b});
  solid.ring = detail::one_ring_from_pairs(pairs, solid.nodes());
  solid.weight.assign(solid.ring.neighbor.size(), S(1));
  for (const auto& [a, b, firm] : lattice.bridges) {
    if (firm) continue;
    nth(solid.weight, solid.ring.slot(a, b)) = Solid<S>::bridge;
    nth(solid.weight, solid.ring.slot(b, a)) = Solid<S>::bridge;
  }
  out = std::move(solid);
  return {};
}

// Makes it stiffer, as DeformerOptions have it for a surface: V numbers above 0. A node is as stiff as the stiffest
// vertex around it, or else as the nearest nodes that have some. Allocates.
template <class S>
RIGLESS_COLD void stiffen(Span<const S> rigidity, Solid<S>& solid) {
  std::vector<S> of(solid.rest.size(), S(0));
  std::vector<std::int32_t> queue;
  for (std::size_t v = 0; v < rigidity.size(); ++v) {
    if (solid.element_of[v] < 0) continue;
    for (const std::int32_t node : nth(solid.element, solid.element_of[v])) {
      if (nth(of, node) == S(0)) queue.push_back(node);
      nth(of, node) = std::max(nth(of, node), rigidity[v]);
    }
  }
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const auto i = to_size(queue[k]);
    for (std::int32_t e = solid.ring.first[i]; e < solid.ring.first[i + 1]; ++e) {
      const std::int32_t j = nth(solid.ring.neighbor, e);
      if (nth(of, j) > S(0)) continue;
      nth(of, j) = of[i];
      queue.push_back(j);
    }
  }
  for (std::size_t i = 0; i < of.size(); ++i)
    for (auto e = to_size(solid.ring.first[i]); e < to_size(solid.ring.first[i + 1]); ++e)
      solid.weight[e] *= std::max(std::min(of[i], nth(of, solid.ring.neighbor[e])), S(1));
}

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

template <class S>
void node_transforms(const Solid<S>& solid, Span<const Vec3<S>> now, Span<NodeTransform<S>> out) {
  detail::fit_node_transforms(solid, now, out);
}

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
  RIGLESS_ASSERT(vertices.size() == solid.element_of.size() && transforms.size() == solid.rest.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::int32_t e = solid.element_of[v];
    out[v] = e < 0 ? normals[v] : detail::carried_normal(solid, e, vertices[v], normals[v], transforms.data());
  }
}

template <class S>
void carry_tangents(const Solid<S>& solid, Span<const Vec3<S>> vertices, Span<const NodeTransform<S>> transforms,
                    Span<const Vec3<S>> tangents, Span<Vec3<S>> out) {
  RIGLESS_ASSERT(vertices.size() == solid.element_of.size() && transforms.size() == solid.rest.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::int32_t e = solid.element_of[v];
    out[v] = e < 0 ? tangents[v] : detail::carried_tangent(solid, e, vertices[v], tangents[v], transforms.data());
  }
}

template <class S>
S volume(const Solid<S>& solid, Span<const Vec3<S>> now) {
  return static_cast<S>(detail::volume_of_elements(solid, now));
}

template <class S>
std::vector<std::int32_t> outermost_vertices(const Solid<S>& solid, Span<const Vec3<S>> vertices) {
  return detail::find_outermost(solid, vertices);
}

}  // namespace rigless
