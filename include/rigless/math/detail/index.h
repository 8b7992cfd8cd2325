// Indices are 32 bits in memory, sizes are std::size_t in C++: what takes either to the other, so that no cast says
// less than it should. All of our code counts with them, so they stand in rigless itself.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rigless/math/detail/macros.h"

namespace rigless {

// An index or a count that is not negative.
template <class I>
constexpr std::size_t to_size(I i) {
  RIGLESS_ASSERT(i >= I{0});
  return static_cast<std::size_t>(i);
}

// Element i of a vector, a view or an array, whatever integer i is.
template <class V, class I>
constexpr decltype(auto) nth(V&& values, I i) {
  return values[to_size(i)];
}

// How many elements there are.
template <class V>
constexpr std::int32_t count_of(const V& values) {
  return static_cast<std::int32_t>(values.size());
}

}  // namespace rigless
