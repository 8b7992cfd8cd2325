// What containers hold on to.
#pragma once

#include <cstdint>
#include <vector>

namespace rigless::detail {

// Bytes that these vectors have taken from the heap, used or not.
template <class... T>
std::int64_t bytes_of(const std::vector<T>&... vectors) {
  return (std::int64_t{0} + ... + static_cast<std::int64_t>(vectors.capacity() * sizeof(T)));
}

}  // namespace rigless::detail
