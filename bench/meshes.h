// What the benchmarks deform: meshes from the shared folder where it exists, meshes made here everywhere, and controls
// spread over them.
#pragma once

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "rigless/deform/detail/discs.h"
#include "rigless/mesh/detail/measure.h"

namespace rigless_bench {

using rigless::Face;
using rigless::Vec3;

struct Mesh {
  std::string name;
  std::vector<Vec3<double>> vertices;
  std::vector<Face> faces;

  bool empty() const { return faces.empty(); }
  template <class S>
  std::vector<Vec3<S>> rest() const {
    std::vector<Vec3<S>> out;
    for (const Vec3<double>& v : vertices) out.push_back(v.cast<S>());
    return out;
  }
};

// Positions and triangles (polygons as fans) of an OBJ or OFF file; no faces when there is no such file.
inline Mesh load_mesh(const std::string& path) {
  Mesh mesh;
  mesh.name = path.substr(path.find_last_of('/') + 1);
  std::ifstream in(path);
  const auto fan = [&](const std::vector<std::int32_t>& polygon) {
    for (std::size_t k = 2; k < polygon.size(); ++k) mesh.faces.push_back({polygon[0], polygon[k - 1], polygon[k]});
  };
  std::string line, word;
  if (path.size() > 4 && path.compare(path.size() - 4, 4, ".off") == 0) {
    std::size_t vertices = 0, faces = 0, edges = 0, corners = 0;
    in >> word >> vertices >> faces >> edges;
    for (std::size_t v = 0; v < vertices; ++v) {
      Vec3<double> p;
      in >> p.x() >> p.y() >> p.z();
      mesh.vertices.push_back(p);
    }
    for (std::size_t f = 0; f < faces && in >> corners; ++f) {
      std::vector<std::int32_t> polygon(corners);
      for (std::int32_t& v : polygon) in >> v;
      fan(polygon);
      std::getline(in, line);
    }
    return mesh;
  }
  while (std::getline(in, line)) {
    std::istringstream words(line);
    words >> word;
    if (word == "v") {
      Vec3<double> p;
      words >> p.x() >> p.y() >> p.z();
      mesh.vertices.push_back(p);
    } else if (word == "f") {
      std::vector<std::int32_t> polygon;
      while (words >> word) polygon.push_back(static_cast<std::int32_t>(std::atoi(word.c_str())) - 1);
      fan(polygon);
    }
    word.clear();
  }
  return mesh;
}

// A torus with bumps, n x n vertices.
inline Mesh torus(std::int32_t n) {
  constexpr double turn = 6.283185307179586;
  Mesh mesh;
  mesh.name = "torus " + std::to_string(n * n);
  for (std::int32_t i = 0; i < n; ++i) {
    for (std::int32_t j = 0; j < n; ++j) {
      const double u = turn * i / n, v = turn * j / n;
      const double tube = 0.35 + 0.04 * std::sin(7 * u) * std::cos(5 * v) + 0.03 * std::sin(3 * u + 2 * v);
      mesh.vertices.emplace_back((1 + tube * std::cos(v)) * std::cos(u), (1 + tube * std::cos(v)) * std::sin(u),
                                 tube * std::sin(v));
      const auto at = [&](std::int32_t a, std::int32_t b) { return (i + a) % n * n + (j + b) % n; };
      mesh.faces.push_back({at(0, 0), at(1, 0), at(1, 1)});
      mesh.faces.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  }
  return mesh;
}

// The named files of the shared folder, or tori of these sides where there is none.
inline std::vector<Mesh> meshes(const std::vector<std::string>& files, const std::vector<std::int32_t>& sides) {
  std::vector<Mesh> out;
  for (const std::string& file : files) {
    if (Mesh mesh = load_mesh(RIGLESS_SHARED_DIR "data/meshes/" + file); !mesh.empty()) out.push_back(std::move(mesh));
  }
  if (!out.empty()) return out;
  for (const std::int32_t n : sides) out.push_back(torus(n));
  return out;
}

// Ten controls, far apart in the file's own order, and where they are dragged: by up to `amplitude` heights.
template <class S>
struct Pull {
  std::vector<rigless::Control<S>> controls;
  std::vector<Vec3<S>> targets;
};

template <class S>
Pull<S> pull(const Mesh& mesh, S amplitude, S radius = S(0)) {
  Pull<S> out;
  const auto rest = mesh.rest<S>();
  const S height = rigless::detail::bounds<S>(rest).height();
  for (int k = 0; k < 10; ++k) {
    const std::size_t v = rest.size() * static_cast<std::size_t>(2 * k + 1) / 20;
    out.controls.push_back({static_cast<std::int32_t>(v), radius * height});
    const Vec3<S> by(static_cast<S>(k * 7 % 5 - 2), static_cast<S>(k * 3 % 5 - 2), static_cast<S>(k * 11 % 5 - 2));
    out.targets.push_back(rest[v] + amplitude * height / S(2) * by);
  }
  return out;
}

}  // namespace rigless_bench
