// A skin or morph targets for a mesh that moves: a module of its own, which only those load who take a dance with them.
// Float32 inside and out. Built for speed.

#include "exports.h"
#include "rigless/skin/detail/morph_builder.h"
#include "rigless/skin/skin_builder.h"

using rigless_wasm::answer;
using rigless_wasm::MorphInfo;
using rigless_wasm::pack;
using rigless_wasm::PackedStatus;
using rigless_wasm::SkinInfo;
using rigless_wasm::view;

namespace {

rigless::SkinBuilder<float> builder;
rigless::detail::MorphBuilder<float> morph_builder;
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
      .targets = skin.targets,
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
// K x V x 3 and F x K
RIGLESS_EXPORT const float* skin_ways() { return reinterpret_cast<const float*>(builder.skin().way.data()); }
RIGLESS_EXPORT const float* skin_mix() { return builder.skin().mix.data(); }

// The same for morph targets: `targets` at most.
RIGLESS_EXPORT PackedStatus begin_morphs(const float* positions, std::int32_t vertices, std::int32_t targets) {
  rigless::detail::MorphOptions options;
  options.targets = targets;
  vertex_count = vertices;
  return pack(morph_builder.begin(view<rigless::Vec3<float>>(positions, vertices), options));
}

// V x 3
RIGLESS_EXPORT PackedStatus add_morph_frame(const float* positions) {
  return pack(morph_builder.add_frame(view<rigless::Vec3<float>>(positions, vertex_count)));
}

RIGLESS_EXPORT std::int32_t advance_morphs() { return morph_builder.advance() ? 1 : 0; }

RIGLESS_EXPORT double morph_progress() { return morph_builder.progress(); }

RIGLESS_EXPORT const MorphInfo* morph_info() {
  const rigless::detail::Morphs<float>& morphs = morph_builder.morphs();
  return answer<MorphInfo>({
      .targets = morphs.targets,
      .frames = morphs.root.size(),
      .rms = morphs.rms,
      .worst = morphs.worst,
  });
}

// K x V x 3; F x K; F x 7
RIGLESS_EXPORT const float* morph_ways() { return morph_builder.morphs().way.data()->data(); }
RIGLESS_EXPORT const float* morph_weights() { return morph_builder.morphs().weight.data(); }
RIGLESS_EXPORT const float* morph_roots() { return morph_builder.morphs().root.data()->turn.coeffs().data(); }
