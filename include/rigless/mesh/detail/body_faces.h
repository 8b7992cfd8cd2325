// What of a mesh is the body, before anybody asks what it looks like.
#pragma once

#include "rigless/mesh/detail/body_box.h"
#include "rigless/mesh/detail/ground.h"

namespace rigless::detail {

// The faces without a ground that the body stands on and without shells that lie far away from it. Allocates.
template <class S>
RIGLESS_COLD std::vector<Face> body_faces(Span<const Vec3<S>> vertices, Span<const Face> faces) {
  const Sheets sheets = find_sheets(vertices, faces);
  const std::vector<char> ground = ground_faces(measure_shells(vertices, faces, sheets), sheets);
  const Box box = body_box(vertices, faces, ground, 0.02);
  std::vector<char> near(to_size(sheets.shells), 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Point p = nth(vertices, faces[f][0]).template cast<double>();
    if ((p.array() >= box.low.array()).all() && (p.array() <= box.high.array()).all())
      nth(near, sheets.shell_of[f]) = 1;
  }
  std::vector<Face> body;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if ((ground.empty() || !ground[f]) && nth(near, sheets.shell_of[f]) != 0) body.push_back(faces[f]);
  if (body.empty()) body.assign(faces.begin(), faces.end());
  return body;
}

}  // namespace rigless::detail
