// The few vertices that can be the lowest of a carried model.
#pragma once

#include "rigless/mesh/solid.h"

namespace rigless {

namespace detail {

// The 26 ways from a cube to its neighbours; d and 25 - d are opposite.
template <class S>
std::array<Vec3<S>, 26> ways_out() {
  std::array<Vec3<S>, 26> ways;
  for (int k = 0; k < 26; ++k) {
    const int d = k < 13 ? k : k + 1;
    ways[static_cast<std::size_t>(k)] =
        Vec3<S>(static_cast<S>(d % 3 - 1), static_cast<S>(d / 3 % 3 - 1), static_cast<S>(d / 9 - 1)).normalized();
  }
  return ways;
}

}  // namespace detail

template <class S>
RIGLESS_COLD std::vector<std::int32_t> outermost_vertices(const Solid<S>& solid, Span<const Vec3<S>> vertices) {
  constexpr std::size_t directions = 26;
  const S shy = solid.cell / S(10);  // by so much less than a neighbour it may stand out
  const auto ways = detail::ways_out<S>();
  struct Extreme {
    S reach = std::numeric_limits<S>::lowest();
    std::int32_t vertex = -1;
  };
  using Extremes = std::array<Extreme, directions>;
  std::vector<Extremes> of_element(solid.element.size());
  std::vector<std::array<S, directions>> of_node(solid.rest.size());
  for (auto& reach : of_node) reach.fill(std::numeric_limits<S>::lowest());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (solid.element_of[v] < 0) continue;
    Extremes& e = nth(of_element, solid.element_of[v]);
    for (std::size_t d = 0; d < directions; ++d) {
      const S reach = ways[d].dot(vertices[v]);
      if (reach > e[d].reach) e[d] = {reach, static_cast<std::int32_t>(v)};
    }
  }
  for (std::size_t e = 0; e < of_element.size(); ++e) {
    for (const std::int32_t node : solid.element[e]) {
      for (std::size_t d = 0; d < directions; ++d) {
        S& reach = nth(of_node, node)[d];
        reach = std::max(reach, of_element[e][d].reach);
      }
    }
  }
  std::vector<std::int32_t> out;
  for (std::size_t e = 0; e < of_element.size(); ++e) {
    for (std::size_t d = 0; d < directions; ++d) {
      const Extreme& x = of_element[e][d];
      if (x.vertex < 0) continue;
      const auto beaten = [&](std::int32_t node) { return nth(of_node, node)[d] > x.reach + shy; };
      if (!std::any_of(solid.element[e].begin(), solid.element[e].end(), beaten)) out.push_back(x.vertex);
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace rigless
