// The core as flat C functions over integer handles. No logic of its own: it turns memory into spans, double into
// float32 and back, and a Status into one number. Vertices are float; motions and control tracks are double inside.
// Pointers into an object live until the object is changed or the heap grows.

#include <cstdlib>
#include <limits>

#include "handle_table.h"
#include "rigless/mesh/inspect.h"
#include "rigless/mesh/measure.h"
#include "rigless/scene/drag.h"

#define RIGLESS_EXPORT(name) extern "C" __attribute__((export_name(#name))) auto name

using namespace rigless;
using rigless_wasm::HandleTable;
using rigless_wasm::ObjectHandle;

namespace {

using Vec3f = Vec3<float>;

// A mesh with its deformer.
struct Body {
  std::vector<Vec3f> rest;
  std::vector<Face> faces;
  MeshTopology topology;
  float volume = 0;
  Deformer<float> deformer;
  Drag<float> drag;
};

HandleTable<Body> bodies;

// error * 2^32 + where: exact in a double, and 0 when all is well.
double pack(Status status) {
  if (status.ok()) return 0;
  return static_cast<double>(status.error) * 4294967296.0 +
         static_cast<double>(static_cast<std::uint32_t>(status.where));
}

Span<const Vec3f> points(const float* data, std::int32_t count) {
  return {reinterpret_cast<const Vec3f*>(data), static_cast<std::size_t>(count)};
}

// Deformed over rest; NaN where an open surface has no volume.
double volume_ratio(const Body& body, Span<const Vec3f> positions) {
  if (!body.topology.closed() || body.volume == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(signed_volume<float>(positions, body.faces) / body.volume);
}

}  // namespace

RIGLESS_EXPORT(alloc)(std::int32_t bytes)->void* { return std::malloc(static_cast<std::size_t>(bytes)); }

RIGLESS_EXPORT(release)(void* memory)->void { std::free(memory); }

RIGLESS_EXPORT(body_new)()->ObjectHandle { return bodies.add(); }

RIGLESS_EXPORT(body_delete)(ObjectHandle handle)->void { bodies.remove(handle); }

// positions: V x 3; faces: F x 3. Forgets controls. On failure the body keeps what it had.
RIGLESS_EXPORT(body_set_mesh)
(ObjectHandle handle, const float* positions, std::int32_t vertices, const std::int32_t* faces, std::int32_t count)
    ->double {
  Body& body = bodies[handle];
  const Span<const Vec3f> rest = points(positions, vertices);
  const Span<const Face> triangles(reinterpret_cast<const Face*>(faces), static_cast<std::size_t>(count));
  if (const Status status = body.deformer.bind(rest, triangles); !status.ok()) return pack(status);
  body.rest.assign(rest.begin(), rest.end());
  body.faces.assign(triangles.begin(), triangles.end());
  body.topology = inspect_mesh(triangles, vertices);
  body.volume = signed_volume(rest, triangles);
  return 0;
}

// out: volume (NaN when open), boundary edges, non-manifold edges, shells, isolated vertices, degenerate faces.
RIGLESS_EXPORT(body_report)(ObjectHandle handle, double* out)->void {
  const Body& body = bodies[handle];
  const MeshTopology& t = body.topology;
  out[0] = t.closed() ? std::abs(static_cast<double>(body.volume)) : std::numeric_limits<double>::quiet_NaN();
  out[1] = t.boundary_edges;
  out[2] = t.non_manifold_edges;
  out[3] = t.shells;
  out[4] = t.isolated_vertices;
  out[5] = t.degenerate_faces;
}

// C vertices and geodesic radii. On failure the old controls stay.
RIGLESS_EXPORT(body_set_controls)
(ObjectHandle handle, const std::int32_t* vertices, const float* radii, std::int32_t count)->double {
  Body& body = bodies[handle];
  std::vector<Handle<float>> handles;
  for (std::int32_t c = 0; c < count; ++c) handles.push_back({vertices[c], radii[c]});
  if (const Status status = body.deformer.set_handles(handles); !status.ok()) return pack(status);
  body.drag.bind(body.deformer);
  return 0;
}

// targets: C x 3, body-local. The result is body_positions().
RIGLESS_EXPORT(body_drag)
(ObjectHandle handle, const float* targets, std::int32_t count, float volume, std::int32_t restart)->double {
  Body& body = bodies[handle];
  if (count != body.deformer.handles()) return pack({Error::size_mismatch, -1});
  const Span<const Vec3f> wanted = points(targets, count);
  for (std::size_t c = 0; c < wanted.size(); ++c) {
    if (!wanted[c].allFinite()) return pack({Error::not_finite, static_cast<std::int32_t>(c)});
  }
  body.drag.move(body.deformer, wanted, volume, restart != 0);
  return 0;
}

RIGLESS_EXPORT(body_positions)(ObjectHandle handle)->const float* {
  return bodies[handle].deformer.positions().data()->data();
}

RIGLESS_EXPORT(body_volume_ratio)(ObjectHandle handle)->double {
  const Body& body = bodies[handle];
  return volume_ratio(body, body.deformer.positions());
}
