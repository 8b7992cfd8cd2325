// A skin for a mesh that moves: a module of its own, which only those load who take a dance with them. Float32 inside
// and out. Built for speed.

#include "exports.h"
#include "rigless/skin/skin_builder.h"

using rigless_wasm::answer;
using rigless_wasm::pack;
using rigless_wasm::PackedStatus;
using rigless_wasm::SkinInfo;
using rigless_wasm::view;

namespace {

rigless::SkinBuilder<float> builder;
std::int32_t vertex_count = 0;

using Pose = rigless::Skin<float>::Pose;
static_assert(sizeof(Pose) == 7 * sizeof(float));

}  // namespace

// positions: V x 3 at rest; faces: F x 3; joints: at most. Then each frame, then advance_skin() until it answers 0.
RIGLESS_EXPORT PackedStatus begin_skin(const float* positions, std::int32_t vertices, const std::int32_t* faces,
                                       std::int32_t face_count, std::int32_t joints) {
  rigless::SkinOptions options;
  options.joints = joints;
  vertex_count = vertices;
  return pack(
      builder.begin(view<rigless::Vec3<float>>(positions, vertices), view<rigless::Face>(faces, face_count), options));
}

// V x 3
RIGLESS_EXPORT PackedStatus add_skin_frame(const float* positions) {
  return pack(builder.add_frame(view<rigless::Vec3<float>>(positions, vertex_count)));
}

RIGLESS_EXPORT std::int32_t advance_skin() { return builder.advance() ? 1 : 0; }

RIGLESS_EXPORT double skin_progress() { return builder.progress(); }

RIGLESS_EXPORT const SkinInfo* skin_info() {
  const rigless::Skin<float>& skin = builder.skin();
  return answer<SkinInfo>({
      .joints = skin.joints(),
      .frames = skin.root.size(),
      .rms = skin.rms,
      .worst = skin.worst,
      .normals = skin.normals,
  });
}

// J x 3; V x 4; V x 4; F x 7 and F x J x 7: a quaternion x, y, z, w and a place
RIGLESS_EXPORT const float* skin_centres() { return builder.skin().centre.data()->data(); }
RIGLESS_EXPORT const std::int32_t* skin_joints() { return builder.skin().joint.data(); }
RIGLESS_EXPORT const float* skin_weights() { return builder.skin().weight.data(); }
RIGLESS_EXPORT const float* skin_roots() { return builder.skin().root.data()->turn.coeffs().data(); }
RIGLESS_EXPORT const float* skin_poses() { return builder.skin().pose.data()->turn.coeffs().data(); }
