// The separate pieces of a mesh, and the ties that hold them together.
#pragma once

#include <cmath>
#include <limits>
#include <numeric>

#include "rigless/mesh/detail/one_ring.h"

namespace rigless::detail {

// The shell (connected piece) of each vertex, numbered by first vertex; isolated vertices are shells of their own.
struct Shells {
  std::vector<std::int32_t> of_vertex;  // V
  std::int32_t count = 0;
};

// Labels the connected pieces of the ring. Allocates.
RIGLESS_COLD inline Shells find_shells(const OneRing& ring) {
  Shells shells;
  const auto n = to_size(ring.vertices());
  shells.of_vertex.assign(n, -1);
  std::vector<std::int32_t> stack;
  for (std::size_t seed = 0; seed < n; ++seed) {
    if (shells.of_vertex[seed] >= 0) continue;
    const std::int32_t id = shells.count++;
    shells.of_vertex[seed] = id;
    stack.push_back(static_cast<std::int32_t>(seed));
    while (!stack.empty()) {
      const auto i = to_size(stack.back());
      stack.pop_back();
      for (std::int32_t k = ring.first[i]; k < ring.first[i + 1]; ++k) {
        const auto j = to_size(nth(ring.neighbor, k));
        if (shells.of_vertex[j] >= 0) continue;
        shells.of_vertex[j] = id;
        stack.push_back(static_cast<std::int32_t>(j));
      }
    }
  }
  return shells;
}

// Points sorted into cubes, so that the nearest foreign point is found without looking at all.
template <class S>
class PointGrid {
 public:
  PointGrid(Span<const Vec3<S>> points, S cell) : points_(points), cell_(cell) {
    order_.resize(points.size());
    std::iota(order_.begin(), order_.end(), 0);
    keys_.reserve(points.size());
    for (const Vec3<S>& p : points) keys_.push_back(key(cube(p)));
    std::sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) {
      const auto ka = nth(keys_, a), kb = nth(keys_, b);
      return ka != kb ? ka < kb : a < b;
    });
  }

  // Nearest point that `accept(index)` within `reach` cubes; -1 when there is none. Exact up to reach * cell.
  template <class Accept>
  std::int32_t nearest(const Vec3<S>& p, int reach, const Accept& accept) const {
    const Cube c = cube(p);
    std::int32_t best = -1;
    S best_distance = std::numeric_limits<S>::max();
    for (std::int64_t x = c[0] - reach; x <= c[0] + reach; ++x) {
      for (std::int64_t y = c[1] - reach; y <= c[1] + reach; ++y) {
        for (std::int64_t z = c[2] - reach; z <= c[2] + reach; ++z) {
          const std::int64_t wanted = key({x, y, z});
          auto it = std::lower_bound(order_.begin(), order_.end(), wanted,
                                     [&](std::int32_t a, std::int64_t k) { return nth(keys_, a) < k; });
          for (; it != order_.end() && nth(keys_, *it) == wanted; ++it) {
            const S d = (nth(points_, *it) - p).squaredNorm();
            if (d < best_distance && accept(*it)) {
              best_distance = d;
              best = *it;
            }
          }
        }
      }
    }
    return best;
  }

 private:
  using Cube = std::array<std::int64_t, 3>;
  Cube cube(const Vec3<S>& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x() / cell_)), static_cast<std::int64_t>(std::floor(p.y() / cell_)),
            static_cast<std::int64_t>(std::floor(p.z() / cell_))};
  }
  static std::int64_t key(const Cube& c) {
    const std::int64_t bias = 1 << 20, mask = (1 << 21) - 1;
    return (((c[0] + bias) & mask) << 42) | (((c[1] + bias) & mask) << 21) | ((c[2] + bias) & mask);
  }

  Span<const Vec3<S>> points_;
  S cell_;
  std::vector<std::int32_t> order_;
  std::vector<std::int64_t> keys_;
};

// Pairs of vertices that tie every shell to what is nearest, until the whole mesh hangs together: up to
// `ties_per_shell` pairs between a shell and its nearest neighbour shell, spread over the smaller of the two. A mesh of
// one shell needs none. Allocates.
template <class S>
RIGLESS_COLD std::vector<std::array<std::int32_t, 2>> tie_shells(Span<const Vec3<S>> vertices, const OneRing& ring,
                                                                 std::size_t ties_per_shell = 6) {
  std::vector<std::array<std::int32_t, 2>> ties;
  Shells shells = find_shells(ring);
  if (shells.count <= 1) return ties;
  Vec3<S> low = vertices[0], high = vertices[0];
  for (const Vec3<S>& v : vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const S diagonal = (high - low).norm();
  if (!(diagonal > S(0))) {  // all at one place: a chain will do
    for (std::size_t v = 1; v < vertices.size(); ++v) {
      ties.push_back({static_cast<std::int32_t>(v - 1), static_cast<std::int32_t>(v)});
    }
    return ties;
  }

  // Boruvka: each round every shell reaches for its nearest foreign vertices; the cubes grow until someone is found.
  std::vector<std::vector<std::int32_t>> members;
  for (S cell = diagonal / S(64); shells.count > 1; cell *= S(2)) {
    members.assign(to_size(shells.count), {});
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      nth(members, shells.of_vertex[v]).push_back(static_cast<std::int32_t>(v));
    }
    std::size_t largest = 0;
    for (std::size_t s = 1; s < members.size(); ++s) {
      if (members[s].size() > members[largest].size()) largest = s;
    }
    const PointGrid<S> grid(vertices, cell);
    const std::size_t before = ties.size();
    for (std::size_t s = 0; s < members.size(); ++s) {
      if (s == largest) continue;
      struct Candidate {
        S distance;
        std::int32_t from, to;
      };
      std::vector<Candidate> found;
      const std::size_t stride =
          std::max<std::size_t>(1, members[s].size() / 2000);  // a sample is enough on big shells
      for (std::size_t m = 0; m < members[s].size(); m += stride) {
        const std::int32_t v = members[s][m];
        const Vec3<S>& p = nth(vertices, v);
        const std::int32_t to = grid.nearest(
            p, 1, [&](std::int32_t other) { return nth(shells.of_vertex, other) != static_cast<std::int32_t>(s); });
        if (to >= 0) found.push_back({(nth(vertices, to) - p).squaredNorm(), v, to});
      }
      std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.from < b.from;
      });
      // the nearest, then others spread over the near half, so that the piece cannot spin about one tie
      const std::size_t near_half =
          found.empty() ? 0 : std::max(std::min(found.size(), ties_per_shell), found.size() / 4);
      const std::size_t step = std::max<std::size_t>(1, near_half / ties_per_shell);
      for (std::size_t k = 0, taken = 0; k < near_half && taken < ties_per_shell; k += step, ++taken) {
        ties.push_back({found[k].from, found[k].to});
      }
    }
    if (ties.size() > before) {
      std::vector<std::array<std::int32_t, 2>> pairs = ties;
      for (std::size_t i = 0; i + 1 < ring.first.size(); ++i) {
        for (std::int32_t k = ring.first[i]; k < ring.first[i + 1]; ++k) {
          pairs.push_back({static_cast<std::int32_t>(i), nth(ring.neighbor, k)});
        }
      }
      shells = find_shells(one_ring_from_pairs(pairs, ring.vertices()));
    }
  }
  return ties;
}

}  // namespace rigless::detail
