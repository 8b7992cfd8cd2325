// Where the trunk of a solid is, from the slabs that hold it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "rigless/deform/detail/control.h"
#include "rigless/mesh/solid.h"

namespace rigless::detail {

// A capsule about the middle of the body, from one slab to beyond the other, which is a chest below its shoulders.
template <class S>
struct TrunkShape {
  Vec3<S> from = Vec3<S>::Zero(), to = Vec3<S>::Zero();
  S radius = 0;  // 0: it is not known

  // From its axis.
  S distance(const Vec3<S>& p) const {
    const Vec3<S> way = to - from;
    const S along = std::clamp((p - from).dot(way) / way.squaredNorm(), S(0), S(1));
    return (p - from - along * way).norm();
  }
  bool holds(const Vec3<S>& p) const { return radius > S(0) && distance(p) < radius; }
};

// As thick as the waist, which no limb is on. rest: C, where controls rest. Allocates.
template <class S>
RIGLESS_COLD TrunkShape<S> find_trunk(const Solid<S>& solid, Span<const Control<S>> controls,
                                      Span<const Vec3<S>> rest) {
  TrunkShape<S> trunk;
  std::vector<Vec3<S>> slabs;
  for (std::size_t c = 0; c < controls.size(); ++c)
    if (controls[c].slab) slabs.push_back(rest[c]);
  if (slabs.size() < 2) return trunk;
  std::sort(slabs.begin(), slabs.end(), [](const Vec3<S>& a, const Vec3<S>& b) { return a.y() < b.y(); });
  trunk.from = slabs.front();
  trunk.to = slabs.back();
  const S length = (trunk.to - trunk.from).norm();
  if (!(length > S(0))) return trunk;
  const Vec3<S> way = (trunk.to - trunk.from) / length, waist = (trunk.from + trunk.to) / S(2);
  const S half = std::max(solid.cell, length / S(8));
  const auto is_waist = [&](const Vec3<S>& p) {  // what is farther away is held in a hand
    return std::abs((p - waist).dot(way)) < half && (p - waist).squaredNorm() < length * length;
  };

  std::vector<std::int32_t> queue;
  std::vector<char> seen(solid.rest.size(), 0);
  std::size_t nearest = 0;
  for (std::size_t v = 1; v < solid.rest.size(); ++v)
    if ((solid.rest[v] - waist).squaredNorm() < (solid.rest[nearest] - waist).squaredNorm()) nearest = v;
  queue.push_back(static_cast<std::int32_t>(nearest));
  seen[nearest] = 1;
  Vec3<S> sum = Vec3<S>::Zero();
  for (std::size_t k = 0; k < queue.size(); ++k) {
    sum += nth(solid.rest, queue[k]) - waist;
    const auto i = to_size(queue[k]);
    for (std::int32_t e = solid.ring.first[i]; e < solid.ring.first[i + 1]; ++e) {
      const std::int32_t j = nth(solid.ring.neighbor, e);
      if (nth(seen, j) != 0 || !is_waist(nth(solid.rest, j))) continue;
      nth(seen, j) = 1;
      queue.push_back(j);
    }
  }
  Vec3<S> middle = sum / static_cast<S>(queue.size());
  middle -= way * way.dot(middle);
  trunk.from += middle;
  trunk.to += middle + S(0.4) * length * way;
  std::vector<S> squares;
  for (const std::int32_t node : queue) {
    const Vec3<S> away = nth(solid.rest, node) - waist - middle;
    squares.push_back(away.squaredNorm() - std::pow(away.dot(way), S(2)));
  }
  const auto median = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), median, squares.end());
  trunk.radius =
      std::min(std::sqrt(std::max(S(2) * *median, S(0))), S(0.75) * length);  // half a disc is nearer than that
  return trunk;
}

}  // namespace rigless::detail
