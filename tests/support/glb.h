// The surface of a plain GLB, as our own cactus is: one mesh, float positions, 16-bit indices, nothing packed.
#pragma once

#include <array>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "rigless/math/types.h"
#include "support/json.h"

namespace rigless::test {

template <class S>
struct Surface {
  std::vector<Vec3<S>> vertices;
  std::vector<Face> faces;
};

// Corners at one place become one vertex, in the file's order. Empty when the file is not such a GLB.
template <class S>
Surface<S> read_glb(const std::string& bytes) {
  const auto read = [&](auto& out, std::size_t at) {
    if (at + sizeof(out) <= bytes.size()) std::memcpy(&out, bytes.data() + at, sizeof(out));
  };
  std::uint32_t text = 0;
  read(text, 12);
  const std::size_t start = 28 + std::size_t(text);
  if (bytes.compare(0, 4, "glTF") != 0 || start > bytes.size()) return {};
  const json::Value file = json::parse(bytes.substr(20, text));
  const json::Value& mesh = file["meshes"][0]["primitives"][0];
  const auto accessor = [&](const json::Value& index) { return file["accessors"][index.integer()]; };
  const auto offset = [&](const json::Value& a) {
    return start + std::size_t(file["bufferViews"][a["bufferView"].integer()]["byteOffset"].integer());
  };
  const json::Value positions = accessor(mesh["attributes"]["POSITION"]), indices = accessor(mesh["indices"]);
  if (positions["componentType"].integer() != 5126 || indices["componentType"].integer() != 5123) return {};

  Surface<S> surface;
  std::map<std::array<float, 3>, std::int32_t> vertex_at;
  std::vector<std::int32_t> vertex_of;
  for (std::size_t k = 0; k < std::size_t(positions["count"].integer()); ++k) {
    std::array<float, 3> p{};
    read(p, offset(positions) + k * sizeof(p));
    const auto [found, fresh] = vertex_at.insert({p, std::int32_t(surface.vertices.size())});
    if (fresh) surface.vertices.push_back({S(p[0]), S(p[1]), S(p[2])});
    vertex_of.push_back(found->second);
  }
  for (std::size_t f = 0; f < std::size_t(indices["count"].integer()) / 3; ++f) {
    std::array<std::uint16_t, 3> corner{};
    read(corner, offset(indices) + f * sizeof(corner));
    surface.faces.push_back({vertex_of[corner[0]], vertex_of[corner[1]], vertex_of[corner[2]]});
  }
  return surface;
}

}  // namespace rigless::test
