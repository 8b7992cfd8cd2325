// What a bare mesh says of itself: a module of its own, which only those load who open a model of their own. Float32
// inside and out. Built for speed.

#include "rigless/mesh/shape_analysis.h"

#include <cstdlib>

#include "exports.h"

using rigless_wasm::pack;
using rigless_wasm::view;

RIGLESS_EXPORT void* alloc(std::int32_t bytes) { return std::malloc(static_cast<std::size_t>(bytes)); }

// positions: V x 3 in any axes and units; faces: F x 3. out, on success: up, front, point and normal of the plane (3
// each), its misfit in diagonals, 1 if the mesh is symmetric in it, count of points (32 at most); then of each point
// its vertex, role, side, partner, radius and 1 if it is wanted (mesh/detail/body_points.h).
RIGLESS_EXPORT double analyse_shape(const float* positions, std::int32_t vertices, const std::int32_t* faces,
                                    std::int32_t face_count, double* out) {
  rigless::ShapeAnalysis<float> u;
  const rigless::Status status = rigless::analyse_shape<float>(view<rigless::Vec3<float>>(positions, vertices),
                                                               view<rigless::Face>(faces, face_count), u);
  if (!status.ok()) return pack(status);
  const auto put = [&](auto number) { *out++ = static_cast<double>(number); };
  for (const rigless::Vec3<float>& v : {u.posture.up, u.posture.front, u.plane.point, u.plane.normal})
    for (int k = 0; k < 3; ++k) put(v[k]);
  put(u.plane.misfit);
  put(rigless::is_symmetric(u.plane));
  put(u.points.size());
  for (const rigless::BodyPoint<float>& p : u.points) {
    put(p.vertex);
    put(p.role);
    put(p.side);
    put(p.partner);
    put(p.radius);
    put(p.wanted);
  }
  return 0;
}
