// The core as flat C functions over integer handles. No logic of its own: it turns memory into spans, double into
// float32, and a Status into one number. Vertices are float; motions and control tracks are double inside.
// A pointer into an object holds until the object changes or the heap grows.

#include <cstdlib>

#include "handle_table.h"
#include "rigless/scene/body.h"

#define RIGLESS_EXPORT extern "C" __attribute__((used, visibility("default")))

using rigless::Error;
using rigless::Face;
using rigless::Span;
using rigless::Status;
using rigless_wasm::HandleTable;
using rigless_wasm::ObjectHandle;

namespace {

using Body = rigless::Body<float>;
using Vec3f = rigless::Vec3<float>;

HandleTable<Body> bodies;

// error * 2^32 + where: exact in a double, and 0 when all is well.
double pack(Status status) {
  if (status.ok()) return 0;
  return static_cast<double>(status.error) * 4294967296.0 +
         static_cast<double>(static_cast<std::uint32_t>(status.where));
}

template <class T, class U>
Span<const T> view(const U* data, std::int32_t count) {
  return {reinterpret_cast<const T*>(data), static_cast<std::size_t>(count)};
}

}  // namespace

RIGLESS_EXPORT void* alloc(std::int32_t bytes) { return std::malloc(static_cast<std::size_t>(bytes)); }

RIGLESS_EXPORT void release(void* memory) { std::free(memory); }

RIGLESS_EXPORT ObjectHandle body_new() { return bodies.add(); }

RIGLESS_EXPORT void body_delete(ObjectHandle body) { bodies.remove(body); }

// positions: V x 3; faces: F x 3. Forgets controls. On failure the body keeps what it had.
RIGLESS_EXPORT double body_set_mesh(ObjectHandle body, const float* positions, std::int32_t vertices,
                                    const std::int32_t* faces, std::int32_t face_count) {
  return pack(bodies[body].set_mesh(view<Vec3f>(positions, vertices), view<Face>(faces, face_count)));
}

// out: volume (NaN when open), boundary edges, non-manifold edges, shells, isolated vertices, degenerate faces.
RIGLESS_EXPORT void body_report(ObjectHandle body, double* out) {
  const rigless::MeshTopology& t = bodies[body].topology();
  out[0] = static_cast<double>(bodies[body].volume());
  out[1] = t.boundary_edges;
  out[2] = t.non_manifold_edges;
  out[3] = t.shells;
  out[4] = t.isolated_vertices;
  out[5] = t.degenerate_faces;
}

// C vertices and geodesic radii. On failure the old controls stay.
RIGLESS_EXPORT double body_set_controls(ObjectHandle body, const std::int32_t* vertices, const float* radii,
                                        std::int32_t count) {
  std::vector<rigless::Handle<float>> controls;
  for (std::int32_t c = 0; c < count; ++c) controls.push_back({vertices[c], radii[c]});
  return pack(bodies[body].set_controls(controls));
}

// targets: C x 3, body-local. The result is body_positions().
RIGLESS_EXPORT double body_drag(ObjectHandle body, const float* targets, std::int32_t count, float volume,
                                std::int32_t restart) {
  return pack(bodies[body].drag(view<Vec3f>(targets, count), volume, restart != 0));
}

RIGLESS_EXPORT const float* body_positions(ObjectHandle body) {
  return bodies[body].deformer().positions().data()->data();
}

RIGLESS_EXPORT double body_volume_ratio(ObjectHandle body) {
  return static_cast<double>(bodies[body].volume_ratio(bodies[body].deformer().positions()));
}
