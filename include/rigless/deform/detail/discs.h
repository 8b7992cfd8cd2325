// Control points as discs: a control holds not one vertex but the vertices around it, as a rigid piece that turns with
// its surroundings. A single held vertex pulls a needle out of the surface; a disc pulls a body.
#pragma once

#include "rigless/deform/detail/cells.h"
#include "rigless/deform/detail/control.h"
#include "rigless/math/detail/rotation.h"
#include "rigless/mesh/detail/geodesic.h"

namespace rigless {

// The vertices that controls hold. A vertex belongs to the nearest control; a control's own vertex always to itself, or
// to the first of those that share it. Public through Deformer::discs().
template <class S>
struct Discs {
  std::vector<std::int32_t> owner;   // V: control, or -1 where the surface is free
  std::vector<Vec3<S>> center;       // C: the control at rest
  std::vector<std::int32_t> first;   // C + 1: into member
  std::vector<std::int32_t> member;  // vertices, control by control

  bool holds(std::size_t vertex) const { return owner[vertex] >= 0; }
  std::size_t size() const { return center.size(); }
};

}  // namespace rigless

namespace rigless::detail {

// Lists the members of C discs, whose centers and owners are told. Allocates.
template <class S>
RIGLESS_COLD void list_members(Discs<S>& discs) {
  discs.first.assign(discs.center.size() + 1, 0);
  for (std::int32_t c : discs.owner) {
    if (c >= 0) discs.first[to_size(c) + 1]++;
  }
  for (std::size_t c = 0; c < discs.center.size(); ++c) discs.first[c + 1] += discs.first[c];
  discs.member.resize(to_size(discs.first.back()));
  std::vector<std::int32_t> next = discs.first;
  for (std::size_t v = 0; v < discs.owner.size(); ++v) {
    if (discs.owner[v] < 0) continue;
    nth(discs.member, nth(next, discs.owner[v])++) = static_cast<std::int32_t>(v);
  }
}

// Grows discs along the surface. Allocates. Errors: no_controls; index_out_of_range (where: control).
template <class S>
RIGLESS_COLD Status make_discs(const Cells<S>& cells, Span<const Control<S>> controls, Discs<S>& out) {
  if (controls.empty()) return {Error::no_controls, -1};
  for (std::size_t c = 0; c < controls.size(); ++c) {
    if (controls[c].vertex < 0 || to_size(controls[c].vertex) >= cells.size()) {
      return {Error::index_out_of_range, c};
    }
  }
  Discs<S> discs;
  discs.owner.assign(cells.size(), -1);
  std::vector<S> distance(cells.size(), std::numeric_limits<S>::max());
  for (std::size_t c = 0; c < controls.size(); ++c) {
    discs.center.push_back(nth(cells.rest, controls[c].vertex));
    for (const auto& [vertex, d] : vertices_within<S>(cells.rest, cells.ring, controls[c].vertex, controls[c].radius)) {
      const auto v = to_size(vertex);
      if (d >= distance[v]) continue;
      distance[v] = d;
      discs.owner[v] = static_cast<std::int32_t>(c);
    }
  }
  list_members(discs);
  out = std::move(discs);
  return {};
}

// What turning and moving the discs needs to know of their edges: those inside a disc as one moment for each member,
// those that leave it one by one. An edge between two discs leaves both.
template <class S>
struct DiscSeams {
  struct Edge {
    std::int32_t member;  // into Discs::member
    std::int32_t to;      // vertex outside the disc
    S weight;
    Vec3<S> rest;         // e, from the member to it
    Vec3<S> from_center;  // p, of the member at rest
  };

  std::vector<Mat3<S>> inside;      // per member: sum w e e^T over its edges inside the disc
  std::vector<std::int32_t> first;  // C + 1: into edge
  std::vector<Edge> edge;
  std::vector<Mat3<S>> transform;  // scratch, per member
};

// Allocates.
template <class S>
RIGLESS_COLD DiscSeams<S> find_seams(const Cells<S>& cells, const Discs<S>& discs) {
  DiscSeams<S> seams;
  seams.inside.assign(discs.member.size(), Mat3<S>::Zero());
  seams.transform.assign(discs.member.size(), Mat3<S>::Identity());
  seams.first.push_back(0);
  for (std::size_t c = 0; c < discs.size(); ++c) {
    const Vec3<S>& center = discs.center[c];
    for (std::int32_t m = discs.first[c]; m < discs.first[c + 1]; ++m) {
      const auto k = to_size(nth(discs.member, m));
      for_each_edge(cells, k, [&](S w, const Vec3<S>& e, std::size_t j) {
        if (discs.owner[j] == static_cast<std::int32_t>(c)) {
          nth(seams.inside, m) += (w * e) * e.transpose();
        } else {
          seams.edge.push_back({m, static_cast<std::int32_t>(j), w, e, cells.rest[k] - center});
        }
      });
    }
    seams.first.push_back(count_of(seams.edge));
  }
  return seams;
}

// The rotation of disc c about its control that best agrees with the cells: an exact block step, so the energy never
// rises. transform(v) is s_v R_v of the cell at vertex v, position(v) the present surface. No allocation.
// The covariance collects sum_k p_k q_k^T over the edges k -> j of the disc's vertices, p from the control at rest:
// to an outer j, both directed copies ask Q p_k = x_j - t + M e_kj; inside the disc, each asks Q e_kl = M_k e_kl.
template <class S, class Transform, class Position>
Mat3<S> fit_disc(DiscSeams<S>& seams, const Discs<S>& discs, std::size_t c, const Transform& transform,
                 const Position& position, const Vec3<S>& target) {
  Mat3<S> C = Mat3<S>::Zero();
  for (std::int32_t m = discs.first[c]; m < discs.first[c + 1]; ++m) {
    const auto at = to_size(m);
    seams.transform[at] = transform(to_size(discs.member[at]));
    C.noalias() += seams.inside[at] * seams.transform[at].transpose();
  }
  for (std::int32_t k = seams.first[c]; k < seams.first[c + 1]; ++k) {
    const auto& edge = nth(seams.edge, k);
    const auto j = to_size(edge.to);
    const Mat3<S> M = nth(seams.transform, edge.member) + transform(j);
    const Vec3<S> q = S(2) * (position(j) - target) + M * edge.rest;
    C.noalias() += (edge.weight * edge.from_center) * q.transpose();
  }
  return nearest_rotation(C);
}

}  // namespace rigless::detail
