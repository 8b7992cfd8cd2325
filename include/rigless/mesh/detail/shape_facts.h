// What a shape analysis finds: how a body stands, its plane of symmetry and its points. Public through
// shape_analysis.h.
#pragma once

#include <cstdint>
#include <limits>

#include "rigless/math/types.h"

namespace rigless {

// Three axes of the file, right-handed: the body's left, its up and its front.
template <class S>
struct Posture {
  Vec3<S> left = Vec3<S>::UnitX();
  Vec3<S> up = Vec3<S>::UnitY();
  Vec3<S> front = Vec3<S>::UnitZ();

  // Seen by the body: left, up, front.
  Vec3<S> see(const Vec3<S>& p) const { return {left.dot(p), up.dot(p), front.dot(p)}; }
};

template <class S>
struct SymmetryPlane {
  Vec3<S> point = Vec3<S>::Zero();
  Vec3<S> normal = Vec3<S>::UnitX();
  // Mean distance of the mirrored surface from the surface, in diagonals.
  S misfit = std::numeric_limits<S>::max();

  S side(const Vec3<S>& p) const { return normal.dot(p - point); }
  Vec3<S> mirror(const Vec3<S>& p) const { return p - S(2) * side(p) * normal; }
};

// Whether the mirror image of the surface lies within 2 % of its diagonal of it.
template <class S>
bool is_symmetric(const SymmetryPlane<S>& plane) {
  return plane.misfit < S(0.02);
}

// How files of a kind hold what stands upright: glTF by specification y up and facing z, OBJ and OFF mostly so, STL
// mostly z up and facing -y, PLY either way.
enum class FileAxes : std::int32_t { unknown, y_up, z_up, y_up_by_rule };

enum class BodyRole : std::int32_t { tip, head, hand, foot, foreleg, tail, hips, chest, elbow, knee };

template <class S>
struct BodyPoint {
  std::int32_t vertex = -1;
  BodyRole role = BodyRole::tip;
  std::int32_t side = 0;      // 1 on the body's left, -1 on its right, 0 in the middle
  std::int32_t partner = -1;  // index of the same point on the other side, its own on the plane of symmetry, or -1
  S radius = S(0);            // of what moves as one piece with it, along the surface
  bool wanted = true;         // a body needs it to dance; else it is there to be chosen
};

// A place of a body that somebody named, as a file does that brings joints; `tip` says only that something is there.
template <class S>
struct Landmark {
  Vec3<S> position = Vec3<S>::Zero();  // in the mesh's axes and units
  BodyRole role = BodyRole::tip;
  std::int32_t side = 0;  // 1 on the body's left, -1 on its right, 0 in the middle
};

}  // namespace rigless
