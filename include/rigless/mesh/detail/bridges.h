// What floats is tied to what is nearest: firmly where it all but touches, as the boxes of a robot do, softly where
// nothing is near, as a hat above a head.
#pragma once

#include <vector>

#include "rigless/mesh/detail/disjoint_sets.h"
#include "rigless/mesh/detail/voxel_grid.h"

namespace rigless::detail {

struct Bridge {
  std::int32_t a, b;
  bool firm;
};

// Pairs of nodes that tie the parts of a graph (pairs) to its largest, nearest first, each to all that is tied already:
// every pair of nodes within the least distance and `room` more. Of parts equally far the larger one comes first. Where
// the least distance is within `room` too, those to the largest part of these are firm: a leg hangs on the trunk and
// not on the other leg. Allocates.
class BridgeBuilder {
 public:
  using Pairs = std::vector<std::array<std::int32_t, 2>>;

  BridgeBuilder(const std::vector<Point>& nodes, const Pairs& pairs) : nodes_(nodes), part_(nodes.size()) {
    DisjointSets sets(nodes.size());
    for (const auto& [a, b] : pairs) sets.unite(a, b);
    std::vector<std::int32_t> number(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      std::int32_t& at = nth(number, sets.find(static_cast<std::int32_t>(i)));
      if (at < 0) {
        at = count_of(members_);
        members_.emplace_back();
      }
      part_[i] = at;
      nth(members_, at).push_back(static_cast<std::int32_t>(i));
    }
  }

  std::int32_t parts() const { return count_of(members_); }

  RIGLESS_COLD std::vector<Bridge> build(double room) {
    std::vector<Bridge> bridges;
    if (members_.size() < 2) return bridges;
    std::size_t largest = 0;
    for (std::size_t p = 1; p < members_.size(); ++p)
      largest = members_[p].size() > members_[largest].size() ? p : largest;
    nearest_.assign(nodes_.size(), 1e300);
    take(static_cast<std::int32_t>(largest));
    while (tied_.size() < nodes_.size()) {
      std::int32_t next = -1;
      double least = 0;
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nearest_[i] < 0) continue;
        const std::int32_t p = part_[i];
        const bool larger = next >= 0 && nearest_[i] == least && nth(members_, p).size() > nth(members_, next).size();
        if (next >= 0 && nearest_[i] >= least && !larger) continue;
        next = p;
        least = nearest_[i];
      }
      bridge(next, std::sqrt(least), room, bridges);
      take(next);
    }
    return bridges;
  }

 private:
  void bridge(std::int32_t next, double least, double room, std::vector<Bridge>& bridges) const {
    const std::size_t first = bridges.size();
    const double reach = least + room;
    std::int32_t trunk = -1;
    for (const std::int32_t a : nth(members_, next)) {
      for (const std::int32_t b : tied_) {
        if ((nth(nodes_, a) - nth(nodes_, b)).squaredNorm() > reach * reach) continue;
        bridges.push_back({a, b, false});
        const std::int32_t part = nth(part_, b);
        if (trunk < 0 || nth(members_, part).size() > nth(members_, trunk).size()) trunk = part;
      }
    }
    for (std::size_t k = first; k < bridges.size() && least < room; ++k) {
      bridges[k].firm = nth(part_, bridges[k].b) == trunk;
    }
  }

  // Adds a part to what is tied; squared distances to that are kept, less than 0 for the tied themselves.
  void take(std::int32_t part) {
    for (const std::int32_t a : nth(members_, part)) {
      tied_.push_back(a);
      nth(nearest_, a) = -1;
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nearest_[i] < 0) continue;
      for (const std::int32_t a : nth(members_, part)) {
        nearest_[i] = std::min(nearest_[i], (nth(nodes_, a) - nodes_[i]).squaredNorm());
      }
    }
  }

  const std::vector<Point>& nodes_;
  std::vector<std::int32_t> part_;                  // of each node
  std::vector<std::vector<std::int32_t>> members_;  // of each part
  std::vector<double> nearest_;
  std::vector<std::int32_t> tied_;
};

}  // namespace rigless::detail
