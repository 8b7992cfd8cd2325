// Surfaces as flat C functions over integer handles: binding, dragging, baking. No logic of its own: it turns memory
// into spans and a Status into one number. Float32 inside and out. Built for speed.

#include "exports.h"
#include "handle_table.h"
#include "rigless/scene/bake.h"
#include "rigless/scene/body.h"

using rigless_wasm::answer;
using rigless_wasm::BakeRoot;
using rigless_wasm::BodyReport;
using rigless_wasm::ControlInput;
using rigless_wasm::HandleTable;
using rigless_wasm::ObjectHandle;
using rigless_wasm::pack;
using rigless_wasm::PackedStatus;
using rigless_wasm::view;

namespace {

using Body = rigless::Body<float>;
using Vec3f = rigless::Vec3<float>;

struct BodyBake {
  Body* body = nullptr;
  rigless::Performance<float> performance;
  rigless::Bake<float> bake;
};

HandleTable<Body> bodies;
HandleTable<BodyBake> bakes;

}  // namespace

RIGLESS_EXPORT ObjectHandle body_new() { return bodies.add(); }

RIGLESS_EXPORT void body_delete(ObjectHandle body) { bodies.remove(body); }

// positions: V x 3; faces: F x 3; rigidity: V, or 0. Forgets controls. On failure the body keeps what it had.
RIGLESS_EXPORT PackedStatus body_set_mesh(ObjectHandle body, const float* positions, std::int32_t vertices,
                                          const std::int32_t* faces, std::int32_t face_count, const float* rigidity,
                                          std::int32_t paper) {
  return pack(bodies[body].set_mesh(view<Vec3f>(positions, vertices), view<rigless::Face>(faces, face_count), {},
                                    {view<float>(rigidity, rigidity == nullptr ? 0 : vertices), paper != 0}));
}

// The same mesh, solved by the solid that was built from it: solid_info() and what follows it, as they are.
RIGLESS_EXPORT PackedStatus body_set_solid_mesh(ObjectHandle body, const float* positions, std::int32_t vertices,
                                                const std::int32_t* faces, std::int32_t face_count, double cell,
                                                const float* nodes, std::int32_t node_count,
                                                const std::int32_t* elements, std::int32_t element_count,
                                                const std::int32_t* element_of, const std::int32_t* first,
                                                const std::int32_t* neighbors, const float* weights,
                                                const std::int32_t* parts, std::int32_t paper) {
  rigless::Solid<float> solid;
  const auto take = [](auto& to, auto from) { to.assign(from.begin(), from.end()); };
  solid.cell = static_cast<float>(cell);
  take(solid.rest, view<Vec3f>(nodes, node_count));
  take(solid.element, view<std::array<std::int32_t, 8>>(elements, element_count));
  take(solid.element_of, view<std::int32_t>(element_of, vertices));
  take(solid.ring.first, view<std::int32_t>(first, node_count + 1));
  take(solid.ring.neighbor, view<std::int32_t>(neighbors, solid.ring.first.back()));
  take(solid.weight, view<float>(weights, solid.ring.first.back()));
  take(solid.part, view<std::int32_t>(parts, node_count));
  return pack(bodies[body].set_mesh(view<Vec3f>(positions, vertices), view<rigless::Face>(faces, face_count),
                                    std::move(solid), {{}, paper != 0}));
}

RIGLESS_EXPORT const BodyReport* body_report(ObjectHandle body) {
  const rigless::MeshTopology& t = bodies[body].topology();
  const rigless::detail::Bounds<float> box = rigless::detail::bounds(bodies[body].rest());
  return answer<BodyReport>({
      .volume = bodies[body].volume(),
      .boundary_edges = t.boundary_edges,
      .non_manifold_edges = t.non_manifold_edges,
      .shells = t.shells,
      .isolated_vertices = t.isolated_vertices,
      .degenerate_faces = t.degenerate_faces,
      .floor = box.low.y(),
      .height = box.height(),
  });
}

// C controls. On failure the old ones stay.
RIGLESS_EXPORT PackedStatus body_set_controls(ObjectHandle body, const ControlInput* inputs, std::int32_t count) {
  std::vector<rigless::Control<float>> controls;
  for (const ControlInput& input : view<ControlInput>(inputs, count)) controls.push_back(control(input));
  return pack(bodies[body].set_controls(controls));
}

// targets: C x 3, body-local; turns: C x 3, or 0. The result is body_positions(), or body_maps().
RIGLESS_EXPORT PackedStatus body_drag(ObjectHandle body, const float* targets, const float* turns, std::int32_t count,
                                      float volume, std::int32_t restart) {
  return pack(bodies[body].drag(view<Vec3f>(targets, count), volume, restart != 0,
                                view<Vec3f>(turns, turns == nullptr ? 0 : count)));
}

RIGLESS_EXPORT const float* body_positions(ObjectHandle body) { return bodies[body].positions().data()->data(); }

// The same by the nodes of the solid that carries the mesh: N x 12, rows of (B | b).
RIGLESS_EXPORT const float* body_maps(ObjectHandle body) { return bodies[body].maps().data()->data(); }

RIGLESS_EXPORT double body_volume_ratio(ObjectHandle body) { return static_cast<double>(bodies[body].volume_ratio()); }

// C x 3, at rest
RIGLESS_EXPORT const float* body_rest_controls(ObjectHandle body) {
  return bodies[body].rest_controls().data()->data();
}

// C x 5: where the limb of a solid at whose tip a control lies leaves the trunk, its length from there, and its swing;
// 0: the surface is solved. Kept until the next call.
RIGLESS_EXPORT const float* body_limbs(ObjectHandle body) {
  static std::vector<std::array<float, 5>> limbs;
  limbs.clear();
  for (const auto& limb : bodies[body].limbs())
    limbs.push_back(
        {limb.base.x(), limb.base.y(), limb.base.z(), limb.length, static_cast<float>(bodies[body].swing(limb))});
  return limbs.empty() ? nullptr : limbs.data()->data();
}

RIGLESS_EXPORT ObjectHandle bake_new() { return bakes.add(); }

RIGLESS_EXPORT void bake_delete(ObjectHandle bake) { bakes.remove(bake); }

// Takes a performance in: controls T x C x 3, turns T x C x 3 or 0, yaw T, travel T x 3, flights as pairs of frames.
// The body and its controls must stay.
RIGLESS_EXPORT void bake_begin(ObjectHandle bake, ObjectHandle body, std::int32_t frames, const float* controls,
                               const float* turns, const float* yaw, const float* travel, const std::int32_t* flights,
                               std::int32_t flight_count, float volume) {
  BodyBake& b = bakes[bake];
  b.body = &bodies[body];
  const auto assign = [](auto& to, auto from) { to.assign(from.begin(), from.end()); };
  b.performance.frames = frames;
  assign(b.performance.controls, view<Vec3f>(controls, frames * b.body->controls()));
  assign(b.performance.turns, view<Vec3f>(turns, turns == nullptr ? 0 : frames * b.body->controls()));
  assign(b.performance.yaw, view<float>(yaw, frames));
  assign(b.performance.travel, view<std::array<float, 3>>(travel, frames));
  assign(b.performance.flights, view<rigless::Flight>(flights, flight_count));
  b.bake.bind(*b.body, b.performance, volume);
}

// Makes a frame: bake_positions(), V x 3 in the world, or bake_maps(), N x 12, and bake_root().
RIGLESS_EXPORT PackedStatus bake_frame(ObjectHandle bake, std::int32_t frame) {
  return pack(bakes[bake].bake.frame(frame));
}

RIGLESS_EXPORT const float* bake_positions(ObjectHandle bake) { return bakes[bake].bake.positions().data()->data(); }

RIGLESS_EXPORT const float* bake_maps(ObjectHandle bake) { return bakes[bake].bake.maps().data()->data(); }

RIGLESS_EXPORT const BakeRoot* bake_root(ObjectHandle bake) {
  const BodyBake& b = bakes[bake];
  return answer<BakeRoot>({
      .position = b.bake.root().position,
      .yaw = b.bake.root().yaw,
      .volume_ratio = b.body->volume_ratio(),
  });
}
