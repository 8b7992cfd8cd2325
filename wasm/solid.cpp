// The solid inside any mesh, a part of the module that looks at models: only those load it who open one of their own.
// Float32 inside and out. Built for speed.

#include "rigless/mesh/solid.h"

#include "exports.h"

using rigless_wasm::answer;
using rigless_wasm::pack;
using rigless_wasm::PackedStatus;
using rigless_wasm::SolidInfo;
using rigless_wasm::view;

namespace {

rigless::Solid<float> solid;

}  // namespace

// positions: V x 3, stage; faces: F x 3; part: V as in SolidOptions, or null; rigidity: V of stiffen(), or null. What
// is built is solid_info() and what follows it.
RIGLESS_EXPORT PackedStatus build_solid(const float* positions, std::int32_t vertices, const std::int32_t* faces,
                                        std::int32_t face_count, const std::int32_t* part, const float* rigidity) {
  rigless::SolidOptions options;
  if (part != nullptr) options.part = {part, static_cast<std::size_t>(vertices)};
  const rigless::Status status = rigless::build_solid<float>(view<rigless::Vec3<float>>(positions, vertices),
                                                             view<rigless::Face>(faces, face_count), options, solid);
  if (status.ok() && rigidity != nullptr) rigless::stiffen<float>(view<float>(rigidity, vertices), solid);
  return pack(status);
}

RIGLESS_EXPORT const SolidInfo* solid_info() {
  return answer<SolidInfo>({
      .nodes = solid.nodes(),
      .elements = solid.elements(),
      .edges = solid.ring.edges(),
      .cell = solid.cell,
  });
}

// N x 3 at rest; E x 8; V, or -1; N + 1 and directed edges, each with its weight
RIGLESS_EXPORT const float* solid_nodes() { return solid.rest.data()->data(); }
RIGLESS_EXPORT const std::int32_t* solid_elements() { return solid.element.data()->data(); }
RIGLESS_EXPORT const std::int32_t* solid_element_of() { return solid.element_of.data(); }
RIGLESS_EXPORT const std::int32_t* solid_first() { return solid.ring.first.data(); }
RIGLESS_EXPORT const std::int32_t* solid_neighbors() { return solid.ring.neighbor.data(); }
RIGLESS_EXPORT const float* solid_weights() { return solid.weight.data(); }
RIGLESS_EXPORT const std::int32_t* solid_parts() { return solid.part.data(); }  // N
