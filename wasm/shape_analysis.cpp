// What a bare mesh says of itself: a module of its own, which only those load who open a model of their own. Float32
// inside and out. Built for speed.

#include "rigless/mesh/shape_analysis.h"

#include "exports.h"

using rigless_wasm::answer;
using rigless_wasm::Landmark;
using rigless_wasm::pack;
using rigless_wasm::PackedStatus;
using rigless_wasm::Shape;
using rigless_wasm::ShapePoint;
using rigless_wasm::view;

namespace {

rigless::ShapeAnalysis<float> analysis;

}  // namespace

// positions: V x 3 in any axes and units; faces: F x 3; file: of FileAxes; up, front: where they are known, else zeros;
// landmarks: any number. What is found is shape() and shape_point().
RIGLESS_EXPORT PackedStatus analyse_shape(const float* positions, std::int32_t vertices, const std::int32_t* faces,
                                          std::int32_t face_count, std::int32_t file, const float* up_and_front,
                                          const Landmark* landmarks, std::int32_t landmark_count) {
  std::vector<rigless::Landmark<float>> named;
  for (const Landmark& one : view<Landmark>(landmarks, landmark_count)) named.push_back(landmark(one));
  const auto known = view<rigless::Vec3<float>>(up_and_front, 2);
  const rigless::Posture<float> posture{known[0].cross(known[1]), known[0], known[1]};
  return pack(rigless::analyse_shape<float>(
      view<rigless::Vec3<float>>(positions, vertices), view<rigless::Face>(faces, face_count), analysis,
      posture.left.isZero() ? nullptr : &posture, static_cast<rigless::FileAxes>(file), named));
}

RIGLESS_EXPORT const Shape* shape() {
  return answer<Shape>({
      .up = analysis.posture.up,
      .front = analysis.posture.front,
      .sure = analysis.sure,
      .plane_point = analysis.plane.point,
      .plane_normal = analysis.plane.normal,
      .misfit = analysis.plane.misfit,
      .symmetric = rigless::is_symmetric(analysis.plane),
      .points = analysis.points.size(),
  });
}

// Those that are wanted first.
RIGLESS_EXPORT const ShapePoint* shape_point(std::int32_t index) {
  const rigless::BodyPoint<float>& p = analysis.points[static_cast<std::size_t>(index)];
  return answer<ShapePoint>({
      .vertex = p.vertex,
      .role = p.role,
      .side = p.side,
      .partner = p.partner,
      .radius = p.radius,
      .wanted = p.wanted,
  });
}
