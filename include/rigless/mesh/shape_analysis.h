// All that a bare mesh says of itself: how it stands, whether it is symmetric, where to hold it.
#pragma once

#include "rigless/mesh/detail/body_faces.h"
#include "rigless/mesh/detail/body_points.h"

namespace rigless {

template <class S>
struct ShapeAnalysis {
  Posture<S> posture;
  S sure = 1;              // of the posture, 0 to 1; below a half it is as well to ask
  SymmetryPlane<S> plane;  // the best there is; see is_symmetric()
  std::vector<BodyPoint<S>> points;
};

// Guesses from V vertices in any axes and units and F faces. A guess may be wrong and is meant to be shown. Allocates;
// about 0.2 s in WASM, whatever V is. Errors: no_faces; index_out_of_range (where: face); not_finite (where: vertex).
// On failure `out` keeps what it had. `posture`: how the mesh stands, where that is known; `file`: how files of
// its kind do; landmarks: places that are named already. Those of a role stand for all of that role, feet for forelegs
// too.
template <class S>
Status analyse_shape(Span<const Vec3<S>> vertices, Span<const Face> faces, ShapeAnalysis<S>& out,
                     const Posture<S>* posture = nullptr, FileAxes file = FileAxes::unknown,
                     Span<const Landmark<S>> landmarks = {}) {
  if (const Status status = detail::check_faces(faces, count_of(vertices)); !status.ok()) return status;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (!vertices[v].allFinite()) return {Error::not_finite, v};
  }
  ShapeAnalysis<S> found;
  const std::vector<Face> body = detail::body_faces(vertices, faces);
  const detail::SurfaceGraph<S> graph = detail::surface_graph<S>(vertices, body);
  const std::vector<S> average = detail::average_geodesic(graph);
  const std::vector<Vec3<S>> samples = detail::surface_samples<S>(vertices, body, 6000);
  const S diagonal = detail::bounds<S>(graph.position).diagonal();
  std::vector<Vec3<S>> tips;  // those that stand apart: the rim of a disc is one
  for (const detail::Extremity<S>& e : detail::extremities<S>(graph, average, S(0.04) * diagonal)) {
    const Vec3<S>& tip = nth(graph.position, e.node);
    const auto near = [&](const Vec3<S>& other) { return (other - tip).norm() < S(0.1) * diagonal; };
    if (!std::any_of(tips.begin(), tips.end(), near)) tips.push_back(tip);
  }
  const detail::SymmetryFinder<S> symmetry(samples);
  if (posture != nullptr) {
    found.posture = *posture;
  } else {
    found.plane = symmetry.best(tips, file == FileAxes::y_up_by_rule ? Vec3<S>(Vec3<S>::UnitX()) : Vec3<S>::Zero());
    const detail::PostureGuess<S> guess = detail::guess_posture<S>(samples, tips, found.plane, file);
    found.posture = guess.posture;
    found.sure = guess.sure;
  }
  if (posture != nullptr || std::abs(found.plane.normal.dot(found.posture.left)) < S(0.8))
    found.plane = symmetry.across(found.posture.left);
  found.points = detail::BodyReader<S>(graph, average, found.posture, found.plane, landmarks).read();
  out = std::move(found);
  return {};
}

}  // namespace rigless
