// Which things hang together, told pair by pair.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include "rigless/math/detail/index.h"

namespace rigless::detail {

// Sets of 0 .. n - 1; the smallest member speaks for its set, in whatever order the pairs come. Each member may be
// turned against the others of its set (parity).
class DisjointSets {
 public:
  DisjointSets() = default;
  explicit DisjointSets(std::size_t n) { reset(n); }

  void reset(std::size_t n) {
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  std::int32_t find(std::int32_t i) {
    while (nth(parent_, i) != i) {
      nth(parent_, i) = nth(parent_, nth(parent_, i));
      i = nth(parent_, i);
    }
    return i;
  }

  void unite(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    nth(parent_, a < b ? b : a) = a < b ? a : b;
  }

 private:
  std::vector<std::int32_t> parent_;
};

// The same with a parity between members: whether one is turned against the other.
class TurnedSets {
 public:
  explicit TurnedSets(std::size_t n) : parent_(n), turned_(n, 0) { std::iota(parent_.begin(), parent_.end(), 0); }

  struct Member {
    std::int32_t root;
    std::uint8_t turned;  // against the root
  };

  Member find(std::int32_t i) {
    std::uint8_t turned = 0;
    std::int32_t root = i;
    for (; nth(parent_, root) != root; root = nth(parent_, root)) turned ^= nth(turned_, root);
    for (std::uint8_t left = turned; nth(parent_, i) != root && i != root;) {  // all on the way point at the root
      const std::int32_t next = nth(parent_, i);
      const std::uint8_t own = nth(turned_, i);
      nth(parent_, i) = root;
      nth(turned_, i) = left;
      left ^= own;
      i = next;
    }
    return {root, turned};
  }

  // Pairs that contradict earlier ones, as on a Moebius strip, change nothing.
  void unite(std::int32_t a, std::int32_t b, bool turned) {
    const Member x = find(a), y = find(b);
    if (x.root == y.root) return;
    const std::int32_t high = x.root < y.root ? y.root : x.root, low = x.root < y.root ? x.root : y.root;
    nth(parent_, high) = low;
    nth(turned_, high) = static_cast<std::uint8_t>(x.turned ^ y.turned ^ (turned ? 1 : 0));
  }

 private:
  std::vector<std::int32_t> parent_;
  std::vector<std::uint8_t> turned_;
};

}  // namespace rigless::detail
