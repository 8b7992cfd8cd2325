// From triangles to a solid, step by step.
#pragma once

#include "rigless/mesh/detail/body_box.h"
#include "rigless/mesh/detail/bridges.h"
#include "rigless/mesh/detail/carriers.h"
#include "rigless/mesh/detail/ground.h"
#include "rigless/mesh/detail/one_ring.h"
#include "rigless/mesh/detail/voxel_nodes.h"
#include "rigless/mesh/detail/voxel_parts.h"

namespace rigless::detail {

// Everything of a solid but the numbers in S.
struct Lattice {
  VoxelGrid grid;
  std::vector<Point> node;         // N
  std::vector<std::int32_t> part;  // N
  std::vector<std::array<std::int32_t, 8>> element;
  std::vector<char> inside;  // E
  std::vector<std::int32_t> element_of;
  std::vector<std::array<std::int32_t, 2>> edges;
  std::vector<Bridge> bridges;
};

// With about that many nodes, not counting those that duplication adds. Allocates.
template <class S>
RIGLESS_COLD Lattice build_lattice(const Triangles<S>& triangles, const Sheets& sheets, const Box& box, double nodes) {
  Lattice out;
  const Voxels voxels = fit_voxels(triangles, box, nodes);
  out.grid = voxels.grid;
  const Pieces pieces = PieceFinder<S>(triangles, sheets, voxels).find();
  const Elements elements = find_elements(voxels, pieces);
  const std::vector<std::int32_t> part = find_parts(voxels, pieces, elements);
  out.node.resize(to_size(NodeJoiner(voxels, pieces, elements, part).join(out.element)));
  out.part.assign(out.node.size(), no_part);
  out.element_of = find_carriers(triangles, sheets, voxels, pieces, elements);
  for (std::size_t e = 0; e < out.element.size(); ++e) {
    const auto at = out.grid.coordinates(elements.voxel[e]);
    for (std::size_t k = 0; k < 8; ++k) {
      const Point corner(at[0] + static_cast<double>(k & 1), at[1] + static_cast<double>(k >> 1 & 1),
                         at[2] + static_cast<double>(k >> 2 & 1));
      join_part(nth(out.part, out.element[e][k]), part[e]);
      nth(out.node, out.element[e][k]) = out.grid.low + out.grid.cell * corner;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t other = k | std::size_t{1} << axis;
        if (other != k) out.edges.push_back({out.element[e][k], out.element[e][other]});
      }
    }
    out.inside.push_back(nth(voxels.kind, elements.voxel[e]) == Voxel::inside);
  }
  return out;
}

// As many nodes as are wanted with duplicates, at least 2,000 and at most 4,000 where voxels can be had so small or so
// large: duplicates are known only afterwards. Allocates.
template <class S>
RIGLESS_COLD Lattice build_lattice(Span<const Vec3<S>> vertices, Span<const Face> faces, Span<const std::int32_t> part,
                                   std::int32_t wanted) {
  const Sheets sheets = find_sheets(vertices, faces);
  const std::vector<char> ground = ground_faces(measure_shells(vertices, faces, sheets), sheets);
  const Triangles<S> triangles{vertices, faces, ground, part};
  const Box box = body_box(vertices, faces, ground);
  Lattice out;
  double nodes = wanted;
  for (int attempt = 0; attempt < 4; ++attempt) {
    out = build_lattice(triangles, sheets, box, nodes);
    const double ratio = static_cast<double>(out.node.size()) / wanted;
    if (ratio > 0.75 && ratio < 1.25) break;
    nodes /= ratio;
  }
  out.bridges = BridgeBuilder(out.node, out.edges).build(0.75 * out.grid.cell);
  return out;
}

}  // namespace rigless::detail
