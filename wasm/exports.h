// What every exported function needs. Pointers that an export returns hold until the object changes or the heap grows.
#pragma once

#include "abi.h"
#include "rigless/math/span.h"
#include "rigless/math/status.h"

#define RIGLESS_EXPORT extern "C" __attribute__((used, visibility("default")))

namespace rigless_wasm {

inline PackedStatus pack(rigless::Status status) {
  if (status.ok()) return 0;
  return static_cast<double>(status.error) * 4294967296.0 +
         static_cast<double>(static_cast<std::uint32_t>(status.where));
}

// Numbers as points, faces or flights.
template <class T, class U>
rigless::Span<const T> view(const U* data, std::int32_t count) {
  static_assert(sizeof(T) % sizeof(U) == 0);
  return {reinterpret_cast<const T*>(data), static_cast<std::size_t>(count)};
}

}  // namespace rigless_wasm
