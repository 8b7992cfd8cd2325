// A ground that a figure stands on is no part of the figure.
#pragma once

#include "rigless/mesh/detail/sheets.h"
#include "rigless/mesh/detail/voxel_grid.h"

namespace rigless::detail {

struct ShellSize {
  Box box;
  double area = 0;
};

// Of each shell. Allocates.
template <class S>
RIGLESS_COLD std::vector<ShellSize> measure_shells(Span<const Vec3<S>> vertices, Span<const Face> faces,
                                                   const Sheets& sheets) {
  std::vector<ShellSize> shells(to_size(sheets.shells));
  for (std::size_t f = 0; f < faces.size(); ++f) {
    ShellSize& shell = nth(shells, sheets.shell_of[f]);
    Point corner[3];
    for (std::size_t k = 0; k < 3; ++k) corner[k] = nth(vertices, faces[f][k]).template cast<double>();
    if (!(shell.area > 0)) shell.box = {corner[0], corner[0]};
    for (const Point& p : corner) shell.box = {shell.box.low.cwiseMin(p), shell.box.high.cwiseMax(p)};
    // a shell without any area is still there
    shell.area += std::max((corner[1] - corner[0]).cross(corner[2] - corner[0]).norm() / 2, 1e-300);
  }
  return shells;
}

// The shells that are flat, lie under all the others and reach as far as these or farther: a ground, or none. `up` is
// an axis. What is less than a thousandth of all area counts for nothing. Allocates.
inline std::vector<char> ground_along(const std::vector<ShellSize>& shells, int up) {
  double area = 0;
  for (const ShellSize& s : shells) area += s.area;
  const auto counts = [&](const ShellSize& s) { return s.area > 0.001 * area; };
  const auto join = [](Box& all, const Box& one, bool first) {
    all = first ? one : Box{all.low.cwiseMin(one.low), all.high.cwiseMax(one.high)};
  };
  Box all, ground, rest;
  bool any = false, any_ground = false, any_rest = false;
  for (const ShellSize& s : shells) {
    if (!counts(s)) continue;
    join(all, s.box, !any);
    any = true;
  }
  const double slack = 0.02 * (all.high[up] - all.low[up]);
  std::vector<char> is_ground(shells.size(), 0);
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const ShellSize& shell = shells[s];
    if (!counts(shell)) continue;
    const bool low = shell.box.high[up] < all.low[up] + slack;
    is_ground[s] = low;
    join(low ? ground : rest, shell.box, low ? !any_ground : !any_rest);
    (low ? any_ground : any_rest) = true;
  }
  bool wide = any_ground && any_rest && rest.low[up] > ground.high[up] - slack;
  double times = 1;
  for (int a = 0; a < 3; ++a) {
    if (a == up) continue;
    const double border = 0.05 * (rest.high[a] - rest.low[a]);
    wide = wide && ground.low[a] < rest.low[a] + border && ground.high[a] > rest.high[a] - border;
    times *= (ground.high[a] - ground.low[a]) / (rest.high[a] - rest.low[a]);
  }
  if (!wide || !(times > 1.5)) is_ground.clear();
  return is_ground;
}

// Faces of the ground, if there is one: a mark for each, or nothing. Models stand along y or z, as formats have it.
inline std::vector<char> ground_faces(const std::vector<ShellSize>& shells, const Sheets& sheets) {
  for (const int up : {1, 2}) {
    const std::vector<char> is_ground = ground_along(shells, up);
    if (is_ground.empty()) continue;
    std::vector<char> of_face(sheets.shell_of.size());
    for (std::size_t f = 0; f < of_face.size(); ++f) of_face[f] = nth(is_ground, sheets.shell_of[f]);
    return of_face;
  }
  return {};
}

}  // namespace rigless::detail
